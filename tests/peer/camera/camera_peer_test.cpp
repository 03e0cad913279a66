// SPDX-License-Identifier: GPL-3.0-or-later
// The camera device against the kernel's own video stack: a camera of the driver vivid. Runs in the virtual
// machine of tests/peer/vm.
#include "devices/camera/camera_device.h"
#include "devices/camera/video_stream.h"
#include "tests/peer/vivid_driver.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <thread>
#include <vector>

using namespace teleta;
using camera::CameraDevice;
using core::CameraFrame;
using core::DeviceState;
using test::kVividNode;
using test::kVividPatience;
using test::setVividFormat;
using test::setVividLoss;
using test::toVividDriver;

namespace {

cv::Size sizeOf(const CameraFrame& frame) {
    return {frame.image.width_px, frame.image.height_px};
}

class Vivid : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(std::filesystem::exists(kVividNode));
        ASSERT_EQ(setVividFormat(640, 360), 0);
        ASSERT_EQ(setVividLoss(0), 0);
    }

    std::unique_ptr<CameraDevice> started(camera::CameraConfig config = {.source = "0"}) {
        config.firstRetry_ms = 50;
        config.longestRetry_ms = 200;
        auto device = CameraDevice::open(config);
        EXPECT_TRUE(device) << describe(device.error());
        if (!device)
            return nullptr;
        (*device)->start(m_wakeup);
        return std::move(*device);
    }

    /// Empty when none came in a long time.
    std::optional<CameraFrame> nextFrame(CameraDevice& device) {
        const auto end = std::chrono::steady_clock::now() + kVividPatience;
        CameraFrame frame;
        while (std::chrono::steady_clock::now() < end) {
            if (device.frames().pop(frame))
                return frame;
            (void)m_wakeup.waitFor(std::chrono::milliseconds(50));
        }
        return std::nullopt;
    }

    /// Frames that come meanwhile lie in m_taken.
    bool reaches(CameraDevice& device, DeviceState wanted) {
        m_taken.clear();
        const auto end = std::chrono::steady_clock::now() + kVividPatience;
        while (std::chrono::steady_clock::now() < end) {
            const bool there = device.status().state == wanted;
            CameraFrame frame;
            while (device.frames().pop(frame))
                m_taken.push_back(std::move(frame));
            if (there)
                return true;
            (void)m_wakeup.waitFor(std::chrono::milliseconds(5));
        }
        return false;
    }

    core::Wakeup m_wakeup;
    std::vector<CameraFrame> m_taken;
};

} // namespace

TEST_F(Vivid, framesComeWithTheDriversCaptureTimesWhichRise) {
    const auto device = started();
    ASSERT_TRUE(device);
    double last_s = -1.0;
    std::int64_t last_ns = 0;
    for (int i = 0; i < 20; ++i) {
        const auto frame = nextFrame(*device);
        ASSERT_TRUE(frame) << i;
        EXPECT_EQ(sizeOf(*frame), cv::Size(640, 360));
        EXPECT_GT(frame->capture_s, last_s);
        EXPECT_GE(frame->time_ns, last_ns);
        EXPECT_EQ(frame->discontinuity, false);
        last_s = frame->capture_s;
        last_ns = frame->time_ns;
    }
    // A test picture: bars from black to white of three quarters.
    const auto frame = nextFrame(*device);
    ASSERT_TRUE(frame);
    ASSERT_FALSE(frame->image.isEmpty());
    const auto [darkest, brightest] =
        std::minmax_element(frame->image.pixels.get(), frame->image.pixels.get() + sizeOf(*frame).area());
    EXPECT_LT(*darkest, 60);
    EXPECT_GT(*brightest, 180);
    EXPECT_EQ(device->status().state, DeviceState::live);
    // Stamps made here by counting frames would be exact multiples of the period.
    EXPECT_GT(device->description().nominalRate_Hz, 0.0);
    const double periods = last_s * device->description().nominalRate_Hz;
    EXPECT_GT(std::abs(periods - std::round(periods)), 1e-9);
}

TEST_F(Vivid, theAskedSizeIsTakenAndWithoutOneTheCamerasOwn) {
    {
        const auto device = started({.source = "0", .width_px = 1280, .height_px = 720});
        ASSERT_TRUE(device);
        const auto frame = nextFrame(*device);
        ASSERT_TRUE(frame);
        EXPECT_EQ(sizeOf(*frame), cv::Size(1280, 720));
        // While it streams, no other program can change it.
        EXPECT_EQ(setVividFormat(320, 180), EBUSY);
        EXPECT_TRUE(nextFrame(*device));
    }
    ASSERT_EQ(setVividFormat(320, 180), 0);
    const auto device = started();
    ASSERT_TRUE(device);
    const auto frame = nextFrame(*device);
    ASSERT_TRUE(frame);
    EXPECT_EQ(sizeOf(*frame), cv::Size(320, 180));
}

