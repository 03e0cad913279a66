// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/signal/signal_plot.h"

#include "widgets/base/colour_maps.h"
#include "widgets/base/controls/provenance_stripe.h"
#include "widgets/base/numbers/unit_title.h"
#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"
#include "widgets/plot/plot_style.h"
#include "widgets/signal/step_ticker.h"
#include "widgets/signal/unit_text.h"

#include <qcustomplot.h>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QRubberBand>
#include <QVBoxLayout>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace teleta::signal {

namespace {

constexpr char kCursorLayer[] = "cursors";
constexpr double kZoomStep = 1.25;
constexpr double kScrollShare = 0.1; ///< of the span, a key or a notch
constexpr double kLine_px = 1.5;
constexpr double kReach_px = 6.0;
constexpr double kLongestSpan_s = 1e9; ///< clock times of recordings may be years apart
/// Samples are marked where they are at least so far apart.
constexpr double kMarked_px = 8.0;
/// Power that is drawn at least, below the largest.
constexpr double kSpectrumFloor = 1e-6;

} // namespace

SignalPlot::SignalPlot(QWidget* parent)
    : SizedView(parent, {48, 28}, {20, 10})
    , m_plot(new QCustomPlot(this))
    , m_export(new base::FigureExport(this, [this] { return figure(); }))
    , m_axes(m_plot->axisRect())
    , m_band(new QRubberBand(QRubberBand::Rectangle, m_plot)) {
    setFocusPolicy(Qt::StrongFocus);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_plot);
    m_plot->setFocusPolicy(Qt::NoFocus);
    m_plot->setFocusProxy(this);
    m_plot->setMouseTracking(true);
    m_plot->setPlottingHint(QCP::phFastPolylines);
    m_plot->installEventFilter(this);
    m_plot->addLayer(QLatin1String(kCursorLayer));
    m_plot->layer(QLatin1String(kCursorLayer))->setMode(QCPLayer::lmBuffered);
    for (std::size_t i = 0; i < m_lines.size(); ++i) {
        m_lines[i] = new QCPItemStraightLine(m_plot);
        m_letters[i] = new QCPItemText(m_plot);
        m_letters[i]->setText(i == 0 ? QStringLiteral("A") : QStringLiteral("B"));
        for (QCPAbstractItem* item :
             {static_cast<QCPAbstractItem*>(m_lines[i]), static_cast<QCPAbstractItem*>(m_letters[i])}) {
            item->setLayer(QLatin1String(kCursorLayer));
            item->setVisible(false);
        }
        for (QCPItemPosition* place : {m_lines[i]->point1, m_lines[i]->point2, m_letters[i]->position}) {
            place->setAxisRect(m_plot->axisRect());
            place->setTypeX(QCPItemPosition::ptPlotCoords);
            place->setTypeY(QCPItemPosition::ptAxisRectRatio);
        }
        m_letters[i]->setPositionAlignment(Qt::AlignTop | Qt::AlignHCenter);
        m_letters[i]->setPadding(QMargins(4, 0, 4, 0));
    }
    connect(m_export, &base::FigureExport::failed, this, &SignalPlot::exportFailed);
    base::onChange(this, [this] { restyle(palette()); },
                   {QEvent::PaletteChange, QEvent::FontChange, QEvent::LanguageChange});
    restyle(palette());
}

void SignalPlot::setCurves(std::vector<PlotCurve> curves) {
    m_curves = std::move(curves);
    arrange();
}

void SignalPlot::setProvenance(base::Provenance provenance) {
    m_provenance = provenance;
    base::showProvenance(this, provenance);
}

void SignalPlot::setDensity(bool density) {
    m_density = density;
    drawSpectra();
    m_dirty = true;
}

/// Makes axes and graphs for the curves.
void SignalPlot::arrange() {
    m_plot->clearGraphs();
    m_graphs.clear();
    std::vector<QString> units;
    for (const PlotCurve& curve : m_curves)
        if (std::ranges::find(units, curve.unit) == units.end())
            units.push_back(curve.unit);
    m_axes.setUnits(units);
    for (const PlotCurve& curve : m_curves) {
        QCPGraph* graph = m_plot->addGraph(m_plot->xAxis, m_axes.axisOf(curve.unit));
        const QColor colour = base::identityColour(curve.colour, base::isDark(m_colours));
        graph->setPen(QPen(colour, kLine_px));
        graph->setAdaptiveSampling(false); // the series has done that
        if (curve.events)
            graph->setLineStyle(QCPGraph::lsNone);
        m_graphs.push_back(graph);
    }
    drawSpectra();
    m_dirty = true;
}

