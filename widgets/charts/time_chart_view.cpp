// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/charts/time_chart_view.h"

#include "widgets/base/controls/inline_edit.h"
#include "widgets/base/controls/provenance_stripe.h"
#include "widgets/base/icons.h"
#include "widgets/base/numbers/number_format.h"
#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"
#include "widgets/charts/time_plot.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <QRegularExpression>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace teleta::charts {

namespace {

constexpr double kZoomStep = 1.25;
constexpr double kScrollStep = 0.1; ///< of the span, for one notch or key
constexpr double kCursorStep = 0.01;
constexpr double kLeastScroll_px = 2.0; ///< less is hardly seen, and takes as long to draw

} // namespace

TimeChartView::TimeChartView(TimePlot* plot, double shortestSpan_s, QWidget* parent)
    : FigureView(parent)
    , m_plot(plot)
    , m_empty(new QLabel(plot))
    , m_pause(new QAction(base::themeIcon(base::Icon::pause), {}, this))
    , m_shortestSpan_s(shortestSpan_s) {
    m_plot->setParent(this);
    m_plot->installEventFilter(this);
    m_plot->setMouseTracking(true);
    m_empty->setAlignment(Qt::AlignCenter);
    m_empty->setWordWrap(true);
    m_empty->setAttribute(Qt::WA_TransparentForMouseEvents);
    makeActions();

    auto* bar = new QWidget(this);
    bar->setAutoFillBackground(true);
    m_tools = new QHBoxLayout(bar);
    m_tools->setContentsMargins(base::grid(this, 0.5), 0, base::grid(this, 0.5), 0);
    m_tools->setSpacing(base::grid(this, 0.25));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(1, 1, 1, 1);
    layout->setSpacing(0);
    layout->addWidget(bar);
    layout->addWidget(m_plot, 1);
    base::onChange(this,
                   [this] {
                       retranslate();
                       setProvenance(m_provenance); // translates its badge
                       refresh();
                   },
                   {QEvent::LanguageChange});
    base::onChange(this, &TimeChartView::restyle, {QEvent::PaletteChange, QEvent::FontChange});
}

void TimeChartView::makeActions() {
    m_spanGroup->setExclusionPolicy(QActionGroup::ExclusionPolicy::ExclusiveOptional);
    for (std::size_t i = 0; i < kSpans_s.size(); ++i) {
        auto* action = new QAction(m_spanGroup);
        action->setCheckable(true);
        action->setChecked(kSpans_s[i] == m_span_s);
        connect(action, &QAction::triggered, this, [this, i] {
            m_spanActions[i]->setChecked(true); // a second click must not uncheck it
            setSpan(kSpans_s[i]);
        });
        m_spanActions[i] = action;
    }
    m_pause->setObjectName(QStringLiteral("pause"));
    m_pause->setCheckable(true);
    connect(m_pause, &QAction::toggled, this, &TimeChartView::setPaused);
}

QToolButton* TimeChartView::addTool(QAction* action) {
    auto* button = new QToolButton(m_tools->parentWidget());
    button->setAutoRaise(true);
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    if (action)
        button->setDefaultAction(action);
    m_tools->addWidget(button);
    return button;
}

void TimeChartView::addTimeTools() {
    m_tools->addStretch(1);
    for (QAction* action : m_spanActions)
        addTool(action)->setToolButtonStyle(Qt::ToolButtonIconOnly);
    m_tools->addSpacing(base::grid(this));
    addTool(m_pause);
}

QList<QToolButton*> TimeChartView::namedTools() const {
    QList<QToolButton*> tools = m_tools->parentWidget()->findChildren<QToolButton*>();
    tools.removeIf([](const QToolButton* tool) { return tool->icon().isNull() || tool->menu() != nullptr; });
    return tools;
}

int TimeChartView::toolsWidth(bool named) const {
    int width = m_tools->minimumSize().width();
    for (const QToolButton* tool : namedTools()) {
        const bool isNamed = tool->toolButtonStyle() != Qt::ToolButtonIconOnly;
        // As Qt makes room for it.
        const int name =
            QFontMetrics(tool->font()).horizontalAdvance(tool->text() + QStringLiteral("  ")) + 4;
        width += (named ? name : 0) - (isNamed ? name : 0);
    }
    return width;
}

void TimeChartView::fitTools() {
    const bool named = toolsWidth(true) <= m_tools->parentWidget()->width();
    for (QToolButton* tool : namedTools())
        tool->setToolButtonStyle(named ? Qt::ToolButtonTextBesideIcon : Qt::ToolButtonIconOnly);
}

