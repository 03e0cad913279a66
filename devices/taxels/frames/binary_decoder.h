// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/taxels/frames/frame_decoder.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace teleta::taxels {

/// Frames of bytes. Where they say their length, one of more than twice the length that the values need and
/// 256 bytes is taken for noise, for which nothing has to wait. A format with little evidence
/// (BinaryFormat::evidence() below three) is believed only after two frames in a row, until the first one
/// that is wrong. Thread: one (pure).
class BinaryDecoder : public FrameDecoder {
public:
    BinaryDecoder(BinaryFormat format, Framing framing);

    [[nodiscard]] bool next(DecodedFrame& frame, Rest rest = Rest::mayCome) override;

private:
    enum class Verdict { incomplete, wrong, other, frame };

    /// Drops what cannot be the begin of a frame; false: nothing that may be one is left.
    [[nodiscard]] bool findSync(Rest rest);
    /// Length of the frame at the begin; nothing: the length field has not come yet. 0: none that can be.
    [[nodiscard]] std::optional<std::size_t> lengthAt(std::span<const std::uint8_t> bytes) const;
    /// What stands at the begin of these bytes, and how long it is. frame: null: only look.
    [[nodiscard]] Verdict judge(std::span<const std::uint8_t> bytes, std::size_t& length, DecodedFrame* frame,
                                Counters* counters) const;
    [[nodiscard]] bool readValues(std::span<const std::uint8_t> bytes, const ValueField& field,
                                  const Scaling& scaling, DecodedFrame* frame) const;
    void refuse();

    BinaryFormat m_format;
    std::size_t m_closing; ///< bytes of the checksum and all behind it, or of the end
    std::size_t m_longest; ///< a longer frame is taken for noise
    bool m_datagrams;
    bool m_needsTwo;
    bool m_locked = false;
};

} // namespace teleta::taxels
