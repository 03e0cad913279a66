// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sources/recording_request.h"
#include "app/sources/source_request.h"
#include "backend/pipeline/recorded/recorded_sources.h"
#include "backend/pipeline/touch_channel.h"
#include "backend/recording/csv_export.h"
#include "backend/recording/recorder.h"
#include "backend/recording/recording.h"
#include "tests/backend/core/temporary_folder.h"
#include "tests/devices/manual_clock.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

namespace teleta::console {
namespace {

/// A cross of five taxels in mT, as lines of numbers, of which the third shows a press on its middle.
class TaxelsSource : public testing::Test {
protected:
    core::Expected<std::shared_ptr<pipeline::TouchChannel>> open() {
        m_folder.write("bytes.csv", "0,0,0,0,0\n0,0,0,0,0\n9,1,1,1,1\n");
        const std::string path =
            m_folder.write("cross.toml", "kind = 'taxels'\nname = 'cross'\nthreshold = 0.5\n" + m_loads +
                                             "[link]\ntype = 'file'\n"
                                             "path = 'bytes.csv'\n[layout]\nunit = 'mT'\n"
                                             "positions_mm = [[0, 0], [4, 0], [-4, 0], [0, 4], [0, -4]]\n"
                                             "[frame]\nencoding = 'csv'\ncolumns = '1..5'\nskip = 0\n");
        return app::makeSourceFactory(app::TaxelsRequest{path}, m_stop)().map(
            [](const std::shared_ptr<pipeline::Channel>& channel) {
                return std::dynamic_pointer_cast<pipeline::TouchChannel>(channel);
            });
    }

    /// Runs the channel until it has processed its frames, and records them as "skin".
    static void record(pipeline::TouchChannel& channel, core::Wakeup& data, const std::string& path,
                       std::uint64_t frames) {
        auto started = recording::Recorder::start(path, {});
        ASSERT_TRUE(started) << core::describe(started.error());
        const std::shared_ptr<recording::Recorder> recorder = std::move(*started);
        channel.record(recorder, "skin");
        channel.start(data);
        ASSERT_TRUE(teleta::test::eventually(data, [&] {
            channel.process();
            return channel.framesProcessed() == frames;
        }));
        channel.stop();
        channel.record(nullptr, {});
        ASSERT_TRUE(recorder->stop());
    }

