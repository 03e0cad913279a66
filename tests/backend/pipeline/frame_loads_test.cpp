// SPDX-License-Identifier: GPL-3.0-or-later
// Loads of frames in N by a calibration, in the channel of an array.
#include "backend/pipeline/touch/frame_loads.h"
#include "backend/pipeline/touch_channel.h"
#include "backend/recording/csv_export.h"
#include "backend/recording/recorder.h"
#include "backend/recording/recording.h"
#include "tests/backend/core/temporary_folder.h"
#include "tests/backend/pipeline/scripted_source.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

using teleta::core::ArrayLayout;
using teleta::core::TaxelLayout;
using teleta::pipeline::ChannelSettings;
using teleta::pipeline::FrameLoads;
using teleta::pipeline::TouchChannel;

namespace {

constexpr ArrayLayout kLayout{.rows = 1, .columns = 2, .pitchX_m = 0.01};
constexpr const char* kHeader = "load,signal,gain,gain_se,rest,least,greatest,scatter\n";
/// force_n = 0.5 (t0 - 10) + 0.25 (t1 - 20)
const std::string kTwoTaxels = std::string(kHeader) + "force_n,t0,0.5,0.01,10,8,30,0.03\n"
                                                      "force_n,t1,0.25,0.02,20,18,60,0.03\n";

class LoadChannel : public testing::Test {
protected:
    void open(const std::string& calibration, std::vector<float> tare = {}) {
        auto source = std::make_unique<teleta::test::ScriptedSource>(kLayout);
        m_source = source.get();
        ChannelSettings settings;
        settings.conditioning.tare = std::move(tare);
        settings.loadUnit = "counts";
        m_channel = std::make_unique<TouchChannel>(std::move(source), settings);
        auto loads = FrameLoads::read(m_folder.write("n.csv", calibration), TaxelLayout(kLayout), "counts");
        ASSERT_TRUE(loads) << teleta::core::describe(loads.error());
        m_channel->setLoads(std::move(*loads));
    }
    teleta::equilibration::LoadCalibration::Loads loadsOf(std::vector<float> frame) {
        EXPECT_TRUE(m_source->push(std::move(frame), m_time_s += 0.01));
        m_channel->process();
        const auto found = m_channel->newestLoads();
        EXPECT_TRUE(found);
        return found ? found->at : teleta::equilibration::LoadCalibration::Loads{};
    }

    teleta::test::TemporaryFolder m_folder;
    teleta::test::ScriptedSource* m_source = nullptr;
    std::unique_ptr<TouchChannel> m_channel;
    double m_time_s = 0.0;
};

} // namespace

TEST_F(LoadChannel, followFromWhatTheTaxelsReadWithTheirError) {
    ASSERT_NO_FATAL_FAILURE(open(kTwoTaxels));
    EXPECT_FALSE(m_channel->newestLoads()) << "no frame came yet";
    const auto found = loadsOf({14.0F, 28.0F});
    EXPECT_NEAR(found.loads[0], 0.5 * 4 + 0.25 * 8, 1e-12);
    EXPECT_NEAR(found.errors[0], std::hypot(0.03, 0.01 * 4 + 0.02 * 8), 1e-12);
    EXPECT_FALSE(found.extrapolated);
    EXPECT_EQ(m_channel->newestLoads()->names, std::vector<std::string>{"force_n"});
}

TEST_F(LoadChannel, areMarkedWhereASignalLiesBeyondThePresses) {
    ASSERT_NO_FATAL_FAILURE(open(kTwoTaxels));
    EXPECT_TRUE(loadsOf({31.0F, 28.0F}).extrapolated);
    EXPECT_TRUE(loadsOf({14.0F, 17.0F}).extrapolated);
    EXPECT_FALSE(loadsOf({30.0F, 60.0F}).extrapolated);
}

TEST_F(LoadChannel, countFromTheTareOfTheArrayWhereThereIsOne) {
    ASSERT_NO_FATAL_FAILURE(open(kTwoTaxels, {110.0F, -20.0F}));
    const auto found = loadsOf({114.0F, -12.0F});
    EXPECT_NEAR(found.loads[0], 0.5 * 4 + 0.25 * 8, 1e-6);
    EXPECT_FALSE(found.extrapolated);
    EXPECT_TRUE(loadsOf({131.0F, -12.0F}).extrapolated);
    EXPECT_NEAR(loadsOf({110.0F, -20.0F}).loads[0], 0.0, 1e-6) << "at rest";
}

