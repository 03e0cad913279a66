// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/charts/strip_chart_view.h"

#include "widgets/base/icons.h"
#include "widgets/base/inline_edit.h"
#include "widgets/base/theme.h"
#include "widgets/charts/strip_plot.h"

#include <QActionGroup>
#include <QContextMenuEvent>
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

namespace teleta::charts {

namespace {

constexpr double kZoomStep = 1.25;
constexpr double kScrollStep = 0.1; ///< of the span, for one notch or key
constexpr double kCursorStep = 0.01;

} // namespace

StripChartView::StripChartView(QWidget* parent)
    : QWidget(parent) {
    setFocusPolicy(Qt::StrongFocus);
    m_plot = new StripPlot(this);
    m_plot->installEventFilter(this);
    m_plot->setMouseTracking(true);
    m_empty = new QLabel(m_plot);
    m_empty->setAlignment(Qt::AlignCenter);
    m_empty->setWordWrap(true);
    m_empty->setAttribute(Qt::WA_TransparentForMouseEvents);
    m_export = new base::FigureExport(this, [this] { return figure(); });
    connect(m_export, &base::FigureExport::saved, this, &StripChartView::exported);
    connect(m_export, &base::FigureExport::failed, this, &StripChartView::exportFailed);
    makeActions();

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(1, 1, 1, 1);
    layout->setSpacing(0);
    layout->addWidget(makeToolBar());
    layout->addWidget(m_plot, 1);
    retranslate();
    takeStrips();
    restyle();
}

void StripChartView::makeActions() {
    m_stripsMenu = new QMenu(this);
    for (const Strip strip : kAllStrips) {
        auto* action = m_stripsMenu->addAction(QString());
        action->setCheckable(true);
        action->setChecked(definitionOf(strip).shownAtFirst);
        connect(action, &QAction::toggled, this, [this] {
            takeStrips();
            emit stripsChanged();
        });
        m_stripActions[static_cast<std::size_t>(strip)] = action;
    }
    m_spanGroup = new QActionGroup(this);
    m_spanGroup->setExclusionPolicy(QActionGroup::ExclusionPolicy::ExclusiveOptional);
    for (std::size_t i = 0; i < kSpans_s.size(); ++i) {
        auto* action = new QAction(m_spanGroup);
        action->setCheckable(true);
        connect(action, &QAction::triggered, this, [this, i] {
            m_spanActions[i]->setChecked(true); // a second click does not leave it unchecked
            setSpan(kSpans_s[i]);
        });
        m_spanActions[i] = action;
    }
    m_spanActions[1]->setChecked(true);
    m_pause = new QAction(base::themeIcon(base::Icon::pause), {}, this);
    m_pause->setCheckable(true);
    connect(m_pause, &QAction::toggled, this, &StripChartView::setPaused);
    m_mark = new QAction(base::themeIcon(base::Icon::mark), {}, this);
    connect(m_mark, &QAction::triggered, this, &StripChartView::requestMark);
}

QWidget* StripChartView::makeToolBar() {
    auto* bar = new QWidget(this);
    bar->setAutoFillBackground(true);
    auto* layout = new QHBoxLayout(bar);
    layout->setContentsMargins(base::grid(this, 0.5), 0, base::grid(this, 0.5), 0);
    layout->setSpacing(base::grid(this, 0.25));
    const auto add = [&](QAction* action) {
        auto* button = new QToolButton(bar);
        button->setDefaultAction(action);
        button->setAutoRaise(true);
        layout->addWidget(button);
        return button;
    };
    m_stripsButton = new QToolButton(bar);
    m_stripsButton->setAutoRaise(true);
    m_stripsButton->setIcon(base::themeIcon(base::Icon::strips));
    m_stripsButton->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_stripsButton->setPopupMode(QToolButton::InstantPopup);
    m_stripsButton->setMenu(m_stripsMenu);
    layout->addWidget(m_stripsButton);
    layout->addStretch(1);
    for (QAction* action : m_spanActions)
        add(action);
    layout->addSpacing(base::grid(this));
    add(m_pause)->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    add(m_mark)->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    return bar;
}

void StripChartView::retranslate() {
    setAccessibleName(tr("Strip charts of the tactile features"));
    setWhatsThis(tr(
        "<p>Force, centres, moment deviation and orientation of the contact over time. The numbers beside "
        "the strips "
        "are the newest values, or those at the cursor.</p>"
        "<p>A line that stops and goes on means that nothing is known in between: the contact was gone, "
        "samples were "
        "lost, or the recording jumped (dotted line).</p>"
        "<p>Drag or Shift+wheel scrolls, Ctrl+wheel changes the span, Space pauses, End goes back to live. "
        "Double-click an axis to type its ends.</p>"));
    m_stripsButton->setText(tr("Strips"));
    m_stripsButton->setToolTip(tr("Choose which strips are shown"));
    m_stripsButton->setAccessibleName(tr("Choose strips"));
    for (const Strip strip : kAllStrips)
        stripAction(strip)->setText(StripTexts::title(strip));
    for (std::size_t i = 0; i < kSpans_s.size(); ++i) {
        m_spanActions[i]->setText(tr("%1 s").arg(kSpans_s[i]));
        m_spanActions[i]->setToolTip(tr("Show %1 s (Ctrl+wheel for other spans)").arg(kSpans_s[i]));
    }
    m_pause->setText(isPaused() ? tr("Go Live") : tr("Pause"));
    m_pause->setToolTip(tr("Stop the picture; samples go on being kept (Space)"));
    m_mark->setText(tr("Mark"));
    m_mark->setToolTip(tr("Mark this moment (M)"));
    m_dirty = true;
}

void StripChartView::restyle() {
    m_plot->setFont(font());
    m_plot->setColours(palette());
    QPalette faint = palette();
    faint.setColor(QPalette::WindowText, palette().color(QPalette::PlaceholderText));
    m_empty->setPalette(faint);
    m_dirty = true;
    refresh();
}

QAction* StripChartView::stripAction(Strip strip) const {
    return m_stripActions[static_cast<std::size_t>(strip)];
}

std::vector<Strip> StripChartView::shownStrips() const {
    std::vector<Strip> strips;
    std::ranges::copy_if(kAllStrips, std::back_inserter(strips),
                         [this](Strip s) { return stripAction(s)->isChecked(); });
    return strips;
}

void StripChartView::takeStrips() {
    m_plot->setStrips(shownStrips());
    m_dirty = true;
    refresh();
}

void StripChartView::append(const pipeline::FeatureSample& sample) {
    m_history.append(sample);
}

void StripChartView::append(std::span<const pipeline::FeatureSample> samples) {
    for (const pipeline::FeatureSample& sample : samples)
        m_history.append(sample);
}

void StripChartView::clear() {
    m_history.clear();
    m_marks.clear();
    m_cursor_s.reset();
    m_keyboardCursor_s.reset();
    m_plot->forgetRanges();
    setPaused(false);
    m_dirty = true;
    refresh();
}

void StripChartView::refresh() {
    const bool news = m_history.appended() != m_drawn && !isPaused();
    if (!news && !m_dirty)
        return;
    draw();
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void StripChartView::draw() {
    m_drawn = m_history.appended();
    m_dirty = false;
    std::erase_if(m_marks, [this](const Mark& mark) { return mark.time_s < m_history.oldestTime_s(); });
    std::vector<TimeLine> lines;
    for (const Mark& mark : m_marks)
        lines.push_back({mark.time_s - end_s(), mark.label});
    m_plot->setMarks(std::move(lines));
    m_plot->showStretch(m_history, end_s(), m_span_s);
    drawCursor();
    m_empty->setVisible(m_history.empty());
    m_empty->setGeometry(m_plot->rect());
}

std::optional<std::size_t> StripChartView::shownSample() const {
    if (m_history.empty())
        return std::nullopt;
    return m_history.nearest(end_s() + m_cursor_s.value_or(0.0));
}

void StripChartView::drawCursor() {
    m_plot->setCursorLine(m_cursor_s ? std::optional(TimeLine{*m_cursor_s, {}}) : std::nullopt);
    m_plot->showValues(m_history, shownSample(), !m_cursor_s && !isPaused());
    updateHeader();
}

void StripChartView::updateHeader() {
    QString text;
    const auto seconds = [](double value) { return base::threeDigits(value).remove(QChar(0x2007)); };
    if (m_cursor_s) {
        const auto sample = shownSample();
        text = sample ? tr("at %1 s   stream time %2 s")
                            .arg(seconds(*m_cursor_s),
                                 QLocale().toString(m_history.sourceTime_s(*sample), 'f', 3))
                      : tr("at %1 s   no sample").arg(seconds(*m_cursor_s));
    } else {
        text = tr("last %1 s").arg(seconds(m_span_s));
    }
    if (isPaused())
        text = tr("PAUSED, %1 s behind   %2").arg(seconds(m_history.newestTime_s() - end_s()), text);
    m_plot->setHeaderText(text);
}

void StripChartView::setLoadUnit(const QString& unit) {
    m_plot->setLoadUnit(unit);
    m_dirty = true;
}

void StripChartView::setProvenance(base::Provenance provenance) {
    m_plot->setProvenance(provenance);
    m_dirty = true;
}

void StripChartView::setEmptyText(const QString& text) {
    m_empty->setText(text);
}

void StripChartView::setPaused(bool paused) {
    if (paused == isPaused())
        return;
    m_end_s = paused ? std::optional(m_history.newestTime_s()) : std::nullopt;
    m_pause->setChecked(paused);
    m_pause->setText(paused ? tr("Go Live") : tr("Pause"));
    m_pause->setIcon(base::themeIcon(paused ? base::Icon::play : base::Icon::pause));
    m_dirty = true;
    refresh();
    emit pausedChanged(paused);
}

void StripChartView::setSpan(double span) {
    if (!std::isfinite(span))
        return;
    const double clamped = std::clamp(span, kShortestSpan_s, kLongestSpan_s);
    for (std::size_t i = 0; i < kSpans_s.size(); ++i)
        m_spanActions[i]->setChecked(kSpans_s[i] == clamped);
    if (clamped == m_span_s)
        return;
    m_span_s = clamped;
    m_plot->forgetRanges();
    m_dirty = true;
    refresh();
    emit spanChanged(m_span_s);
}

void StripChartView::scrollBy(double seconds) {
    if (m_history.empty())
        return;
    const double wanted_s = end_s() + seconds;
    if (wanted_s >= m_history.newestTime_s()) {
        setPaused(false);
        return;
    }
    setPaused(true);
    // The oldest sample may come to the left end, not further.
    const double first_s = std::min(m_history.oldestTime_s() + m_span_s, m_history.newestTime_s());
    m_end_s = std::max(wanted_s, first_s);
    m_dirty = true;
    refresh();
}

void StripChartView::zoomBy(double factor, double anchor_s) {
    const double before_s = m_span_s;
    setSpan(before_s * factor);
    // Live, the newest sample stays at the right; paused, the time under the mouse stays where it is.
    if (isPaused() && before_s > 0.0)
        scrollBy(anchor_s * (1.0 - m_span_s / before_s));
}

bool StripChartView::addMark(double sourceTime_s, const QString& label) {
    const auto sample = m_history.nearestSource(sourceTime_s);
    if (!sample || std::abs(m_history.sourceTime_s(*sample) - sourceTime_s) > m_history.longestStep_s())
        return false;
    m_marks.push_back({m_history.time_s(*sample), label});
    m_dirty = true;
    return true;
}

void StripChartView::requestMark() {
    if (const auto sample = shownSample())
        emit markRequested(m_history.sourceTime_s(*sample));
}

void StripChartView::setCursorTime(std::optional<double> time_s) {
    if (time_s)
        time_s = std::clamp(*time_s, -m_span_s, 0.0);
    if (time_s == m_cursor_s)
        return;
    m_cursor_s = time_s;
    drawCursor();
    m_plot->repaintOverlay();
    setAccessibleDescription(m_plot->headerText());
}

void StripChartView::moveCursor(double seconds) {
    m_keyboardCursor_s = std::clamp(m_cursor_s.value_or(0.0) + seconds, -m_span_s, 0.0);
    setCursorTime(m_keyboardCursor_s);
}

base::Figure StripChartView::figure() {
    base::Figure figure;
    figure.name = tr("charts");
    figure.size_px = QSizeF(m_plot->size());
    figure.paint = [picture = m_plot->onPaper()](QPainter& painter) { painter.drawPicture(0, 0, picture); };
    const std::size_t first = m_history.firstAt(end_s() - m_span_s);
    const std::size_t last = std::max(first, m_history.firstAt(std::nextafter(end_s(), INFINITY)));
    figure.csv = [csv = QString::fromStdString(featuresCsv(m_history, first, last))] { return csv; };
    m_dirty = true; // the plot was coloured for paper
    refresh();
    return figure;
}

void StripChartView::populateMenu(QMenu& menu, std::optional<Strip> strip) {
    m_stripsMenu->setTitle(tr("&Strips"));
    menu.addMenu(m_stripsMenu);
    QMenu* spans = menu.addMenu(tr("S&pan"));
    spans->addActions(m_spanGroup->actions());
    menu.addAction(m_pause);
    menu.addAction(m_mark);
    if (strip) {
        menu.addSeparator();
        menu.addAction(tr("&Type Range of %1…").arg(StripTexts::title(*strip)), this,
                       [this, strip] { editRange(*strip); });
        QAction* automatic =
            menu.addAction(tr("&Automatic Range"), this, [this, strip] { applyRangeText(*strip, {}); });
        automatic->setCheckable(true);
        automatic->setChecked(!m_plot->fixedRange(*strip));
    }
    menu.addSeparator();
    m_export->addActions(menu);
}

void StripChartView::editRange(Strip strip) {
    if (m_rangeEdit || m_plot->plotRect(strip).isEmpty())
        return;
    const ValueRange range = m_plot->rangeOf(strip);
    const QRect place(m_plot->mapTo(this, m_plot->plotRect(strip).topLeft()),
                      QSize(base::em(this, 10), base::em(this, 1)));
    const QLocale locale;
    m_rangeEdit = new base::InlineEdit(this, place,
                                       QStringLiteral("%1 … %2").arg(locale.toString(range.low, 'g', 4),
                                                                     locale.toString(range.high, 'g', 4)));
    m_rangeEdit->setAccessibleName(tr("Ends of the axis of %1").arg(StripTexts::title(strip)));
    m_rangeEdit->setToolTip(tr("Lower and upper end, for example -5 5. Empty: automatic."));
    m_rangeEdit->setPlaceholderText(tr("auto"));
    connect(m_rangeEdit, &base::InlineEdit::committed, this,
            [this, strip](const QString& text) { applyRangeText(strip, text); });
}

void StripChartView::applyRangeText(Strip strip, const QString& text) {
    static const QRegularExpression separator(QStringLiteral("[\\s…;]+"));
    const QStringList parts = text.split(separator, Qt::SkipEmptyParts);
    if (parts.isEmpty()) {
        m_plot->setFixedRange(strip, std::nullopt);
        m_plot->forgetRanges();
    } else {
        bool lowOk = false, highOk = false;
        const QLocale locale;
        const double low = locale.toDouble(parts.first(), &lowOk);
        const double high = locale.toDouble(parts.last(), &highOk);
        if (parts.size() != 2 || !lowOk || !highOk || !(low < high))
            return;
        m_plot->setFixedRange(strip, ValueRange{low, high});
    }
    m_dirty = true;
    refresh();
}

void StripChartView::onMouseMove(const QPointF& position, Qt::MouseButtons buttons) {
    if (m_dragFrom_px && buttons.testFlag(Qt::LeftButton)) {
        const double seconds = m_plot->timeAt(*m_dragFrom_px) - m_plot->timeAt(position.x());
        m_dragFrom_px = position.x();
        scrollBy(seconds);
    }
    const auto strip = m_plot->stripAt(position);
    const bool inside = strip && m_plot->plotRect(*strip).contains(position.toPoint());
    setCursorTime(inside ? std::optional(m_plot->timeAt(position.x())) : m_keyboardCursor_s);
}

bool StripChartView::onWheel(QWheelEvent* event) {
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

bool StripChartView::eventFilter(QObject* watched, QEvent* event) {
    if (watched != m_plot)
        return QWidget::eventFilter(watched, event);
    switch (event->type()) {
    case QEvent::MouseMove: {
        auto* mouse = static_cast<QMouseEvent*>(event);
        onMouseMove(mouse->position(), mouse->buttons());
        return true;
    }
    case QEvent::MouseButtonPress: {
        auto* mouse = static_cast<QMouseEvent*>(event);
        setFocus(Qt::MouseFocusReason);
        if (mouse->button() == Qt::LeftButton && m_plot->stripAt(mouse->position()) &&
            !m_plot->axisAt(mouse->position()))
            m_dragFrom_px = mouse->position().x();
        return true;
    }
    case QEvent::MouseButtonRelease:
        m_dragFrom_px.reset();
        return true;
    case QEvent::MouseButtonDblClick:
        if (const auto strip = m_plot->axisAt(static_cast<QMouseEvent*>(event)->position()))
            editRange(*strip);
        return true;
    case QEvent::Leave:
        setCursorTime(m_keyboardCursor_s);
        return false;
    case QEvent::Wheel:
        // Ignored, not passed on: QCustomPlot would take every wheel and a window around the view could not
        // scroll.
        if (!onWheel(static_cast<QWheelEvent*>(event)))
            event->ignore();
        return true;
    case QEvent::ContextMenu: {
        auto* request = static_cast<QContextMenuEvent*>(event);
        auto* menu = new QMenu(this);
        menu->setAttribute(Qt::WA_DeleteOnClose);
        populateMenu(*menu, m_plot->stripAt(request->pos()));
        menu->popup(request->globalPos());
        return true;
    }
    case QEvent::Resize:
        m_dirty = true;
        m_empty->setGeometry(m_plot->rect());
        return false;
    default:
        return false;
    }
}

void StripChartView::keyPressEvent(QKeyEvent* event) {
    const bool scroll = event->modifiers().testFlag(Qt::ShiftModifier);
    const auto sideways = [&](double direction) {
        if (scroll)
            scrollBy(direction * kScrollStep * m_span_s);
        else
            moveCursor(direction * kCursorStep * m_span_s);
    };
    if (event->matches(QKeySequence::Copy)) {
        base::copyPicture(figure());
        return;
    }
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
        scrollBy(m_history.oldestTime_s() - end_s());
        break;
    case Qt::Key_End:
        m_keyboardCursor_s.reset();
        setCursorTime(std::nullopt);
        setPaused(false);
        break;
    case Qt::Key_M:
        requestMark();
        break;
    default:
        QWidget::keyPressEvent(event);
    }
}

void StripChartView::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
        refresh();
    } else if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) {
        restyle();
    }
}

void StripChartView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setPen(palette().color(hasFocus() ? QPalette::Highlight : QPalette::Window));
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

} // namespace teleta::charts
