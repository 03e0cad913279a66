// SPDX-License-Identifier: GPL-3.0-or-later
// A servo task on the robot of Fast DDS and MuJoCo, whose pad hangs above a ball on a spring: what the first
// press rehearses, the second one does. The robot's log says where the arm was and what its pad felt.
#include "app/sources/source_request.h"
#include "backend/arm_servo/channel_servo.h"
#include "backend/core/device/arm_device.h"
#include "backend/core/steady_time.h"
#include "backend/core/threads/stop_switch.h"
#include "backend/pipeline/touch_pipeline.h"
#include "tests/backend/pipeline/pad_on_arm.h"
#include "tests/peer/ros/robot_fixture.h"

#include <chrono>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace teleta {
namespace {

constexpr int kDomain = 131;
constexpr double kForce_N = 3.0;
constexpr double kBall_m = 0.012;
constexpr double kGap_m = 0.004;
constexpr double kStiffness_NPerM = 1000.0;

class ArmServoPeer : public RosArmPeer {
protected:
    void SetUp() override {
        const core::JointVector q_rad{0.0, 0.6, 0.0, -1.2, 0.0, std::numbers::pi - 1.8, 0.0};
        QStringList position;
        for (const double each : q_rad)
            position << QString::number(each, 'g', 12);
        // In the middle of a taxel, which feels it alone.
        const Eigen::Vector3d top_m = test::chainOf("resources/arms/seven-joints.urdf")->X_Base_Tip(q_rad) *
                                      Eigen::Vector3d(0.0017, 0.0017, kGap_m);
        start(kDomain, {"--pad", "--position", position.join(','), "--object",
                        QString("%1,%2,%3,%4")
                            .arg(top_m.x(), 0, 'g', 12)
                            .arg(top_m.y(), 0, 'g', 12)
                            .arg(top_m.z() - kBall_m, 0, 'g', 12)
                            .arg(kStiffness_NPerM)});
        writeFile("[touch]\narray = \"pad.toml\"\nframe = \"tool0\"\npose = [0, 0, 0, 0, 0, 0]\n");
        writeBeside("pad.toml", "kind = \"ros_tactile\"\nname = \"pad\"\ntopic = \"/pad/tactile\"\nformat = "
                                "\"Float64MultiArray\"\nrows = 14\ncols = 6\npitch_mm = 3.4\nrate_Hz = 100\n"
                                "threshold = 0.02\n[ros]\ndomain = " +
                                    std::to_string(kDomain) + "\ninterface = \"lo\"\n");
        (void)m_pipeline.open(app::makeSourceFactory(app::ArmRequest{.path = path()}, m_stop));
        ASSERT_TRUE(eventually([this] {
            for (const pipeline::ChannelEvent& event : m_pipeline.takeEvents())
                if (event.channel)
                    m_arm = std::dynamic_pointer_cast<pipeline::ArmChannel>(event.channel);
            return m_arm != nullptr;
        }));
        auto opened = arm_servo::ChannelServo::open(m_arm);
        ASSERT_TRUE(opened) << core::describe(opened.error());
        m_servo = std::move(*opened);
        m_servo->setTask(arm_servo::ArmTask::point, kForce_N);
        // Until other programs would have been found, nothing moves.
        ASSERT_TRUE(eventually([this] {
            tick(false);
            return m_arm->device().hindrance().empty() && m_arm->skin()->generation() > 0;
        }));
    }

    void tick(bool held) {
        (void)m_arm->skin()->update();
        const std::int64_t now_ns = core::steadyNow_ns();
        m_late = m_late || now_ns - std::exchange(m_tick_ns, now_ns) > core::ArmCommand::kJogLifetime_ns;
        (void)m_servo->tick(now_ns, held, m_stop.engaged(), false);
    }
    void tickFor(double seconds, bool held) {
        using Clock = std::chrono::steady_clock;
        for (const auto end = Clock::now() + std::chrono::duration<double>(seconds); Clock::now() < end;
             std::this_thread::sleep_for(std::chrono::milliseconds(33)))
            tick(held);
    }
    /// A press of an arm whose task has been rehearsed. A computer that is late for longer than a command
    /// counts ends the task, as it should: then it is rehearsed and done again.
    void driveFor(double seconds) {
        for (int tries = 0; tries < 5; ++tries) {
            m_late = false;
            tickFor(seconds, true);
            if (m_servo->servo().isRunning() || !m_late)
                return;
            tickFor(0.3, false);
            tickFor(1.5, true);
            tickFor(0.3, false);
        }
    }

