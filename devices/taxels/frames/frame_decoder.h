// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/taxels/frames/frame_format.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace teleta::taxels {

/// What stood in one frame.
struct DecodedFrame {
    std::vector<float> values;            ///< scaled, in the order of the frame; then the other numbers
    std::optional<std::uint32_t> counter; ///< wraps
    std::optional<std::uint32_t> ticks;   ///< of the sensor's time; wraps
    std::optional<double> time_s;         ///< the same where it is no whole number, and does not wrap
};

/// Finds frames in a stream of bytes that may contain anything else. After a false start the search goes on
/// at its second byte, so that no intact frame is lost to a damaged one before it.
///   bytes fed = bytes of frames + droppedBytes + pendingBytes
/// Depends only on the bytes, not on how they were cut into calls of feed(). Never throws but for memory.
/// Thread: one (pure).
class FrameDecoder {
public:
    struct Counters {
        std::uint64_t frames = 0;
        std::uint64_t frameBytes = 0;   ///< of these and of the other frames
        std::uint64_t otherFrames = 0;  ///< whole ones of another length, in which the values are not
        std::uint64_t droppedBytes = 0; ///< of nothing that is a frame
        std::uint64_t badChecksums = 0;
        std::uint64_t badSizes = 0;  ///< lengths that no frame has
        std::uint64_t badEnds = 0;   ///< the closing bytes are not there
        std::uint64_t badValues = 0; ///< not a number, or out of range

        bool operator==(const Counters&) const = default;
    };

    /// Why the newest frame of the sensor could not be used.
    struct Problem {
        enum class Kind {
            none,
            noValues, ///< it tells none of these values
            model,    ///< it is another model
            taxels,   ///< it has another number of taxels
            other,    ///< damaged in some way
        };
        Kind kind = Kind::none;
        std::string found = {}; ///< of model and taxels
        std::string expected = {};

        bool operator==(const Problem&) const = default;
    };

    /// The model of sensor that is expected; empty: none has been told yet, or the frames tell none.
    [[nodiscard]] virtual std::string model() const { return {}; }
    /// The first model that was told on a connection before; empty: none was.
    virtual void expectModel(const std::string& /*model*/) {}

    /// Whether the bytes of an incomplete frame may still follow.
    enum class Rest {
        mayCome,
        willNotCome, ///< a line that is silent, or a link that was cut
        ended,       ///< of a file that was read to its end
    };
    enum class Framing {
        stream,
        datagrams, ///< what is fed at once is one frame or none
    };

    virtual ~FrameDecoder() = default;
    FrameDecoder() = default;
    FrameDecoder(const FrameDecoder&) = delete;
    FrameDecoder& operator=(const FrameDecoder&) = delete;

    /// Appends bytes as they were read.
    void feed(std::span<const std::uint8_t> bytes);
    /// The next frame; false when there is none (yet). Nothing stays pending unless more may come.
    [[nodiscard]] virtual bool next(DecodedFrame& frame, Rest rest = Rest::mayCome) = 0;

    [[nodiscard]] const Counters& counters() const { return m_counters; }
    /// Of the newest frame; none: it is fine.
    [[nodiscard]] const Problem& problem() const { return m_problem; }
    [[nodiscard]] std::size_t pendingBytes() const { return m_buffer.size() - m_begin; }
    /// Bytes of the stream before the newest frame, and those that it has.
    [[nodiscard]] std::uint64_t frameBegin() const { return m_frameBegin; }
    [[nodiscard]] std::size_t frameSize() const { return m_frameSize; }

protected:
    [[nodiscard]] std::span<const std::uint8_t> pending() const {
        return std::span(m_buffer).subspan(m_begin);
    }
    void drop(std::size_t bytes);
    /// Takes the pending bytes of a frame; isOther: one of another kind.
    void take(std::size_t bytes, bool isOther);

    Counters m_counters;
    Problem m_problem;

private:
    std::vector<std::uint8_t> m_buffer;
    std::size_t m_begin = 0;    ///< of what was not taken or dropped
    std::uint64_t m_erased = 0; ///< bytes of the stream before the buffer
    std::uint64_t m_frameBegin = 0;
    std::size_t m_frameSize = 0;
};

/// A decoder for a format that its reader has checked.
[[nodiscard]] std::unique_ptr<FrameDecoder> makeDecoder(const FrameFormat& format,
                                                        FrameDecoder::Framing framing);

/// How many values a frame has, without the other numbers.
[[nodiscard]] std::size_t valuesOf(const FrameFormat& format);

} // namespace teleta::taxels
