// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDBusConnection>
#include <QDBusServiceWatcher>
#include <QObject>
#include <QString>
#include <QVariant>

#include <memory>

class QDBusMessage;
class QDBusPendingCallWatcher;

namespace teleta::console {

/// Asks the desktop to keep the screen on while something runs that a person watches: by
/// org.freedesktop.ScreenSaver on the session bus, in a Flatpak by the portal. Without a bus, without the
/// service, or when the service goes away it says so once and nothing else happens. Thread: GUI; no call
/// waits.
class ScreenKeeper : public QObject {
    Q_OBJECT

public:
    enum class Service {
        screenSaver, ///< org.freedesktop.ScreenSaver
        portal,      ///< org.freedesktop.portal.Inhibit
    };
    enum class State {
        idle,        ///< nobody wants it
        asking,      ///< the service has not answered yet
        held,        ///< the screen stays on
        unavailable, ///< it is wanted, but nobody does it
    };

    /// The portal in a Flatpak, else the screen saver.
    [[nodiscard]] static Service serviceHere();

    explicit ScreenKeeper(Service service = serviceHere(), QObject* parent = nullptr);
    ~ScreenKeeper() override;

    /// Whether the screen is to stay on; cheap when nothing changes. reason: shown by the desktop.
    void setWanted(bool wanted, const QString& reason);
    [[nodiscard]] State state() const { return m_state; }

signals:
    void stateChanged();
    /// The first time that the screen cannot be kept on. why: of the bus.
    void failed(const QString& why);

private:
    [[nodiscard]] bool connectToBus();
    void ask(const QString& reason);
    void take(const QDBusMessage& answer);
    void release();
    void fail(const QString& why);
    void setState(State state);

    Service m_service;
    QDBusConnection m_bus;
    std::unique_ptr<QDBusServiceWatcher> m_watcher;
    State m_state = State::idle;
    bool m_wanted = false;
    bool m_told = false;
    int m_asked = 0;      ///< counts the questions: an answer to an older one is given back
    QVariant m_hold = {}; ///< cookie, or path of the request
};

} // namespace teleta::console
