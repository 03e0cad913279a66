// SPDX-License-Identifier: GPL-3.0-or-later
// Export to MCAP and import, in processor time of one core, compared in the same run with @mcap/core on Node
// writing the same messages (tests/peer/mcap/write_speed.mjs; installed by tests/peer/mcap/install.sh).
//   tactile   100 000 frames of 84 taxels, two messages each; the peer's frames repeat after 256
//   pictures  100 grey pictures of 1640 x 1232
#include "backend/mcap/recorded/mcap_export.h"
#include "backend/mcap/recorded/mcap_import.h"
#include "backend/recording/recording_writer.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QProcess>
#include <QTemporaryDir>
#include <QTimeZone>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <sys/resource.h>
#include <utility>
#include <vector>

namespace {

using namespace teleta;

constexpr int kFrames = 100'000;
constexpr std::size_t kTaxels = 84;
constexpr int kPictures = 100;
constexpr int kWidth = 1640;
constexpr int kHeight = 1232;
constexpr int kTurns = 3;

double ownSeconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

double childrenSeconds() {
    rusage usage{};
    getrusage(RUSAGE_CHILDREN, &usage);
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * 1e-6;
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// Loads of a few newtons with the noise of a sensor, to 1 mN.
void recordTactile(const std::string& path) {
    recording::RecordingWriter writer(path,
                                      {{0, QDateTime::fromSecsSinceEpoch(1'790'000'000, QTimeZone::utc())}});
    (void)writer.begin({});
    recording::StreamInfo info;
    info.name = "frames";
    info.shape = {6, 14};
    info.unit = "N";
    info.details = R"({"pitch_m":0.0034})";
    (void)writer.addStream(info);
    std::mt19937 random(1);
    std::normal_distribution<float> noise(0.0F, 0.015F);
    for (int frame = 0; frame < kFrames; frame += 500) {
        core::TappedFrames block;
        std::vector<float> values;
        for (int i = frame; i < frame + 500; ++i) {
            block.time_ns.push_back(i * 5'000'000LL);
            block.sourceTime_s.push_back(i * 0.005);
            for (std::size_t taxel = 0; taxel < kTaxels; ++taxel)
                values.push_back(
                    std::round((static_cast<float>(taxel % 7) * 0.3F + noise(random)) * 1000.0F) / 1000.0F);
        }
        const auto* bytes = reinterpret_cast<const std::byte*>(values.data());
        block.values.assign(bytes, bytes + values.size() * sizeof(float));
        writer.take(0, std::move(block));
        if (frame % 10'000 == 0)
            (void)writer.commit();
    }
    (void)writer.commit();
    (void)writer.finish();
}

/// Dots on a dark skin, with noise of one grey level.
void recordPictures(const std::string& path) {
    recording::RecordingWriter writer(path,
                                      {{0, QDateTime::fromSecsSinceEpoch(1'790'000'000, QTimeZone::utc())}});
    (void)writer.begin({});
    recording::StreamInfo info;
    info.name = "camera";
    info.kind = recording::StreamKind::camera;
    info.type = recording::ValueType::grey8;
    info.shape = {kHeight, kWidth};
    (void)writer.addStream(info);
    std::mt19937 random(1);
    for (int picture = 0; picture < kPictures; ++picture) {
        std::shared_ptr<std::uint8_t[]> pixels(new std::uint8_t[kWidth * kHeight]);
        for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth; ++x) {
                const bool isDot = (x + picture) % 40 < 12 && y % 40 < 12;
                pixels[static_cast<std::size_t>(y * kWidth + x)] =
                    static_cast<std::uint8_t>((isDot ? 180U : 40U) + random() % 2U);
            }
        }
        core::TappedFrames block;
        block.time_ns.push_back(picture * 25'000'000LL);
        block.sourceTime_s.push_back(picture * 0.025);
        block.image = {std::shared_ptr<const std::uint8_t>(pixels, pixels.get()), kWidth, kHeight};
        writer.take(0, std::move(block));
        (void)writer.commit();
    }
    (void)writer.finish();
}

double bestOf(const std::function<void()>& work, double (*clock)()) {
    double best = 1e9;
    for (int turn = 0; turn < kTurns; ++turn) {
        const double start = clock();
        work();
        best = std::min(best, clock() - start);
    }
    return best;
}

void peer(const std::string& file, const char* what, int count) {
    QProcess process;
    process.start("node", {TELETA_SOURCE_DIR "/tests/peer/mcap/write_speed.mjs", QString::fromStdString(file),
                           what, QString::number(count)});
    process.waitForFinished(-1);
    if (process.exitCode() != 0)
        std::printf("node: %s\n", process.readAllStandardError().constData());
}

void report(const char* what, double seconds, double count, const char* unit, const std::string& file) {
    std::printf("%-34s %10.0f %s, file of %.1f MB\n", what, count / seconds, unit,
                static_cast<double>(std::filesystem::file_size(file)) / 1e6);
}

} // namespace

int main(int argc, char** argv) {
    const QCoreApplication application(argc, argv);
    qputenv("TELETA_MCAP_PEERS", TELETA_SOURCE_DIR "/build/mcap-peers");
    const QTemporaryDir folder;
    const auto path = [&folder](const char* name) {
        return folder.filePath(QLatin1String(name)).toStdString();
    };
    recordTactile(path("tactile.teleta"));
    recordPictures(path("pictures.teleta"));
    const auto tactile = recording::Recording::open(path("tactile.teleta"));
    const auto pictures = recording::Recording::open(path("pictures.teleta"));
    const auto exported = [&](const recording::Recording& recording, mcap::Compression compression) {
        (void)mcap::exportMcap(recording, path("ours.mcap"), {.compression = compression, .overwrite = true});
    };
    const auto imported = [&] {
        std::filesystem::remove(path("again.teleta"));
        (void)mcap::importMcap(path("ours.mcap"), path("again.teleta"));
    };
    constexpr double kMegabytes = static_cast<double>(kPictures) * kWidth * kHeight / 1e6;
    for (const auto& [compression, name] : {std::pair{mcap::Compression::zstd, "zstd"},
                                            {mcap::Compression::lz4, "lz4"},
                                            {mcap::Compression::none, "none"}}) {
        const std::string text = std::string("tactile, ours, ") + name;
        report(text.c_str(), bestOf([&] { exported(*tactile, compression); }, ownSeconds), kFrames,
               "frames/s", path("ours.mcap"));
    }
    report("tactile, @mcap/core on Node, zstd",
           bestOf([&] { peer(path("peer.mcap"), "tactile", kFrames); }, childrenSeconds), kFrames, "frames/s",
           path("peer.mcap"));
    exported(*tactile, mcap::Compression::zstd);
    report("tactile, our import", bestOf(imported, ownSeconds), kFrames, "frames/s", path("again.teleta"));
    for (const auto& [compression, name] : {std::pair{mcap::Compression::zstd, "zstd"},
                                            {mcap::Compression::lz4, "lz4"},
                                            {mcap::Compression::none, "none"}}) {
        const std::string text = std::string("pictures, ours, ") + name;
        report(text.c_str(), bestOf([&] { exported(*pictures, compression); }, ownSeconds), kMegabytes,
               "MB/s", path("ours.mcap"));
    }
    report("pictures, @mcap/core on Node, zstd",
           bestOf([&] { peer(path("peer.mcap"), "pictures", kPictures); }, childrenSeconds), kMegabytes,
           "MB/s", path("peer.mcap"));
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    std::printf("most memory of this process: %.0f MiB\n", static_cast<double>(usage.ru_maxrss) / 1024.0);
    return 0;
}
