// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

/// Gives any bytes to the decoder and what it finds to every reader of messages, in pieces whose sizes the
/// bytes choose; ends the program when the decoder's account of the bytes does not close or a reader leaves
/// its cells. The name is libFuzzer's. Returns 0.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
