// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/pattern/timeline/timeline_view.h"

#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"
#include "widgets/pattern/document/pattern_names.h"
#include "widgets/pattern/timeline/timeline_menu.h"
#include "widgets/pattern/timeline/timeline_painter.h"

#include <QContextMenuEvent>
#include <QMenu>
#include <QPainter>
#include <QSignalBlocker>

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::pattern {

namespace {

constexpr double kMargin = 0.02; ///< of a pattern that is shown as a whole
constexpr double kShortestSpan_s = 0.01;
constexpr int kScrollSteps = 1'000'000;

} // namespace

TimelineView::TimelineView(PatternDocument* document, QWidget* parent)
    : SizedView(parent, {50, 26}, {20, 13})
    , m_document(document)
    , m_export(new base::FigureExport(this, [this] { return figure(); }))
    , m_overview(new PatternOverview(document, this))
    , m_reference(new PatternReference(document, this)) {
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::Base);
    setAttribute(Qt::WA_OpaquePaintEvent, false);
    m_scroll->setFocusPolicy(Qt::NoFocus);
    connect(m_scroll, &QScrollBar::valueChanged, this, [this](int value) {
        showSpan(longestSpan_s() * value / kScrollSteps - kMargin * m_document->pattern().duration_s,
                 m_span_s);
    });
    connect(m_document, &PatternDocument::patternChanged, this, [this] {
        m_playhead_s = std::min(m_playhead_s, m_document->pattern().duration_s);
        showSpan(m_begin_s, m_span_s);
        invalidate();
    });
    connect(m_document, &PatternDocument::patternOpened, this, [this] {
        m_grab = Grab::none;
        m_loop.reset();
        m_playhead_s = 0.0;
        zoomToFit();
        emit loopChanged();
    });
    connect(m_document, &PatternDocument::selectionChanged, this, &TimelineView::invalidate);
    connect(m_document, &PatternDocument::motorsChanged, this, &TimelineView::invalidate);
    connect(m_overview, &PatternOverview::changed, this, &TimelineView::invalidate);
    connect(m_reference, &PatternReference::changed, this, [this] {
        const auto& other = m_reference->pattern();
        m_compiledReference = other ? CompiledPattern(*other) : CompiledPattern();
        invalidate();
    });
    base::keepTranslated(this, &TimelineView::retranslate);
    base::onChange(this, &TimelineView::invalidate,
                   {QEvent::LanguageChange, QEvent::PaletteChange, QEvent::FontChange});
    zoomToFit();
}

void TimelineView::retranslate() {
    setAccessibleName(tr("Timeline of the pattern"));
    m_scroll->setAccessibleName(tr("Visible time"));
    setWhatsThis(tr(
        "<p>Six motors over time. The blue line is the commanded intensity of a motor, the thin one its "
        "predicted response; hatching shows where the motor cannot follow.</p><p>Double-click or <b>P</b>: "
        "add breakpoints. Drag: move, with <b>Alt</b> without the grid. Drag on the background, or with "
        "<b>Shift</b>: select. Double-click on a breakpoint or <b>Enter</b>: type its numbers. Arrow keys: "
        "move what is selected, with <b>Shift</b> farther in time and finer in intensity. <b>Page Up</b>, "
        "<b>Page Down</b>: lane; <b>,</b> and <b>.</b>: breakpoint, with <b>Shift</b> one more; <b>N</b>: "
        "object; <b>Insert</b>: a breakpoint at the playhead; <b>[</b> and <b>]</b>: begin and end of the "
        "loop, <b>\\</b>: none.</p><p><b>Ctrl</b> and wheel: zoom. <b>Shift</b> and wheel: scroll. On the "
        "ruler a drag moves the playhead and, with <b>Shift</b>, sets the loop.</p>"));
}

void TimelineView::invalidate() {
    m_layerValid = false;
    update();
}

TimelineGeometry TimelineView::geometryNow() const {
    return {QRectF(rect()).adjusted(0.0, 0.0, 0.0, -m_scroll->height()), font(), m_begin_s, m_span_s};
}

double TimelineView::longestSpan_s() const {
    return std::max(kShortestSpan_s, m_document->pattern().duration_s * (1.0 + 2.0 * kMargin));
}

void TimelineView::zoomToFit() {
    showSpan(-kMargin * m_document->pattern().duration_s, longestSpan_s());
}

void TimelineView::showSpan(double begin_s, double span_s) {
    const double longest_s = longestSpan_s();
    const double first_s = -kMargin * m_document->pattern().duration_s;
    const double span = std::clamp(span_s, kShortestSpan_s, longest_s);
    const double begin = std::clamp(begin_s, first_s, first_s + longest_s - span);
    if (begin != m_begin_s || span != m_span_s) {
        m_begin_s = begin;
        m_span_s = span;
        invalidate();
    }
    updateScrollBar();
}

