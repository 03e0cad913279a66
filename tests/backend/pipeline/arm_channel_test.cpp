// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/model/built_in_patterns.h"
#include "backend/pipeline/arm_channel.h"
#include "backend/pipeline/touch_pipeline.h"
#include "backend/playback/pattern_program.h"
#include "backend/recording/stream_sink.h"
#include "tests/backend/pipeline/next_event.h"
#include "tests/backend/pipeline/scripted_arm_source.h"
#include "tests/backend/pipeline/scripted_source.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <numbers>
#include <thread>

using namespace teleta;
using pipeline::ArmChannel;
using pipeline::ArmSettings;
using pipeline::TouchChannel;
using pipeline::TouchRecord;
using test::ScriptedArm;
using test::ScriptedArmSource;
using test::ScriptedSource;

namespace {

playback::Program builtInProgram(const std::string& id) {
    const pattern::Pattern* pattern = pattern::findBuiltIn(id);
    return pattern == nullptr ? playback::Program{} : playback::programOf(*pattern);
}

/// 9 x 9 taxels of 5 mm around the crest of the forearm: the middle one lies at P_C = 0.15 m.
constexpr core::ArrayLayout kSkin{.rows = 9, .columns = 9, .pitchX_m = 0.005};
constexpr double kDistance_m = 0.15;

std::vector<float> pressedInTheMiddle(double force_N) {
    std::vector<float> values(kSkin.taxels());
    values[40] = static_cast<float>(force_N);
    return values;
}

/// The scripted arm has no inertia: its touches may be quick.
ArmSettings withoutInertia() {
    ArmSettings settings;
    settings.touch.leastRise_s = 0.0;
    return settings;
}

/// One arm with its skin, fed in step.
class ArmChannelTest : public testing::Test {
protected:
    void step(double elbow_Nm) {
        const double force_N = m_arm.forceFor_N(elbow_Nm);
        core::JointSample sample = m_arm.next(force_N);
        if (m_withoutTorques)
            sample.torque_Nm = {};
        ASSERT_TRUE(m_source->push(sample));
        if (++m_samples % 5 == 0) {
            core::SampleBlock block;
            block.channels = kSkin.taxels();
            block.time_ns = {sample.time_ns};
            block.sourceTime_s = {sample.sourceTime_s};
            block.values = pressedInTheMiddle(force_N);
            ASSERT_TRUE(m_skin->blocks().push(std::move(block)));
        }
    }
    void touch() {
        for (int i = 0; i < 100; ++i)
            step(0.0);
        for (int i = 1; i <= 80; ++i)
            step(0.001 * i);
        for (int i = 79; i >= 0; --i)
            step(0.001 * i);
        for (int i = 0; i < 50; ++i)
            step(0.0);
    }

    ScriptedArm m_arm{kDistance_m, std::numbers::pi, 1325.9};
    ScriptedArmSource* m_source = new ScriptedArmSource; // owned by the channel
    ScriptedSource* m_skin = new ScriptedSource(kSkin, 1024);
    std::shared_ptr<TouchChannel> m_touchChannel = std::make_shared<TouchChannel>(
        std::unique_ptr<core::TactileSource>(m_skin), pipeline::ChannelSettings{});
    ArmChannel m_channel{std::unique_ptr<core::ArmSource>(m_source), m_touchChannel, withoutInertia()};
    int m_samples = 0;
    bool m_withoutTorques = false;
};

} // namespace

