// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/mouse3d/mouse3d.h"
#include "tests/devices/manual_clock.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <mutex>

using namespace teleta;
using namespace teleta::mouse3d;
using core::DeviceState;
using test::eventually;
using test::ManualClock;

namespace {

constexpr std::int64_t kMs_ns = 1'000'000;
using Report = std::vector<std::uint8_t>;

const Report kPressed = {0x03, 0x01, 0x00};
const Report kReleased = {0x03, 0x00, 0x00};
const Report kRight = {0x01, 0x5E, 0x01, 0x00, 0x00, 0x00, 0x00};

/// A mouse that a test plugs in and moves. Thread: any.
class PlayedMouse {
public:
    void plug(bool plugged) {
        const std::scoped_lock lock(m_mutex);
        m_plugged = plugged;
        m_reports.clear();
        m_changed.notify_all();
    }
    void send(Report report) {
        const std::scoped_lock lock(m_mutex);
        m_reports.push_back(std::move(report));
        m_changed.notify_all();
    }
    [[nodiscard]] int opened() const {
        const std::scoped_lock lock(m_mutex);
        return m_opened;
    }
    /// The mouse must outlive what it opens.
    HidInputOpener opener() {
        return [this]() -> core::Expected<std::unique_ptr<hid::HidDevice>> {
            const std::scoped_lock lock(m_mutex);
            if (!m_plugged)
                return core::Unexpected(core::Error{core::ErrorKind::unavailable, "none", {}, {}});
            ++m_opened;
            return std::make_unique<Input>(*this);
        };
    }

private:
    class Input : public hid::HidDevice {
    public:
        explicit Input(PlayedMouse& mouse)
            : m_mouse(mouse) {}
        [[nodiscard]] int read(std::span<std::uint8_t> report, int timeout_ms) override {
            std::unique_lock lock(m_mouse.m_mutex);
            m_mouse.m_changed.wait_for(lock, std::chrono::milliseconds(timeout_ms),
                                       [this] { return !m_mouse.m_plugged || !m_mouse.m_reports.empty(); });
            if (!m_mouse.m_plugged)
                return -1;
            if (m_mouse.m_reports.empty())
                return 0;
            const Report next = m_mouse.m_reports.front();
            m_mouse.m_reports.pop_front();
            std::ranges::copy(next, report.begin());
            return static_cast<int>(next.size());
        }
        [[nodiscard]] std::string name() const override { return "played mouse"; }

    private:
        PlayedMouse& m_mouse;
    };

    mutable std::mutex m_mutex;
    std::condition_variable m_changed;
    std::deque<Report> m_reports;
    bool m_plugged = true;
    int m_opened = 0;
};

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
            m_mouse.send(report);
        return eventually(m_wakeup, [&] { return taken() == before + reports.size(); });
    }
    [[nodiscard]] std::uint64_t taken() const {
        const core::DeviceStatus status = m_device->status();
        return status.framesRead + status.framesLost;
    }

    PlayedMouse m_mouse;
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
