// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/camera/camera_device.h"
#include "tests/backend/core/temporary_folder.h"
#include "tests/devices/camera/written_video.h"

#include <gtest/gtest.h>

#include <chrono>
#include <vector>

namespace teleta::camera {
namespace {

using core::CameraFrame;
using core::DeviceState;

constexpr int kFrames = 30;

class CameraDeviceTest : public testing::Test {
protected:
    void SetUp() override { ASSERT_NO_FATAL_FAILURE(test::writeVideo(m_path, kFrames, 100.0)); }

    /// Takes frames until there are so many or the device has ended; fails after a long while.
    std::vector<CameraFrame> take(CameraDevice& device, std::size_t count) {
        std::vector<CameraFrame> frames;
        for (int i = 0; i < 2000 && frames.size() < count; ++i) {
            (void)m_wakeup.waitFor(std::chrono::milliseconds(20));
            CameraFrame frame;
            while (frames.size() < count && device.frames().pop(frame))
                frames.push_back(std::move(frame));
            const DeviceState state = device.status().state;
            if (state == DeviceState::finished && device.frames().size() == 0)
                break;
        }
        return frames;
    }

    test::TemporaryFolder m_folder;
    std::string m_path = m_folder.path("video.avi");
    core::Wakeup m_wakeup;
};

} // namespace

TEST_F(CameraDeviceTest, deliversEveryFrameOfAFileThatIsPlayedAsFastAsItIsTaken) {
    auto device = CameraDevice::open({.source = m_path, .paced = false, .queueFrames = 4});
    ASSERT_TRUE(device) << describe(device.error());
    (*device)->start(m_wakeup);
    const auto frames = take(**device, kFrames + 1);
    ASSERT_EQ(frames.size(), static_cast<std::size_t>(kFrames));
    for (std::size_t i = 0; i < frames.size(); ++i) {
        EXPECT_EQ(frames[i].number, i);
        EXPECT_NEAR(frames[i].capture_s, static_cast<double>(i) / 100.0, 1e-6);
        EXPECT_FALSE(frames[i].image.isEmpty());
        EXPECT_GE(frames[i].time_ns, i == 0 ? 1 : frames[i - 1].time_ns);
    }
    EXPECT_EQ((*device)->status().state, DeviceState::finished);
    EXPECT_EQ((*device)->status().framesLost, 0U);
}

TEST_F(CameraDeviceTest, beginsAnewWithADiscontinuityInALoop) {
    auto device = CameraDevice::open({.source = m_path, .paced = false, .loop = true, .queueFrames = 4});
    ASSERT_TRUE(device);
    (*device)->start(m_wakeup);
    const auto frames = take(**device, kFrames + 5);
    ASSERT_EQ(frames.size(), static_cast<std::size_t>(kFrames + 5));
    EXPECT_FALSE(frames[kFrames - 1].discontinuity);
    EXPECT_TRUE(frames[kFrames].discontinuity);
    EXPECT_EQ(frames[kFrames].capture_s, 0.0);
    (*device)->stop();
    EXPECT_EQ((*device)->status().state, DeviceState::closed);
}

TEST_F(CameraDeviceTest, keepsTheNewestFramesWhenNobodyTakesThemInTheTimeOfTheFile) {
    auto device = CameraDevice::open({.source = m_path, .queueFrames = 2});
    ASSERT_TRUE(device);
    (*device)->start(m_wakeup);
    for (int i = 0; i < 2000 && (*device)->status().state != DeviceState::finished; ++i)
        (void)m_wakeup.waitFor(std::chrono::milliseconds(20));
    EXPECT_EQ((*device)->status().state, DeviceState::finished);
    EXPECT_EQ((*device)->status().framesRead, static_cast<std::uint64_t>(kFrames));
    EXPECT_EQ((*device)->status().framesLost, 0U);
    const auto frames = take(**device, 3);
    ASSERT_EQ(frames.size(), 2U);
    EXPECT_EQ(frames[0].passedOver, static_cast<std::uint64_t>(kFrames - 2));
    EXPECT_EQ(frames[1].number, static_cast<std::uint64_t>(kFrames - 1));
}

TEST_F(CameraDeviceTest, stopsAtOnceWhileItWaitsAndStartsAgain) {
    auto device = CameraDevice::open({.source = m_path});
    ASSERT_TRUE(device);
    (*device)->start(m_wakeup);
    EXPECT_FALSE(take(**device, 2).empty());
    (*device)->stop();
    (*device)->stop();
    EXPECT_EQ((*device)->status().state, DeviceState::closed);
    CameraFrame frame;
    while ((*device)->frames().pop(frame)) {
    }
    (*device)->start(m_wakeup);
    const auto frames = take(**device, 1);
    ASSERT_EQ(frames.size(), 1U);
    EXPECT_EQ(frames.front().number, 0U);
    EXPECT_EQ(frames.front().capture_s, 0.0);
}

TEST(CameraNumber, isWhatTheStreamOpensAsACamera) {
    for (const char* source : {"0", "7", "12"})
        EXPECT_TRUE(isCameraNumber(source)) << source;
    for (const char* source : {"", "-1", "1.avi", "0x1", " 1", "99999999999"})
        EXPECT_FALSE(isCameraNumber(source)) << source;
}

TEST_F(CameraDeviceTest, reportsAFileThatIsNotThere) {
    EXPECT_FALSE(CameraDevice::open({.source = m_folder.path("missing.avi")}));
}

} // namespace teleta::camera