void TimelineView::updateScrollBar() {
    const QSignalBlocker blocker(m_scroll);
    const double longest_s = longestSpan_s();
    const int page = static_cast<int>(std::lround(kScrollSteps * m_span_s / longest_s));
    m_scroll->setRange(0, kScrollSteps - page);
    m_scroll->setPageStep(std::max(1, page));
    m_scroll->setSingleStep(std::max(1, page / 20));
    m_scroll->setValue(static_cast<int>(
        std::lround(kScrollSteps * (m_begin_s + kMargin * m_document->pattern().duration_s) / longest_s)));
}

void TimelineView::zoomAround(double anchor_s, double factor) {
    const double span_s = std::clamp(m_span_s / factor, kShortestSpan_s, longestSpan_s());
    showSpan(anchor_s - (anchor_s - m_begin_s) * span_s / m_span_s, span_s);
}

void TimelineView::setPlayhead(double time_s) {
    const double limited_s = time_s > 0.0 ? std::min(time_s, m_document->pattern().duration_s) : 0.0;
    if (limited_s == m_playhead_s)
        return;
    const TimelineGeometry geometry = geometryNow();
    const auto strip = [&](double at_s) {
        const double x = geometry.xOf(at_s);
        if (x > -geometry.em && x < width() + geometry.em)
            update(QRectF(x - geometry.em, 0.0, 2.0 * geometry.em, height()).toAlignedRect());
    };
    strip(m_playhead_s);
    m_playhead_s = limited_s;
    strip(m_playhead_s);
    if (m_playhead_s < m_begin_s || m_playhead_s > m_begin_s + m_span_s)
        showSpan(m_playhead_s - 0.1 * m_span_s, m_span_s);
}

void TimelineView::movePlayhead(double time_s) {
    const double before_s = m_playhead_s;
    setPlayhead(time_s);
    if (m_playhead_s != before_s)
        emit playheadMoved(m_playhead_s);
}

void TimelineView::setLoop(std::optional<Span> loop) {
    if (loop) {
        const double duration_s = m_document->pattern().duration_s;
        loop->begin_s = std::clamp(loop->begin_s, 0.0, duration_s);
        loop->end_s = std::clamp(loop->end_s, 0.0, duration_s);
        if (!(loop->begin_s < loop->end_s))
            loop.reset();
    }
    m_loop = loop;
    invalidate();
    emit loopChanged();
}

void TimelineView::setPen(bool pen) {
    if (std::exchange(m_pen, pen) == pen)
        return;
    setCursor(pen ? Qt::CrossCursor : Qt::ArrowCursor);
    emit penChanged(pen);
}

void TimelineView::reveal(Span span) {
    const double length_s = std::max(span.end_s - span.begin_s, 0.0);
    if (span.begin_s >= m_begin_s && span.end_s <= m_begin_s + m_span_s)
        return;
    const double shown_s = std::max(m_span_s, 1.2 * length_s);
    showSpan(span.begin_s - 0.5 * (shown_s - length_s), shown_s);
}

void TimelineView::refreshCurves() {
    const Span span{m_begin_s, m_begin_s + m_span_s};
    const int columns = std::max(1, static_cast<int>(geometryNow().plot.width()));
    m_bands = {};
    m_referenceBands = {};
    const bool isLong = m_span_s > kLongestPrediction_s;
    if (isLong && m_overview->commanded()) {
        m_bands = bandsOf(*m_overview->commanded(), m_overview->predicted().get(), span, columns);
    } else {
        m_curves = sampleCurves(m_document->pattern(), m_document->compiled(), m_document->motors(), span,
                                2 * columns);
        if (isLong)
            m_bands = bandsOf(m_curves, span, columns);
    }
    const auto& other = m_reference->pattern();
    if (!other)
        return;
    if (!m_bands.empty() && m_reference->envelopes())
        m_referenceBands = bandsOf(*m_reference->envelopes(), nullptr, span, columns);
    m_referenceCurves =
        sampleCurves(*other, m_compiledReference, m_document->motors(), span, 2 * columns, false);
}

