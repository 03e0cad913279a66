// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/frames/frame_request.h"
#include "backend/frames/frame_series.h"

#include <string>

namespace teleta::frames {

/// Whether a text is a recording of Tekscan in ASCII: it has a line ASCII_DATA @@ among its first ones.
[[nodiscard]] bool isTekscan(const std::string& path);

/// Reads a recording of Tekscan in ASCII (.asf, .csv): lines "KEY value" up to ASCII_DATA @@, then per frame
/// a line "Frame N" and ROWS lines of COLS numbers. B, a place outside of the sensor, becomes NaN. A pressure
/// times the area of a place is a force in N; RAW are counts. The time of frame N is N - START_FRAME times
/// SECONDS_PER_FRAME, or by the rate of the request; frames that are missing leave a gap. The area is
/// SENSEL_AREA, else ROW_SPACING times COL_SPACING. MIRROR_ROW and MIRROR_COL, if not 0, turn the order of
/// the rows and of the columns round. NOISE_THRESHOLD, SCALE_FACTOR, SATURATION_PRESSURE and SENSITIVITY
/// change nothing and are named in FrameSeries::unused. Error: badInput with line and column, also for a last
/// frame that is cut off, or for unequal distances of rows and columns when the request has no pitch.
[[nodiscard]] core::Expected<FrameSeries> readTekscan(const FrameRequest& request, const GoOn& goOn);

} // namespace teleta::frames
