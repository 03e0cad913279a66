// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/charts/joint_plot.h"

#include "widgets/base/colour_maps.h"
#include "widgets/base/theme.h"

#include <QFontMetricsF>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace teleta::charts {

namespace {

constexpr double kPartHeight_em = 6.8; ///< at least: title and four values
constexpr double kHeaderHeight_em = 1.5;
constexpr double kAxisHeight_em = 1.7;
constexpr double kPanelWidth_em = 13.0;
constexpr double kAxisPadding = 0.05;
constexpr double kMilli = 1e3;
constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr double kLeastTorqueSpan_mNm = 20.0;
constexpr double kLeastAngleSpan_deg = 5.0;
constexpr auto kOverlay = "teleta.overlay";

} // namespace

JointPlot::JointPlot(QWidget* parent)
    : QCustomPlot(parent)
    , m_colours(palette()) {
    setFocusPolicy(Qt::NoFocus);
    setNoAntialiasingOnDrag(false);
    setPlottingHints(QCP::phCacheLabels);
    plotLayout()->clear();
    plotLayout()->setRowSpacing(0);
    m_header = new HeaderElement(this);
    plotLayout()->addElement(0, 0, m_header);
    m_grid = new QCPLayoutGrid;
    plotLayout()->addElement(1, 0, m_grid);
    m_axisRoom = new QCPLayoutElement(this);
    plotLayout()->addElement(2, 0, m_axisRoom);
    // The cursor and the numbers have a buffer of their own: moving the mouse redraws no curve.
    addLayer(QString::fromLatin1(kOverlay));
    layer(QString::fromLatin1(kOverlay))->setMode(QCPLayer::lmBuffered);
    m_touches = new Shades(this, QStringLiteral("background"), Shades::Kind::times);
    m_window = new Shades(this, QStringLiteral("background"), Shades::Kind::values);
    m_jumps = new TimeLines(this, QStringLiteral("grid"));
    m_cursor = new TimeLines(this, QString::fromLatin1(kOverlay));
    m_header->setLayer(QString::fromLatin1(kOverlay));
    m_parts[0] = makePart(kMilli, QStringLiteral("mNm"), kLeastTorqueSpan_mNm);
    m_parts[1] = makePart(kDegrees, QStringLiteral("°"), kLeastAngleSpan_deg);
    m_window->setRects({m_parts[0].rect});
    m_grid->addElement(0, 0, m_parts[0].rect);
    m_grid->addElement(0, 1, m_parts[0].panel);
    m_grid->addElement(1, 0, m_parts[1].rect);
    m_grid->addElement(1, 1, m_parts[1].panel);
    retranslate();
    setAnglesShown(false);
}

JointPlot::Part JointPlot::makePart(double scale, const QString& unit, double minimumSpan) {
    Part part;
    part.scale = scale;
    part.unit = unit;
    part.rect = new QCPAxisRect(this, true);
    part.rect->setAutoMargins(QCP::msNone);
    part.panel = new ValuePanel(this);
    part.panel->setLayer(QString::fromLatin1(kOverlay));
    part.range = base::CalmRange(minimumSpan);
    QCPAxis* bottom = part.rect->axis(QCPAxis::atBottom);
    QCPAxis* left = part.rect->axis(QCPAxis::atLeft);
    bottom->setTicker(QSharedPointer<RoundTicker>::create(0.0, tr(" s")));
    bottom->ticker()->setTickCount(8);
    left->setTicker(QSharedPointer<RoundTicker>::create());
    left->ticker()->setTickCount(4);
    left->grid()->setZeroLinePen(Qt::NoPen);
    bottom->grid()->setZeroLinePen(Qt::NoPen);
    for (QCPGraph*& graph : part.graphs) {
        graph = addGraph(bottom, left);
        graph->setAdaptiveSampling(false); // the polyline has few points already
    }
    return part;
}

QString JointPlot::jointName(std::size_t joint) {
    switch (joint) {
    case 0:
        return tr("shoulder roll");
    case 1:
        return tr("shoulder pitch");
    case 2:
        return tr("shoulder yaw");
    case 3:
        return tr("elbow pitch");
    default:
        return {};
    }
}

double JointPlot::em() const {
    return QFontMetricsF(font()).height();
}

void JointPlot::retranslate() {
    m_parts[0].panel->setTitle(tr("Joint torque"));
    m_parts[1].panel->setTitle(tr("Joint angle"));
}

void JointPlot::setAnglesShown(bool shown) {
    m_anglesShown = shown;
    Part& angle = m_parts[1];
    angle.rect->setVisible(shown);
    angle.panel->setVisible(shown);
    for (QCPGraph* graph : angle.graphs)
        graph->setVisible(shown);
    for (const auto side : {QCPAxis::atBottom, QCPAxis::atLeft, QCPAxis::atTop, QCPAxis::atRight})
        angle.rect->axis(side)->setVisible(shown && (side == QCPAxis::atBottom || side == QCPAxis::atLeft));
    m_grid->setRowStretchFactor(1, shown ? 1.0 : 1e-6);
    std::vector<QCPAxisRect*> rects{m_parts[0].rect};
    if (shown)
        rects.push_back(angle.rect);
    m_touches->setRects(rects);
    m_jumps->setRects(rects);
    m_cursor->setRects(rects);
    setColours(m_colours);
    setMinimumHeight(minimumSizeHint().height());
    updateGeometry();
}

