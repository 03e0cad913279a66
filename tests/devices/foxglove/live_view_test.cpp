// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/mcap/cdr_reader.h"
#include "tests/devices/foxglove/live_streams.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QNetworkRequest>
#include <QTcpSocket>
#include <QThread>
#include <QWebSocket>

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstring>
#include <map>
#include <optional>
#include <string>
#include <vector>

using namespace teleta;
using foxglove::LiveView;
using foxglove::LiveViewStatus;
using test::waitUntil;

namespace {

/// A viewer, written by the protocol's text.
class Viewer {
public:
    explicit Viewer(std::uint16_t port, const char* protocol = "foxglove.websocket.v1") {
        QObject::connect(&m_socket, &QWebSocket::textMessageReceived, &m_socket, [this](const QString& text) {
            const QJsonObject object = QJsonDocument::fromJson(text.toUtf8()).object();
            const QString op = object["op"].toString();
            if (op == "serverInfo")
                m_info = object;
            for (const QJsonValue& entry : object["channels"].toArray())
                m_channels[entry["topic"].toString().toStdString()] = entry.toObject();
            for (const QJsonValue& id : object["channelIds"].toArray())
                std::erase_if(m_channels, [&](const auto& channel) { return channel.second["id"] == id; });
        });
        QObject::connect(&m_socket, &QWebSocket::binaryMessageReceived, &m_socket,
                         [this](const QByteArray& bytes) { m_messages.push_back(bytes.toStdString()); });
        QNetworkRequest request(QUrl(QStringLiteral("ws://127.0.0.1:%1").arg(port)));
        request.setRawHeader("Sec-WebSocket-Protocol", protocol);
        m_socket.open(request);
    }

    void say(const QJsonObject& object) {
        m_socket.sendTextMessage(QString::fromUtf8(QJsonDocument(object).toJson(QJsonDocument::Compact)));
    }
    void subscribe(std::uint32_t id, const std::string& topic) {
        say({{"op", "subscribe"},
             {"subscriptions", QJsonArray{QJsonObject{{"id", static_cast<qint64>(id)},
                                                      {"channelId", m_channels.at(topic)["id"]}}}}});
    }

    QWebSocket m_socket;
    std::optional<QJsonObject> m_info;
    std::map<std::string, QJsonObject> m_channels;
    std::vector<std::string> m_messages;
};

template <typename Number>
Number numberAt(const std::string& bytes, std::size_t at) {
    Number value{};
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
}

} // namespace

TEST(LiveView, announcesItsTopicsAndSendsThoseThatAreSubscribedTo) {
    const auto view = test::listeningView();
    ASSERT_NE(view, nullptr);
    const auto tap = view->addStream(test::skinInfo());
    for (const char* protocol : {"foxglove.websocket.v1", "foxglove.sdk.v1"}) {
        Viewer viewer(view->status().port, protocol);
        ASSERT_TRUE(waitUntil([&] { return viewer.m_info && viewer.m_channels.contains("/skin/array"); }));
        EXPECT_EQ((*viewer.m_info)["name"].toString(), "TeleTA Console");
        EXPECT_TRUE((*viewer.m_info)["capabilities"].toArray().isEmpty());
        const QJsonObject& channel = viewer.m_channels.at("/skin/array");
        EXPECT_EQ(channel["encoding"].toString(), "cdr");
        EXPECT_EQ(channel["schemaName"].toString(), "teleta_msgs/msg/TactileArray");
        EXPECT_EQ(channel["schemaEncoding"].toString(), "ros2msg");
        EXPECT_TRUE(channel["schema"].toString().startsWith("std_msgs/Header header\nuint32 rows\n"));
        EXPECT_TRUE(viewer.m_channels.contains("/events"));

        viewer.subscribe(77, "/skin/array");
        const auto before = std::chrono::system_clock::now().time_since_epoch();
        ASSERT_TRUE(waitUntil([&] {
            if (!viewer.m_messages.empty())
                return true;
            (void)test::appendSkin(*tap, 0.5F);
            return false;
        }));
        const std::string& message = viewer.m_messages.front();
        EXPECT_EQ(message[0], '\1');
        EXPECT_EQ(numberAt<std::uint32_t>(message, 1), 77U);
        const auto utc_ns = static_cast<double>(numberAt<std::uint64_t>(message, 5));
        EXPECT_NEAR(utc_ns * 1e-9, std::chrono::duration<double>(before).count(), 30.0) << "UTC";
        mcap::CdrReader cdr(std::string_view(message).substr(13));
        const auto seconds = cdr.number<std::int32_t>();
        const auto nanoseconds = cdr.number<std::uint32_t>();
        EXPECT_EQ(seconds * 1'000'000'000LL + nanoseconds,
                  static_cast<long long>(numberAt<std::uint64_t>(message, 5)));
        EXPECT_EQ(cdr.text(), "skin");
        EXPECT_EQ(cdr.number<std::uint32_t>(), 2U);
        EXPECT_EQ(cdr.number<std::uint32_t>(), 3U);
        EXPECT_EQ(cdr.number<double>(), 0.0034);
        EXPECT_EQ(cdr.text(), "N");
        (void)cdr.text();
        std::vector<float> values;
        cdr.sequence(values);
        EXPECT_EQ(values, (std::vector<float>{0.5F, 1.0F, 2.0F, 3.0F, 4.0F, 5.0F}));
        EXPECT_FALSE(cdr.failed());
    }
}

