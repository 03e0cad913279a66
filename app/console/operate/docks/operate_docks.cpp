// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/operate/docks/operate_docks.h"

#include "app/console/operate/docks/dock_tabs.h"
#include "widgets/base/theme.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QDataStream>
#include <QDockWidget>
#include <QEvent>
#include <QIODevice>
#include <QMouseEvent>
#include <QPointer>
#include <QScopedValueRollback>
#include <QScreen>
#include <QScrollArea>
#include <QStyle>
#include <QTabWidget>

#include <algorithm>
#include <utility>

namespace teleta::console {

namespace {

/// Version of the layouts: stored ones of another version are not restored.
constexpr qint32 kLayoutVersion = 8;
/// In front of a layout that tells the sizes of its docks. Qt's own begin otherwise.
constexpr quint32 kWithSizes = 0x53697a65;

constexpr std::array<const char*, OperateDocks::kDocks> kNames{
    "heatmap", "reconstruction", "charts",  "processing", "stiffness", "bracelet", "joints", "touches",
    "jog",     "feedback",       "contour", "servo",      "runs",      "objects",  "camera", "events",
    "gel",     "gel-events",     "scene",   "marks"};

/// As wide as what is in it, at least, and any height.
class LowRoom : public QScrollArea {
public:
    using QScrollArea::QScrollArea;

