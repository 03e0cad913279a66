// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/arm_model/serial_chain.h"
#include "backend/arm_model/urdf_reader.h"
#include "backend/pipeline/joint_channel.h"
#include "backend/pipeline/recorded/recorded_sources.h"
#include "backend/pipeline/recorded/recorded_streams.h"
#include "backend/recording/recorder.h"
#include "backend/recording/recording.h"
#include "backend/recording/stream_columns.h"
#include "tests/backend/pipeline/pad_on_arm.h"
#include "tests/backend/pipeline/scripted_arm_source.h"

#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

using namespace teleta;
using pipeline::JointChannel;
using test::ScriptedArmSource;

namespace {

core::JointSample sampleAt(int number) {
    core::JointSample sample;
    sample.time_ns = 1'000'000'000 + number * std::int64_t{1'000'000};
    sample.sourceTime_s = 0.001 * number;
    sample.angle_rad = {0.1, 0.2, 0.3, 0.001 * number};
    sample.reference_rad = {0.1, 0.2, 0.3, 0.4};
    return sample; // no torques: this arm does not tell them
}

} // namespace

TEST(JointChannel, everySampleReachesTheViewerOnceAndInOrder) {
    auto* arm = new ScriptedArmSource; // owned by the channel
    JointChannel channel{std::unique_ptr<core::ArmSource>(arm)};
    EXPECT_EQ(channel.process(), 0U);
    for (int number = 0; number < 300; ++number) {
        ASSERT_TRUE(arm->push(sampleAt(number)));
        if (number % 7 == 0)
            channel.process();
    }
    channel.process();
    EXPECT_EQ(channel.samplesProcessed(), 300U);
    EXPECT_EQ(channel.framesProcessed(), 300U);
    core::JointSample sample;
    for (int number = 0; number < 300; ++number) {
        ASSERT_TRUE(channel.popSample(sample));
        EXPECT_EQ(sample.time_ns, sampleAt(number).time_ns);
    }
    EXPECT_FALSE(channel.popSample(sample));
    EXPECT_EQ(channel.samplesNotShown(), 0U);
}

TEST(JointChannel, aViewerThatIsLateLosesTheNewestAndIsToldHowMany) {
    auto* arm = new ScriptedArmSource;
    JointChannel channel{std::unique_ptr<core::ArmSource>(arm)};
    constexpr std::size_t kMore = 5;
    for (std::size_t number = 0; number < JointChannel::kHistorySamples + kMore; ++number) {
        ASSERT_TRUE(arm->push(sampleAt(static_cast<int>(number))));
        channel.process();
    }
    EXPECT_EQ(channel.samplesNotShown(), kMore);
    channel.drain();
    core::JointSample sample;
    EXPECT_FALSE(channel.popSample(sample));
}

TEST(JointChannel, theArmStartsAndStopsWithTheChannel) {
    auto* arm = new ScriptedArmSource;
    core::Wakeup data;
    JointChannel channel{std::unique_ptr<core::ArmSource>(arm)};
    channel.start(data);
    EXPECT_EQ(arm->starts, 1);
    channel.stop();
    EXPECT_EQ(arm->stops, 1);
    EXPECT_EQ(channel.summary().name, channel.description().name);
    EXPECT_FALSE(channel.summary().recorded);
    EXPECT_EQ(channel.playback(), nullptr);
}

TEST(JointChannel, aRecordingSaysWhatTheArmDoesNotTell) {
    QTemporaryDir folder;
    const std::string path = folder.filePath("arm.teleta").toStdString();
    auto* arm = new ScriptedArmSource;
    JointChannel channel{std::unique_ptr<core::ArmSource>(arm)};
    {
        auto started = recording::Recorder::start(path, {});
        ASSERT_TRUE(started) << core::describe(started.error());
        const std::shared_ptr<recording::Recorder> recorder = std::move(*started);
        channel.record(recorder, "robot");
        for (int number = 0; number < 10; ++number)
            ASSERT_TRUE(arm->push(sampleAt(number)));
        channel.process();
        channel.record(nullptr, {});
        ASSERT_TRUE(arm->push(sampleAt(10)));
        channel.process();
        ASSERT_TRUE(recorder->stop());
    }
    const auto recording = recording::Recording::open(path);
    ASSERT_TRUE(recording) << core::describe(recording.error());
    ASSERT_EQ(recording->streams().size(), 1U);
    EXPECT_EQ(recording->streams()[0].name, "robot-joints");
    recording::StreamReader reader = recording->reader(0);
    core::TappedFrames block;
    ASSERT_TRUE(reader.next(block).value_or(false));
    ASSERT_EQ(block.frames(), 10U);
    constexpr std::size_t kJoints = 4;
    const auto values = recording::valuesOf<double>(block, 9, 3 * kJoints);
    EXPECT_DOUBLE_EQ(values[3], 0.009);
    for (std::size_t joint = 0; joint < kJoints; ++joint) {
        EXPECT_TRUE(std::isnan(values[kJoints + joint])) << "a torque that nobody told";
        EXPECT_EQ(values[2 * kJoints + joint], sampleAt(9).reference_rad[joint]);
    }
    EXPECT_FALSE(reader.next(block).value_or(true));
    EXPECT_TRUE(recording::jointSample(values).torque_Nm.empty());
    EXPECT_EQ(recording::jointSample(values).angle_rad, sampleAt(9).angle_rad);
}