TEST_F(Vivid, aCameraThatAnotherProgramReadsIsNotOpenedAndSaysSoUntilItIsFree) {
    {
        const auto first = started();
        ASSERT_TRUE(first);
        ASSERT_TRUE(nextFrame(*first));
        const auto second = CameraDevice::open({.source = "0"});
        ASSERT_FALSE(second);
        EXPECT_EQ(second.error().kind, core::ErrorKind::unavailable);
        EXPECT_NE(second.error().message.find("another program uses camera 0"), std::string::npos)
            << describe(second.error());
        EXPECT_FALSE(second.error().expected.empty()) << "what to do";
        EXPECT_TRUE(nextFrame(*first)) << "the first one goes on";
    }
    const auto device = started();
    ASSERT_TRUE(device);
    EXPECT_TRUE(nextFrame(*device));
}

TEST_F(Vivid, aCameraThatAnotherProgramTookComesBackWhenItIsFree) {
    const auto device = started();
    ASSERT_TRUE(device);
    ASSERT_TRUE(nextFrame(*device));
    device->stop();
    CameraFrame old;
    while (device->frames().pop(old)) {
    }
    {
        core::Wakeup wakeup;
        const auto other = CameraDevice::open({.source = "0"});
        ASSERT_TRUE(other) << describe(other.error());
        (*other)->start(wakeup);
        device->start(m_wakeup);
        ASSERT_TRUE(reaches(*device, DeviceState::reconnecting));
        EXPECT_NE(device->status().message.find("another program uses camera 0"), std::string::npos)
            << device->status().message;
    }
    EXPECT_TRUE(nextFrame(*device));
}

TEST_F(Vivid, theFirstFrameMayComeLaterThanTheOthers) {
    ASSERT_EQ(setVividLoss(100), 0);
    const auto device = started();
    ASSERT_TRUE(device);
    // Long enough for a frame that is not the first to be given up, and short of the patience for that one.
    std::this_thread::sleep_for(std::chrono::seconds(2 * camera::VideoStream::kLongestWait_s));
    EXPECT_EQ(device->status().state, DeviceState::connecting);
    ASSERT_EQ(setVividLoss(0), 0);
    const auto frame = nextFrame(*device);
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->number, 0U);
    EXPECT_FALSE(frame->discontinuity) << "it was not opened anew";
}

TEST_F(Vivid, anotherFormatBetweenStopAndStartIsTaken) {
    const auto device = started();
    ASSERT_TRUE(device);
    ASSERT_TRUE(nextFrame(*device));
    device->stop();
    EXPECT_EQ(device->status().state, DeviceState::closed);
    ASSERT_EQ(setVividFormat(320, 180), 0);
    CameraFrame old;
    while (device->frames().pop(old)) {
    }
    device->start(m_wakeup);
    const auto frame = nextFrame(*device);
    ASSERT_TRUE(frame);
    EXPECT_EQ(sizeOf(*frame), cv::Size(320, 180));
}

TEST_F(Vivid, aCameraThatIsUnboundIsLostAndComesBackWithADiscontinuity) {
    ASSERT_EQ(setVividFormat(320, 180), 0);
    const auto device = started();
    ASSERT_TRUE(device);
    auto frame = nextFrame(*device);
    ASSERT_TRUE(frame);
    EXPECT_EQ(sizeOf(*frame), cv::Size(320, 180));
    ASSERT_NO_FATAL_FAILURE(toVividDriver("unbind"));
    ASSERT_TRUE(reaches(*device, DeviceState::reconnecting));
    EXPECT_FALSE(device->status().message.empty());
    ASSERT_NO_FATAL_FAILURE(toVividDriver("bind"));
    ASSERT_TRUE(reaches(*device, DeviceState::live));
    const auto number = frame->number;
    // All frames of before were taken until it was lost.
    frame = m_taken.empty() ? nextFrame(*device) : std::optional(m_taken.front());
    ASSERT_TRUE(frame);
    EXPECT_TRUE(frame->discontinuity);
    do {
        frame = nextFrame(*device);
        ASSERT_TRUE(frame);
    } while (frame->number <= number + 2);
    EXPECT_EQ(device->status().state, DeviceState::live);
    // The driver has begun anew with its own format, and the frames say what they are.
    EXPECT_EQ(sizeOf(*frame), cv::Size(640, 360));
}

TEST_F(Vivid, aCameraThatIsUnboundTwentyTimesIsBackEachTime) {
    const auto device = started();
    ASSERT_TRUE(device);
    ASSERT_TRUE(nextFrame(*device));
    for (int i = 0; i < 20; ++i) {
        ASSERT_NO_FATAL_FAILURE(toVividDriver("unbind"));
        ASSERT_TRUE(reaches(*device, DeviceState::reconnecting)) << i;
        ASSERT_NO_FATAL_FAILURE(toVividDriver("bind"));
        ASSERT_TRUE(reaches(*device, DeviceState::live)) << i;
    }
    device->stop();
    EXPECT_EQ(device->status().state, DeviceState::closed);
}
