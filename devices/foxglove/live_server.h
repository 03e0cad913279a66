// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/mcap/recorded/stream_encoder.h"

#include <QByteArray>
#include <QString>

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

class QJsonArray;
class QTcpServer;
class QWebSocket;
class QWebSocketServer;

namespace teleta::foxglove {

/// Serves topics over WebSocket, as Foxglove reads them: it announces channels, and sends the messages of
/// those to which a client has subscribed. What a client sends besides subscriptions is ignored. A client
/// that has more than kMostUnsent bytes unsent misses messages, which are counted: what it gets is new.
/// Thread: one with an event loop. Source: Foxglove WebSocket protocol, foxglove.websocket.v1.
class LiveServer {
public:
    static constexpr std::int64_t kMostUnsent = 1'000'000;
    static constexpr std::size_t kMostClients = 16;

    LiveServer();
    ~LiveServer();
    LiveServer(const LiveServer&) = delete;
    LiveServer& operator=(const LiveServer&) = delete;

    /// port: 0 takes any that is free. Error: unavailable, nobody can listen there.
    [[nodiscard]] core::Expected<void> listen(const std::string& address, std::uint16_t port);
    [[nodiscard]] std::uint16_t port() const;

    /// Announces a topic to all clients; returns the number of its channel.
    std::uint32_t advertise(mcap::TopicType topic);
    void unadvertise(std::uint32_t channel);
    /// Whether somebody has subscribed to it.
    [[nodiscard]] bool isWanted(std::uint32_t channel) const;
    /// message: in CDR.
    void publish(std::uint32_t channel, std::int64_t utc_ns, std::string_view message);

    [[nodiscard]] std::size_t clients() const { return m_clients.size(); }
    [[nodiscard]] std::uint64_t sent() const { return m_sent; }
    /// Messages that clients missed.
    [[nodiscard]] std::uint64_t dropped() const { return m_dropped; }

private:
    struct Client {
        QWebSocket* socket = nullptr;
        std::map<std::uint32_t, std::uint32_t> subscriptions; ///< channels, by number of the subscription
    };

    void takeConnections();
    void accept();
    void receive(QWebSocket* socket, const QString& text);
    void forget(QWebSocket* socket);
    [[nodiscard]] QByteArray announcement(const std::vector<std::uint32_t>& channels) const;

    std::unique_ptr<QWebSocketServer> m_server;
    std::unique_ptr<QTcpServer> m_listener; ///< gives its connections to the server
    std::vector<Client> m_clients;
    std::map<std::uint32_t, mcap::TopicType> m_topics; ///< by number of the channel
    std::uint32_t m_next = 1;
    std::uint64_t m_sent = 0;
    std::uint64_t m_dropped = 0;
};

} // namespace teleta::foxglove
