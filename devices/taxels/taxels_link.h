// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "devices/link/byte_link.h"
#include "devices/link/wake_pipe.h"
#include "devices/taxels/frames/frame_decoder.h"
#include "devices/taxels/taxels_file.h"

#include <cstdint>
#include <memory>

namespace teleta::taxels {

inline constexpr std::int64_t kMs_ns = 1'000'000;

/// Opens the link of a described array within its time and sends the greeting. wake: may be null. Error: as
/// link::ByteLink::open.
[[nodiscard]] core::Expected<link::ByteLink> openLink(const TaxelsFile& file, const link::WakePipe* wake);

/// A decoder for what comes over the link.
[[nodiscard]] std::unique_ptr<FrameDecoder> makeDecoder(const FrameFormat& format,
                                                        const link::ByteLink& link);

/// What to believe of the bytes of an incomplete frame once the link is gone.
[[nodiscard]] FrameDecoder::Rest restOf(const link::ByteLink& link);

} // namespace teleta::taxels
