// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene/scene_reader.h"
#include "backend/simulation/servo/servo_array.h"
#include "backend/simulation/servo/touched_shape.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

namespace teleta::simulation {
namespace {

/// A scene of the program with its operator's end of the link.
class ServoArrayTest : public testing::Test {
protected:
    void SetUp() override {
        const auto scene =
            scene::readScene(std::string(TELETA_SOURCE_DIR) + "/resources/scenes/servo-straight-bar.toml");
        ASSERT_TRUE(scene.has_value()) << scene.error().message;
        auto array = makeServoArray(*scene, 1, m_link);
        ASSERT_TRUE(array.has_value()) << array.error().message;
        m_array = std::move(*array);
        m_values.resize(m_array->description().layout.taxels());
    }

    const servo::ServoReport& run(double duration_s, bool held = false) {
        const double end_s = m_array->time_s() + duration_s;
        while (m_array->time_s() < end_s)
            m_array->next(m_values, held);
        EXPECT_TRUE(m_link->reports.update());
        return m_link->reports.front();
    }

    std::shared_ptr<servo::ServoLink> m_link = std::make_shared<servo::ServoLink>();
    std::unique_ptr<core::FrameGenerator> m_array;
    std::vector<float> m_values;
};

} // namespace

TEST_F(ServoArrayTest, framesComeAtTheirRateAndSayThatTheyAreSimulated) {
    EXPECT_TRUE(m_array->description().simulated);
    EXPECT_EQ(m_array->description().nominalRate_Hz, 200.0);
    for (int frame = 1; frame <= 40; ++frame) {
        m_array->next(m_values, false);
        EXPECT_NEAR(m_array->time_s(), frame / 200.0, 1.001e-3);
    }
}

TEST_F(ServoArrayTest, theServoReportsItsTaskAndTheEdgeThatItFollows) {
    EXPECT_EQ(run(0.1).output.kind, servo::TaskKind::freeMotion);
    const servo::ServoReport& report = run(8.0);
    EXPECT_EQ(report.output.kind, servo::TaskKind::explore);
    EXPECT_EQ(report.tasks, 5U);
    std::vector<Eigen::Vector3d> edge_m;
    int steps = 0;
    double force_N = 0.0;
    for (servo::ServoStep step; m_link->steps.pop(step); ++steps) {
        if (step.p_Base_Contact.allFinite())
            edge_m.push_back(step.p_Base_Contact);
        EXPECT_EQ(step.run, 0U);
        force_N = step.force_N;
    }
    EXPECT_NEAR(steps, 810, 1) << "100 a second";
    EXPECT_NEAR(force_N, 10.0, 2.0);
    ASSERT_FALSE(edge_m.empty());
    EXPECT_GT((edge_m.back() - edge_m.front()).norm(), 0.005);
}

TEST_F(ServoArrayTest, theBodyLiesWhereTheArrayFeelsIt) {
    const servo::ServoReport& report = run(8.0);
    const servo::TouchedBody& body = m_link->body;
    EXPECT_EQ(body.name, "metal bar");
    ASSERT_EQ(body.axis_m.size(), 2U);
    const Eigen::Vector3d from = report.X_Base_Object * body.axis_m[0];
    const Eigen::Vector3d along = (report.X_Base_Object * body.axis_m[1] - from).normalized();
    Eigen::Vector3d touched = Eigen::Vector3d::Zero();
    for (servo::ServoStep step; m_link->steps.pop(step);)
        if (step.p_Base_Contact.allFinite())
            touched = step.p_Base_Contact;
    // Half a taxel is what the array resolves across the bar.
    EXPECT_NEAR((touched - from).cross(along).norm(), body.radius_m, 0.5 * 0.0034);
}

TEST(TouchedBody, aBodysAxisIsARadiusDeepInIt) {
    for (const char* name : {"servo-bent-bar", "servo-straight-bar", "servo-roll"}) {
        const auto scene =
            scene::readScene(std::string(TELETA_SOURCE_DIR) + "/resources/scenes/" + name + ".toml");
        ASSERT_TRUE(scene.has_value()) << scene.error().message;
        const servo::TouchedBody body = bodyOf(scene->servo().object);
        ASSERT_FALSE(body.axis_m.empty()) << name;
        const TouchedShape shape = makeShape(scene->servo().object.shape);
        for (const Eigen::Vector3d& p : body.axis_m)
            EXPECT_NEAR(std::visit([&](const auto& one) { return depthIn(one, p).depth_m; }, shape),
                        body.radius_m, 1e-9)
                << name << " " << p.transpose();
    }
}

TEST_F(ServoArrayTest, stopHoldsTheCommandAndTheArmComesToRest) {
    run(6.0);
    const Eigen::Isometry3d command = run(0.02, true).output.X_Base_Sensor;
    run(1.0, true);
    const Eigen::Isometry3d rest = m_link->reports.front().X_Base_Sensor;
    const servo::ServoReport& held = run(1.0, true);
    EXPECT_TRUE(held.stopped);
    EXPECT_EQ(held.output.X_Base_Sensor.matrix(), command.matrix());
    EXPECT_LE((held.X_Base_Sensor.translation() - rest.translation()).norm(), 1e-6);
    // A task that is chosen meanwhile does not begin, then or later.
    const std::size_t phase = held.output.phase;
    m_link->task.post(0);
    EXPECT_EQ(run(0.1, true).output.phase, phase);
    EXPECT_NE(run(0.02, false).output.phase, 0U);
}

TEST_F(ServoArrayTest, wishesTakeEffectWithinTheirBounds) {
    run(6.0);
    servo::ServoTuning tuning = m_link->reports.front().tuning;
    tuning.force_N = 8.0;
    tuning.slide_mPerS = 1.0;
    m_link->tuning.post(tuning);
    const servo::ServoReport& report = run(0.1);
    EXPECT_EQ(report.tuning.force_N, 8.0);
    EXPECT_EQ(report.tuning.slide_mPerS, servo::ServoTuning::kHighestSlide_mPerS);
    EXPECT_NEAR(report.output.desired[servo::kZ] / report.normalCompliance_mPerN, 8.0, 1e-12);
    m_link->task.post(99); // there is none
    const std::size_t phase = report.output.phase;
    EXPECT_EQ(run(0.02).output.phase, phase);
    m_link->task.post(2);
    EXPECT_EQ(run(0.02).output.kind, servo::TaskKind::edgeControl);
}

TEST_F(ServoArrayTest, aRestartBeginsAnewAndSaysSo) {
    const double before_s = run(3.0).time_s;
    m_array->restart();
    const servo::ServoReport& report = run(0.05);
    EXPECT_LT(report.time_s, before_s);
    EXPECT_EQ(report.restarts, 1U);
    servo::ServoStep step;
    while (m_link->steps.pop(step)) {
    }
    EXPECT_EQ(step.run, 1U);
    EXPECT_EQ(report.output.kind, servo::TaskKind::freeMotion);
}

// An arm that is held for longer than a contact may be lost has not lost it.
TEST_F(ServoArrayTest, theVerdictFollowsTheRunAndStartsAnewWithIt) {
    const servo::TaskVerdict early = run(0.1).verdict.value();
    EXPECT_FALSE(early.completed);
    EXPECT_EQ(early.reason, servo::NotCompleted::neverInContact);
    const servo::TaskVerdict later = run(8.0).verdict.value();
    EXPECT_TRUE(later.completed) << servo::toString(later.reason);
    EXPECT_EQ(later.phase, servo::TaskKind::explore);
    EXPECT_TRUE(run(3.0, true).verdict.value().completed);
    m_array->restart();
    EXPECT_FALSE(run(0.1).verdict.value().completed);
}

// The arm stands still because it is told to.
TEST_F(ServoArrayTest, anArrayThatIsNotToSlideIsNotStalled) {
    run(8.0);
    m_link->tuning.post({.force_N = 10.0, .slide_mPerS = 0.0, .gain = 1.0, .moment = true});
    const servo::TaskVerdict verdict = run(5.0).verdict.value();
    EXPECT_TRUE(verdict.completed) << servo::toString(verdict.reason);
}

TEST_F(ServoArrayTest, theSameSeedGivesTheSameFrames) {
    const auto scene =
        scene::readScene(std::string(TELETA_SOURCE_DIR) + "/resources/scenes/servo-straight-bar.toml");
    auto other = makeServoArray(*scene, 1, std::make_shared<servo::ServoLink>());
    std::vector<float> values(m_values.size());
    for (int frame = 0; frame < 600; ++frame) {
        m_array->next(m_values, false);
        (*other)->next(values, false);
        ASSERT_EQ(values, m_values) << frame;
    }
}

} // namespace teleta::simulation
