// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/keys/keys.h"
#include "devices/taxels/frames/frame_format.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace teleta::taxels {

/// Bytes that a key may give at most.
inline constexpr std::size_t kMostMarkBytes = 64;

/// "AA 55" or "aa55" as bytes; nothing for anything else, or more than kMostMarkBytes.
[[nodiscard]] std::optional<std::vector<std::uint8_t>> bytesOf(const std::string& hex);

/// Describes the table [frame]: how a sensor's bytes are frames. Each field is checked against the length of
/// the frame and the others. perGroup: components that stand together.
void describeFrame(core::Keys& keys, FrameFormat& format, std::size_t perGroup);

} // namespace teleta::taxels