TEST_F(ArmChannelTest, publishesATouchWithEverythingThatIsKnownOfIt) {
    EXPECT_EQ(m_channel.process(), 0U);
    EXPECT_FALSE(m_channel.update());
    touch();
    EXPECT_EQ(m_channel.process(), 310U);
    ASSERT_TRUE(m_channel.update());
    const pipeline::ArmSnapshot& snapshot = m_channel.snapshot();
    EXPECT_EQ(snapshot.samplesProcessed, 310U);
    EXPECT_EQ(snapshot.newest.sourceTime_s, 0.31);
    EXPECT_EQ(snapshot.drive, core::ArmDrive::jog);
    EXPECT_FALSE(snapshot.contact);
    EXPECT_EQ(snapshot.contour.points_m.size(), 1U);

    TouchRecord record;
    ASSERT_TRUE(m_channel.popTouch(record));
    EXPECT_FALSE(m_channel.popTouch(record));
    EXPECT_NEAR(record.contactDistance_m, kDistance_m, 1e-9);
    ASSERT_TRUE(record.stiffness && record.stiffness->object.value_NPerM);
    EXPECT_NEAR(*record.stiffness->object.value_NPerM, 1325.9, 1e-6 * 1325.9);
    ASSERT_TRUE(snapshot.lastTouch);
    EXPECT_EQ(snapshot.lastTouch->number, record.number);
    EXPECT_LT((snapshot.contour.points_m[0] - record.p_Base_Contact_m.head<2>()).norm(), 1e-12);
    EXPECT_EQ(snapshot.contour.height_m, record.p_Base_Contact_m.z());

    // The skin's own channel was fed as well.
    EXPECT_EQ(m_touchChannel->framesProcessed(), 62U);
}

TEST_F(ArmChannelTest, hearsOfEachSampleWhileATouchIsNearlyComplete) {
    for (int i = 0; i < 100; ++i)
        step(0.0);
    m_channel.process();
    EXPECT_FALSE(m_source->wakesAtEach);
    TouchRecord record;
    bool asked = false;
    for (int i = 1; i <= 80 && !m_channel.popTouch(record); ++i) {
        asked = m_source->wakesAtEach;
        step(0.001 * i);
        m_channel.process();
    }
    EXPECT_EQ(record.number, 1U);
    EXPECT_TRUE(asked) << "for the sample that completed it";
    EXPECT_FALSE(m_source->wakesAtEach);
}

TEST_F(ArmChannelTest, anArmWithoutTorquesFindsWhereItTouches) {
    m_withoutTorques = true;
    for (int i = 0; i < 3; ++i)
        touch();
    m_channel.process();
    ASSERT_TRUE(m_channel.update());
    EXPECT_EQ(m_channel.snapshot().contour.points_m.size(), 3U);
    ASSERT_EQ(m_channel.snapshot().objects.size(), 1U);
    EXPECT_FALSE(m_channel.snapshot().objects[0].material);
    TouchRecord record;
    for (int i = 0; i < 3; ++i) {
        ASSERT_TRUE(m_channel.popTouch(record));
        EXPECT_NEAR(record.contactDistance_m, kDistance_m, 1e-9);
        EXPECT_EQ(record.refusal, stiffness::Refusal::noTorques);
    }
    EXPECT_FALSE(m_channel.popTouch(record));
}

TEST_F(ArmChannelTest, touchesAreCountedOnWhenTorquesComeLater) {
    m_withoutTorques = true;
    touch();
    m_withoutTorques = false;
    touch();
    touch();
    m_channel.process();
    TouchRecord record;
    for (std::uint64_t number = 1; number <= 3; ++number) {
        ASSERT_TRUE(m_channel.popTouch(record));
        EXPECT_EQ(record.number, number);
        EXPECT_EQ(record.refusal.has_value(), number == 1);
    }
    EXPECT_FALSE(m_channel.popTouch(record));
}

TEST_F(ArmChannelTest, countsATouchOfARecordingOnceHoweverOftenItIsPlayed) {
    m_source->setRecorded();
    for (int pass = 0; pass < 3; ++pass) {
        m_arm = ScriptedArm(kDistance_m, std::numbers::pi, 1325.9); // its time begins anew
        touch();
        m_channel.process();
        m_channel.update();
        ASSERT_EQ(m_channel.snapshot().objects.size(), 1U) << pass;
        EXPECT_EQ(m_channel.snapshot().objects[0].touches, 1U) << pass;
        EXPECT_EQ(m_channel.snapshot().contour.points_m.size(), 1U) << pass;
        TouchRecord record;
        ASSERT_TRUE(m_channel.popTouch(record)) << pass;
        EXPECT_EQ(record.number, 1U) << pass;
        EXPECT_FALSE(m_channel.popTouch(record)) << pass;
    }
}