    teleta::test::TemporaryFolder m_folder;
    core::StopSwitch m_stop;
    std::string m_loads; ///< a line of the description
};

TEST_F(TaxelsSource, isShownRecordedAndFoundInItsRecordingInItsOwnUnit) {
    const auto opened = open();
    ASSERT_TRUE(opened) << core::describe(opened.error());
    pipeline::TouchChannel& channel = **opened;
    EXPECT_EQ(channel.settings().loadUnit, "mT");
    EXPECT_EQ(channel.settings().features.threshold_N, 0.5);
    const std::string path = m_folder.path("run.teleta");
    core::Wakeup data;
    ASSERT_NO_FATAL_FAILURE(record(channel, data, path, 3));
    ASSERT_TRUE(channel.update());
    ASSERT_EQ(channel.snapshot().contacts.size(), 1U);
    EXPECT_EQ(channel.snapshot().contacts[0].taxels, 5);
    EXPECT_EQ(channel.snapshot().features.dead, 0) << "the corners of the cross have no taxel";
    EXPECT_NEAR(channel.snapshot().contacts[0].x_m, 0.0, 1e-9);
    EXPECT_EQ(channel.snapshot().loadUnit, "mT");

    const auto recording = recording::Recording::open(path);
    ASSERT_TRUE(recording) << core::describe(recording.error());
    const auto sources = pipeline::recordedSources(*recording);
    ASSERT_TRUE(sources) << core::describe(sources.error());
    ASSERT_EQ(sources->arrays.size(), 1U);
    const core::SourceDescription& array = sources->arrays[0].array.description;
    EXPECT_EQ(array.layout.grid(), (core::ArrayLayout{3, 3, 0.004}));
    EXPECT_TRUE(array.layout.isAbsent(0));
    EXPECT_EQ(array.unit, "mT");
    EXPECT_EQ(sources->arrays[0].array.settings.loadUnit, "mT");
    recording::StreamReader reader = recording->reader(sources->arrays[0].arrayStream);
    core::TappedFrames block;
    std::vector<float> values;
    while (reader.next(block).value_or(false))
        for (std::size_t i = 0; i < block.frames(); ++i) {
            const auto frame = recording::valuesOf<float>(block, i, 9);
            values.assign(frame.begin(), frame.end());
        }
    ASSERT_EQ(values.size(), 9U);
    EXPECT_EQ(values[4], 9.0F);
    EXPECT_TRUE(std::isnan(values[0]));

    const auto again = app::recordingRequestsOf(path);
    ASSERT_TRUE(again);
    const auto replayed = app::openRecording(again->front(), m_stop);
    ASSERT_TRUE(replayed) << core::describe(replayed.error());
    EXPECT_EQ(dynamic_cast<pipeline::TouchChannel&>(**replayed).description().layout, array.layout);
}

/// Three magnetometers off a grid, with the field as vectors. The second frame presses and pushes the first.
TEST_F(TaxelsSource, vectorsOffAGridAreShownRecordedExportedAndPlayed) {
    m_folder.write("bytes.csv", "0,0,0,0,0,0,0,0,0\n3,4,-10,0,0,0,0,0,0\n");
    const std::string device =
        m_folder.write("skin.toml", "kind = 'taxels'\nname = 'skin'\nthreshold = 0.5\n[link]\ntype = 'file'\n"
                                    "path = 'bytes.csv'\n[layout]\nunit = 'uT'\ncomponents = 3\n"
                                    "positions_mm = [[0, 0], [4, 1], [9, 0]]\n"
                                    "[frame]\nencoding = 'csv'\ncolumns = '1..9'\nskip = 0\n");
    const auto opened = app::makeSourceFactory(app::TaxelsRequest{device}, m_stop)();
    ASSERT_TRUE(opened) << core::describe(opened.error());
    auto& channel = dynamic_cast<pipeline::TouchChannel&>(**opened);
    const core::TaxelLayout layout = channel.description().layout;
    EXPECT_FALSE(layout.isGrid());
    const std::string path = m_folder.path("run.teleta");
    core::Wakeup data;
    ASSERT_NO_FATAL_FAILURE(record(channel, data, path, 2));
    const auto expectPressed = [](const pipeline::TouchSnapshot& snapshot) {
        ASSERT_EQ(snapshot.contacts.size(), 1U);
        EXPECT_NEAR(snapshot.contacts[0].x_m, -0.0045, 1e-9) << "from the middle of the box";
        ASSERT_TRUE(snapshot.contacts[0].shear);
        EXPECT_NEAR(snapshot.contacts[0].force_N, 10.0, 1e-6);
        EXPECT_NEAR(snapshot.contacts[0].shear->friction, 0.5, 1e-6);
        EXPECT_NEAR(snapshot.features.shear->x_N, 3.0, 1e-6);
    };
    ASSERT_TRUE(channel.update());
    expectPressed(channel.snapshot());

    const auto recording = recording::Recording::open(path);
    ASSERT_TRUE(recording) << core::describe(recording.error());
    const std::string folder = m_folder.path("csv");
    const auto written = recording::exportCsv(*recording, folder);
    ASSERT_TRUE(written) << core::describe(written.error());
    const auto firstLineOf = [&](const std::string& name) {
        std::ifstream file(folder + '/' + name);
        std::string line;
        std::getline(file, line);
        return line;
    };
    EXPECT_EQ(firstLineOf("skin-frames.csv"), "time_s,t0_x,t0_y,t0_z,t1_x,t1_y,t1_z,t2_x,t2_y,t2_z");
    EXPECT_EQ(firstLineOf("skin-features.csv"),
              "time_s,contact_type,force_ut,cop_x_m,cop_y_m,coc_x_m,coc_y_m,dzmp_x_m,dzmp_y_m,alpha_z_rad,"
              "lambda1_m2,lambda2_m2,active,shear_x_ut,shear_y_ut,moment_z_ut_m,friction_ratio");

    const auto requests = app::recordingRequestsOf(path);
    ASSERT_TRUE(requests);
    const auto replayed = app::openRecording(requests->front(), m_stop);
    ASSERT_TRUE(replayed) << core::describe(replayed.error());
    auto& again = dynamic_cast<pipeline::TouchChannel&>(**replayed);
    EXPECT_EQ(again.description().layout, layout);
    EXPECT_EQ(again.settings().loadUnit, "uT");
    again.start(data);
    again.playback()->play();
    ASSERT_TRUE(teleta::test::eventually(data, [&] {
        again.process();
        return again.framesProcessed() >= 2;
    }));
    again.stop();
    ASSERT_TRUE(again.update());
    expectPressed(again.snapshot());
}

TEST_F(TaxelsSource, hasItsLoadsInNewtonsByTheFileThatItsDescriptionNames) {
    m_loads = "loads = 'newtons.csv'\n";
    m_folder.write("newtons.csv", "load,signal,gain,gain_se,rest,least,greatest,scatter\n"
                                  "force_n,force_mt,0.5,0.01,0,0,10,0.02\n"
                                  "force_n,t4,0.25,0,0,0,10,0.02\n");
    const auto opened = open();
    ASSERT_TRUE(opened) << core::describe(opened.error());
    core::Wakeup data;
    ASSERT_NO_FATAL_FAILURE(record(**opened, data, m_folder.path("run.teleta"), 3));
    const auto found = (*opened)->newestLoads();
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->at.loads[0], 0.5 * 13 + 0.25 * 9, 1e-6);
    EXPECT_NEAR(found->at.errors[0], std::hypot(0.02, 0.01 * 13), 1e-6);
    EXPECT_TRUE(found->at.extrapolated) << "13 mT is beyond 10";
    const auto recording = recording::Recording::open(m_folder.path("run.teleta"));
    ASSERT_TRUE(recording) << core::describe(recording.error());
    ASSERT_EQ(recording->streams().size(), 3U);
    EXPECT_EQ(recording->streams()[2].name, "skin-loads");

