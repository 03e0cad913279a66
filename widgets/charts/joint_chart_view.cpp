// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/charts/joint_chart_view.h"

#include "backend/core/number_text.h"
#include "widgets/base/icons.h"
#include "widgets/base/theme.h"
#include "widgets/charts/joint_plot.h"

#include <QActionGroup>
#include <QContextMenuEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
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

JointChartView::JointChartView(QWidget* parent)
    : QWidget(parent)
    , m_history(kJointColumns)
    , m_plot(new JointPlot(this))
    , m_empty(new QLabel(m_plot))
    , m_spanGroup(new QActionGroup(this))
    , m_angles(new QAction(base::themeIcon(base::Icon::strips), {}, this))
    , m_pause(new QAction(base::themeIcon(base::Icon::pause), {}, this))
    , m_export(new base::FigureExport(this, [this] { return figure(); })) {
    setFocusPolicy(Qt::StrongFocus);
    m_plot->installEventFilter(this);
    m_plot->setMouseTracking(true);
    m_empty->setAlignment(Qt::AlignCenter);
    m_empty->setWordWrap(true);
    m_empty->setAttribute(Qt::WA_TransparentForMouseEvents);
    connect(m_export, &base::FigureExport::saved, this, &JointChartView::exported);
    connect(m_export, &base::FigureExport::failed, this, &JointChartView::exportFailed);
    m_spanGroup->setExclusionPolicy(QActionGroup::ExclusionPolicy::ExclusiveOptional);
    for (std::size_t i = 0; i < kSpans_s.size(); ++i) {
        auto* action = new QAction(m_spanGroup);
        action->setCheckable(true);
        action->setChecked(kSpans_s[i] == m_span_s);
        connect(action, &QAction::triggered, this, [this, i] {
            m_spanActions[i]->setChecked(true); // a second click does not leave it unchecked
            setSpan(kSpans_s[i]);
        });
        m_spanActions[i] = action;
    }
    m_angles->setCheckable(true);
    connect(m_angles, &QAction::toggled, this, [this](bool shown) {
        m_plot->setAnglesShown(shown);
        m_dirty = true;
        refresh();
        emit anglesChanged(shown);
    });
    m_pause->setCheckable(true);
    connect(m_pause, &QAction::toggled, this, &JointChartView::setPaused);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(1, 1, 1, 1);
    layout->setSpacing(0);
    layout->addWidget(makeToolBar());
    layout->addWidget(m_plot, 1);
    setWindow({});
    retranslate();
    restyle();
}

QWidget* JointChartView::makeToolBar() {
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
    add(m_angles)->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    layout->addStretch(1);
    for (QAction* action : m_spanActions)
        add(action);
    layout->addSpacing(base::grid(this));
    add(m_pause)->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    return bar;
}

void JointChartView::retranslate() {
    setAccessibleName(tr("Joint torques and angles of the arm"));
    setWhatsThis(
        tr("<p>Torque of each joint over time. The coloured band is the torque window: between its "
           "ends a touch is evaluated. Grey stretches are touches with their numbers, from the first "
           "torque above the noise to the estimate.</p>"
           "<p>Drag or Shift+wheel scrolls, Ctrl+wheel changes the span, Space pauses, End goes back "
           "to live.</p>"));
    if (m_defaultEmptyText)
        m_empty->setText(tr("No arm. Open a scene or a device with an arm."));
    m_angles->setText(tr("Angles"));
    m_angles->setToolTip(tr("Show the joint angles too"));
    for (std::size_t i = 0; i < kSpans_s.size(); ++i) {
        m_spanActions[i]->setText(tr("%1 s").arg(kSpans_s[i]));
        m_spanActions[i]->setToolTip(tr("Show %1 s (Ctrl+wheel for other spans)").arg(kSpans_s[i]));
    }
    m_pause->setText(isPaused() ? tr("Go Live") : tr("Pause"));
    m_pause->setToolTip(tr("Stop the picture; samples go on being kept (Space)"));
    m_plot->retranslate();
    m_dirty = true;
}

void JointChartView::restyle() {
    m_plot->setFont(font());
    m_plot->setColours(palette());
    QPalette faint = palette();
    faint.setColor(QPalette::WindowText, palette().color(QPalette::PlaceholderText));
    m_empty->setPalette(faint);
    m_dirty = true;
    refresh();
}