void TimelineView::paintEvent(QPaintEvent*) {
    const TimelineGeometry geometry = geometryNow();
    const qreal ratio = devicePixelRatioF();
    if (!m_layerValid || m_layer.size() != size() * ratio || m_layer.devicePixelRatio() != ratio) {
        refreshCurves();
        m_layer = QPixmap(size() * ratio);
        m_layer.setDevicePixelRatio(ratio);
        m_layer.fill(palette().color(QPalette::Base));
        TimelineContent content;
        content.pattern = &m_document->pattern();
        content.curves = &m_curves;
        content.bands = &m_bands;
        if (const auto& other = m_reference->pattern()) {
            content.reference = &m_referenceCurves;
            content.referenceBands = &m_referenceBands;
            content.referenceName = QString::fromStdString(other->name);
            content.comparison = m_reference->comparison() ? &*m_reference->comparison() : nullptr;
        }
        content.selection = &m_document->selection();
        content.loop = m_loop;
        content.currentLane = m_lane;
        const MotorProfiles& motors = m_document->motors();
        content.assumedMotors = std::any_of(motors.begin(), motors.end(),
                                            [](const MotorProfile& motor) { return motor.assumed; });
        QPainter painter(&m_layer);
        painter.setFont(font());
        m_drawnHandles = paintTimeline(painter, geometry, content, palette(), font());
        m_layerValid = true;
    }
    QPainter painter(this);
    painter.drawPixmap(QPointF(), m_layer);
    const QColor accent = palette().color(QPalette::Highlight);
    if (m_grab == Grab::box && m_moved) {
        painter.setPen(QPen(accent, 1.0));
        painter.setBrush(base::translucent(accent, 0.15F));
        painter.drawRect(QRectF(m_press, m_now).normalized().intersected(geometry.plot));
    }
    paintPlayhead(painter, geometry, m_playhead_s, palette());
    base::paintFocusFrame(painter, *this);
}

void TimelineView::resizeEvent(QResizeEvent* event) {
    const int thick = m_scroll->sizeHint().height();
    m_scroll->setGeometry(0, height() - thick, width(), thick);
    updateScrollBar();
    invalidate();
    QWidget::resizeEvent(event);
}

base::Figure TimelineView::figure() const {
    base::Figure figure;
    figure.name = m_document->pattern().name.empty() ? tr("pattern") : displayName(m_document->pattern());
    figure.size_px = QSizeF(width(), height() - m_scroll->height());
    const double begin_s = m_begin_s;
    const double span_s = m_span_s;
    const QFont used = font();
    const Pattern copy = m_document->pattern();
    const int samples = 2 * std::max(2, width());
    TimelineCurves curves = sampleCurves(copy, m_document->compiled(), m_document->motors(),
                                         {begin_s, begin_s + span_s}, samples);
    figure.csv = [curves] {
        QString csv = QStringLiteral("time_s,t1,t2,t3,t4,t5,t6");
        if (curves.hasPrediction())
            csv += QStringLiteral(",predicted1,predicted2,predicted3,predicted4,predicted5,predicted6");
        csv += QLatin1Char('\n');
        for (std::size_t k = 0; k < curves.times_s.size(); ++k) {
            csv += QString::number(curves.times_s[k], 'g', 9);
            for (const auto& values : curves.commanded)
                csv += QLatin1Char(',') + QString::number(values[k], 'g', 6);
            if (curves.hasPrediction())
                for (const auto& values : curves.predicted)
                    csv += QLatin1Char(',') + QString::number(values[k], 'g', 6);
            csv += QLatin1Char('\n');
        }
        return csv;
    };
    figure.paint = [copy, curves = std::move(curves), bands = m_bands, begin_s, span_s, used,
                    size = figure.size_px](QPainter& painter) {
        painter.setFont(used);
        const TimelineContent content{.pattern = &copy, .curves = &curves, .bands = &bands};
        (void)paintTimeline(painter, {QRectF(QPointF(), size), used, begin_s, span_s}, content,
                            base::designedPalette(false), used);
    };
    return figure;
}

void TimelineView::populateMenu(QMenu& menu, std::optional<QPointF> at) {
    fillTimelineMenu(menu, *m_document, m_playhead_s);
    const PointRefs& chosen = m_document->selection().points;
    if (chosen.size() == 1)
        menu.addAction(tr("&Type numbers…"), this, [this, point = chosen.front()] { editPoint(point); });
    const TimelineGeometry geometry = geometryNow();
    if (at && geometry.plot.contains(*at) && !pointAt(*at)) {
        const std::size_t lane = *geometry.laneAt(at->y());
        const Breakpoint point{m_document->snapped(geometry.timeAt(at->x())),
                               geometry.intensityAt(lane, at->y())};
        menu.addAction(tr("Add &breakpoint here"), this,
                       [this, lane, point] { m_document->addPoint(lane, point); });
    }
    menu.addSeparator();
    menu.addAction(tr("&Zoom to fit"), this, &TimelineView::zoomToFit);
    if (m_loop)
        menu.addAction(tr("Clear &loop"), this, [this] { setLoop(std::nullopt); });
    menu.addSeparator();
    m_export->addActions(menu);
}

void TimelineView::contextMenuEvent(QContextMenuEvent* event) {
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    const QPointF at = event->pos();
    const auto point = pointAt(at);
    const PointRefs& chosen = m_document->selection().points;
    if (point && std::find(chosen.begin(), chosen.end(), *point) == chosen.end())
        m_document->select({{*point}, {}});
    else if (const auto object = objectAt(at); object && !point && chosen.empty())
        m_document->select({{}, *object});
    populateMenu(*menu, event->reason() == QContextMenuEvent::Mouse ? std::optional(at) : std::nullopt);
    menu->popup(event->globalPos());
}

} // namespace teleta::pattern
