// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/mouse3d/mouse3d.h"
#include "tests/devices/manual_clock.h"
#include "tests/devices/mouse3d/played_mouse.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace teleta;
using namespace teleta::mouse3d;
using core::DeviceState;
using test::eventually;
using test::kPressed;
using test::kReleased;
using test::kRight;
using test::ManualClock;
using test::PlayedMouse;
using test::Report;

namespace {

constexpr std::int64_t kMs_ns = 1'000'000;
class Mouse3dTest : public testing::Test {
protected:
    void start(Mouse3dConfig config = {}) {
        config.clock = m_clock;
        m_device = std::make_unique<Mouse3d>(std::move(config), m_mouse.opener());
        m_device->start(m_wakeup);
    }
    [[nodiscard]] bool becomes(DeviceState state) {
        return eventually(m_wakeup, [&] { return m_device->status().state == state; });
    }
    /// Sends reports and waits until all of them are taken.
    [[nodiscard]] bool send(std::initializer_list<Report> reports) {
        const std::uint64_t before = taken();
        for (const Report& report : reports)
            m_mouse.send({report});
        return eventually(m_wakeup, [&] { return taken() == before + reports.size(); });
    }
    [[nodiscard]] std::uint64_t taken() const {
        const core::DeviceStatus status = m_device->status();
        return status.framesRead + status.framesLost;
    }

    PlayedMouse m_mouse{true};
    std::shared_ptr<ManualClock> m_clock = std::make_shared<ManualClock>();
    core::Wakeup m_wakeup;
    std::unique_ptr<Mouse3d> m_device;
};

} // namespace

TEST_F(Mouse3dTest, isLiveAtRest) {
    start();
    ASSERT_TRUE(becomes(DeviceState::live));
    EXPECT_EQ(m_device->name(), "played mouse");
    EXPECT_EQ(m_device->motion(), SixAxes{});
    m_device->stop();
    EXPECT_EQ(m_device->status().state, DeviceState::closed);
    m_device->stop();
}

TEST_F(Mouse3dTest, movesOnlyWhileTheDeadManButtonIsHeld) {
    start();
    ASSERT_TRUE(becomes(DeviceState::live));
    ASSERT_TRUE(send({kRight}));
    EXPECT_EQ(m_device->reading().axes.translation[0], 1.0);
    EXPECT_EQ(m_device->motion(), SixAxes{});
    ASSERT_TRUE(send({kReleased, kPressed}));
    EXPECT_EQ(m_device->motion().translation[0], 1.0);
    ASSERT_TRUE(send({kReleased}));
    EXPECT_EQ(m_device->motion(), SixAxes{});
    EXPECT_EQ(m_device->status().framesRead, 4U);
}

TEST_F(Mouse3dTest, takesTheButtonThatItIsToldTo) {
    start({.deadManButton = 9});
    ASSERT_TRUE(becomes(DeviceState::live));
    ASSERT_TRUE(send({kRight, kPressed}));
    EXPECT_EQ(m_device->motion(), SixAxes{});
    ASSERT_TRUE(send({Report{0x03, 0x00, 0x02}}));
    EXPECT_EQ(m_device->reading().buttons, 0x200U);
    EXPECT_EQ(m_device->motion().translation[0], 1.0);
}

TEST_F(Mouse3dTest, comesToRestWhenADeflectedCapFallsSilentAndWantsTheButtonAnew) {
    start();
    ASSERT_TRUE(becomes(DeviceState::live));
    ASSERT_TRUE(send({kReleased, kPressed, kRight}));
    m_clock->advanceAlone(200 * kMs_ns);
    EXPECT_EQ(m_device->motion().translation[0], 1.0);
    m_clock->advanceAlone(1);
    EXPECT_EQ(m_device->motion(), SixAxes{});
    EXPECT_FALSE(m_device->reading().deadManHeld) << "in the same reading: the hand is not held at rest";
    EXPECT_EQ(m_device->reading().axes, SixAxes{});
    ASSERT_TRUE(send({kRight}));
    EXPECT_EQ(m_device->motion(), SixAxes{}) << "the button was not pressed since";
    ASSERT_TRUE(send({kPressed, kRight}));
    EXPECT_EQ(m_device->motion(), SixAxes{}) << "nor let go";
    ASSERT_TRUE(send({kReleased, kPressed, kRight}));
    EXPECT_EQ(m_device->motion().translation[0], 1.0);
}