TEST_F(LoadChannel, followFromWhatWasComputedOfTheFrame) {
    ASSERT_NO_FATAL_FAILURE(
        open(std::string(kHeader) + "force_n,force_counts,0.1,0.001,0,0,100,0.02\n", {1.0F, 1.0F}));
    EXPECT_NEAR(loadsOf({31.0F, 41.0F}).loads[0], 0.1 * 70, 1e-9);
    EXPECT_TRUE(loadsOf({100.0F, 41.0F}).extrapolated);
}

TEST_F(LoadChannel, areNotKnownWhereASignalIsNot) {
    ASSERT_NO_FATAL_FAILURE(open(kTwoTaxels));
    const auto found = loadsOf({std::nanf(""), 28.0F});
    EXPECT_TRUE(std::isnan(found.loads[0]));
    EXPECT_FALSE(found.extrapolated) << "what is not known lies nowhere";
}

/// A paused source sends nothing.
TEST_F(LoadChannel, ofTheLastFrameFollowAChangeOfTheSettings) {
    ASSERT_NO_FATAL_FAILURE(open(kTwoTaxels, {12.0F, 22.0F}));
    EXPECT_NEAR(loadsOf({20.0F, 28.0F}).loads[0], 0.5 * 8.0 + 0.25 * 6.0, 1e-12);
    m_channel->clearTare();
    m_channel->process();
    EXPECT_NEAR(m_channel->newestLoads()->at.loads[0], 0.5 * 10.0 + 0.25 * 8.0, 1e-12);
}

TEST_F(LoadChannel, areRecordedAndExportedUnderTheNamesOfTheCommand) {
    ASSERT_NO_FATAL_FAILURE(open(kTwoTaxels));
    auto started = teleta::recording::Recorder::start(m_folder.path("mat.teleta"), {});
    ASSERT_TRUE(started) << teleta::core::describe(started.error());
    const std::shared_ptr<teleta::recording::Recorder> recorder = std::move(*started);
    m_channel->record(recorder, "mat");
    (void)loadsOf({14.0F, 28.0F});
    (void)loadsOf({14.0F, 80.0F});
    ASSERT_TRUE(recorder->stop());
    const auto recording = teleta::recording::Recording::open(m_folder.path("mat.teleta"));
    ASSERT_TRUE(recording) << teleta::core::describe(recording.error());
    ASSERT_TRUE(teleta::recording::exportCsv(*recording, m_folder.path("csv")));
    std::ifstream file(m_folder.path("csv") + "/mat-loads.csv");
    std::string header, first, second;
    ASSERT_TRUE(std::getline(file, header) && std::getline(file, first) && std::getline(file, second));
    EXPECT_EQ(header, "time_s,force_n,force_n_se,extrapolated");
    EXPECT_NE(first.find(",4,"), std::string::npos) << first;
    EXPECT_TRUE(first.ends_with(",0")) << first;
    EXPECT_NE(second.find(",17,"), std::string::npos) << second;
    EXPECT_TRUE(second.ends_with(",1")) << second;
}

TEST(FrameLoads, knowTheColumnsOfExportedFramesAndFeatures) {
    const auto scalars = FrameLoads::signalsOf(TaxelLayout(kLayout), "\u00b5T");
    EXPECT_EQ(scalars.front(), "force_ut");
    EXPECT_EQ(scalars.back(), "t1");
    EXPECT_EQ(std::ranges::count(scalars, "contact_type"), 0);
    const auto vectors = FrameLoads::signalsOf(TaxelLayout(kLayout, 3), "\u00b5T");
    EXPECT_EQ(std::ranges::count(vectors, "shear_x_ut"), 1);
    EXPECT_EQ(vectors.back(), "t1_z");
}

TEST(FrameLoads, refuseASignalThatTheArrayDoesNotHave) {
    const teleta::test::TemporaryFolder folder;
    const std::string path = folder.write("n.csv", kTwoTaxels + "force_n,t2,1,0,0,0,1,0.03\n");
    const auto loads = FrameLoads::read(path, TaxelLayout(kLayout), "counts");
    ASSERT_FALSE(loads);
    EXPECT_EQ(loads.error().kind, teleta::core::ErrorKind::badInput);
    EXPECT_EQ(loads.error().where.file, path);
    EXPECT_EQ(loads.error().where.line, 4);
    EXPECT_GT(loads.error().where.column, 1);
    EXPECT_NE(loads.error().message.find("t2"), std::string::npos);
    EXPECT_NE(loads.error().expected.find("force_counts"), std::string::npos);
    EXPECT_EQ(FrameLoads::read(folder.path("none.csv"), TaxelLayout(kLayout), "counts").error().kind,
              teleta::core::ErrorKind::notFound);
}
