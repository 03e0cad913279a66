// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/frames/frame_request.h"
#include "backend/frames/frame_series.h"

#include <QString>

#include <string>

namespace teleta::frames {

/// Reads a table of another program, one row a frame, as the request says: taxelColumns (else all columns but
/// that of the times), timeColumn with timeUnit, or the rate. Separated by ; tabs, commas or blanks; with a
/// decimal comma where the separator is another one; with or without a header; lines that begin with # or %
/// before it are comments. Times of iso are since the first frame. Error: badInput with line and column, also
/// what option is missing; cancelled by goOn.
[[nodiscard]] core::Expected<FrameSeries> readTable(const FrameRequest& request, const GoOn& goOn);

/// The options with which a table of another program can be read, guessed from its first lines, such as
/// "--columns 2..85 --time-column t --time-unit ms"; empty: it is no table of numbers.
[[nodiscard]] QString tableOptions(const std::string& path);

} // namespace teleta::frames
