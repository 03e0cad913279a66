// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/keys/keys.h"
#include "devices/taxels/frames/frame_format.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace teleta::taxels {

/// A key whose value is at most 64 hexadecimal bytes, as "AA 55" or "aa55". Without it there
/// are none.
void describeBytes(core::Keys& keys, std::string_view key, std::vector<std::uint8_t>& bytes,
                   std::string_view about);

/// The key "url": the address of a WebSocket server.
void describeWebAddress(core::Keys& keys, std::string& url, std::string_view about, core::Need need);

/// Says that the key "threshold" is missing: no value can be taken for it.
void refuseWithoutThreshold(core::Keys& keys);

/// Describes the table [frame]: how a sensor's bytes are frames. Each field is checked against the length of
/// the frame and the others. perGroup: components that stand together.
void describeFrame(core::Keys& keys, FrameFormat& format, std::size_t perGroup);

} // namespace teleta::taxels