TEST_F(ArmChannelTest, showsTheContactWhileItTouches) {
    for (int i = 0; i < 100; ++i)
        step(0.0);
    for (int i = 1; i <= 60; ++i)
        step(0.001 * i);
    m_channel.process();
    m_channel.update();
    const pipeline::ArmSnapshot& snapshot = m_channel.snapshot();
    ASSERT_TRUE(snapshot.contact && snapshot.contact->force);
    EXPECT_NEAR(snapshot.contact->contactDistance_m, kDistance_m, 1e-9);
    EXPECT_NEAR(snapshot.contact->force->force_N.dot(m_arm.normal_Base()), 0.06 / kDistance_m, 0.01);
}

TEST_F(ArmChannelTest, handsEverySampleToTheViewerAndCountsTheRest) {
    touch();
    m_channel.process();
    core::JointSample sample;
    for (int i = 1; i <= 310; ++i) {
        ASSERT_TRUE(m_channel.popSample(sample));
        ASSERT_NEAR(sample.sourceTime_s, 1e-3 * i, 1e-12);
    }
    EXPECT_FALSE(m_channel.popSample(sample));
    for (int i = 0; i < 20'000; ++i) {
        step(0.0);
        if (i % 1000 == 999)
            m_channel.process();
    }
    EXPECT_EQ(m_channel.samplesNotShown(), 20'000U - ArmChannel::kHistorySamples);
    EXPECT_EQ(m_channel.samplesProcessed(), 20'310U);
}

TEST_F(ArmChannelTest, losesNoTouchOfAViewerThatIsLate) {
    for (int i = 0; i < 20; ++i) {
        touch();
        m_channel.process();
    }
    TouchRecord record;
    for (std::uint64_t number = 1; number <= 20; ++number) {
        ASSERT_TRUE(m_channel.popTouch(record));
        EXPECT_EQ(record.number, number);
    }
    EXPECT_EQ(m_channel.touchesNotShown(), 0U);
}

TEST_F(ArmChannelTest, putsSkinAndJointsInOrderOfTime) {
    // All of the skin's frames wait before the first joint sample: those of the future must not count early.
    touch();
    touch();
    m_channel.process();
    TouchRecord record;
    for (int i = 0; i < 2; ++i) {
        ASSERT_TRUE(m_channel.popTouch(record));
        EXPECT_TRUE(record.located);
        EXPECT_NEAR(record.ready_s, 0.31 * i + 0.1 + 0.061, 1e-9);
    }
}

TEST_F(ArmChannelTest, usesNewSettingsFromTheNextSamplesOn) {
    ArmSettings settings = withoutInertia();
    settings.touch.method = stiffness::Method::twoPoint;
    settings.contour.samplesPerSegment = 3;
    m_channel.post(settings);
    touch();
    touch();
    m_channel.process();
    EXPECT_EQ(m_channel.settings().touch.method, stiffness::Method::twoPoint);
    TouchRecord record;
    ASSERT_TRUE(m_channel.popTouch(record));
    EXPECT_EQ(record.stiffness->method, stiffness::Method::twoPoint);
    m_channel.update();
    EXPECT_EQ(m_channel.snapshot().contour.curve_m.size(), 4U);
}

TEST_F(ArmChannelTest, tellsTheFeedbackOfEveryTouch) {
    int played = 0;
    const auto feedback = std::make_shared<pipeline::TactileFeedback>(
        [&played](const playback::Program&) { return ++played > 0; });
    feedback->setMap(pattern::PatternMap::defaults(), builtInProgram);
    touch();
    m_channel.process();
    EXPECT_EQ(played, 0);
    m_channel.setFeedback(feedback);
    touch();
    m_channel.process();
    EXPECT_EQ(played, 1);
    pipeline::FeedbackSent sent;
    ASSERT_TRUE(feedback->popSent(sent));
    EXPECT_EQ(sent.touch, 2U);
    EXPECT_EQ(sent.material, stiffness::Material::rubberSponge); // 1325.9 N/m
    m_channel.setFeedback(nullptr);
    touch();
    m_channel.process();
    EXPECT_EQ(played, 1);
}

/// Recognising shapes takes time, and so does recording.
TEST_F(ArmChannelTest, playsATouchBeforeItDoesAnythingElseWithIt) {
    class Sink : public recording::StreamSink {
    public:
        std::shared_ptr<core::StreamTap> addStream(recording::StreamInfo info) override {
            auto tap = std::make_shared<core::StreamTap>(64);
            if (info.kind == recording::StreamKind::touches)
                touches = tap;
            return tap;
        }
        void add(recording::RecordingEvent /*event*/) override {}
        std::shared_ptr<core::StreamTap> touches;
    };
    const auto sink = std::make_shared<Sink>();
    m_channel.watch(pipeline::Watcher::plot, sink, "arm");
    ASSERT_TRUE(sink->touches);
    int played = 0;
    bool wasRecorded = false;
    const auto feedback = std::make_shared<pipeline::TactileFeedback>([&](const playback::Program&) {
        core::TappedFrames frames;
        wasRecorded = wasRecorded || sink->touches->pop(frames);
        return ++played > 0;
    });
    feedback->setMap(pattern::PatternMap::defaults(), builtInProgram);
    m_channel.setFeedback(feedback);
    touch();
    m_channel.process();
    EXPECT_EQ(played, 1);
    EXPECT_FALSE(wasRecorded);
    core::TappedFrames frames;
    EXPECT_TRUE(sink->touches->pop(frames));
    m_channel.watch(pipeline::Watcher::plot, nullptr, {});
}

TEST_F(ArmChannelTest, forgetsTheContourOnCommandAlsoWhileNoSampleComes) {
    touch();
    m_channel.process();
    m_channel.update();
    const std::uint64_t revision = m_channel.snapshot().contour.revision;
    EXPECT_EQ(m_channel.snapshot().contour.points_m.size(), 1U);
    m_channel.resetContour();
    m_channel.process();
    ASSERT_TRUE(m_channel.update());
    EXPECT_TRUE(m_channel.snapshot().contour.points_m.empty());
    EXPECT_GT(m_channel.snapshot().contour.revision, revision);
    EXPECT_TRUE(m_channel.snapshot().lastTouch);
}

TEST(TouchPipelineWithAnArm, opensArmAndSkinTogetherAndStopsBoth) {
    ScriptedArm arm(kDistance_m);
    ScriptedArmSource* source = nullptr;
    ScriptedSource* skin = nullptr;
    pipeline::TouchPipeline pipeline;
    const auto key = pipeline.open([&]() -> core::Expected<std::shared_ptr<pipeline::Channel>> {
        auto skinSource = std::make_unique<ScriptedSource>(kSkin, 1024);
        auto armSource = std::make_unique<ScriptedArmSource>();
        skin = skinSource.get();
        source = armSource.get();
        return std::make_shared<ArmChannel>(
            std::move(armSource),
            std::make_shared<TouchChannel>(std::move(skinSource), pipeline::ChannelSettings()));
    });
    const auto channel = std::dynamic_pointer_cast<ArmChannel>(test::nextEvent(pipeline).channel);
    ASSERT_TRUE(channel);
    EXPECT_EQ(source->starts, 1);
    EXPECT_TRUE(skin->started());

    for (int i = 0; i < 100; ++i)
        source->push(arm.next(0.0));
    for (int i = 1; i <= 80; ++i) {
        const double force_N = arm.forceFor_N(0.001 * i);
        source->push(arm.next(force_N));
        if (i % 5 == 0) {
            core::SampleBlock block;
            block.channels = kSkin.taxels();
            block.time_ns = {arm.clockOffset_ns + (100 + i) * 1'000'000};
            block.sourceTime_s = {1e-3 * (100 + i)};
            block.values = pressedInTheMiddle(force_N);
            skin->blocks().push(std::move(block));
        }
    }
    TouchRecord record;
    while (!channel->popTouch(record))
        std::this_thread::yield(); // the test's time-out ends it
    EXPECT_EQ(record.number, 1U);

    pipeline.close(key);
    EXPECT_EQ(test::nextEvent(pipeline).kind, pipeline::ChannelEvent::Kind::closed);
    EXPECT_EQ(source->stops, 1);
    EXPECT_EQ(skin->stops(), 1);
}
