// SPDX-License-Identifier: GPL-3.0-or-later
// A flat gel at a site: its consoles follow its markers in the pictures that they get, from the places at
// rest that the site took.
#include "app/sources/site_request.h"
#include "backend/pipeline/gel_channel.h"
#include "backend/pipeline/recorded/recorded_camera.h"
#include "backend/pipeline/recorded/recorded_sources.h"
#include "backend/recording/recorder.h"
#include "backend/recording/recording.h"
#include "tests/app/cli/gel_video.h"
#include "tests/peer/site/site_process.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QStringList>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <fstream>
#include <memory>
#include <span>
#include <sstream>
#include <string>
#include <vector>

namespace teleta {
namespace {

using test::SiteProcess;
using test::TestConsole;

constexpr int kFrames = 40;
constexpr double kRate_Hz = 25.0;

std::string devices(int quality) {
    return "[[device]]\nid = \"practice\"\nscene = \":/scenes/teleoperation.toml\"\n"
           "[[device]]\nid = \"finger\"\nfile = \"gel.toml\"\nquality = " +
           std::to_string(quality) + "\nmax_kbit_s = 20000\n";
}

void writeGel(SiteProcess& site) {
    ASSERT_TRUE(test::writeGelVideo(site.folder().filePath("press.avi").toStdString(), kFrames));
    std::ofstream(site.folder().filePath("gel.toml").toStdString()) << "source = \"press.avi\"\n"
                                                                    << test::kGelFile;
}

std::shared_ptr<pipeline::GelChannel> openGel(const TestConsole& console) {
    const auto opened =
        app::openRemote(console.sharedClient(), {{}, "lab", "finger", console.sharedClient()});
    EXPECT_TRUE(opened) << core::describe(opened.error());
    return opened ? std::dynamic_pointer_cast<pipeline::GelChannel>(*opened) : nullptr;
}

/// Squares of the errors of the markers' ways, along one axis each.
struct Errors {
    double squares_px2 = 0.0;
    double count = 0.0;
    [[nodiscard]] double rms_px() const { return std::sqrt(squares_px2 / count); }
};

/// Against how the video was made: frame n drags the gel by so much from its rest.
void add(const pipeline::GelSnapshot& shown, int frame, Errors& errors) {
    const double dragged_px = test::kDraggedPerFrame_px * std::max(0, frame - test::kStillFrames + 1);
    const simulation::GelContact contact{
        .centre_m = {160.0, 120.0}, .radius_m = 70.0, .slip_m = {2.0 * dragged_px, 0.0}, .stick = 0.70710678};
    for (std::size_t i = 0; i < shown.markers.size(); ++i) {
        if (!shown.motions[i].found)
            continue;
        const Eigen::Vector2d& rest_px = shown.markers[i].rest_px;
        const Eigen::Vector2d error_px =
            shown.motions[i].place_px - rest_px - contact.displacement_m(rest_px);
        errors.squares_px2 += error_px.squaredNorm();
        errors.count += 2.0;
    }
}

class SiteGel : public testing::TestWithParam<int> {};

TEST_P(SiteGel, itsConsolesFollowItsMarkersFromTheRestThatTheSiteTook) {
    SiteProcess site(134, devices(GetParam()));
    writeGel(site);
    site.start();
    TestConsole console(site, "a");
    const auto gel = openGel(console);
    ASSERT_TRUE(gel);
    EXPECT_EQ(gel->description().name, "simulated");
    EXPECT_TRUE(gel->description().recorded) << "the site plays a video";
    const std::string path = site.folder().filePath("console.teleta").toStdString();
    auto started = recording::Recorder::start(path, {});
    ASSERT_TRUE(started) << core::describe(started.error());
    const std::shared_ptr<recording::Recorder> recorder = std::move(*started);
    gel->record(recorder, "finger");
    gel->start();
    // Wherever in the video the console came in: nothing was taken here while something touched the gel.
    Errors errors;
    int contacts = 0;
    std::vector<bool> seen(kFrames, false);
    ASSERT_TRUE(TestConsole::eventually([&] {
        if (!gel->update() || !gel->snapshot().usable)
            return false;
        const pipeline::GelSnapshot& shown = gel->snapshot();
        // The video begins again and again.
        pipeline::GelEvent event;
        while (gel->popEvent(event)) {
        }
        const auto moved_px = (shown.motions[44].place_px - shown.markers[44].rest_px).x();
        const int frame = test::kStillFrames - 1 +
                          static_cast<int>(std::lround(std::max(0.0, moved_px) / test::kDraggedPerFrame_px));
        if (frame >= kFrames)
            return false;
        seen[static_cast<std::size_t>(frame)] = true;
        add(shown, frame, errors);
        contacts += shown.contacts.empty() ? 0 : 1;
        return std::ranges::count(seen, true) > (kFrames - test::kStillFrames) * 3 / 4;
    }));
    EXPECT_GT(contacts, 10);
    // As for a gel that is here; see the table of the gels' accuracy.
    EXPECT_LT(errors.rms_px(), 0.1);
    ::testing::Test::RecordProperty("marker_error_mpx", static_cast<int>(1e3 * errors.rms_px()));
    std::cout << "quality " << GetParam() << ": " << errors.rms_px() << " px rms an axis\n";

    gel->stop();
    gel->record(nullptr, {});
    ASSERT_TRUE(recorder->stop());
    const auto recording = recording::Recording::open(path);
    ASSERT_TRUE(recording) << core::describe(recording.error());
    const auto sources = pipeline::recordedSources(*recording);
    ASSERT_TRUE(sources) << core::describe(sources.error());
    ASSERT_EQ(sources->gels.size(), 1U);
    EXPECT_EQ(sources->gels.front().file.plane.mmPerPx, 0.1);
    const auto rest = pipeline::firstReference(*recording, sources->gels.front().referenceStream);
    ASSERT_TRUE(rest);
    EXPECT_EQ(rest->height_px, test::kStillFrames * 240) << "the pictures that the site took";
}

INSTANTIATE_TEST_SUITE_P(OfPictures, SiteGel, testing::Values(40, 70, 90));

/// What the program writes for these arguments.
std::string written(const QStringList& arguments) {
    QProcess program;
    program.start(QStringLiteral(TELETA_PROGRAM), arguments);
    EXPECT_TRUE(program.waitForFinished(60'000) && program.exitCode() == 0)
        << program.readAllStandardError().toStdString();
    return program.readAllStandardOutput().toStdString();
}

/// The rows of a CSV text, the names of the columns first.
std::vector<std::vector<std::string>> cellsOf(std::istream& table) {
    std::vector<std::vector<std::string>> rows;
    for (std::string line; std::getline(table, line);) {
        rows.emplace_back();
        std::istringstream row(line);
        for (std::string cell; std::getline(row, cell, ',');)
            rows.back().push_back(cell);
    }
    return rows;
}

/// 3 N per mm of shear, beyond which nothing was pressed.
void expectNewtons(const std::vector<std::vector<std::string>>& rows) {
    ASSERT_GT(rows.size(), 1U);
    const std::vector<std::string>& names = rows.front();
    const auto column = [&names](const char* name) {
        return static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
    };
    const std::size_t force = column("force_n");
    ASSERT_EQ(force + 3, names.size());
    EXPECT_EQ(names[force + 1], "force_n_se");
    EXPECT_EQ(names[force + 2], "extrapolated");
    double largest_N = 0.0;
    for (const std::vector<std::string>& row : std::span(rows).subspan(1)) {
        ASSERT_EQ(row.size(), names.size());
        const double shear_m = std::stod(row[column("shear_proxy_x_m")]);
        EXPECT_NEAR(std::stod(row[force]), 3000.0 * shear_m, 1e-6);
        EXPECT_NEAR(std::stod(row[force + 1]), std::hypot(0.05, 10.0 * shear_m), 1e-6);
        EXPECT_EQ(std::stod(row[force + 2]), shear_m > 0.0002 || shear_m < 0.0 ? 1.0 : 0.0);
        largest_N = std::max(largest_N, std::stod(row[force]));
    }
    EXPECT_GT(largest_N, 0.5);
}

TEST(SiteGelLoads, areInNewtonsInWhatIsMadeOfTheRecordingsOfBothEnds) {
    SiteProcess site(134, {});
    site.recordInto(site.folder().path());
    site.setDevices(devices(90));
    writeGel(site);
    std::ofstream(site.folder().filePath("gel.toml").toStdString())
        << "source = \"press.avi\"\nloads = \"newtons.csv\"\n"
        << test::kGelFile;
    std::ofstream(site.folder().filePath("newtons.csv").toStdString())
        << "load,signal,gain,gain_se,rest,least,greatest,scatter\nforce_n,shear_proxy_x_m,3000,10,0,0,0.0002,"
           "0.05\n";
    site.start();
    QStringList files{site.folder().filePath("console.teleta")};
    {
        TestConsole console(site, "a");
        const auto gel = openGel(console);
        ASSERT_TRUE(gel);
        auto started = recording::Recorder::start(files.front().toStdString(), {});
        ASSERT_TRUE(started) << core::describe(started.error());
        const std::shared_ptr<recording::Recorder> recorder = std::move(*started);
        gel->record(recorder, "finger");
        gel->start();
        ASSERT_TRUE(TestConsole::eventually([&] {
            pipeline::GelEvent event;
            while (gel->popEvent(event)) {
            }
            return gel->update() && gel->snapshot().processed > 2 * kFrames;
        }));
        gel->stop();
        gel->record(nullptr, {});
        ASSERT_TRUE(recorder->stop());
    }
    site.send(SIGTERM);
    ASSERT_TRUE(TestConsole::eventually([&] { return site.memory_MiB() == 0.0; }));
    const QDir folder(site.folder().path());
    for (const QString& name : folder.entryList({QStringLiteral("*.teleta")}))
        if (!files.contains(folder.filePath(name)))
            files << folder.filePath(name);
    ASSERT_EQ(files.size(), 2) << "of the console and of the site";
    for (const QString& file : files) {
        SCOPED_TRACE(file.toStdString());
        written({"export", file, "--csv", file + ".csv"});
        written({"export", file, "--mcap", file + ".mcap", "--compression", "none"});
        std::ifstream table((file + ".csv/finger-contacts.csv").toStdString());
        expectNewtons(cellsOf(table));
        std::istringstream replayed(written({"replay", file, "--stream", "finger-camera"}));
        expectNewtons(cellsOf(replayed));
        QFile mcap(file + ".mcap");
        ASSERT_TRUE(mcap.open(QIODevice::ReadOnly));
        EXPECT_TRUE(mcap.readAll().contains(
            "float64 slip_index\nfloat64 force_n\nfloat64 force_n_se\nfloat64 extrapolated"));
    }
}

TEST(SiteGelRest, isKnownToAConsoleThatComesWhileTheGelIsTouchedAndMayBeTakenThereAnew) {
    SiteProcess site(134, devices(90));
    writeGel(site);
    site.start();
    TestConsole console(site, "a");
    const auto gel = openGel(console);
    ASSERT_TRUE(gel);
    gel->start();
    ASSERT_TRUE(TestConsole::eventually([&] { return gel->update() && gel->snapshot().hasReference(); }));
    // The site's is there with the first picture, not after eight.
    EXPECT_LT(gel->snapshot().processed, 8U);
    EXPECT_EQ(gel->snapshot().markers.size(), 80U);
    long taken = 0;
    const auto countRests = [&] {
        pipeline::GelEvent event;
        while (gel->popEvent(event))
            taken += event.kind == pipeline::GelEvent::Kind::reference ? 1 : 0;
        return taken;
    };
    ASSERT_TRUE(TestConsole::eventually([&] { return countRests() == 1; }));
    gel->renewReference();
    EXPECT_TRUE(TestConsole::eventually([&] { return countRests() == 2; }));
    gel->stop();
}

} // namespace
} // namespace teleta