void SignalPlot::setClockTime(bool clock) {
    if (std::exchange(m_clock, clock) == clock)
        return;
    styleTime();
    m_dirty = true;
}

void SignalPlot::styleTime() {
    if (m_clock)
        m_plot->xAxis->setTicker(QSharedPointer<QCPAxisTicker>(new ClockTicker));
    else
        m_plot->xAxis->setTicker(QSharedPointer<QCPAxisTicker>(new StepTicker));
    m_plot->xAxis->setLabel(
        m_clock ? tr("clock time")
                : base::titleWithUnit(tr("time since the start of each source"), QStringLiteral("s")));
}

std::optional<ValueRange> SignalPlot::extent_s(bool growing) const {
    std::optional<ValueRange> extent;
    for (const PlotCurve& curve : m_curves) {
        if (!curve.series || curve.series->empty() || (growing && !curve.grows))
            continue;
        const double first_s = curve.shift_s + curve.series->time_s(0);
        const double last_s = curve.shift_s + curve.series->time_s(curve.series->size() - 1);
        if (!extent)
            extent = ValueRange{first_s, last_s};
        extent->low = std::min(extent->low, first_s);
        extent->high = std::max(extent->high, last_s);
    }
    return extent;
}

std::uint64_t SignalPlot::appended() const {
    std::uint64_t sum = 0;
    for (const PlotCurve& curve : m_curves)
        sum += curve.series ? curve.series->appended() : 0;
    return sum;
}

void SignalPlot::refresh() {
    const std::uint64_t now = appended();
    if (std::exchange(m_drawn, now) != now)
        m_dirty = true;
    if (!m_dirty || !isVisible())
        return;
    m_dirty = false;
    const auto growing = extent_s(true);
    const auto extent = growing ? growing : extent_s();
    if (m_following && extent && extent->high != m_to_s) {
        const double span = span_s();
        m_to_s = extent->high;
        m_from_s = m_to_s - span;
    }
    draw();
}