void JointChartView::append(std::span<const core::JointSample> samples) {
    std::array<double, kJointColumns> row{};
    for (const core::JointSample& sample : samples) {
        std::ranges::copy(sample.torque_Nm, row.begin());
        std::ranges::copy(sample.angle_rad, row.begin() + core::kArmJoints);
        m_history.append({sample.time_ns, sample.sourceTime_s, sample.discontinuity}, row);
    }
}

bool JointChartView::addTouch(const pipeline::TouchRecord& touch) {
    const auto first = m_history.nearestSource(touch.start_s);
    const auto last = m_history.nearestSource(touch.ready_s);
    if (!first || !last ||
        std::abs(m_history.sourceTime_s(*first) - touch.start_s) > m_history.longestStep_s())
        return false;
    m_touches.push_back({touch.number, m_history.time_s(*first), m_history.time_s(*last)});
    m_dirty = true;
    return true;
}

void JointChartView::clear() {
    m_history.clear();
    m_touches.clear();
    m_cursor_s.reset();
    m_keyboardCursor_s.reset();
    m_plot->forgetRanges();
    setPaused(false);
    m_dirty = true;
    refresh();
}

void JointChartView::refresh() {
    const bool news = m_history.appended() != m_drawn && !isPaused();
    if (!news && !m_dirty)
        return;
    draw();
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void JointChartView::draw() {
    m_drawn = m_history.appended();
    m_dirty = false;
    std::erase_if(m_touches, [this](const Touch& t) { return t.to_s < m_history.oldestTime_s(); });
    std::vector<Shade> shades;
    for (const Touch& touch : m_touches)
        if (touch.to_s > end_s() - m_span_s && touch.from_s < end_s())
            shades.push_back({touch.from_s - end_s(), touch.to_s - end_s(), QString::number(touch.number)});
    m_plot->setTouches(std::move(shades));
    m_plot->showStretch(m_history, end_s(), m_span_s);
    drawCursor();
    m_empty->setVisible(m_history.empty());
    m_empty->setGeometry(m_plot->rect());
}

std::optional<std::size_t> JointChartView::shownSample() const {
    if (m_history.empty())
        return std::nullopt;
    return m_history.nearest(end_s() + m_cursor_s.value_or(0.0));
}

void JointChartView::drawCursor() {
    m_plot->setCursorLine(m_cursor_s);
    m_plot->showValues(m_history, shownSample(), !m_cursor_s && !isPaused());
    updateHeader();
}

void JointChartView::updateHeader() {
    const auto seconds = [](double value) {
        QString text = base::threeDigits(value);
        return text.remove(QChar(0x2007));
    };
    QString text;
    if (m_cursor_s) {
        const auto sample = shownSample();
        text = sample ? tr("at %1 s   arm time %2 s")
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

void JointChartView::setWindow(const stiffness::TorqueWindow& window) {
    m_plot->setWindow(window.low_Nm, window.high_Nm);
    m_dirty = true;
}

void JointChartView::setProvenance(base::Provenance provenance) {
    m_plot->setProvenance(provenance);
    m_dirty = true;
}

void JointChartView::setEmptyText(const QString& text) {
    m_defaultEmptyText = false;
    m_empty->setText(text);
}

void JointChartView::setPaused(bool paused) {
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

void JointChartView::setSpan(double span) {
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

void JointChartView::scrollBy(double seconds) {
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

bool JointChartView::showTouch(std::uint64_t number) {
    const auto touch =
        std::ranges::find_if(m_touches, [number](const Touch& t) { return t.number == number; });
    if (touch == m_touches.end())
        return false;
    const double middle_s = 0.5 * (touch->from_s + touch->to_s);
    setPaused(true);
    scrollBy(middle_s + 0.5 * m_span_s - end_s());
    return true;
}

void JointChartView::zoomBy(double factor, double anchor_s) {
    const double before_s = m_span_s;
    setSpan(before_s * factor);
    // Live, the newest sample stays at the right; paused, the time under the mouse stays where it is.
    if (isPaused() && before_s > 0.0)
        scrollBy(anchor_s * (1.0 - m_span_s / before_s));
}

void JointChartView::setCursorTime(std::optional<double> time_s) {
    if (time_s)
        time_s = std::clamp(*time_s, -m_span_s, 0.0);
    if (time_s == m_cursor_s)
        return;
    m_cursor_s = time_s;
    drawCursor();
    m_plot->repaintOverlay();
    setAccessibleDescription(m_plot->headerText());
}

void JointChartView::moveCursor(double seconds) {
    m_keyboardCursor_s = std::clamp(m_cursor_s.value_or(0.0) + seconds, -m_span_s, 0.0);
    setCursorTime(m_keyboardCursor_s);
}

QString JointChartView::csv() const {
    std::string text = "time_s";
    for (std::size_t joint = 1; joint <= core::kArmJoints; ++joint)
        text += ",joint" + std::to_string(joint) + "_angle_rad,joint" + std::to_string(joint) + "_torque_nm";
    text += '\n';
    const auto put = [&text](double value) {
        if (std::isfinite(value))
            text += core::NumberText(value).view();
        else
            text += "NA";
    };
    const std::size_t last = m_history.firstAt(std::nextafter(end_s(), INFINITY));
    for (std::size_t i = m_history.firstAt(end_s() - m_span_s); i < last; ++i) {
        put(m_history.sourceTime_s(i));
        for (std::size_t joint = 0; joint < core::kArmJoints; ++joint)
            for (const std::size_t column : {core::kArmJoints + joint, joint}) {
                text += ',';
                put(m_history.value(column, i));
            }
        text += '\n';
    }
    return QString::fromStdString(text);
}

base::Figure JointChartView::figure() {
    draw(); // also when it is not on the screen
    base::Figure figure;
    figure.name = tr("joints");
    figure.size_px = QSizeF(m_plot->size());
    figure.paint = [picture = m_plot->onPaper()](QPainter& painter) { painter.drawPicture(0, 0, picture); };
    figure.csv = [text = csv()] { return text; };
    m_dirty = true; // the plot was coloured for paper
    refresh();
    return figure;
}

void JointChartView::populateMenu(QMenu& menu) {
    menu.addAction(m_angles);
    QMenu* spans = menu.addMenu(tr("S&pan"));
    spans->addActions(m_spanGroup->actions());
    menu.addAction(m_pause);
    menu.addSeparator();
    m_export->addActions(menu);
}

bool JointChartView::onWheel(QWheelEvent* event) {
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

bool JointChartView::eventFilter(QObject* watched, QEvent* event) {
    if (watched != m_plot)
        return QWidget::eventFilter(watched, event);
    const auto inside = [this](const QPointF& point) {
        return m_plot->plotRect(JointPlot::Row::torque).contains(point.toPoint()) ||
               m_plot->plotRect(JointPlot::Row::angle).contains(point.toPoint());
    };
    switch (event->type()) {
    case QEvent::MouseMove: {
        const auto* mouse = static_cast<QMouseEvent*>(event);
        if (m_dragFrom_px && mouse->buttons().testFlag(Qt::LeftButton)) {
            const double seconds = m_plot->timeAt(*m_dragFrom_px) - m_plot->timeAt(mouse->position().x());
            m_dragFrom_px = mouse->position().x();
            scrollBy(seconds);
        }
        setCursorTime(inside(mouse->position()) ? std::optional(m_plot->timeAt(mouse->position().x()))
                                                : m_keyboardCursor_s);
        return true;
    }
    case QEvent::MouseButtonPress: {
        const auto* mouse = static_cast<QMouseEvent*>(event);
        setFocus(Qt::MouseFocusReason);
        if (mouse->button() == Qt::LeftButton && inside(mouse->position()))
            m_dragFrom_px = mouse->position().x();
        return true;
    }
    case QEvent::MouseButtonRelease:
        m_dragFrom_px.reset();
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
        auto* menu = new QMenu(this);
        menu->setAttribute(Qt::WA_DeleteOnClose);
        populateMenu(*menu);
        menu->popup(static_cast<QContextMenuEvent*>(event)->globalPos());
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

void JointChartView::keyPressEvent(QKeyEvent* event) {
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
    default:
        QWidget::keyPressEvent(event);
    }
}

void JointChartView::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
        refresh();
    } else if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) {
        restyle();
    }
}

void JointChartView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setPen(palette().color(hasFocus() ? QPalette::Highlight : QPalette::Window));
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

} // namespace teleta::charts