QSize TimeChartView::minimumSizeHint() const {
    const QSize least = FigureView::minimumSizeHint();
    const int frame = 2;
    return {std::max(m_plot->minimumSizeHint().width(), toolsWidth(false)) + frame, least.height()};
}

void TimeChartView::addTimeActions(QMenu& menu) {
    menu.addMenu(tr("S&pan"))->addActions(m_spanGroup->actions());
    menu.addAction(m_pause);
}

void TimeChartView::addRangeActions(QMenu& menu, const QPoint& position) {
    const auto lane = m_plot->laneAt(m_plot->mapFromParent(position));
    if (!lane)
        return;
    menu.addSeparator();
    menu.addAction(tr("&Type range of %1…").arg(m_plot->laneTitle(*lane)), this,
                   [this, lane] { editRange(*lane); });
    QAction* automatic =
        menu.addAction(tr("&Automatic range"), this, [this, lane] { applyRangeText(*lane, {}); });
    automatic->setCheckable(true);
    automatic->setChecked(!m_plot->fixedLaneRange(*lane));
}

void TimeChartView::retranslate() {
    for (std::size_t i = 0; i < kSpans_s.size(); ++i) {
        m_spanActions[i]->setText(tr("%1 s").arg(kSpans_s[i]));
        m_spanActions[i]->setToolTip(tr("Show %1 s (Ctrl+wheel for other spans)").arg(kSpans_s[i]));
    }
    m_pause->setToolTip(tr("Freeze the chart; samples are still collected (Space)"));
    showPause();
    fitTools();
    invalidate();
}

void TimeChartView::showPause() {
    m_pause->setText(isPaused() ? tr("Go live") : tr("Pause"));
    m_pause->setIcon(base::themeIcon(isPaused() ? base::Icon::play : base::Icon::pause));
}

void TimeChartView::restyle() {
    m_plot->setFont(font());
    m_plot->setColours(palette());
    base::setTextColour(m_empty, palette().color(QPalette::PlaceholderText));
    invalidate();
    refresh();
}

void TimeChartView::reset() {
    m_cursor_s.reset();
    m_keyboardCursor_s.reset();
    m_plot->forgetRanges();
    setPaused(false);
    invalidate();
    refresh();
}