    /// States of the last seconds in the log.
    [[nodiscard]] std::vector<json> newest(double seconds) {
        std::vector<json> states = logOf("state");
        const double from_s = steady_s(states.back()) - seconds;
        std::erase_if(states, [&](const json& state) { return steady_s(state) < from_s; });
        return states;
    }
    static double farthest(const json& a, const json& b) {
        double most = 0.0;
        for (std::size_t i = 0; i < a["position"].size(); ++i)
            most = std::max(most, std::abs(a["position"][i].get<double>() - b["position"][i].get<double>()));
        return most;
    }

    core::StopSwitch m_stop;
    pipeline::TouchPipeline m_pipeline;
    std::shared_ptr<pipeline::ArmChannel> m_arm;
    std::unique_ptr<arm_servo::ChannelServo> m_servo;
    std::int64_t m_tick_ns = core::steadyNow_ns();
    bool m_late = false; ///< a tick came later than a command counts
};

TEST_F(ArmServoPeer, theFirstPressMovesNothingAndTheSecondOneHoldsAForce) {
    using arm_servo::Stage;
    const json before = logOf("state").back();
    tickFor(3.0, true);
    EXPECT_EQ(m_servo->servo().stage(), Stage::rehearsing);
    EXPECT_TRUE(m_servo->newest().shadow_rad);
    tickFor(0.3, false);
    ASSERT_EQ(m_servo->servo().stage(), Stage::rehearsed) << static_cast<int>(m_servo->servo().ending());
    EXPECT_TRUE(logOf("trajectory").empty()) << "the rehearsal is told to nobody";
    for (const json& state : newest(3.0)) {
        EXPECT_LT(farthest(state, before), 1e-3);
        EXPECT_EQ(state["pad_N"].get<double>(), 0.0);
    }

    driveFor(25.0);
    ASSERT_EQ(m_servo->servo().stage(), Stage::driving) << static_cast<int>(m_servo->servo().ending());
    // The spring below the ball tells the force; a taxel loses the point of contact for a moment when it
    // crosses the edge of the taxel.
    const std::vector<json> held = newest(3.0);
    double sum_N = 0.0;
    for (const json& state : held) {
        const double force_N = kStiffness_NPerM * state["depth_m"][0].get<double>();
        sum_N += force_N;
        EXPECT_NEAR(force_N, kForce_N, 0.2 * kForce_N);
    }
    const double mean_N = sum_N / static_cast<double>(held.size());
    RecordProperty("mean_mN", static_cast<int>(std::lround(1e3 * mean_N)));
    EXPECT_NEAR(mean_N, kForce_N, 0.05 * kForce_N);
    for (const json& trajectory : logOf("trajectory"))
        EXPECT_TRUE(trajectory["accepted"].get<bool>()) << trajectory.dump();

    // Letting go holds the arm where it is.
    tickFor(0.6, false);
    const json rested = logOf("state").back();
    tickFor(1.0, false);
    EXPECT_LT(farthest(logOf("state").back(), rested), 1e-3);
    EXPECT_EQ(m_servo->servo().stage(), Stage::rehearsed);
}

TEST_F(ArmServoPeer, aSilentPadAndStopEndTheMotionAndTheNextPressIsARehearsal) {
    using arm_servo::Ending;
    using arm_servo::Stage;
    for (const bool byStop : {false, true}) {
        tickFor(1.5, true);
        tickFor(0.3, false);
        ASSERT_EQ(m_servo->servo().stage(), Stage::rehearsed);
        const std::size_t commands = logOf("trajectory").size();
        driveFor(1.0);
        ASSERT_EQ(m_servo->servo().stage(), Stage::driving)
            << byStop << ' ' << static_cast<int>(m_servo->servo().ending());
        EXPECT_GT(logOf("trajectory").size(), commands);
        if (byStop)
            m_stop.engage();
        else
            ASSERT_TRUE(m_robot.command("fault no-pad"));
        tickFor(1.0, true);
        EXPECT_EQ(m_servo->servo().stage(), Stage::idle);
        EXPECT_EQ(m_servo->servo().ending(), byStop ? Ending::stopped : Ending::noFrames);
        const json rested = logOf("state").back();
        m_stop.release();
        ASSERT_TRUE(m_robot.command("fault none"));
        tickFor(1.0, true);
        EXPECT_LT(farthest(logOf("state").back(), rested), 1e-3) << "the switch is still held";
        tickFor(0.3, false);
        tickFor(1.0, true);
        EXPECT_EQ(m_servo->servo().stage(), Stage::rehearsing);
        EXPECT_LT(farthest(logOf("state").back(), rested), 1e-3);
        tickFor(0.3, false);
        m_servo->setTask(arm_servo::ArmTask::point, kForce_N);
        tickFor(0.1, false);
    }
}

} // namespace
} // namespace teleta
