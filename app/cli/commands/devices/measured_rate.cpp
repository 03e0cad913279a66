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
std::optional<double> rateOf(Source& source, const Take& take) {
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
    source.stop();
    if (frames < 2 || last_ns <= first_ns)
        return std::nullopt;
    return 1e9 * static_cast<double>(frames - 1) / static_cast<double>(last_ns - first_ns);
}

} // namespace

std::optional<double> measuredRate_Hz(core::TactileSource& array) {
    return rateOf(array, [&](const auto& count) {
        core::SampleBlock block;
        while (array.blocks().pop(block))
            for (const std::int64_t time_ns : block.time_ns)
                count(time_ns);
    });
}

SeenPictures lookAt(core::CameraSource& camera) {
    SeenPictures seen;
    seen.rate_Hz = rateOf(camera, [&](const auto& count) {
        core::CameraFrame frame;
        while (camera.pop(frame)) {
            // Those that were passed over came as well.
            for (std::uint64_t i = 0; i <= frame.passedOver; ++i)
                count(frame.time_ns);
            const auto colour = core::colourOf(frame.image);
            seen.width_px = colour.width_px;
            seen.height_px = colour.height_px;
        }
    });
    return seen;
}

} // namespace teleta::cli