TEST(JointChannel, aRecordingHasTheForcesAtTheWrist) {
    QTemporaryDir folder;
    const std::string path = folder.filePath("arm.teleta").toStdString();
    auto* arm = new ScriptedArmSource;
    arm->hasWrench = true;
    JointChannel channel{std::unique_ptr<core::ArmSource>(arm)};
    EXPECT_FALSE(channel.newestWrench());
    {
        auto started = recording::Recorder::start(path, {});
        ASSERT_TRUE(started) << core::describe(started.error());
        const std::shared_ptr<recording::Recorder> recorder = std::move(*started);
        channel.record(recorder, "robot");
        for (int number = 0; number < 10; ++number)
            ASSERT_TRUE(arm->push(core::WrenchSample{.time_ns = 1'000'000'000 + number,
                                                     .sourceTime_s = 0.5 * number,
                                                     .force_N = {1.0, -2.0, 0.25 * number},
                                                     .torque_Nm = {0.1, 0.2, -0.3}}));
        channel.process();
        ASSERT_TRUE(recorder->stop());
    }
    ASSERT_TRUE(channel.newestWrench());
    EXPECT_EQ(channel.newestWrench()->force_N[2], 0.25 * 9);
    const auto recording = recording::Recording::open(path);
    ASSERT_TRUE(recording) << core::describe(recording.error());
    ASSERT_EQ(recording->streams().size(), 2U);
    EXPECT_EQ(recording->streams()[1].name, "robot-wrench");
    EXPECT_EQ(recording->streams()[1].kind, recording::StreamKind::wrench);
    recording::StreamReader reader = recording->reader(1);
    core::TappedFrames block;
    std::size_t frames = 0;
    while (reader.next(block).value_or(false)) {
        for (std::size_t frame = 0; frame < block.frames(); ++frame, ++frames) {
            const auto values = recording::valuesOf<double>(block, frame, 6);
            const std::vector<double> expected{1.0, -2.0, 0.25 * static_cast<double>(frames), 0.1, 0.2, -0.3};
            EXPECT_TRUE(std::ranges::equal(values, expected));
            EXPECT_EQ(block.sourceTime_s[frame], 0.5 * static_cast<double>(frames));
        }
    }
    EXPECT_EQ(frames, 10U);
}

