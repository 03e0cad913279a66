// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/link/web_socket.h"

#include "backend/core/failure.h"
#include "backend/core/steady_time.h"
#include "devices/link/link_text.h"

#include <QAbstractSocket>
#include <QByteArray>
#include <QEventLoop>
#include <QSocketNotifier>
#include <QString>
#include <QTimer>
#include <QUrl>
#include <QWebSocket>

#include <algorithm>
#include <chrono>
#include <deque>
#include <optional>
#include <utility>

namespace teleta::link {

namespace {

constexpr std::int64_t kPing_ns = 5'000'000'000;
/// More than that wait only when nobody reads; the oldest are left out then.
constexpr std::size_t kMostWaiting = 1024;

} // namespace

struct WebSocket::Data {
    QEventLoop loop; ///< made before the socket, which a thread without one would not serve
    QWebSocket socket;
    std::deque<QByteArray> messages;
    bool isOpen = false;
    bool isGone = false;
    std::int64_t nextPing_ns = 0;
    std::uint64_t leftOut = 0;
    std::string reason;

    explicit Data(bool textsOnly) {
        socket.setMaxAllowedIncomingMessageSize(kLongestMessage);
        QObject::connect(&socket, &QWebSocket::connected, &socket, [this] {
            isOpen = true;
            loop.quit();
        });
        QObject::connect(&socket, &QWebSocket::stateChanged, &socket,
                         [this](QAbstractSocket::SocketState state) {
                             if (state == QAbstractSocket::UnconnectedState)
                                 end();
                         });
        QObject::connect(&socket, &QWebSocket::textMessageReceived, &socket,
                         [this](const QString& text) { take(text.toUtf8()); });
        QObject::connect(&socket, &QWebSocket::binaryMessageReceived, &socket,
                         [this, textsOnly](const QByteArray& bytes) {
                             if (textsOnly)
                                 ++leftOut;
                             else
                                 take(bytes);
                         });
    }

    ~Data() {
        socket.disconnect(); // what it still says reaches nobody
    }

    void take(QByteArray message) {
        if (messages.size() >= kMostWaiting)
            messages.pop_front();
        messages.push_back(std::move(message));
        loop.quit();
    }

    void end() {
        if (!isGone) {
            const QString closed =
                socket.closeReason().isEmpty() ? socket.errorString() : socket.closeReason();
            reason = isOpen ? LinkText::tr("The server closed the connection (code %1): %2")
                                  .arg(static_cast<int>(socket.closeCode()))
                                  .arg(closed)
                                  .toStdString()
                            : closed.toStdString();
        }
        isGone = true;
        loop.quit();
    }

    /// Turns the loop until something happened.
    Outcome wait(std::int64_t deadline_ns, const WakePipe* wake) {
        const std::int64_t left_ns = deadline_ns - core::steadyNow_ns();
        if (left_ns <= 0)
            return Outcome::timedOut;
        bool isWoken = false;
        std::optional<QSocketNotifier> notifier;
        if (wake != nullptr && wake->descriptor() >= 0) {
            notifier.emplace(wake->descriptor(), QSocketNotifier::Read);
            QObject::connect(&*notifier, &QSocketNotifier::activated, &loop, [&] {
                isWoken = true;
                loop.quit();
            });
        }
        bool isLate = false;
        QTimer timer;
        timer.setSingleShot(true);
        timer.setTimerType(Qt::PreciseTimer);
        QObject::connect(&timer, &QTimer::timeout, &loop, [&] {
            isLate = true;
            loop.quit();
        });
        timer.start(std::chrono::ceil<std::chrono::milliseconds>(std::chrono::nanoseconds(left_ns)));
        loop.exec();
        if (isWoken)
            return Outcome::woken;
        if (isGone)
            return Outcome::gone;
        return isLate ? Outcome::timedOut : Outcome::done;
    }
};

WebSocket::WebSocket(std::unique_ptr<Data> data)
    : m_data(std::move(data)) {
}
WebSocket::WebSocket(WebSocket&& other) noexcept = default;
WebSocket& WebSocket::operator=(WebSocket&& other) noexcept = default;
WebSocket::~WebSocket() = default;

core::Expected<WebSocket> WebSocket::open(const WebAddress& address, std::int64_t deadline_ns,
                                          const WakePipe* wake) {
    const QString name = QString::fromStdString(address.url);
    auto data = std::make_unique<Data>(address.textsOnly);
    data->socket.open(QUrl(name));
    Outcome outcome = Outcome::done;
    while (!data->isOpen && outcome == Outcome::done)
        outcome = data->wait(deadline_ns, wake);
    if (outcome == Outcome::woken)
        return core::failed(core::ErrorKind::cancelled, LinkText::tr("connecting was cancelled"));
    if (!data->isOpen) {
        const QString why = data->isGone ? QString::fromStdString(data->reason) : LinkText::tr("no answer");
        return core::failed(core::ErrorKind::unavailable,
                            LinkText::tr("cannot connect to %1: %2").arg(name, why));
    }
    data->nextPing_ns = core::steadyNow_ns() + kPing_ns;
    return WebSocket(std::move(data));
}

Outcome WebSocket::read(std::span<std::uint8_t> buffer, std::size_t& count, std::int64_t deadline_ns,
                        const WakePipe* wake) {
    count = 0;
    while (m_data->messages.empty()) {
        if (m_data->isGone)
            return Outcome::gone;
        if (core::steadyNow_ns() >= m_data->nextPing_ns) {
            m_data->socket.ping();
            m_data->nextPing_ns = core::steadyNow_ns() + kPing_ns;
        }
        const Outcome outcome = m_data->wait(deadline_ns, wake);
        if (outcome == Outcome::woken || (outcome == Outcome::timedOut && m_data->messages.empty()))
            return outcome;
    }
    const QByteArray message = std::move(m_data->messages.front());
    m_data->messages.pop_front();
    count = std::min(buffer.size(), static_cast<std::size_t>(message.size()));
    std::copy_n(message.begin(), count, buffer.begin());
    return Outcome::done;
}

void WebSocket::tell(const std::string& text) {
    if (!text.empty())
        m_data->socket.sendTextMessage(QString::fromStdString(text));
    m_data->socket.flush();
}

std::uint64_t WebSocket::leftOut() const {
    return m_data->leftOut;
}

const std::string& WebSocket::goneReason() const {
    return m_data->reason;
}

} // namespace teleta::link
