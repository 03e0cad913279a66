// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/study/running/participant_placement.h"

#include <QGuiApplication>
#include <QMargins>
#include <QScreen>
#include <QWidget>
#include <QWindow>

#include <algorithm>
#include <array>
#include <tuple>

namespace teleta::console {

namespace {

QRect onScreen(const QWidget& widget) {
    return {widget.mapToGlobal(QPoint()), widget.size()};
}

} // namespace

int participantScreen(const QList<QRect>& screens, int console) {
    const auto place = [&](int screen) { return std::tuple(screens[screen].left(), screens[screen].top()); };
    int best = -1;
    for (int screen = 0; screen < screens.size(); ++screen) {
        // On a mirrored screen the window would cover the console.
        if (screen == console || (console >= 0 && screens[screen] == screens[console]))
            continue;
        if (best < 0 || place(screen) > place(best))
            best = screen;
    }
    return best;
}

QRect placeBeside(const QRect& room, const QRect& taken, const QSize& wanted, const QSize& least) {
    std::array sides{room, room, room, room};
    sides[0].setLeft(std::max(room.left(), taken.right() + 1));
    sides[1].setRight(std::min(room.right(), taken.left() - 1));
    sides[2].setTop(std::max(room.top(), taken.bottom() + 1));
    sides[3].setBottom(std::min(room.bottom(), taken.top() - 1));
    QRect best;
    for (const QRect& side : sides) {
        if (side.width() < least.width() || side.height() < least.height())
            continue;
        QRect place(QPoint(), wanted.expandedTo(least).boundedTo(side.size()));
        place.moveCenter(side.center());
        if (place.width() * place.height() > best.width() * best.height())
            best = place;
    }
    return best;
}

ParticipantPlacement::ParticipantPlacement(QWidget& window, QWidget& console, QWidget& controls)
    : m_window(window)
    , m_console(console)
    , m_controls(controls) {
    connect(qGuiApp, &QGuiApplication::screenRemoved, this, &ParticipantPlacement::onScreenRemoved);
}

void ParticipantPlacement::show() {
    const QList<QScreen*> screens = QGuiApplication::screens();
    QList<QRect> places;
    for (const QScreen* screen : screens)
        places << screen->geometry();
    const int other = participantScreen(places, static_cast<int>(screens.indexOf(m_console.screen())));
    if (other < 0) {
        // A window that somebody has moved stays.
        if (m_screen != nullptr || m_window.isFullScreen() || !m_window.isVisible())
            showBeside();
    } else {
        m_screen = screens[other];
        stayAbove(false);
        m_window.setGeometry(places[other]);
        m_window.showFullScreen();
    }
    m_window.raise();
    m_window.activateWindow();
}

/// A click on the console does not hide the window. It is no transient window of the console: dialogs of the
/// experimenter would block the participant.
void ParticipantPlacement::stayAbove(bool above) {
    (void)m_window.winId(); // a window of the system
    m_window.windowHandle()->setFlag(Qt::WindowStaysOnTopHint, above);
}

void ParticipantPlacement::showBeside() {
    m_screen = nullptr;
    stayAbove(true);
    m_window.showNormal();
    const QRect room = m_console.screen()->availableGeometry();
    const QRect console = m_console.window()->frameGeometry();
    // Its frame will be as wide as the console's.
    const QRect inside = m_console.window()->geometry();
    const QMargins frame(inside.left() - console.left(), inside.top() - console.top(),
                         console.right() - inside.right(), console.bottom() - inside.bottom());
    const QSize wanted = m_window.sizeHint().expandedTo(room.size() / 2).grownBy(frame);
    const QSize least = m_window.minimumSizeHint().expandedTo(m_window.minimumSize()).grownBy(frame);
    const QRect page = onScreen(m_console).intersected(room);
    QRect place = placeBeside(room, console, wanted, least);
    if (place.isNull())
        place = placeBeside(page, onScreen(m_controls), wanted, least);
    const bool covers = place.isNull();
    if (covers) {
        place = QRect(QPoint(), least);
        place.moveTopRight(page.topRight());
    }
    m_window.setGeometry(place.marginsRemoved(frame));
    if (covers)
        emit consoleCovered();
}

void ParticipantPlacement::onScreenRemoved(QScreen* screen) {
    if (screen != m_screen)
        return;
    const bool wasShown = m_window.isVisible();
    m_screen = nullptr;
    if (!wasShown)
        return;
    showBeside();
    emit screenLost();
}

} // namespace teleta::console