TEST(JointChannel, anArmWithoutASkinIsFoundInItsRecordingWithJointsThatTurnForEver) {
    constexpr double kEndless = std::numeric_limits<double>::infinity();
    QTemporaryDir folder;
    const std::string path = folder.filePath("arm.teleta").toStdString();
    core::ArmDescription arm;
    arm.name = "robot";
    arm.nominalRate_Hz = 0.0;
    arm.lowest_rad = {-1.0, -kEndless};
    arm.highest_rad = {2.0, kEndless};
    arm.fastest_radPerS = {0.5, 0.25};
    {
        auto recorder = recording::Recorder::start(path, {});
        ASSERT_TRUE(recorder) << core::describe(recorder.error());
        const auto tap = (*recorder)->addStream(pipeline::armStream("robot-joints", arm, {}));
        core::JointSample sample;
        sample.angle_rad = sample.reference_rad = {0.1, 20.0};
        const std::vector<double> values = recording::jointValues(sample, 2);
        tap->append(1'000'000'000, 0.0, std::span<const double>(values));
        ASSERT_TRUE((*recorder)->stop());
    }
    const auto recording = recording::Recording::open(path);
    ASSERT_TRUE(recording) << core::describe(recording.error());
    const auto sources = pipeline::recordedSources(*recording);
    ASSERT_TRUE(sources) << core::describe(sources.error());
    EXPECT_TRUE(sources->arrays.empty());
    ASSERT_EQ(sources->arms.size(), 1U);
    EXPECT_EQ(sources->arms[0].stream, 0U);
    const core::ArmDescription& found = sources->arms[0].arm;
    EXPECT_EQ(found.name, "robot");
    EXPECT_TRUE(found.recorded);
    EXPECT_EQ(found.lowest_rad, arm.lowest_rad);
    EXPECT_EQ(found.highest_rad, arm.highest_rad);
    EXPECT_EQ(found.fastest_radPerS, arm.fastest_radPerS);
}

TEST(JointChannel, theLinksOfAnArmAreInItsRecording) {
    const auto model =
        arm_model::readUrdf(std::string(TELETA_SOURCE_DIR) + "/resources/arms/seven-joints.urdf");
    ASSERT_TRUE(model) << core::describe(model.error());
    const auto chain = arm_model::SerialChain::create(std::make_shared<const arm_model::ArmModel>(*model),
                                                      model->links.front().name, "tool0");
    ASSERT_TRUE(chain) << core::describe(chain.error());
    core::ArmDescription arm;
    arm.lowest_rad = chain->lowest();
    arm.highest_rad = chain->highest();
    arm.fastest_radPerS = chain->fastest();
    recording::StreamInfo stream = pipeline::armStream("robot-joints", arm, {}, &*chain);

    const auto found = pipeline::recordedArm(stream, "file");
    ASSERT_TRUE(found) << core::describe(found.error());
    ASSERT_TRUE(found->chain);
    EXPECT_EQ(found->chain->tipLink(), "tool0");
    const core::JointVector q{0.1, -0.2, 0.3, -0.4, 0.5, -0.6, 0.7};
    EXPECT_TRUE(found->chain->X_Base_Tip(q).isApprox(chain->X_Base_Tip(q), 1e-12));

    const std::size_t link = stream.details.find("<robot");
    ASSERT_NE(link, std::string::npos);
    stream.details.replace(link, 6, "<zobot");
    EXPECT_FALSE(pipeline::recordedArm(stream, "file"));
}

TEST(JointChannel, aRecordingSaysWhereTheArmsPadIs) {
    const auto chain = test::chainOf("resources/arms/seven-joints.urdf");
    core::ArmDescription arm;
    arm.lowest_rad = chain->lowest();
    arm.highest_rad = chain->highest();
    arm.fastest_radPerS = chain->fastest();
    arm.pad = test::padOnLinkFive();
    arm.pad->joint = "joint_4";
    arm.pad->centreSe_m = 0.0005;
    arm.pad->torques = {.windowLow_Nm = 0.8, .windowHigh_Nm = 2.0, .threshold_Nm = 1.9, .noiseFloor_Nm = 0.1};
    recording::StreamInfo stream = pipeline::armStream("robot-joints", arm, "pad-frames", &*chain);

    const auto found = pipeline::recordedArm(stream, "file");
    ASSERT_TRUE(found) << core::describe(found.error());
    EXPECT_EQ(found->skinStream, "pad-frames");
    ASSERT_TRUE(found->chain && found->description.pad);
    const core::PadPlacement& pad = *found->description.pad;
    EXPECT_EQ(pad.link, "link_5");
    EXPECT_EQ(pad.position_m, arm.pad->position_m);
    EXPECT_EQ(pad.rollPitchYaw_rad, arm.pad->rollPitchYaw_rad);
    EXPECT_EQ(pad.joint, "joint_4");
    EXPECT_EQ(pad.jointStiffness_NmPerRad, arm.pad->jointStiffness_NmPerRad);
    EXPECT_EQ(pad.centreSe_m, 0.0005);
    EXPECT_EQ(pad.torques.windowLow_Nm, 0.8);
    EXPECT_EQ(pad.torques.windowHigh_Nm, 2.0);
    EXPECT_EQ(pad.torques.threshold_Nm, 1.9);
    EXPECT_EQ(pad.torques.noiseFloor_Nm, 0.1);

    const auto spoiled = [&stream](const std::string& text, const std::string& with) {
        recording::StreamInfo other = stream;
        const std::size_t place = other.details.find(text);
        EXPECT_NE(place, std::string::npos) << text;
        other.details.replace(place, text.size(), with);
        return !pipeline::recordedArm(other, "file").has_value();
    };
    EXPECT_TRUE(spoiled("\"urdf\":", "\"lost\":")) << "a pad needs links";
    EXPECT_TRUE(spoiled("\"window_nm\":[0.8,2.0]", "\"window_nm\":[0.8]"));
    EXPECT_TRUE(spoiled("\"pad\":{", "\"pad\":[],\"x\":{"));
}
