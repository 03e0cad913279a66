// SPDX-License-Identifier: GPL-3.0-or-later
// The live view for Foxglove on loopback: how late Foxglove's own client on Node gets the messages, and what
// a frame costs the data thread, compared by turns with nobody looking. Eight topics (four arrays of 84
// taxels, two topics each) at 200 Hz, and pictures of 640 x 480 at 30 Hz. The peers are installed by
// tests/peer/mcap/install.sh. Give the seconds of a turn (10).
#include "backend/core/steady_time.h"
#include "devices/foxglove/live_view.h"
#include "tests/support/peer_process.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <random>
#include <span>
#include <string>
#include <thread>
#include <vector>

namespace {

using namespace teleta;

constexpr std::size_t kTaxels = 84;
constexpr int kArrays = 4;
constexpr int kTurns = 3;
constexpr int kWidth_px = 640;
constexpr int kHeight_px = 480;
constexpr std::chrono::microseconds kPeriod{5000};
constexpr double kPicturesASecond = 30.0;

/// Processor time of this thread.
double threadSeconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

struct Streams {
    std::vector<std::shared_ptr<core::StreamTap>> arrays;
    std::shared_ptr<core::StreamTap> camera;
};

Streams streamsOf(foxglove::LiveView& view) {
    Streams streams;
    for (int i = 0; i < kArrays; ++i) {
        recording::StreamInfo info;
        info.name = "skin";
        info.name.append(std::to_string(i));
        info.shape = {6, 14};
        info.unit = "N";
        streams.arrays.push_back(view.addStream(info));
    }
    recording::StreamInfo camera;
    camera.name = "camera";
    camera.kind = recording::StreamKind::camera;
    camera.type = recording::ValueType::grey8;
    camera.shape = {kHeight_px, kWidth_px};
    streams.camera = view.addStream(camera);
    return streams;
}

core::GreyImage picture() {
    std::shared_ptr<std::uint8_t[]> pixels(new std::uint8_t[kWidth_px * kHeight_px]);
    std::mt19937 random(1);
    for (int i = 0; i < kWidth_px * kHeight_px; ++i)
        pixels[static_cast<std::size_t>(i)] =
            static_cast<std::uint8_t>(40U + random() % 2U + (i / 7 % 9 == 0 ? 120U : 0U));
    return {std::shared_ptr<const std::uint8_t>(pixels, pixels.get()), kWidth_px, kHeight_px};
}

/// Sends for that long, as devices do; returns the data thread's processor time for one frame of an array.
double send(const Streams& streams, const core::GreyImage& image, double seconds) {
    std::array<float, kTaxels> values{};
    const auto start = std::chrono::steady_clock::now();
    const auto cycles = static_cast<std::int64_t>(seconds / std::chrono::duration<double>(kPeriod).count());
    double appending_s = 0.0;
    std::int64_t pictures = 0;
    for (std::int64_t cycle = 0; cycle < cycles; ++cycle) {
        std::this_thread::sleep_until(start + cycle * kPeriod);
        values.fill(static_cast<float>(cycle));
        const double before_s = threadSeconds();
        for (const auto& tap : streams.arrays) {
            const std::int64_t now_ns = core::steadyNow_ns();
            tap->append(now_ns, static_cast<double>(now_ns) * 1e-9, std::span<const float>(values));
        }
        appending_s += threadSeconds() - before_s;
        if (static_cast<double>(cycle) * 0.005 * kPicturesASecond >= static_cast<double>(pictures)) {
            const std::int64_t now_ns = core::steadyNow_ns();
            core::CameraFrame frame;
            frame.image = image;
            frame.time_ns = now_ns;
            frame.capture_s = static_cast<double>(now_ns) * 1e-9;
            streams.camera->append(frame);
            ++pictures;
        }
    }
    return appending_s / static_cast<double>(cycles * kArrays);
}

} // namespace

int main(int argc, char** argv) {
    const QCoreApplication application(argc, argv);
    const int seconds = argc > 1 ? std::max(std::atoi(argv[1]), 1) : 10;
    qputenv("TELETA_MCAP_PEERS", TELETA_SOURCE_DIR "/build/mcap-peers");
    foxglove::LiveView view({.port = 0});
    while (view.status().state == foxglove::LiveViewStatus::State::starting)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    const Streams streams = streamsOf(view);
    const core::GreyImage image = picture();
    double alone_s = 1.0;
    double watched_s = 1.0;
    for (int turn = 0; turn < kTurns; ++turn) {
        alone_s = std::min(alone_s, send(streams, image, 1.0));
        test::PeerProcess client;
        // One topic more than the pictures and eight of arrays: the events.
        client.start(QStringLiteral("node"),
                     {QStringLiteral(TELETA_SOURCE_DIR "/tests/peer/mcap/live_latency.mjs"),
                      QString::number(view.status().port), QString::number(2 * kArrays + 2),
                      QString::number(seconds)});
        if (!client.waitFor("subscribed")) {
            std::printf("the client does not subscribe: %s\n", client.errors().c_str());
            return 1;
        }
        watched_s = std::min(watched_s, send(streams, image, seconds + 1.0));
        const auto received = client.waitFor("received");
        std::printf("%s; %llu messages were dropped\n", received ? received->c_str() : "nothing received",
                    static_cast<unsigned long long>(view.status().dropped));
    }
    std::printf(
        "a frame of %zu taxels on its data thread: %.2f us, with nobody looking %.2f us, ratio %.2f\n",
        kTaxels, 1e6 * watched_s, 1e6 * alone_s, watched_s / alone_s);
    return 0;
}