TEST(LiveView, takesBackTheTopicsOfAStreamThatIsOver) {
    const auto view = test::listeningView();
    ASSERT_NE(view, nullptr);
    auto tap = view->addStream(test::skinInfo());
    const auto same = view->addStream(test::skinInfo());
    Viewer viewer(view->status().port);
    ASSERT_TRUE(waitUntil([&] { return viewer.m_channels.contains("/skin_2/array"); }));
    EXPECT_TRUE(viewer.m_channels.contains("/skin/array"));
    tap.reset();
    EXPECT_TRUE(waitUntil([&] { return !viewer.m_channels.contains("/skin/array"); }));
    EXPECT_TRUE(viewer.m_channels.contains("/skin_2/array"));
}

TEST(LiveView, aSlowViewerMissesMessagesAndTheyAreCounted) {
    const auto view = test::listeningView();
    ASSERT_NE(view, nullptr);
    recording::StreamInfo large = test::skinInfo();
    large.shape = {256, 256};
    const auto tap = view->addStream(large);
    Viewer viewer(view->status().port);
    ASSERT_TRUE(waitUntil([&] { return viewer.m_channels.contains("/skin/array"); }));
    viewer.subscribe(1, "/skin/array");
    viewer.m_socket.flush();
    // From here on the viewer reads nothing, until megabytes wait for it.
    const std::vector<float> values(256 * 256, 1.0F);
    QDeadlineTimer deadline(test::kPatience_ms);
    while (view->status().dropped == 0 && !deadline.hasExpired()) {
        tap->append(core::steadyNow_ns(), 0.0, std::span<const float>(values));
        QThread::msleep(1);
    }
    EXPECT_GT(view->status().dropped, 0U);
    EXPECT_GT(view->status().sent, 0U);
    // What it gets later is new, not what was dropped.
    EXPECT_TRUE(waitUntil([&] { return viewer.m_messages.size() > 1; }));
}

TEST(LiveView, whatAViewerSendsDoesNoHarm) {
    const auto view = test::listeningView();
    ASSERT_NE(view, nullptr);
    Viewer viewer(view->status().port);
    ASSERT_TRUE(waitUntil([&] { return viewer.m_channels.contains("/events"); }));
    viewer.m_socket.sendTextMessage("rubbish");
    viewer.m_socket.sendBinaryMessage(QByteArray(1000, '\1'));
    viewer.say({{"op", "subscribe"}, {"subscriptions", "none"}});
    viewer.say({{"op", "subscribe"},
                {"subscriptions", QJsonArray{1, QJsonObject{{"id", -1}, {"channelId", 1e300}}}}});
    viewer.say({{"op", "unsubscribe"}, {"subscriptionIds", QJsonArray{17, "a", -1}}});
    viewer.say(
        {{"op", "setParameters"}, {"parameters", QJsonArray{QJsonObject{{"name", "stop"}, {"value", 1}}}}});
    viewer.subscribe(5, "/events");
    ASSERT_TRUE(waitUntil([&] {
        if (!viewer.m_messages.empty())
            return true;
        view->add({.time_ns = core::steadyNow_ns(), .kind = "mark", .text = "here", .value = 1.0});
        return false;
    }));
    EXPECT_NE(viewer.m_messages.front().find("here"), std::string::npos);
    EXPECT_EQ(view->status().clients, 1U);
}

TEST(LiveView, aPortThatIsTakenFailsAndSaysSo) {
    const auto view = test::listeningView();
    ASSERT_NE(view, nullptr);
    for (const foxglove::LiveViewOptions& options : {foxglove::LiveViewOptions{.port = view->status().port},
                                                     foxglove::LiveViewOptions{.address = "nowhere"}}) {
        LiveView other(options);
        ASSERT_TRUE(waitUntil([&] { return other.status().state == LiveViewStatus::State::failed; }));
        EXPECT_FALSE(other.status().error.empty());
        const auto tap = other.addStream(test::skinInfo());
        (void)test::appendSkin(*tap, 1.0F);
    }
}

TEST(LiveView, listensOnThisComputerOnly) {
    EXPECT_EQ(foxglove::LiveViewOptions().address, "127.0.0.1");
    const auto view = test::listeningView();
    ASSERT_NE(view, nullptr);
    QTcpSocket elsewhere;
    elsewhere.connectToHost(QStringLiteral("127.0.0.2"), view->status().port);
    EXPECT_FALSE(elsewhere.waitForConnected(1000));
}