    const auto requests = app::recordingRequestsOf(m_folder.path("run.teleta"));
    ASSERT_TRUE(requests);
    const auto replayed = app::openRecording(requests->front(), m_stop);
    ASSERT_TRUE(replayed) << core::describe(replayed.error());
    auto& again = dynamic_cast<pipeline::TouchChannel&>(**replayed);
    again.start(data);
    again.playback()->play();
    ASSERT_TRUE(teleta::test::eventually(data, [&] {
        again.process();
        return again.framesProcessed() >= 3;
    }));
    again.stop();
    const auto played = again.newestLoads();
    ASSERT_TRUE(played);
    EXPECT_EQ(played->names, std::vector<std::string>{"force_n"});
    EXPECT_NEAR(played->at.loads[0], 0.5 * 13 + 0.25 * 9, 1e-6);
    EXPECT_NEAR(played->at.errors[0], std::hypot(0.02, 0.01 * 13), 1e-6);
    EXPECT_TRUE(played->at.extrapolated);
}

TEST_F(TaxelsSource, refusesLoadsThatDoNotFit) {
    m_loads = "loads = 'newtons.csv'\n";
    EXPECT_EQ(open().error().kind, core::ErrorKind::notFound);
    const std::string path =
        m_folder.write("newtons.csv", "load,signal,gain,gain_se,rest,least,greatest,scatter\n"
                                      "force_n,force_n,0.5,0.01,0,0,10,0.02\n");
    const auto opened = open();
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.error().where.file, path);
    EXPECT_EQ(opened.error().where.line, 2);
    EXPECT_NE(opened.error().expected.find("force_mt"), std::string::npos) << opened.error().expected;
}

TEST_F(TaxelsSource, saysWhereItsDescriptionIsWrong) {
    const std::string path = m_folder.write("cross.toml", "kind = 'taxels'\nname = ''\n");
    const auto opened = app::makeSourceFactory(app::TaxelsRequest{path}, m_stop)();
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.error().kind, core::ErrorKind::badInput);
    EXPECT_EQ(opened.error().where.line, 2);
}

} // namespace
} // namespace teleta::console