void SignalPlot::draw() {
    const double width_px = std::max(1, m_plot->axisRect()->width());
    m_plot->xAxis->setRange(m_from_s, m_to_s);
    std::map<QString, std::optional<ValueRange>> values;
    for (std::size_t i = 0; i < m_curves.size(); ++i) {
        const PlotCurve& curve = m_curves[i];
        if (!curve.series)
            continue;
        const auto range =
            curve.series->line(m_from_s - curve.shift_s, m_to_s - curve.shift_s, span_s() / width_px, m_line);
        QVector<QCPGraphData> points;
        points.reserve(static_cast<qsizetype>(m_line.size()));
        for (const Sample& sample : m_line)
            points.append(QCPGraphData(curve.shift_s + sample.time_s, sample.value));
        // Strokes that cross each other in every column take seconds when they are smooth and wide.
        const bool dense = static_cast<double>(m_line.size()) > width_px;
        m_graphs[i]->setAntialiased(!dense);
        m_graphs[i]->setPen(QPen(m_graphs[i]->pen().color(), dense ? 1.0 : kLine_px));
        const bool marked = curve.events || static_cast<double>(m_line.size()) * kMarked_px < width_px;
        m_graphs[i]->setScatterStyle(marked ? QCPScatterStyle(QCPScatterStyle::ssDisc, 5.0)
                                            : QCPScatterStyle(QCPScatterStyle::ssNone));
        m_graphs[i]->data()->set(points, true);
        std::optional<ValueRange>& all = values[curve.unit];
        if (range)
            all = all ? ValueRange{std::min(all->low, range->low), std::max(all->high, range->high)} : *range;
    }
    for (const auto& [unit, range] : values)
        m_axes.fit(unit, range, m_to_s, m_following);
    drawCursors();
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void SignalPlot::drawSpectra() {
    const bool any =
        std::ranges::any_of(m_curves, [](const PlotCurve& each) { return each.spectrum != nullptr; });
    if (!any) {
        if (m_spectrumRect != nullptr) {
            m_plot->plotLayout()->remove(std::exchange(m_spectrumRect, nullptr));
            m_plot->plotLayout()->simplify();
        }
        return;
    }
    if (m_spectrumRect == nullptr) {
        m_spectrumRect = new QCPAxisRect(m_plot, /*setupDefaultAxes=*/false);
        m_spectrumRect->addAxes(QCPAxis::atBottom | QCPAxis::atLeft);
        m_plot->plotLayout()->addElement(1, 0, m_spectrumRect);
        m_plot->plotLayout()->setRowStretchFactor(1, 0.7);
        m_spectrumRect->axis(QCPAxis::atBottom)->setTicker(QSharedPointer<QCPAxisTicker>(new StepTicker));
        m_spectrumRect->axis(QCPAxis::atLeft)->setScaleType(QCPAxis::stLogarithmic);
        m_spectrumRect->axis(QCPAxis::atLeft)->setTicker(QSharedPointer<QCPAxisTicker>(new QCPAxisTickerLog));
        m_spectrumRect->axis(QCPAxis::atLeft)->setNumberFormat(QStringLiteral("eb"));
        m_spectrumRect->axis(QCPAxis::atLeft)->setNumberPrecision(0);
    }
    QCPAxis* frequency = m_spectrumRect->axis(QCPAxis::atBottom);
    QCPAxis* size = m_spectrumRect->axis(QCPAxis::atLeft);
    plot::styleAxis(*frequency, m_colours, font());
    plot::styleAxis(*size, m_colours, font());
    while (m_plot->graphCount() > static_cast<int>(m_graphs.size()))
        m_plot->removeGraph(m_plot->graphCount() - 1);
    double highest = 0.0, lowest = std::numeric_limits<double>::infinity(), fastest_Hz = 0.0;
    QString unit;
    bool sameUnit = true, isFirst = true;
    for (const PlotCurve& curve : m_curves) {
        if (!curve.spectrum)
            continue;
        sameUnit = sameUnit && (isFirst || curve.unit == unit);
        unit = curve.unit;
        isFirst = false;
        QCPGraph* graph = m_plot->addGraph(frequency, size);
        graph->setPen(QPen(base::identityColour(curve.colour, base::isDark(m_colours)), 1.0));
        graph->setAntialiased(false);
        const Spectrum& spectrum = *curve.spectrum;
        const std::vector<double>& values = m_density ? spectrum.density : spectrum.amplitude;
        // The mean is taken away: the first frequency says nothing.
        for (std::size_t bin = 1; bin < values.size(); ++bin) {
            graph->addData(spectrum.frequency_Hz[bin], values[bin]);
            highest = std::max(highest, values[bin]);
            lowest = values[bin] > 0.0 ? std::min(lowest, values[bin]) : lowest;
        }
        fastest_Hz = std::max(fastest_Hz, spectrum.frequency_Hz.back());
    }
    frequency->setLabel(base::titleWithUnit(tr("frequency"), QStringLiteral("Hz")));
    const QString shown = sameUnit ? unitText(unit) : tr("units");
    size->setLabel(
        m_density ? tr("power density ((%1)\u00b2/Hz)").arg(shown.isEmpty() ? QStringLiteral("1") : shown)
        : shown.isEmpty() ? tr("amplitude")
                          : tr("amplitude (%1)").arg(shown));
    frequency->setRange(0.0, fastest_Hz > 0.0 ? fastest_Hz : 1.0);
    const double floor = highest * (m_density ? kSpectrumFloor * kSpectrumFloor : kSpectrumFloor);
    size->setRange(highest > 0.0 ? std::max(floor, 0.5 * lowest) : 1e-6, highest > 0.0 ? 2.0 * highest : 1.0);
}

void SignalPlot::drawCursors() {
    for (std::size_t i = 0; i < m_lines.size(); ++i) {
        m_lines[i]->setVisible(m_cursors.has_value());
        m_letters[i]->setVisible(m_cursors.has_value());
        if (!m_cursors)
            continue;
        const double time_s = (*m_cursors)[i];
        m_lines[i]->point1->setCoords(time_s, 0.0);
        m_lines[i]->point2->setCoords(time_s, 1.0);
        m_letters[i]->position->setCoords(time_s, 0.0);
        const bool inView = time_s >= m_from_s && time_s <= m_to_s;
        m_lines[i]->setVisible(inView);
        m_letters[i]->setVisible(inView);
    }
}

void SignalPlot::showCursors() {
    drawCursors();
    m_plot->layer(QLatin1String(kCursorLayer))->replot();
    emit cursorsChanged();
}

void SignalPlot::setRange(double from_s, double to_s) {
    const double middle_s = 0.5 * (from_s + to_s);
    const double half_s = 0.5 * std::clamp(to_s - from_s, kShortestSpan_s, kLongestSpan_s);
    m_from_s = middle_s - half_s;
    m_to_s = middle_s + half_s;
    m_dirty = true;
    if (std::exchange(m_following, false))
        emit followingChanged(false);
}

void SignalPlot::setFollowing(bool following) {
    m_dirty = true;
    if (std::exchange(m_following, following) != following)
        emit followingChanged(following);
}

void SignalPlot::showEverything() {
    m_axes.followValues();
    const auto extent = extent_s();
    if (extent && extent->high > extent->low)
        setRange(extent->low, extent->high);
    m_dirty = true;
}

void SignalPlot::zoomBy(double factor, double at_s) {
    if (m_following) {
        // The newest sample stays at the right end.
        m_from_s = m_to_s - std::clamp(factor * span_s(), kShortestSpan_s, kLongestSpan_s);
        m_dirty = true;
        return;
    }
    setRange(at_s + factor * (m_from_s - at_s), at_s + factor * (m_to_s - at_s));
}

void SignalPlot::setCursors(bool shown) {
    if (shown == hasCursors())
        return;
    m_cursors = shown ? std::optional(std::array{m_from_s + 0.35 * span_s(), m_from_s + 0.65 * span_s()})
                      : std::nullopt;
    if (shown)
        setFollowing(false);
    showCursors();
}

void SignalPlot::moveCursor(int cursor, double time_s) {
    if (!m_cursors)
        setCursors(true);
    (*m_cursors)[static_cast<std::size_t>(cursor)] = time_s;
    showCursors();
}

double SignalPlot::timeAt(double x) const {
    return m_plot->xAxis->pixelToCoord(x);
}

double SignalPlot::xOf(double time_s) const {
    return m_plot->mapToParent(QPointF(m_plot->xAxis->coordToPixel(time_s), 0.0)).x();
}

std::optional<int> SignalPlot::cursorAt(const QPointF& point) const {
    if (!m_cursors || !m_plot->axisRect()->rect().contains(point.toPoint()))
        return std::nullopt;
    std::optional<int> found;
    double nearest = kReach_px;
    for (int i = 0; i < 2; ++i) {
        const double distance =
            std::abs(m_plot->xAxis->coordToPixel((*m_cursors)[static_cast<std::size_t>(i)]) - point.x());
        if (distance <= nearest) {
            nearest = distance;
            found = i;
        }
    }
    return found;
}

bool SignalPlot::eventFilter(QObject* watched, QEvent* event) {
    if (watched != m_plot)
        return SizedView::eventFilter(watched, event);
    switch (event->type()) {
    case QEvent::MouseButtonPress:
        setFocus(Qt::MouseFocusReason);
        onPress(*static_cast<QMouseEvent*>(event));
        return true;
    case QEvent::MouseMove:
        onMove(*static_cast<QMouseEvent*>(event));
        return true;
    case QEvent::MouseButtonRelease:
        onRelease(*static_cast<QMouseEvent*>(event));
        return true;
    case QEvent::MouseButtonDblClick:
        showEverything();
        return true;
    case QEvent::Wheel:
        onWheel(*static_cast<QWheelEvent*>(event));
        event->accept();
        return true;
    case QEvent::ContextMenu:
        emit menuRequested(static_cast<QContextMenuEvent*>(event)->globalPos());
        return true;
    case QEvent::Resize:
        m_dirty = true;
        return false;
    default:
        return SizedView::eventFilter(watched, event);
    }
}

void SignalPlot::onPress(const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton)
        return;
    m_dragFrom = event.position();
    m_dragFrom_s = m_from_s;
    if (event.modifiers() & Qt::ControlModifier) {
        m_drag = Drag::rectangle;
        m_band->setGeometry(QRect(m_dragFrom.toPoint(), QSize()));
        m_band->show();
    } else if (const auto cursor = cursorAt(m_dragFrom)) {
        m_drag = Drag::cursor;
        m_dragged = *cursor;
    } else {
        m_drag = Drag::scroll;
    }
}

