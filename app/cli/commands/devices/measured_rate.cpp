// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/devices/measured_rate.h"

#include "app/cli/base/interruption.h"
#include "backend/core/data/sample_block.h"
#include "backend/core/device/camera_source.h"
#include "backend/core/device/colour_image.h"
#include "backend/core/device/device.h"
#include "backend/core/threads/wakeup.h"

#include <chrono>
#include <cstddef>
#include <cstdint>

namespace teleta::cli {

namespace {

/// take: hands the times of new frames to its argument.
template <typename Source, typename Take>
SeenFrames framesOf(Source& source, const Take& take) {
    using Clock = std::chrono::steady_clock;
    constexpr std::chrono::seconds kLongestWait{3};
    constexpr std::chrono::seconds kMeasured{1};
    constexpr std::chrono::milliseconds kLook{50}; // for an interruption, while no frame comes
    core::Wakeup wakeup;
    source.start(wakeup);
    auto end = Clock::now() + kLongestWait;
    std::int64_t first_ns = 0;
    std::int64_t last_ns = 0;
    std::size_t frames = 0;
    while (Clock::now() < end && !interrupted()) {
        take([&](std::int64_t time_ns) {
            if (frames++ == 0) {
                first_ns = time_ns;
                end = Clock::now() + kMeasured;
            }
            last_ns = time_ns;
        });
        (void)wakeup.waitFor(kLook);
    }
    SeenFrames seen{.rate_Hz = std::nullopt, .status = source.status()};
    source.stop();
    if (frames >= 2 && last_ns > first_ns)
        seen.rate_Hz = 1e9 * static_cast<double>(frames - 1) / static_cast<double>(last_ns - first_ns);
    return seen;
}

} // namespace

SeenFrames lookAt(core::TactileSource& array) {
    return framesOf(array, [&](const auto& count) {
        core::SampleBlock block;
        while (array.blocks().pop(block))
            for (const std::int64_t time_ns : block.time_ns)
                count(time_ns);
    });
}

SeenFrames lookAt(core::CameraSource& camera) {
    core::ColourImage last;
    SeenFrames seen = framesOf(camera, [&](const auto& count) {
        core::CameraFrame frame;
        while (camera.pop(frame)) {
            // Those that were passed over came as well.
            for (std::uint64_t i = 0; i <= frame.passedOver; ++i)
                count(frame.time_ns);
            last = core::colourOf(frame.image);
        }
    });
    seen.width_px = last.width_px;
    seen.height_px = last.height_px;
    return seen;
}

} // namespace teleta::cli
