// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/temperature_drift.h"
#include "backend/core/error.h"
#include "devices/taxels/frames/frame_decoder.h"
#include "devices/taxels/taxels_file.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace teleta::taxels {

/// What came from a sensor, and what its description makes of it.
struct TaxelsProbe {
    struct Place {
        std::uint64_t begin = 0;
        std::size_t bytes = 0;
    };

    std::vector<std::uint8_t> bytes; ///< the first ones, as they came
    std::vector<Place> frames;       ///< where frames are among all bytes
    FrameDecoder::Counters counters;
    std::uint64_t binaryMessages = 0; ///< left out, of a WebSocket whose messages are texts
    std::optional<double> rate_Hz;    ///< frames a second; empty: fewer than two, or bytes of a file
    std::vector<float> first;         ///< the grid of the first frame; empty: there was none
    std::vector<float> others;        ///< its other numbers, such as temperatures
    core::TemperatureDrift drift;     ///< of the chips since the first frame
};

struct ProbeLimits {
    std::size_t bytes = 4096; ///< that are kept
    double wait_s = 3.0;      ///< for the first frame
    double measure_s = 1.0;   ///< from the first frame on
};

/// Listens to the sensor of a file. It ends limits.measure_s after the first frame, when none came within
/// limits.wait_s, or when the link is gone; at a file also when so many bytes came. cancelled: asked between
/// reads. Error: as link::ByteLink::open.
[[nodiscard]] core::Expected<TaxelsProbe> probeTaxels(const TaxelsFile& file, const ProbeLimits& limits,
                                                      const std::function<bool()>& cancelled = {});

/// What an unloaded array reads.
struct RestReading {
    std::vector<float> values;            ///< of the layout; NaN where no taxel is
    std::vector<float> temperatures_degC; ///< of its chips; empty: they tell none
};

/// Measures it: the medians over the first file.restFrames frames. Each of them is waited for, also where the
/// rate is not known. Error: as link::ByteLink::open; unavailable, one of them did not come in time;
/// cancelled.
[[nodiscard]] core::Expected<RestReading> measureRest(const TaxelsFile& file,
                                                      const std::function<bool()>& cancelled = {});

} // namespace teleta::taxels