TEST_F(Mouse3dTest, takesAButtonThatIsHeldOverACapAtRestForLetGoAfterAWhile) {
    start();
    ASSERT_TRUE(becomes(DeviceState::live));
    ASSERT_TRUE(send({kReleased, kPressed}));
    m_clock->advanceAlone(3000 * kMs_ns);
    EXPECT_TRUE(m_device->reading().deadManHeld);
    m_clock->advanceAlone(1);
    EXPECT_FALSE(m_device->reading().deadManHeld) << "its release may have been lost";
    ASSERT_TRUE(send({kRight}));
    EXPECT_EQ(m_device->motion(), SixAxes{});
    ASSERT_TRUE(send({kReleased, kPressed, kRight}));
    EXPECT_EQ(m_device->motion().translation[0], 1.0);
}

TEST_F(Mouse3dTest, wantsTheButtonAnewAfterTheMachineHasSlept) {
    start();
    ASSERT_TRUE(becomes(DeviceState::live));
    ASSERT_TRUE(send({kReleased, kPressed, kRight}));
    m_clock->suspend(3'600'000 * kMs_ns); // while the steady clock stands still
    EXPECT_FALSE(m_device->reading().deadManHeld);
    ASSERT_TRUE(send({kRight}));
    EXPECT_EQ(m_device->motion(), SixAxes{});
    ASSERT_TRUE(send({kReleased, kPressed, kRight}));
    EXPECT_EQ(m_device->motion().translation[0], 1.0);
}

TEST_F(Mouse3dTest, comesToRestWhenUnpluggedAndWantsTheButtonAnew) {
    start();
    ASSERT_TRUE(becomes(DeviceState::live));
    ASSERT_TRUE(send({kReleased, kPressed, kRight}));
    m_mouse.plug(false);
    ASSERT_TRUE(becomes(DeviceState::lost));
    EXPECT_FALSE(m_device->status().message.empty());
    ASSERT_TRUE(eventually(m_wakeup, [&] { return m_device->motion() == SixAxes{}; }));
    m_mouse.plug(true);
    m_clock->settle();
    m_clock->advanceAlone(250 * kMs_ns);
    ASSERT_TRUE(becomes(DeviceState::live));
    EXPECT_EQ(m_mouse.opened(), 2);
    EXPECT_TRUE(m_device->status().message.empty());
    ASSERT_TRUE(send({kRight}));
    EXPECT_EQ(m_device->motion(), SixAxes{}) << "the button was not pressed since";
    ASSERT_TRUE(send({kReleased, kPressed}));
    EXPECT_EQ(m_device->motion().translation[0], 1.0);
}

// A report tells of all buttons at once: one that has been held since before the mouse was connected shows
// with the first change of another one.
TEST_F(Mouse3dTest, isNotMovedByAButtonThatWasHeldAllTheTimeWhenAnotherOneIsPressed) {
    start();
    ASSERT_TRUE(becomes(DeviceState::live));
    ASSERT_TRUE(send({kReleased, kPressed, kRight}));
    ASSERT_EQ(m_device->motion().translation[0], 1.0);
    m_mouse.plug(false);
    ASSERT_TRUE(becomes(DeviceState::lost));
    m_mouse.plug(true);
    m_clock->settle();
    m_clock->advanceAlone(250 * kMs_ns);
    ASSERT_TRUE(becomes(DeviceState::live));
    const Report kBoth = {0x03, 0x03, 0x00};
    ASSERT_TRUE(send({kRight, kBoth}));
    EXPECT_EQ(m_device->motion(), SixAxes{});
    ASSERT_TRUE(send({kPressed, kRight}));
    EXPECT_EQ(m_device->motion(), SixAxes{}) << "the other one was let go";
    ASSERT_TRUE(send({kReleased, kPressed, kRight}));
    EXPECT_EQ(m_device->motion().translation[0], 1.0);
}

TEST_F(Mouse3dTest, looksForAMouseLessAndLessOften) {
    m_mouse.plug(false);
    start();
    m_clock->settle();
    EXPECT_EQ(m_device->status().state, DeviceState::lost);
    EXPECT_EQ(m_device->status().message, "none");
    m_clock->advance(250 * kMs_ns); // tried again, in vain
    m_mouse.plug(true);
    m_clock->advance(499 * kMs_ns);
    EXPECT_EQ(m_mouse.opened(), 0);
    m_clock->advanceAlone(1 * kMs_ns);
    ASSERT_TRUE(becomes(DeviceState::live));
    EXPECT_EQ(m_mouse.opened(), 1);
}

TEST_F(Mouse3dTest, countsDamagedReports) {
    start();
    ASSERT_TRUE(becomes(DeviceState::live));
    ASSERT_TRUE(send({kReleased, kPressed, kRight, Report{0x01, 0x00}}));
    EXPECT_EQ(m_device->status().framesLost, 1U);
    EXPECT_EQ(m_device->motion().translation[0], 1.0);
}

TEST_F(Mouse3dTest, stopsWhileItLooksForAMouse) {
    m_mouse.plug(false);
    start();
    m_clock->settle();
    m_device->stop();
    EXPECT_EQ(m_device->status().state, DeviceState::closed);
}
