// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "devices/sound_bracelet/latency/sound_latency.h"

#include <string>

namespace teleta::sound {

/// A measured latency as the lines of a device file: latency_ms and latency_spread_ms, in steps of 0.01 ms.
/// Thread: any (pure).
[[nodiscard]] std::string latencyLines(const SoundLatency& latency);

/// Keeps a measured latency in the device file, in place of the one that it has. All else in it stays as it
/// is, comments too. Error: as readSoundBracelet(); ioFailed; refused, for a file that is written so
/// unusually that a person has to change it. Thread: any.
[[nodiscard]] core::Expected<void> keepLatency(const std::string& path, const SoundLatency& latency);

} // namespace teleta::sound