void JointPlot::setWindow(double low_Nm, double high_Nm) {
    m_window->setShades({{kMilli * low_Nm, kMilli * high_Nm, {}}, {-kMilli * high_Nm, -kMilli * low_Nm, {}}});
}

void JointPlot::setProvenance(base::Provenance provenance) {
    m_header->setBadge(base::provenanceText(provenance));
}

void JointPlot::arrange() {
    const auto px = [this](double count) { return static_cast<int>(std::lround(count * em())); };
    m_header->setMinimumSize(0, px(kHeaderHeight_em));
    m_header->setMaximumSize(QWIDGETSIZE_MAX, px(kHeaderHeight_em));
    m_header->setMargins(QMargins(px(0.5), 0, px(0.5), 0));
    const QFontMetricsF small(base::sized(font(), base::kSmallText));
    const int left = static_cast<int>(small.horizontalAdvance(QStringLiteral("\u2212888"))) + px(1.0);
    m_grid->setColumnSpacing(px(0.6));
    m_grid->setRowSpacing(m_anglesShown ? px(0.35) : 0);
    m_axisRoom->setMinimumSize(0, px(kAxisHeight_em));
    m_axisRoom->setMaximumSize(QWIDGETSIZE_MAX, px(kAxisHeight_em));
    for (std::size_t i = 0; i < m_parts.size(); ++i) {
        Part& part = m_parts[i];
        const bool shown = i < parts();
        part.rect->setMargins(QMargins(left, shown ? px(0.2) : 0, 0, 0));
        part.rect->setMinimumSize(0, 0);
        part.rect->setMaximumSize(QWIDGETSIZE_MAX, shown ? QWIDGETSIZE_MAX : 0);
        part.panel->setMargins(QMargins(0, shown ? px(0.2) : 0, px(0.5), 0));
        part.panel->setMinimumSize(px(kPanelWidth_em), 0);
        part.panel->setMaximumSize(px(kPanelWidth_em), shown ? QWIDGETSIZE_MAX : 0);
        part.rect->axis(QCPAxis::atBottom)->setTickLabels(i + 1 == parts());
    }
}

void JointPlot::setColours(const QPalette& palette) {
    m_colours = palette;
    const QColor ground = palette.color(QPalette::Base);
    const QColor text = palette.color(QPalette::Text);
    const QColor accent = palette.color(QPalette::Highlight);
    const QFont small = base::sized(font(), base::kSmallText);
    const bool dark = base::isDark(palette);
    setBackground(QBrush(ground));
    m_header->setInk(font(), base::mixed(text, ground, 0.2), base::statusColours(palette).simulated);
    QColor window = accent; // see-through: a touch goes on behind it
    window.setAlphaF(dark ? 0.30F : 0.16F);
    m_window->setInk(small, window, QPen(base::mixed(ground, accent, 0.8), 1.0, Qt::DashLine), text);
    m_touches->setInk(small, base::mixed(ground, text, dark ? 0.12 : 0.08),
                      QPen(base::mixed(ground, text, 0.45), 1.0), base::mixed(text, ground, 0.2));
    m_jumps->setPen(QPen(palette.color(QPalette::PlaceholderText), 1.0, Qt::DotLine));
    m_cursor->setPen(QPen(text, 1.0));
    m_cursor->setFont(small);
    for (Part& part : m_parts) {
        styleAxes(part.rect, font(), palette);
        part.panel->setInk(small, text, palette.color(QPalette::PlaceholderText));
        auto lines = part.panel->lines();
        for (std::size_t joint = 0; joint < part.graphs.size(); ++joint) {
            const QColor colour = base::identityColour(static_cast<int>(joint) + 1, dark);
            part.graphs[joint]->setPen(QPen(colour, 1.0));
            if (joint < lines.size())
                lines[joint].colour = colour;
        }
        part.panel->setLines(std::move(lines));
    }
    arrange();
}