    [[nodiscard]] QSize minimumSizeHint() const override {
        const int bar = style()->pixelMetric(QStyle::PM_ScrollBarExtent, nullptr, this);
        return {widget()->minimumSizeHint().width() + bar, QScrollArea::minimumSizeHint().height()};
    }

protected:
    bool event(QEvent* event) override {
        if (event->type() == QEvent::LayoutRequest)
            updateGeometry();
        return QScrollArea::event(event);
    }
};

} // namespace

OperateDocks::OperateDocks(QWidget* parent)
    : QMainWindow(parent) {
    // Inside a page; it is no window itself.
    setWindowFlags(Qt::Widget);
    m_default.fill(true);
    setDockNestingEnabled(true);
    setDockOptions(AnimatedDocks | AllowNestedDocks | AllowTabbedDocks);
    setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    connect(new DockTabs(this), &DockTabs::maximiseRequested, this,
            [this](const QDockWidget* dock) { setMaximised(dock->objectName()); });
    connect(qApp, &QApplication::focusChanged, this, &OperateDocks::showFocus);
    // Queued: the window system may place the windows anew itself.
    connect(qApp, &QGuiApplication::screenRemoved, this, &OperateDocks::bringBack, Qt::QueuedConnection);
}

QRect OperateDocks::reachablePlace(const QRect& window, const QList<QRect>& screens, const QRect& home,
                                   QSize grip) {
    const QRect title(window.topLeft(), QSize(window.width(), grip.height()));
    const auto isReachable = [&](const QRect& screen) {
        const QRect seen = screen.intersected(title);
        return seen.height() >= grip.height() && seen.width() >= std::min(grip.width(), title.width());
    };
    if (std::ranges::any_of(screens, isReachable))
        return window;
    QRect place(QPoint(), window.size().boundedTo(home.size()));
    place.moveCenter(home.center());
    return place;
}

void OperateDocks::bringBack() {
    QList<QRect> screens;
    for (const QScreen* screen : QGuiApplication::screens())
        screens << screen->availableGeometry();
    const QSize grip(base::em(this, 6), base::em(this, 1.5));
    for (QDockWidget* dock : m_docks) {
        if (dock == nullptr || !dock->isFloating() || !dock->isVisible())
            continue;
        const QRect place =
            reachablePlace(dock->geometry(), screens, window()->screen()->availableGeometry(), grip);
        if (place != dock->geometry())
            dock->setGeometry(place);
    }
}

void OperateDocks::showFocus(const QWidget* before, const QWidget* now) {
    // Tab also goes into docks behind others. A focus that was driven out of what went is not followed:
    // nothing comes forward by itself.
    const bool wasLeft = before != nullptr && before->isEnabled() && before->isVisibleTo(before->window());
    for (const QDockWidget* dock : m_docks)
        if (dock != nullptr && now != nullptr && dock->isAncestorOf(now))
            m_lastUsed = dock->objectName();
    if (now == nullptr || !wasLeft)
        return;
    for (QDockWidget* dock : m_docks)
        if (dock != nullptr && dock->isAncestorOf(now) && !tabifiedDockWidgets(dock).isEmpty())
            dock->raise();
}

void OperateDocks::add(Dock dock, QWidget* view) {
    auto* frame = new QDockWidget(this);
    frame->setObjectName(QLatin1String(kNames[dock])); // saveState() needs it
    frame->setWidget(view);
    addDockWidget(Qt::LeftDockWidgetArea, frame);
    frame->installEventFilter(this);
    m_docks[dock] = frame;
    // A person moves it, unless a layout is being built.
    connect(frame, &QDockWidget::topLevelChanged, this, [this] {
        if (m_building)
            return;
        m_default[index()] = false;
        QMetaObject::invokeMethod(this, &OperateDocks::noteSizes, Qt::QueuedConnection);
    });
    // One that was closed is opened where it was, which may be nowhere by now.
    connect(frame, &QDockWidget::visibilityChanged, this, &OperateDocks::bringBack, Qt::QueuedConnection);
}

void OperateDocks::addScrolling(Dock dock, QWidget* view) {
    auto* room = new LowRoom(this);
    room->setFocusPolicy(Qt::NoFocus); // its fields are what Tab goes to
    room->setWidgetResizable(true);
    room->setFrameShape(QFrame::NoFrame);
    room->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    room->setWidget(view);
    add(dock, room);
}

void OperateDocks::begin() {
    retranslate();
    resetLayout();
    enableActions();
}

void OperateDocks::setKind(Kind kind) {
    if (kind == m_kind)
        return;
    change(kind, m_small);
    bringForward(std::exchange(m_forward, QString()));
}

void OperateDocks::setSmall(bool small) {
    const std::size_t before = index();
    m_small = small;
    const std::size_t after = index();
    if (after == before)
        return;
    m_small = !small;
    const QString alone = m_alone;
    setMaximised({});
    std::array<bool, kDocks> closed{};
    std::ranges::transform(m_docks, closed.begin(), &QDockWidget::isHidden);
    change(m_kind, small);
    // Shown for the first time: what a person has closed stays closed.
    for (std::size_t i = 0; m_layouts[after].isEmpty() && i < kDocks; ++i)
        if (closed[i])
            m_docks[i]->hide();
    setMaximised(alone);
}

/// To the layout of a kind in a window.
void OperateDocks::change(Kind kind, bool small) {
    m_layouts[index()] = stateNow();
    forgetMaximised();
    m_kind = kind;
    m_small = small;
    enableActions();
    if (m_layouts[index()].isEmpty() || !restore(m_layouts[index()]))
        resetLayout();
}

bool OperateDocks::restore(const QByteArray& layout) {
    const QScopedValueRollback building(m_building, true);
    QDataStream stream(layout);
    quint32 begin = 0;
    QByteArray state = layout;
    QSize sizesIn;
    QList<QSize> sizes;
    bool sharesAnew = false;
    if (stream >> begin; begin == kWithSizes)
        stream >> state >> sizesIn >> sizes;
    const bool isTold = stream.status() == QDataStream::Ok && sizes.size() == std::ssize(m_sizes);
    if (isTold && !stream.atEnd()) // an older program did not tell
        stream >> sharesAnew;
    if (!restoreState(state, kLayoutVersion))
        return false;
    m_default[index()] = sharesAnew;
    m_sizesIn = isTold ? sizesIn : QSize();
    if (isTold)
        std::ranges::copy(sizes, m_sizes.begin());
    if (isVisible())
        QMetaObject::invokeMethod(this, &OperateDocks::bringSizes, Qt::QueuedConnection);
    // What is not in a layout stays where it was.
    for (std::size_t i = 0; i < kDocks; ++i)
        if (!isUsed(i))
            m_docks[i]->hide();
    showScene();
    return true;
}

bool OperateDocks::isUsed(std::size_t dock) const {
    return belongs(m_kind, dock) && (dock != scene || m_hasScene);
}

void OperateDocks::setHasScene(bool has) {
    if (has == std::exchange(m_hasScene, has))
        return;
    m_sceneClosed.fill(false);
    enableActions();
    // Into, or out of, the layout of all: the dock that is alone stays alone.
    const QString alone = m_alone;
    if (!alone.isEmpty())
        setMaximised({});
    const QScopedValueRollback building(m_building, true);
    if (!has)
        m_docks[scene]->hide();
    showScene();
    if (m_default[index()])
        shareSpace();
    if (has || alone != QLatin1String(kNames[scene]))
        setMaximised(alone);
}

void OperateDocks::showScene() {
    if (!m_hasScene || m_sceneClosed[index()] || !m_alone.isEmpty() || !m_docks[scene]->isHidden())
        return;
    m_docks[scene]->show();
    if (m_kind == Kind::scene)
        m_docks[scene]->raise();
}

bool OperateDocks::belongs(Kind kind, std::size_t dock) {
    if (dock == marks || dock == scene)
        return true;
    if (kind == Kind::scene)
        return false;
    if (kind == Kind::camera)
        return dock == reconstruction || dock == camera || dock == events;
    if (kind == Kind::gel)
        return dock == reconstruction || dock == gel || dock == gelEvents;
    if (kind == Kind::joints)
        return dock == reconstruction || dock == joints || dock == jog;
    if (dock < stiffness)
        return true;
    if (dock == camera || dock == events || dock == gel || dock == gelEvents)
        return false;
    return kind == (dock == servo || dock == runs ? Kind::servo : Kind::arm);
}

QStringList OperateDocks::names() {
    QStringList names;
    for (const char* name : kNames)
        names << QLatin1String(name);
    return names;
}

void OperateDocks::bringForward(const QString& name) {
    m_forward = name;
    const auto index = static_cast<std::size_t>(names().indexOf(name));
    if (index >= kDocks || !isUsed(index))
        return;
    if (!m_alone.isEmpty() && name != m_alone)
        setMaximised({});
    m_docks[index]->show();
    m_docks[index]->raise();
}

void OperateDocks::setMaximised(const QString& name) {
    // Hiding a dock for a moment must not hand its keyboard to the next control, such as Record.
    QWidget* const focused = QApplication::focusWidget();
    const QPointer<QWidget> keyboard = focused != nullptr && isAncestorOf(focused) ? focused : nullptr;
    showAlone(name);
    QWidget* const kept = keyboard.data();
    if (kept == nullptr)
        return;
    if (kept->isVisible())
        kept->setFocus(Qt::OtherFocusReason);
    else if (const auto shown = names().indexOf(m_alone); shown >= 0)
        m_docks[static_cast<std::size_t>(shown)]->widget()->setFocus(Qt::OtherFocusReason);
}

void OperateDocks::showAlone(const QString& name) {
    if (!m_together.isEmpty()) {
        const QByteArray together = m_together;
        forgetMaximised();
        if (!restore(together))
            resetLayout();
    }
    const auto index = static_cast<std::size_t>(names().indexOf(name));
    if (index >= kDocks || !isUsed(index) || m_docks[index]->isFloating())
        return;
    m_together = stateNow();
    m_alone = name;
    for (QDockWidget* dock : m_docks)
        if (dock != m_docks[index] && !dock->isFloating())
            dock->hide();
    m_docks[index]->show();
    m_docks[index]->raise();
    emit maximisedChanged(true);
}

void OperateDocks::toggleMaximised() {
    const auto used = static_cast<std::size_t>(std::max<qsizetype>(0, names().indexOf(m_lastUsed)));
    if (!m_alone.isEmpty())
        setMaximised({});
    else
        setMaximised(m_docks[used]->isVisible() && !m_lastUsed.isEmpty()
                         ? m_lastUsed
                         : QLatin1String(kNames[m_kind == Kind::camera   ? camera
                                                : m_kind == Kind::gel    ? gel
                                                : m_kind == Kind::joints ? reconstruction
                                                : m_kind == Kind::scene  ? scene
                                                                         : heatmap]));
}

void OperateDocks::forgetMaximised() {
    m_together.clear();
    if (!std::exchange(m_alone, QString()).isEmpty())
        emit maximisedChanged(false);
}

QByteArray OperateDocks::stateNow() const {
    if (!m_together.isEmpty())
        return m_together;
    const auto sizes = isVisible() ? sizesNow() : m_sizes;
    QByteArray bytes;
    QDataStream stream(&bytes, QIODevice::WriteOnly);
    stream << kWithSizes << saveState(kLayoutVersion) << (isVisible() ? size() : m_sizesIn)
           << QList<QSize>(sizes.begin(), sizes.end()) << m_default[index()];
    return bytes;
}

bool OperateDocks::eventFilter(QObject* watched, QEvent* event) {
    // By its button or its action; what is hidden or restored here is not closed or opened by a person.
    if (watched == m_docks[scene] && !m_building && event->type() == QEvent::Close)
        m_sceneClosed[index()] = true;
    else if (watched == m_docks[scene] && !m_building && event->type() == QEvent::Show)
        m_sceneClosed[index()] = false;
    // Before the dock itself, which would float.
    if (event->type() == QEvent::MouseButtonDblClick) {
        const auto* dock = qobject_cast<QDockWidget*>(watched);
        const auto* mouse = static_cast<QMouseEvent*>(event);
        if (dock != nullptr && !dock->isFloating() && mouse->button() == Qt::LeftButton &&
            mouse->position().y() < dock->widget()->y()) {
            setMaximised(m_alone == dock->objectName() ? QString() : dock->objectName());
            return true;
        }
    }
    return QMainWindow::eventFilter(watched, event);
}

QList<QAction*> OperateDocks::actions() const {
    QList<QAction*> all;
    for (QDockWidget* dock : m_docks)
        all << dock->toggleViewAction();
    return all;
}

void OperateDocks::enableActions() {
    for (std::size_t i = 0; i < kDocks; ++i)
        m_docks[i]->toggleViewAction()->setVisible(isUsed(i) && isVisible());
}

QByteArray OperateDocks::saveLayouts() const {
    std::array<QByteArray, kLayouts> layouts = m_layouts;
    layouts[index()] = stateNow();
    QByteArray bytes;
    QDataStream stream(&bytes, QIODevice::WriteOnly);
    stream << kLayoutVersion;
    for (const QByteArray& layout : layouts)
        stream << layout;
    return bytes;
}

bool OperateDocks::restoreLayouts(const QByteArray& layouts) {
    forgetMaximised();
    QDataStream stream(layouts);
    qint32 version = 0;
    std::array<QByteArray, kLayouts> stored;
    stream >> version;
    // An older program knew fewer.
    for (QByteArray& layout : stored)
        if (!stream.atEnd())
            stream >> layout;
    const bool whole = stream.status() == QDataStream::Ok && version == kLayoutVersion;
    if (!whole || (!stored[index()].isEmpty() && !restore(stored[index()]))) {
        m_layouts = {};
        m_default.fill(true);
        resetLayout();
        return false;
    }
    m_layouts = std::move(stored);
    if (m_layouts[index()].isEmpty())
        resetLayout();
    return true;
}

void OperateDocks::resetLayout() {
    forgetMaximised();
    arrange();
    m_default[index()] = true;
    shareSpace();
}

bool OperateDocks::event(QEvent* event) {
    const bool done = QMainWindow::event(event);
    // Qt accepts only the release of a separator.
    if (event->type() == QEvent::MouseButtonRelease && event->isAccepted()) {
        m_default[index()] = false;
        noteSizes();
    }
    return done;
}

void OperateDocks::showEvent(QShowEvent* event) {
    QMainWindow::showEvent(event);
    enableActions();
    // Only now do the docks have room. A layout that was restored keeps its own shares.
    QMetaObject::invokeMethod(this, &OperateDocks::bringSizes, Qt::QueuedConnection);
}

/// Another page: its docks are not to be shown or closed from there.
void OperateDocks::hideEvent(QHideEvent* event) {
    QMainWindow::hideEvent(event);
    enableActions();
}

void OperateDocks::resizeEvent(QResizeEvent* event) {
    QMainWindow::resizeEvent(event);
    if (!isVisible() || !m_alone.isEmpty())
        return;
    if (m_default[index()])
        shareSpace();
    else
        keepSizes();
}

void OperateDocks::retranslate() {
    const std::array<QString, kDocks> titles{tr("Heatmap"),
                                             tr("Reconstruction"),
                                             tr("Features over time"),
                                             tr("Processing"),
                                             tr("Stiffness"),
                                             tr("Bracelet"),
                                             tr("Joints"),
                                             tr("Touches"),
                                             tr("Jog"),
                                             tr("Feedback"),
                                             tr("Contour"),
                                             tr("Servo"),
                                             tr("Servo runs"),
                                             tr("Run sheet"),
                                             tr("Camera"),
                                             tr("Events"),
                                             tr("Gel"),
                                             tr("Events"),
                                             tr("Scene"),
                                             tr("Marks")};
    // Qt says what its buttons do once, in the language of that time.
    constexpr const char* kQt = "QDockWidget";
    const auto name = [kQt](const QDockWidget& dock, const char* button, const char* text,
                            const char* description) {
        if (auto* found = dock.findChild<QAbstractButton*>(QLatin1String(button))) {
            found->setAccessibleName(QCoreApplication::translate(kQt, text));
            found->setAccessibleDescription(QCoreApplication::translate(kQt, description));
        }
    };
    for (std::size_t i = 0; i < kDocks; ++i) {
        m_docks[i]->setWindowTitle(titles[i]);
        name(*m_docks[i], "qt_dockwidget_closebutton", "Close", "Closes the dock widget");
        name(*m_docks[i], "qt_dockwidget_floatbutton", "Float", "Undocks and re-attaches the dock widget");
    }
    // The words of another language may need more lines.
    if (isVisible() && m_alone.isEmpty() && m_default[index()])
        QMetaObject::invokeMethod(this, &OperateDocks::bringSizes, Qt::QueuedConnection);
}

} // namespace teleta::console