void SignalPlot::onMove(const QMouseEvent& event) {
    const QPointF point = event.position();
    switch (m_drag) {
    case Drag::none:
        m_plot->setCursor(cursorAt(point) ? Qt::SplitHCursor : Qt::ArrowCursor);
        break;
    case Drag::scroll: {
        const double moved_s =
            span_s() * (m_dragFrom.x() - point.x()) / std::max(1, m_plot->axisRect()->width());
        if (point.x() != m_dragFrom.x())
            setRange(m_dragFrom_s + moved_s, m_dragFrom_s + moved_s + span_s());
        break;
    }
    case Drag::rectangle:
        m_band->setGeometry(QRect(m_dragFrom.toPoint(), point.toPoint()).normalized());
        break;
    case Drag::cursor:
        moveCursor(m_dragged, timeAt(point.x()));
        break;
    }
}

void SignalPlot::onRelease(const QMouseEvent& event) {
    if (std::exchange(m_drag, Drag::none) != Drag::rectangle)
        return;
    m_band->hide();
    const QRectF inside = m_plot->axisRect()->rect();
    const QRectF chosen = QRectF(m_dragFrom, event.position()).normalized().intersected(inside);
    if (chosen.width() < kReach_px || chosen.height() < kReach_px)
        return;
    m_axes.zoomTo((inside.bottom() - chosen.bottom()) / inside.height(),
                  (inside.bottom() - chosen.top()) / inside.height());
    setRange(timeAt(chosen.left()), timeAt(chosen.right()));
}