void TimeChartView::refresh() {
    const std::uint64_t appended = history().appended();
    const bool standsStill = std::exchange(m_seen, appended) == appended;
    const bool news = appended != m_drawn && !isPaused() && (standsStill || hasScrolled());
    if (!news && !m_dirty)
        return;
    draw();
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

bool TimeChartView::hasScrolled() const {
    const double scroll_s = std::abs(history().newestTime_s() - m_drawnTime_s);
    return scroll_s * m_plot->width() >= kLeastScroll_px * m_span_s;
}

void TimeChartView::draw() {
    m_drawn = history().appended();
    m_drawnTime_s = history().empty() ? -std::numeric_limits<double>::infinity() : history().newestTime_s();
    m_dirty = false;
    prepareExtras();
    m_plot->showStretch(history(), end_s(), m_span_s);
    drawCursor();
    m_empty->setVisible(history().empty());
    m_empty->setGeometry(m_plot->rect());
}

std::optional<std::size_t> TimeChartView::shownSample() const {
    if (history().empty())
        return std::nullopt;
    return history().nearest(end_s() + m_cursor_s.value_or(0.0));
}

void TimeChartView::drawCursor() {
    m_plot->setCursorLine(m_cursor_s);
    m_plot->showValues(history(), shownSample(), !m_cursor_s && !isPaused());
    updateHeader();
}

void TimeChartView::updateHeader() {
    const auto seconds = [](double value) { return base::threeDigits(value).remove(QChar(0x2007)); };
    QString text;
    if (m_cursor_s) {
        const auto sample = shownSample();
        text = sample ? cursorText(seconds(*m_cursor_s),
                                   QLocale().toString(history().sourceTime_s(*sample), 'f', 3))
                      : tr("at %1 s   no sample").arg(seconds(*m_cursor_s));
    } else {
        text = tr("last %1 s").arg(seconds(m_span_s));
    }
    if (isPaused())
        text = tr("PAUSED, %1 s behind   %2").arg(seconds(history().newestTime_s() - end_s()), text);
    m_plot->setHeaderText(text);
}

void TimeChartView::setProvenance(base::Provenance provenance) {
    base::showProvenance(this, provenance);
    m_provenance = provenance;
    m_plot->setProvenance(provenance);
    invalidate();
}

void TimeChartView::setEmptyText(const QString& text) {
    m_defaultEmptyText = false;
    m_empty->setText(text);
}

void TimeChartView::setDefaultEmptyText(const QString& text) {
    if (m_defaultEmptyText)
        m_empty->setText(text);
}

void TimeChartView::setPaused(bool paused) {
    if (paused == isPaused())
        return;
    m_end_s = paused ? std::optional(history().newestTime_s()) : std::nullopt;
    m_pause->setChecked(paused);
    showPause();
    invalidate();
    refresh();
}

void TimeChartView::setSpan(double span) {
    if (!std::isfinite(span))
        return;
    const double clamped = std::clamp(span, m_shortestSpan_s, kLongestSpan_s);
    for (std::size_t i = 0; i < kSpans_s.size(); ++i)
        m_spanActions[i]->setChecked(kSpans_s[i] == clamped);
    if (clamped == m_span_s)
        return;
    m_span_s = clamped;
    m_plot->forgetRanges();
    invalidate();
    refresh();
}

void TimeChartView::scrollBy(double seconds) {
    if (history().empty())
        return;
    const double wanted_s = end_s() + seconds;
    if (wanted_s >= history().newestTime_s()) {
        setPaused(false);
        return;
    }
    setPaused(true);
    // The oldest sample can scroll to the left end at most.
    const double first_s = std::min(history().oldestTime_s() + m_span_s, history().newestTime_s());
    m_end_s = std::max(wanted_s, first_s);
    invalidate();
    refresh();
}

void TimeChartView::zoomBy(double factor, double anchor_s) {
    const double before_s = m_span_s;
    setSpan(before_s * factor);
    // Live: the newest sample stays at the right end. Paused: the time under the mouse stays in place.
    if (isPaused() && before_s > 0.0)
        scrollBy(anchor_s * (1.0 - m_span_s / before_s));
}

void TimeChartView::setCursorTime(std::optional<double> time_s) {
    if (time_s)
        time_s = std::clamp(*time_s, -m_span_s, 0.0);
    if (time_s == m_cursor_s)
        return;
    m_cursor_s = time_s;
    drawCursor();
    m_plot->repaintOverlay();
    setAccessibleDescription(m_plot->headerText());
}

void TimeChartView::moveCursor(double seconds) {
    m_keyboardCursor_s = std::clamp(m_cursor_s.value_or(0.0) + seconds, -m_span_s, 0.0);
    setCursorTime(m_keyboardCursor_s);
}

base::Figure TimeChartView::figure() {
    draw(); // even if it is not on the screen
    base::Figure figure;
    figure.name = figureName();
    figure.size_px = QSizeF(m_plot->size());
    figure.paint = [picture = m_plot->onPaper()](QPainter& painter) { painter.drawPicture(0, 0, picture); };
    const std::size_t first = history().firstAt(end_s() - m_span_s);
    const std::size_t last = std::max(first, history().firstAt(std::nextafter(end_s(), INFINITY)));
    figure.csv = [text = csv(first, last)] { return text; };
    invalidate(); // the plot was coloured for paper
    refresh();
    return figure;
}

void TimeChartView::editRange(int lane) {
    const QRect area = m_plot->laneRect(lane);
    if (m_rangeEdit || area.isEmpty())
        return;
    const ValueRange range = m_plot->laneRange(lane);
    const QRect place(m_plot->mapTo(this, area.topLeft()), QSize(base::em(this, 10), base::em(this, 1)));
    const QLocale locale;
    m_rangeEdit = new base::InlineEdit(this, place,
                                       QStringLiteral("%1 … %2").arg(locale.toString(range.low, 'g', 4),
                                                                     locale.toString(range.high, 'g', 4)));
    m_rangeEdit->setAccessibleName(tr("Range of the axis of %1").arg(m_plot->laneTitle(lane)));
    m_rangeEdit->setToolTip(tr("Lower and upper end, for example -5 5. Empty: automatic."));
    m_rangeEdit->setPlaceholderText(tr("auto"));
    connect(m_rangeEdit, &base::InlineEdit::committed, this,
            [this, lane](const QString& text) { applyRangeText(lane, text); });
}

void TimeChartView::applyRangeText(int lane, const QString& text) {
    static const QRegularExpression separator(QStringLiteral("[\\s…;]+"));
    const QStringList parts = text.split(separator, Qt::SkipEmptyParts);
    if (parts.isEmpty()) {
        m_plot->setFixedLaneRange(lane, std::nullopt);
        m_plot->forgetRanges();
    } else {
        bool lowOk = false, highOk = false;
        const QLocale locale;
        const double low = locale.toDouble(parts.first(), &lowOk);
        const double high = locale.toDouble(parts.last(), &highOk);
        if (parts.size() != 2 || !lowOk || !highOk || !(low < high))
            return;
        m_plot->setFixedLaneRange(lane, ValueRange{low, high});
    }
    invalidate();
    refresh();
}

void TimeChartView::onMouseMove(const QPointF& position, Qt::MouseButtons buttons) {
    if (m_dragFrom_px && buttons.testFlag(Qt::LeftButton)) {
        const double seconds = m_plot->timeAt(*m_dragFrom_px) - m_plot->timeAt(position.x());
        m_dragFrom_px = position.x();
        scrollBy(seconds);
    }
    const auto lane = m_plot->laneAt(position);
    const bool inside = lane && m_plot->laneRect(*lane).contains(position.toPoint());
    setCursorTime(inside ? std::optional(m_plot->timeAt(position.x())) : m_keyboardCursor_s);
}

bool TimeChartView::onWheel(QWheelEvent* event) {
    constexpr double kNotch = 120.0;
    const QPoint delta = event->angleDelta();
    const double notches = (delta.y() != 0 ? delta.y() : delta.x()) / kNotch; // Shift may swap the axes
    if (event->modifiers().testFlag(Qt::ControlModifier))
        zoomBy(std::pow(kZoomStep, -notches), m_plot->timeAt(event->position().x()));
    else if (event->modifiers().testFlag(Qt::ShiftModifier))
        scrollBy(-notches * kScrollStep * m_span_s);
    else
        return false;
    event->accept();
    return true;
}

bool TimeChartView::eventFilter(QObject* watched, QEvent* event) {
    if (watched != m_plot)
        return QWidget::eventFilter(watched, event);
    switch (event->type()) {
    case QEvent::MouseMove: {
        const auto* mouse = static_cast<QMouseEvent*>(event);
        onMouseMove(mouse->position(), mouse->buttons());
        return true;
    }
    case QEvent::MouseButtonPress: {
        const auto* mouse = static_cast<QMouseEvent*>(event);
        setFocus(Qt::MouseFocusReason);
        if (mouse->button() == Qt::LeftButton && m_plot->laneAt(mouse->position()) &&
            !m_plot->laneAxisAt(mouse->position()))
            m_dragFrom_px = mouse->position().x();
        return true;
    }
    case QEvent::MouseButtonRelease:
        m_dragFrom_px.reset();
        return true;
    case QEvent::MouseButtonDblClick:
        if (const auto lane = m_plot->laneAxisAt(static_cast<QMouseEvent*>(event)->position()))
            editRange(*lane);
        return true;
    case QEvent::Leave:
        setCursorTime(m_keyboardCursor_s);
        return false;
    case QEvent::Wheel:
        // QCustomPlot accepts every wheel event, so a scroll area around the view could not scroll.
        if (!onWheel(static_cast<QWheelEvent*>(event)))
            event->ignore();
        return true;
    case QEvent::Resize:
        fitTools();
        invalidate();
        m_empty->setGeometry(m_plot->rect());
        return false;
    default:
        return false;
    }
}

void TimeChartView::keyPressEvent(QKeyEvent* event) {
    const bool scroll = event->modifiers().testFlag(Qt::ShiftModifier);
    const auto sideways = [&](double direction) {
        if (scroll)
            scrollBy(direction * kScrollStep * m_span_s);
        else
            moveCursor(direction * kCursorStep * m_span_s);
    };
    switch (event->key()) {
    case Qt::Key_Space:
        setPaused(!isPaused());
        break;
    case Qt::Key_Left:
        sideways(-1.0);
        break;
    case Qt::Key_Right:
        sideways(1.0);
        break;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        zoomBy(1.0 / kZoomStep, m_cursor_s.value_or(0.0));
        break;
    case Qt::Key_Minus:
        zoomBy(kZoomStep, m_cursor_s.value_or(0.0));
        break;
    case Qt::Key_Home:
        scrollBy(history().oldestTime_s() - end_s());
        break;
    case Qt::Key_End:
        m_keyboardCursor_s.reset();
        setCursorTime(std::nullopt);
        setPaused(false);
        break;
    default:
        FigureView::keyPressEvent(event);
    }
}

void TimeChartView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setPen(palette().color(hasFocus() ? QPalette::Highlight : QPalette::Window));
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

} // namespace teleta::charts