void JointPlot::fill(std::size_t index, const SampleHistory& history, double end_s, double bucket_s) {
    Part& part = m_parts[index];
    std::optional<ValueRange> extent;
    for (std::size_t joint = 0; joint < core::kArmJoints; ++joint) {
        const auto range = makePolyline(history, index * core::kArmJoints + joint, end_s - m_span_s, end_s,
                                        bucket_s, 0.0, m_lines[joint]);
        for (PolylinePoint& point : m_lines[joint])
            point = {point.time_s - end_s, part.scale * point.value};
        if (!range)
            continue;
        const ValueRange shown{part.scale * range->low, part.scale * range->high};
        extent =
            extent ? ValueRange{std::min(extent->low, shown.low), std::max(extent->high, shown.high)} : shown;
    }
    if (extent) {
        if (index == 0) // the window stays in sight
            for (const Shade& window : m_window->shades())
                if (window.from >= 0.0)
                    extent = ValueRange{std::min(0.0, extent->low), std::max(window.to, extent->high)};
        part.range.update(extent->low, extent->high, end_s);
    }
    const double padding = kAxisPadding * (part.range.high() - part.range.low());
    const ValueRange axis{part.range.low() - padding, part.range.high() + padding};
    part.rect->axis(QCPAxis::atLeft)->setRange(axis.low, axis.high);
    part.rect->axis(QCPAxis::atBottom)->setRange(-m_span_s, 0.0);
    QVector<QCPGraphData> points;
    for (std::size_t joint = 0; joint < core::kArmJoints; ++joint) {
        cutPolyline(m_lines[joint], axis);
        points.resize(static_cast<qsizetype>(m_lines[joint].size()));
        std::ranges::transform(m_lines[joint], points.begin(),
                               [](const PolylinePoint& p) { return QCPGraphData(p.time_s, p.value); });
        part.graphs[joint]->data()->set(points, true);
    }
}

void JointPlot::showStretch(const SampleHistory& history, double end_s, double span_s) {
    m_span_s = span_s;
    const double bucket_s = span_s / std::max(1.0, width() * devicePixelRatioF());
    for (std::size_t index = 0; index < parts(); ++index)
        fill(index, history, end_s, bucket_s);
    std::vector<TimeLine> jumps;
    for (std::size_t i = std::max<std::size_t>(1, history.firstAt(end_s - span_s)); i < history.size(); ++i) {
        if (history.time_s(i) > end_s)
            break;
        if (history.breakBefore(i) == Break::jump)
            jumps.push_back({history.time_s(i) - end_s, {}});
    }
    m_jumps->setLines(std::move(jumps));
}

void JointPlot::showValues(const SampleHistory& history, std::optional<std::size_t> index, bool steady) {
    const bool dark = base::isDark(m_colours);
    for (std::size_t row = 0; row < m_parts.size(); ++row) {
        Part& part = m_parts[row];
        std::vector<ValuePanel::Line> lines;
        for (std::size_t joint = 0; joint < core::kArmJoints; ++joint) {
            std::optional<double> value;
            if (index)
                value = part.scale * history.value(row * core::kArmJoints + joint, *index);
            part.numbers[joint].update(value);
            const QString number = steady ? part.numbers[joint].text() : base::threeDigits(value);
            lines.push_back({base::identityColour(static_cast<int>(joint) + 1, dark), false, jointName(joint),
                             base::withUnit(number, part.unit)});
        }
        part.panel->setLines(std::move(lines));
    }
}

void JointPlot::setCursorLine(std::optional<double> time_s) {
    m_cursor->setLines(time_s ? std::vector<TimeLine>{{*time_s, {}}} : std::vector<TimeLine>{});
}

void JointPlot::repaintOverlay() {
    layer(QString::fromLatin1(kOverlay))->replot();
}

void JointPlot::forgetRanges() {
    for (Part& part : m_parts)
        part.range.reset();
}

QPicture JointPlot::onPaper() {
    const QPalette screen = m_colours;
    setColours(base::designedPalette(false));
    QPicture picture;
    QCPPainter painter;
    painter.begin(&picture);
    painter.setMode(QCPPainter::pmVectorized);
    toPainter(&painter, width(), height());
    painter.end();
    setColours(screen);
    return picture;
}

double JointPlot::timeAt(double x) const {
    return std::clamp(m_parts[0].rect->axis(QCPAxis::atBottom)->pixelToCoord(x), -m_span_s, 0.0);
}

double JointPlot::xOf(double time_s) const {
    return m_parts[0].rect->axis(QCPAxis::atBottom)->coordToPixel(time_s);
}

QRect JointPlot::plotRect(Row row) const {
    const auto index = static_cast<std::size_t>(row);
    return index < parts() ? m_parts[index].rect->rect() : QRect();
}

double JointPlot::yOfTorque(double torque_Nm) const {
    return m_parts[0].rect->axis(QCPAxis::atLeft)->coordToPixel(kMilli * torque_Nm);
}

const ValuePanel* JointPlot::panelOf(Row row) const {
    return m_parts[static_cast<std::size_t>(row)].panel;
}

QCPGraph* JointPlot::graphOf(Row row, std::size_t joint) const {
    return m_parts[static_cast<std::size_t>(row)].graphs[joint];
}

QSize JointPlot::minimumSizeHint() const {
    const double height = kHeaderHeight_em + kAxisHeight_em + kPartHeight_em * static_cast<double>(parts());
    return {static_cast<int>(28.0 * em()), static_cast<int>(height * em())};
}

QSize JointPlot::sizeHint() const {
    return {static_cast<int>(48.0 * em()), static_cast<int>(minimumSizeHint().height() * 1.3)};
}

} // namespace teleta::charts
