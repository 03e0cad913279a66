// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/array_layout.h"
#include "backend/core/error.h"
#include "backend/frames/arrays/array_file.h"
#include "backend/frames/frame_request.h"

#include <QString>

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace teleta::frames {

/// All frames of a file. NaN: a dead taxel, or a place outside of the sensor.
struct FrameSeries {
    core::ArrayLayout layout{};        ///< of a known array: one row of all its values
    bool isPlaced = false;             ///< the values are in the order of the known array
    bool hasPitch = false;             ///< the file or the request says the pitches of the layout
    std::string unit{};                ///< of the values, as the file says; empty: not told
    std::vector<std::string> unused{}; ///< what the file says besides and nothing here heeds, by its names
    std::vector<double> time_s{};      ///< finite, never decreasing
    std::vector<float> values{};       ///< time_s.size() x layout.taxels(), row-major

    [[nodiscard]] std::size_t frames() const { return time_s.size(); }
    [[nodiscard]] std::span<const float> frame(std::size_t i) const {
        return std::span(values).subspan(i * layout.taxels(), layout.taxels());
    }
};

/// Asked now and then; false ends the work with ErrorKind::cancelled and no text.
using GoOn = std::function<bool()>;

/// The array that the frames of a request have: its rows and columns, else the likely array or 6 x 14. With
/// taxelColumns one side follows from the other. Error: badInput when so many taxels do not fit; what: what
/// has them, in words.
[[nodiscard]] core::Expected<core::ArrayLayout> layoutOf(const FrameRequest& request, std::uint64_t taxels,
                                                         const QString& what);

/// Times for frames of a steady rate, from 0. Error: badInput when no rate is told.
[[nodiscard]] core::Expected<std::vector<double>> timesAt(std::optional<double> rate_Hz, std::size_t frames,
                                                          const std::string& path);

/// Error: badInput for a time that is not finite or goes back, with the number of the frame.
[[nodiscard]] core::Expected<void> checkTimes(std::span<const double> time_s, const std::string& path);

/// Finds the frames among the arrays of a file and reads them: the array that the request names, else
/// `frames`, else the only one of three dimensions, else the only one of two; times are `time_s` beside it,
/// else the rate. Values are rounded to float. Error: badInput that lists what is there, with place and
/// reason.
[[nodiscard]] core::Expected<FrameSeries> framesOf(ArrayFile& file, const FrameRequest& request,
                                                   const GoOn& goOn);

/// The names of the arrays that can be read and have two or three dimensions, in the order of the file.
[[nodiscard]] std::vector<std::string> namesOfFrames(const ArrayFile& file);

} // namespace teleta::frames