void SignalPlot::onWheel(const QWheelEvent& event) {
    // With a key pressed some desktops turn the wheel sideways.
    const double notches = (event.angleDelta().x() + event.angleDelta().y()) / 120.0;
    const double factor = std::pow(kZoomStep, -notches);
    if (event.modifiers() & Qt::ShiftModifier)
        setRange(m_from_s - kScrollShare * notches * span_s(), m_to_s - kScrollShare * notches * span_s());
    else if (QCPAxis* axis = m_axes.at(event.position())) {
        m_axes.zoomAt(axis, factor, event.position().y());
        m_dirty = true;
    } else {
        zoomBy(factor, timeAt(event.position().x()));
    }
}

void SignalPlot::keyPressEvent(QKeyEvent* event) {
    const auto modifiers = event->modifiers();
    const int direction = event->key() == Qt::Key_Left ? -1 : 1;
    switch (event->key()) {
    case Qt::Key_Space:
        setFollowing(!m_following);
        return;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        zoomBy(1.0 / kZoomStep, 0.5 * (m_from_s + m_to_s));
        return;
    case Qt::Key_Minus:
        zoomBy(kZoomStep, 0.5 * (m_from_s + m_to_s));
        return;
    case Qt::Key_Home:
        showEverything();
        return;
    case Qt::Key_End:
        setFollowing(true);
        return;
    case Qt::Key_Left:
    case Qt::Key_Right:
        if (modifiers & Qt::ShiftModifier) {
            const double moved_s = direction * kScrollShare * span_s();
            setRange(m_from_s + moved_s, m_to_s + moved_s);
        } else {
            const int cursor = modifiers & Qt::ControlModifier ? 1 : 0;
            if (!m_cursors)
                setCursors(true);
            const double pixel_s = span_s() / std::max(1, m_plot->axisRect()->width());
            moveCursor(cursor, (*m_cursors)[static_cast<std::size_t>(cursor)] + direction * pixel_s);
        }
        return;
    case Qt::Key_C:
        if (modifiers & Qt::ControlModifier)
            base::copyPicture(figure());
        else
            setCursors(!hasCursors());
        return;
    default:
        SizedView::keyPressEvent(event);
    }
}

void SignalPlot::restyle(const QPalette& colours) {
    m_colours = colours;
    plot::stylePlot(*m_plot, colours, font());
    m_plot->setLocale(locale());
    styleTime();
    m_plot->xAxis->setSubTickPen(Qt::NoPen);
    m_axes.restyle(colours, font());
    const QColor accent = colours.color(QPalette::Highlight);
    for (std::size_t i = 0; i < m_lines.size(); ++i) {
        m_lines[i]->setPen(QPen(accent, 1.5, i == 0 ? Qt::SolidLine : Qt::DashLine));
        m_letters[i]->setBrush(accent);
        m_letters[i]->setColor(base::readableOn(accent));
        m_letters[i]->setFont(base::bold(font()));
    }
    setAccessibleName(tr("Signals over time"));
    arrange();
}

base::Figure SignalPlot::figure() {
    base::Figure figure;
    figure.name = tr("plot", "name of a file");
    figure.size_px = m_plot->size();
    restyle(base::designedPalette(false)); // for paper
    draw();
    const QPicture picture = plot::pictureOf(*m_plot);
    restyle(palette());
    draw();
    figure.paint = [picture](QPainter& painter) { painter.drawPicture(0, 0, picture); };
    if (m_provenance == base::Provenance::live)
        return figure;
    // Above the picture, where no curve runs.
    const QSizeF badge = base::badgeSize(font(), base::provenanceText(m_provenance));
    const double line_px = 1.25 * badge.height();
    const QRectF line(0.0, 0.0, figure.size_px.width(), line_px);
    figure.size_px += QSizeF(0.0, line_px);
    figure.paint = [picture, line, provenance = m_provenance, font = font()](QPainter& painter) {
        painter.setFont(font);
        base::paintProvenance(painter, line, provenance, base::designedPalette(false), 0.0);
        painter.drawPicture(QPointF(0.0, line.bottom()), picture);
    };
    return figure;
}

} // namespace teleta::signal
