// SPDX-License-Identifier: GPL-3.0-or-later
// A camera of the kernel's driver vivid as the console opens it: by a request, into a channel that tracks.
#include "app/console/sources/source_manager.h"
#include "backend/pipeline/camera_channel.h"
#include "backend/vision/calibration/camera_file.h"
#include "backend/vision/camera/nominal_camera.h"
#include "tests/peer/vivid_driver.h"

#include <QObject>

#include <gtest/gtest.h>

#include <cerrno>
#include <chrono>
#include <memory>
#include <string>
#include <thread>
#include <vector>

using namespace teleta;
using app::CameraRequest;
using console::SourceManager;
using core::DeviceState;
using pipeline::CameraChannel;
using pipeline::CameraEvent;
using test::kVividNode;
using test::kVividPatience;
using test::setVividFormat;
using test::toVividDriver;

namespace {

constexpr int kWidth_px = 640;
constexpr int kHeight_px = 360;

class CameraRequestPeer : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(vision::writeCamera(
            {.camera = vision::nominalCamera(kWidth_px, kHeight_px), .summary = {}, .others = {}}, kModel));
        QObject::connect(&m_sources, &SourceManager::failed,
                         [this](const QString& name, const core::Error& error) {
                             m_failures.push_back(name.toStdString() + ": " + describe(error));
                         });
    }

    template <typename Condition>
    [[nodiscard]] bool eventually(const Condition& condition) {
        const auto end = std::chrono::steady_clock::now() + kVividPatience;
        while (std::chrono::steady_clock::now() < end) {
            m_sources.poll();
            if (condition())
                return true;
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        return condition();
    }

    /// Null when it does not open; m_failures says why.
    std::shared_ptr<CameraChannel> opened() {
        m_key = m_sources.open(CameraRequest{.source = "0", .modelPath = kModel});
        const auto* item = m_sources.find(m_key);
        EXPECT_EQ(item->name.toStdString(), kVividNode);
        if (!eventually([&] { return !m_failures.empty() || m_sources.find(m_key)->isOpen(); }) ||
            !m_failures.empty())
            return nullptr;
        return m_sources.find(m_key)->camera();
    }

    [[nodiscard]] bool processes(CameraChannel& channel, std::uint64_t frames) {
        const std::uint64_t before = channel.framesProcessed();
        return eventually([&] { return channel.framesProcessed() >= before + frames; });
    }

    static constexpr const char* kModel = "/tmp/camera.json";
    core::StopSwitch m_stop;
    SourceManager m_sources{m_stop};
    pipeline::ChannelKey m_key = 0;
    std::vector<std::string> m_failures;
};

} // namespace

TEST_F(CameraRequestPeer, itsFramesArriveInTheSizeOfTheModelAndItIsLetGoWhenItIsClosed) {
    ASSERT_EQ(setVividFormat(320, 180), 0) << "another one before";
    auto channel = opened();
    ASSERT_TRUE(channel) << (m_failures.empty() ? "no answer" : m_failures.front());
    EXPECT_FALSE(channel->description().recorded);
    EXPECT_FALSE(channel->description().simulated);
    double last_s = -1.0;
    for (int i = 0; i < 5; ++i) {
        ASSERT_TRUE(eventually([&] { return channel->update(); })) << i;
        const pipeline::CameraSnapshot& now = channel->snapshot();
        EXPECT_EQ(now.image.width_px, kWidth_px);
        EXPECT_EQ(now.image.height_px, kHeight_px);
        EXPECT_FALSE(now.preview.isEmpty());
        EXPECT_TRUE(now.hasReference);
        EXPECT_TRUE(now.usable) << now.problem;
        EXPECT_GT(now.time_s, last_s);
        last_s = now.time_s;
    }
    EXPECT_EQ(channel->status().state, DeviceState::live);
    EXPECT_EQ(setVividFormat(320, 180), EBUSY) << "while it streams";
    m_sources.close(m_key);
    channel.reset();
    EXPECT_TRUE(eventually([] { return setVividFormat(320, 180) == 0; }));
}

TEST_F(CameraRequestPeer, oneThatIsUnpluggedIsToldAndItsFramesGoOnWhenItIsBack) {
    const auto channel = opened();
    ASSERT_TRUE(channel) << (m_failures.empty() ? "no answer" : m_failures.front());
    ASSERT_TRUE(processes(*channel, 3));
    for (int round = 0; round < 3; ++round) {
        ASSERT_NO_FATAL_FAILURE(toVividDriver("unbind"));
        ASSERT_TRUE(eventually([&] {
            const core::DeviceStatus status = channel->status();
            return (status.state == DeviceState::lost || status.state == DeviceState::reconnecting) &&
                   !status.message.empty();
        })) << round;
        ASSERT_NO_FATAL_FAILURE(toVividDriver("bind"));
        ASSERT_TRUE(eventually([&] { return channel->status().state == DeviceState::live; })) << round;
        ASSERT_TRUE(processes(*channel, 20)) << round;
        int restarts = 0;
        CameraEvent event;
        while (channel->popEvent(event))
            restarts += event.kind == CameraEvent::Kind::restart ? 1 : 0;
        EXPECT_EQ(restarts, 1) << round;
    }
    (void)channel->update();
    EXPECT_TRUE(channel->snapshot().usable) << channel->snapshot().problem;
    EXPECT_EQ(channel->snapshot().image.width_px, kWidth_px);
    EXPECT_TRUE(m_failures.empty()) << "the source stays open";
}

TEST_F(CameraRequestPeer, oneThatIsNotThereIsToldWithItsName) {
    ASSERT_NO_FATAL_FAILURE(toVividDriver("unbind"));
    EXPECT_FALSE(opened());
    ASSERT_NO_FATAL_FAILURE(toVividDriver("bind"));
    ASSERT_EQ(m_failures.size(), 1U);
    EXPECT_NE(m_failures.front().find(kVividNode), std::string::npos) << m_failures.front();
    EXPECT_TRUE(m_sources.items().empty());
    m_failures.clear();
    // A moment later it is plugged in.
    ASSERT_TRUE(eventually([] { return setVividFormat(kWidth_px, kHeight_px) == 0; }));
    const auto channel = opened();
    ASSERT_TRUE(channel) << (m_failures.empty() ? "no answer" : m_failures.front());
    EXPECT_TRUE(processes(*channel, 2));
}
