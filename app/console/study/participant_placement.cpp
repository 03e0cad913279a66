// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/study/participant_placement.h"

#include <QGuiApplication>
#include <QScreen>
#include <QWidget>

#include <tuple>

namespace teleta::console {

int participantScreen(const QList<QRect>& screens, int console) {
    const auto place = [&](int screen) { return std::tuple(screens[screen].left(), screens[screen].top()); };
    int best = -1;
    for (int screen = 0; screen < screens.size(); ++screen) {
        // Mirrored screens show the same: on one of them the window would cover the console's.
        if (screen == console || (console >= 0 && screens[screen] == screens[console]))
            continue;
        if (best < 0 || place(screen) > place(best))
            best = screen;
    }
    return best;
}

ParticipantPlacement::ParticipantPlacement(QWidget& window, QWidget& console)
    : m_window(window)
    , m_console(console) {
    connect(qGuiApp, &QGuiApplication::screenRemoved, this, &ParticipantPlacement::onScreenRemoved);
}

void ParticipantPlacement::show() {
    const QList<QScreen*> screens = QGuiApplication::screens();
    QList<QRect> places;
    for (const QScreen* screen : screens)
        places << screen->geometry();
    const int other = participantScreen(places, static_cast<int>(screens.indexOf(m_console.screen())));
    if (other < 0) {
        if (m_screen != nullptr || m_window.isFullScreen())
            showBeside();
        else
            m_window.show();
    } else {
        m_screen = screens[other];
        m_window.setGeometry(places[other]);
        m_window.showFullScreen();
    }
    m_window.raise();
    m_window.activateWindow();
}

void ParticipantPlacement::showBeside() {
    m_screen = nullptr;
    m_window.showNormal();
    const QRect room = m_console.screen()->availableGeometry();
    QRect place(QPoint(), m_window.sizeHint().expandedTo(room.size() / 2).boundedTo(room.size()));
    place.moveCenter(room.center());
    m_window.setGeometry(place);
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
