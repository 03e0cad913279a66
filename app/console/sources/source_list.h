// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/base/source_request.h"
#include "backend/core/error.h"

#include <string>
#include <vector>

namespace teleta::console {

/// Reads a source list (TOML): one [[source]] a tactile array or a camera, in the order in which they open.
///   recording = "FILE.csv" with rows, columns, pitch_m, tare, gains, inverted, gain, threshold, unit,
///   rate_Hz, speed, loop, or recording = "FILE.teleta" with loop, which opens all sources of it (what is
///   missing of CSV is guessed from the file as in guessRecording), or scene = "FILE.toml" with seed, or wts
///   = "/dev/ttyUSB0" or "tcp://HOST:PORT" with baud (serial ports only), delay_ms, run_length, tare (by the
///   sensor, when it starts), gains, gain, threshold, unit, or camera = "VIDEO" or "0" with camera_model =
///   "CAMERA.json" and loop.
/// Relative paths start at the list's folder. Errors carry file, line and column.
/// Reads the header of each recording: not on the GUI's thread.
[[nodiscard]] core::Expected<std::vector<SourceRequest>> readSourceList(const std::string& path);

/// Whether a TOML file means to be a source list, whatever is wrong with its sources: it has a key "source",
/// which no scene has. A file that cannot be read at all is none. Not on the GUI's thread.
[[nodiscard]] bool isSourceList(const std::string& path);

} // namespace teleta::console
