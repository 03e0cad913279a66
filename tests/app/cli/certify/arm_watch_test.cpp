// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/certify/arm_watch.h"
#include "backend/core/steady_time.h"

#include <gtest/gtest.h>

#include <chrono>
#include <condition_variable>
#include <mutex>

using teleta::cli::ArmWatch;
using teleta::cli::JointView;
using namespace std::chrono_literals;

namespace {

constexpr double kRate = 0.1; // the tolerance is 1e-3 rad then

/// Hands over what a test says; without more, the last position again and again, or nothing.
class ScriptedView : public JointView {
public:
    std::vector<double> wait(std::int64_t longest_ns) override {
        std::unique_lock lock(m_mutex);
        (void)m_said.wait_for(lock,
                              std::min<std::chrono::nanoseconds>(2ms, std::chrono::nanoseconds(longest_ns)),
                              [this] { return !m_next.empty(); });
        if (m_next.empty() && !m_silent)
            return {m_last};
        m_last = m_next.empty() ? m_last : m_next.back();
        return std::exchange(m_next, {});
    }
    std::string name() const override { return "arm"; }
    bool simulated() const override { return true; }

    void say(std::vector<double> positions) {
        const std::lock_guard lock(m_mutex);
        m_silent = false;
        m_next = std::move(positions);
        m_said.notify_one();
    }
    void fallSilent() {
        const std::lock_guard lock(m_mutex);
        m_silent = true;
    }

private:
    std::mutex m_mutex;
    std::condition_variable m_said;
    std::vector<double> m_next;
    double m_last = 0.0;
    bool m_silent = true;
};

template <typename Holds>
bool eventually(const Holds& holds) {
    using Clock = std::chrono::steady_clock;
    for (const auto end = Clock::now() + 10s; Clock::now() < end; std::this_thread::sleep_for(1ms))
        if (holds())
            return true;
    return false;
}

struct Watched {
    ScriptedView* view = new ScriptedView;
    ArmWatch watch{std::unique_ptr<JointView>(view), kRate};
};

} // namespace

TEST(ArmWatch, anArmIsAtRestFromWhereItStayed) {
    Watched arm;
    EXPECT_FALSE(arm.watch.position());
    const std::int64_t begin_ns = teleta::core::steadyNow_ns();
    EXPECT_FALSE(arm.watch.offSince(begin_ns)) << "nothing was heard";
    arm.view->say({0.0, 0.01, 0.02});
    ASSERT_TRUE(eventually([&] { return arm.watch.offSince(begin_ns).has_value(); }));
    const auto rest = arm.watch.offSince(begin_ns);
    EXPECT_EQ(arm.watch.position(), 0.02);
    EXPECT_TRUE(arm.watch.wasOnAfter(begin_ns)) << "it came from 0";
    EXPECT_FALSE(arm.watch.wasOnAfter(rest->answered_ns));
    EXPECT_FALSE(arm.watch.newest().on);
    // The same rest, however long it lasts.
    std::this_thread::sleep_for(20ms);
    EXPECT_EQ(arm.watch.offSince(begin_ns)->answered_ns, rest->answered_ns);
    // Within the tolerance it is noise, beyond it motion.
    const std::int64_t before_ns = teleta::core::steadyNow_ns();
    arm.view->say({0.02 + 0.9e-3});
    ASSERT_TRUE(eventually([&] { return *arm.watch.position() > 0.0205; }));
    EXPECT_FALSE(arm.watch.wasOnAfter(before_ns));
    arm.view->say({0.02 + 2.5e-3});
    ASSERT_TRUE(eventually([&] { return *arm.watch.position() > 0.022; }));
    EXPECT_TRUE(arm.watch.wasOnAfter(before_ns));
}

TEST(ArmWatch, anArmThatIsNotHeardIsNotAtRest) {
    Watched arm;
    const std::int64_t begin_ns = teleta::core::steadyNow_ns();
    arm.view->say({0.5});
    ASSERT_TRUE(eventually([&] { return arm.watch.offSince(begin_ns).has_value(); }));
    arm.view->fallSilent();
    EXPECT_TRUE(eventually([&] { return !arm.watch.offSince(begin_ns).has_value(); }));
    EXPECT_TRUE(eventually([&] { return arm.watch.failed(); }));
}

TEST(ArmWatch, anArmThatNeverSpeaksIsRefused) {
    const auto watch = ArmWatch::start(std::make_unique<ScriptedView>(), kRate);
    ASSERT_FALSE(watch);
    EXPECT_EQ(watch.error().kind, teleta::core::ErrorKind::unavailable);
}
