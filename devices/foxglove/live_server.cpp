// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/foxglove/live_server.h"

#include "backend/core/failure.h"
#include "backend/mcap/byte_fields.h"

#include <QCoreApplication>
#include <QHostAddress>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStringList>
#include <QTcpServer>
#include <QTcpSocket>
#include <QUuid>
#include <QWebSocket>
#include <QWebSocketServer>

#include <algorithm>
#include <limits>
#include <utility>

namespace teleta::foxglove {

namespace {

struct LiveServerText {
    Q_DECLARE_TR_FUNCTIONS(LiveView)
};

constexpr char kMessageData = 1;
constexpr std::size_t kMessageHead = 1 + 4 + 8;
/// Of what a client sends.
constexpr quint64 kMostIncoming = 1U << 20U;
constexpr std::size_t kMostSubscriptions = 4096;

QByteArray textOf(const QJsonObject& object) {
    return QJsonDocument(object).toJson(QJsonDocument::Compact);
}

/// A number of 32 bits; empty for anything else.
std::optional<std::uint32_t> numberOf(const QJsonValue& value) {
    const double number = value.toDouble(-1.0);
    if (number < 0.0 || number > double{std::numeric_limits<std::uint32_t>::max()} ||
        number != static_cast<double>(static_cast<std::uint32_t>(number)))
        return std::nullopt;
    return static_cast<std::uint32_t>(number);
}

} // namespace

LiveServer::LiveServer()
    : m_server(std::make_unique<QWebSocketServer>(QStringLiteral("TeleTA Console"),
                                                  QWebSocketServer::NonSecureMode))
    , m_listener(std::make_unique<QTcpServer>()) {
    m_server->setSupportedSubprotocols(
        {QStringLiteral("foxglove.websocket.v1"), QStringLiteral("foxglove.sdk.v1")});
    QObject::connect(m_listener.get(), &QTcpServer::newConnection, m_server.get(),
                     [this] { takeConnections(); });
    QObject::connect(m_server.get(), &QWebSocketServer::newConnection, m_server.get(), [this] { accept(); });
}

LiveServer::~LiveServer() {
    for (const Client& client : m_clients) {
        client.socket->disconnect(m_server.get());
        client.socket->abort();
        delete client.socket;
    }
}

core::Expected<void> LiveServer::listen(const std::string& address, std::uint16_t port) {
    const QHostAddress host(QString::fromStdString(address));
    if (host.isNull())
        return core::failed(core::ErrorKind::unavailable,
                            LiveServerText::tr("\"%1\" is no address").arg(QString::fromStdString(address)),
                            LiveServerText::tr("an address such as 127.0.0.1"));
    if (!m_listener->listen(host, port))
        return core::failed(core::ErrorKind::unavailable,
                            LiveServerText::tr("the live view cannot listen on %1:%2: %3")
                                .arg(QString::fromStdString(address))
                                .arg(port)
                                .arg(m_listener->errorString()),
                            LiveServerText::tr("another port"));
    return {};
}

std::uint16_t LiveServer::port() const {
    return m_listener->serverPort();
}

/// Without delay: otherwise a small message waits for the answer to the one before, up to 40 ms.
void LiveServer::takeConnections() {
    while (QTcpSocket* connection = m_listener->nextPendingConnection()) {
        connection->setSocketOption(QAbstractSocket::LowDelayOption, 1);
        m_server->handleConnection(connection);
    }
}

void LiveServer::accept() {
    while (QWebSocket* socket = m_server->nextPendingConnection()) {
        if (m_clients.size() >= kMostClients) {
            socket->close(QWebSocketProtocol::CloseCodePolicyViolated);
            socket->deleteLater();
            continue;
        }
        socket->setMaxAllowedIncomingMessageSize(kMostIncoming);
        QObject::connect(socket, &QWebSocket::textMessageReceived, m_server.get(),
                         [this, socket](const QString& text) { receive(socket, text); });
        QObject::connect(socket, &QWebSocket::disconnected, m_server.get(),
                         [this, socket] { forget(socket); });
        m_clients.push_back({socket, {}});
        socket->sendTextMessage(QString::fromUtf8(
            textOf({{"op", "serverInfo"},
                    {"name", m_server->serverName()},
                    {"capabilities", QJsonArray()},
                    {"supportedEncodings", QJsonArray()},
                    {"metadata", QJsonObject{{"app_version", QCoreApplication::applicationVersion()}}},
                    {"sessionId", QUuid::createUuid().toString(QUuid::WithoutBraces)}})));
        std::vector<std::uint32_t> channels;
        for (const auto& [channel, topic] : m_topics)
            channels.push_back(channel);
        socket->sendTextMessage(QString::fromUtf8(announcement(channels)));
    }
}

QByteArray LiveServer::announcement(const std::vector<std::uint32_t>& channels) const {
    QJsonArray list;
    for (const std::uint32_t channel : channels) {
        const mcap::TopicType& topic = m_topics.at(channel);
        list.append(QJsonObject{{"id", static_cast<qint64>(channel)},
                                {"topic", QString::fromStdString(topic.topic)},
                                {"encoding", "cdr"},
                                {"schemaName", QString::fromStdString(topic.schemaName)},
                                {"schema", QString::fromStdString(topic.schemaText)},
                                {"schemaEncoding", "ros2msg"}});
    }
    return textOf({{"op", "advertise"}, {"channels", list}});
}

void LiveServer::receive(QWebSocket* socket, const QString& text) {
    const auto client = std::ranges::find(m_clients, socket, &Client::socket);
    if (client == m_clients.end())
        return;
    const QJsonObject object = QJsonDocument::fromJson(text.toUtf8()).object();
    const QString op = object.value(QLatin1String("op")).toString();
    if (op == QLatin1String("subscribe")) {
        for (const QJsonValue& entry : object.value(QLatin1String("subscriptions")).toArray()) {
            const auto id = numberOf(entry.toObject().value(QLatin1String("id")));
            const auto channel = numberOf(entry.toObject().value(QLatin1String("channelId")));
            if (id && channel && client->subscriptions.size() < kMostSubscriptions)
                client->subscriptions[*id] = *channel;
        }
    } else if (op == QLatin1String("unsubscribe")) {
        for (const QJsonValue& entry : object.value(QLatin1String("subscriptionIds")).toArray()) {
            if (const auto id = numberOf(entry))
                client->subscriptions.erase(*id);
        }
    }
}

void LiveServer::forget(QWebSocket* socket) {
    std::erase_if(m_clients, [socket](const Client& client) { return client.socket == socket; });
    socket->deleteLater();
}

std::uint32_t LiveServer::advertise(mcap::TopicType topic) {
    const std::uint32_t channel = m_next++;
    m_topics.emplace(channel, std::move(topic));
    const QString text = QString::fromUtf8(announcement({channel}));
    for (const Client& client : m_clients)
        client.socket->sendTextMessage(text);
    return channel;
}

void LiveServer::unadvertise(std::uint32_t channel) {
    m_topics.erase(channel);
    const QString text = QString::fromUtf8(
        textOf({{"op", "unadvertise"}, {"channelIds", QJsonArray{static_cast<qint64>(channel)}}}));
    for (Client& client : m_clients) {
        std::erase_if(client.subscriptions, [channel](const auto& entry) { return entry.second == channel; });
        client.socket->sendTextMessage(text);
    }
}

bool LiveServer::isWanted(std::uint32_t channel) const {
    return std::ranges::any_of(m_clients, [channel](const Client& client) {
        return std::ranges::any_of(client.subscriptions,
                                   [channel](const auto& entry) { return entry.second == channel; });
    });
}

void LiveServer::publish(std::uint32_t channel, std::int64_t utc_ns, std::string_view message) {
    for (const Client& client : m_clients) {
        for (const auto& [id, wanted] : client.subscriptions) {
            if (wanted != channel)
                continue;
            if (client.socket->bytesToWrite() > kMostUnsent) {
                ++m_dropped;
                continue;
            }
            std::string bytes;
            bytes.reserve(kMessageHead + message.size());
            bytes.push_back(kMessageData);
            mcap::appendNumber(bytes, id);
            mcap::appendNumber(bytes, static_cast<std::uint64_t>(utc_ns));
            bytes.append(message);
            client.socket->sendBinaryMessage(QByteArray(bytes.data(), static_cast<qsizetype>(bytes.size())));
            ++m_sent;
        }
    }
}

} // namespace teleta::foxglove
