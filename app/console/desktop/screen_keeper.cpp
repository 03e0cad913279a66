// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/desktop/screen_keeper.h"

#include <QCoreApplication>
#include <QDBusMessage>
#include <QDBusObjectPath>
#include <QDBusPendingCallWatcher>
#include <QFileInfo>
#include <QVariantMap>

#include <cstdint>
#include <utility>

namespace teleta::console {

namespace {

constexpr std::uint32_t kIdle = 8; ///< flag of the portal: the session must not go idle

QString nameOf(ScreenKeeper::Service service) {
    return service == ScreenKeeper::Service::portal ? QStringLiteral("org.freedesktop.portal.Desktop")
                                                    : QStringLiteral("org.freedesktop.ScreenSaver");
}

/// Without one Qt would try to start a bus, and wait for it.
bool hasSessionBus() {
    const QString runtime = qEnvironmentVariable("XDG_RUNTIME_DIR");
    return !qEnvironmentVariableIsEmpty("DBUS_SESSION_BUS_ADDRESS") ||
           (!runtime.isEmpty() && QFileInfo::exists(runtime + QStringLiteral("/bus")));
}

QDBusMessage screenSaver(const char* method) {
    return QDBusMessage::createMethodCall(
        QStringLiteral("org.freedesktop.ScreenSaver"), QStringLiteral("/org/freedesktop/ScreenSaver"),
        QStringLiteral("org.freedesktop.ScreenSaver"), QLatin1String(method));
}

QDBusMessage question(ScreenKeeper::Service service, const QString& reason) {
    if (service == ScreenKeeper::Service::screenSaver) {
        QDBusMessage message = screenSaver("Inhibit");
        message << QCoreApplication::applicationName() << reason;
        return message;
    }
    QDBusMessage message = QDBusMessage::createMethodCall(
        nameOf(service), QStringLiteral("/org/freedesktop/portal/desktop"),
        QStringLiteral("org.freedesktop.portal.Inhibit"), QStringLiteral("Inhibit"));
    message << QString() << kIdle << QVariantMap{{QStringLiteral("reason"), reason}};
    return message;
}

QDBusMessage givingBack(ScreenKeeper::Service service, const QVariant& hold) {
    if (service == ScreenKeeper::Service::screenSaver) {
        QDBusMessage message = screenSaver("UnInhibit");
        message << hold;
        return message;
    }
    return QDBusMessage::createMethodCall(nameOf(service), hold.toString(),
                                          QStringLiteral("org.freedesktop.portal.Request"),
                                          QStringLiteral("Close"));
}

/// Cookie, or path of the request; nothing when the answer is another one.
QVariant holdOf(ScreenKeeper::Service service, const QDBusMessage& answer) {
    const QVariant value = answer.arguments().value(0);
    if (service == ScreenKeeper::Service::portal)
        return value.canConvert<QDBusObjectPath>() ? QVariant(value.value<QDBusObjectPath>().path())
                                                   : QVariant();
    return value.typeId() == QMetaType::UInt ? value : QVariant();
}

} // namespace

ScreenKeeper::Service ScreenKeeper::serviceHere() {
    return QFileInfo::exists(QStringLiteral("/.flatpak-info")) ? Service::portal : Service::screenSaver;
}

ScreenKeeper::ScreenKeeper(Service service, QObject* parent)
    : QObject(parent)
    , m_service(service)
    , m_bus(QString()) {
}

ScreenKeeper::~ScreenKeeper() {
    if (m_hold.isValid())
        m_bus.send(givingBack(m_service, m_hold));
}

bool ScreenKeeper::connectToBus() {
    if (m_watcher != nullptr)
        return m_bus.isConnected();
    if (!hasSessionBus())
        return false;
    m_bus = QDBusConnection::sessionBus();
    m_watcher = std::make_unique<QDBusServiceWatcher>(nameOf(m_service), m_bus,
                                                      QDBusServiceWatcher::WatchForUnregistration);
    connect(m_watcher.get(), &QDBusServiceWatcher::serviceUnregistered, this, [this] {
        if (m_state == State::idle)
            return;
        m_hold = {};
        ++m_asked;
        fail(tr("the service has ended"));
    });
    return m_bus.isConnected();
}

void ScreenKeeper::setWanted(bool wanted, const QString& reason) {
    if (wanted == m_wanted)
        return;
    m_wanted = wanted;
    if (wanted)
        ask(reason);
    else
        release();
}

void ScreenKeeper::ask(const QString& reason) {
    if (!connectToBus()) {
        fail(tr("there is no session bus"));
        return;
    }
    setState(State::asking);
    auto* call = new QDBusPendingCallWatcher(m_bus.asyncCall(question(m_service, reason)), this);
    connect(call, &QDBusPendingCallWatcher::finished, this,
            [this, number = ++m_asked](QDBusPendingCallWatcher* finished) {
                finished->deleteLater();
                const QDBusMessage answer = finished->reply();
                if (number == m_asked)
                    take(answer);
                else if (const QVariant hold = holdOf(m_service, answer); hold.isValid())
                    m_bus.send(givingBack(m_service, hold)); // it is not wanted any more
            });
}

void ScreenKeeper::take(const QDBusMessage& answer) {
    m_hold = answer.type() == QDBusMessage::ReplyMessage ? holdOf(m_service, answer) : QVariant();
    if (m_hold.isValid())
        setState(State::held);
    else
        fail(answer.errorMessage().isEmpty() ? tr("the answer is not understood") : answer.errorMessage());
}

void ScreenKeeper::release() {
    ++m_asked;
    if (m_hold.isValid())
        m_bus.send(givingBack(m_service, std::exchange(m_hold, {})));
    setState(State::idle);
}

void ScreenKeeper::fail(const QString& why) {
    setState(State::unavailable);
    if (!std::exchange(m_told, true))
        emit failed(why);
}

void ScreenKeeper::setState(State state) {
    if (std::exchange(m_state, state) != state)
        emit stateChanged();
}

} // namespace teleta::console
