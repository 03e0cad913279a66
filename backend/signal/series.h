// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

namespace teleta::signal {

/// One point of a line; a value of NaN lifts the pen.
struct Sample {
    double time_s = 0.0;
    double value = 0.0;
};

struct ValueRange {
    double low = 0.0, high = 0.0;
};

/// The samples of one signal in order of time, with their extremes in blocks of 64 and of 4096, so that a
/// line through millions of them costs what its pixels cost. The oldest samples give way to new ones, a
/// chunk at a time, and are counted. A copy shares all full chunks, which never change: it is cheap, and
/// another thread may read it. Thread: one.
class Series {
public:
    static constexpr std::size_t kLeaf = 64;
    static constexpr std::size_t kChunk = 4096;
    /// Samples that are kept at most, 16 bytes each.
    static constexpr std::size_t kMost = 12'000'000;

    /// Newest samples that are kept, rounded up to whole chunks.
    explicit Series(std::size_t capacity = kMost)
        : m_capacity(capacity) {}

    /// A time before that of the newest sample becomes that one's. A value that is not finite interrupts the
    /// line.
    void append(double time_s, double value);
    /// Interrupts the line after the newest sample, with NaN at its time. Nothing happens where it is
    /// interrupted already.
    void lift();
    void setCapacity(std::size_t samples);

    [[nodiscard]] std::size_t size() const { return m_full.size() * kChunk + m_tail.time_s.size(); }
    [[nodiscard]] bool empty() const { return size() == 0; }
    /// Of the oldest samples, those that gave way.
    [[nodiscard]] std::uint64_t dropped() const { return m_dropped; }
    /// Of all times, to detect new ones.
    [[nodiscard]] std::uint64_t appended() const { return m_dropped + size(); }

    /// index: from 0, the oldest one that is kept.
    [[nodiscard]] double time_s(std::size_t index) const { return chunkOf(index).time_s[index % kChunk]; }
    /// NaN: none.
    [[nodiscard]] double value(std::size_t index) const { return chunkOf(index).value[index % kChunk]; }
    /// First sample at or after a time; size() when there is none.
    [[nodiscard]] std::size_t firstAt(double time_s) const { return firstAt(time_s, 0); }
    /// The value at a time: that of the nearest sample on the same uninterrupted stretch. Empty outside.
    [[nodiscard]] std::optional<double> at(double time_s) const;
    /// The newest value; empty: none, or NaN.
    [[nodiscard]] std::optional<double> newest() const;

    /// Extremes of samples first..last (exclusive); empty without a value.
    [[nodiscard]] std::optional<ValueRange> range(std::size_t first, std::size_t last) const;

    /// A line between two times with few points: the samples themselves where there are at most two a bucket,
    /// else the smallest and the largest of each bucket in order of time, so that no peak is lost. Buckets
    /// lie at whole multiples of their width, so that a scrolling line does not shimmer. It goes one sample
    /// beyond both ends. NaN stands wherever the line is interrupted; a single sample becomes a dash of one
    /// bucket. line: overwritten. bucket_s > 0. Returns the range of its values.
    std::optional<ValueRange> line(double from_s, double to_s, double bucket_s,
                                   std::vector<Sample>& line) const;

private:
    /// Where the extremes of some samples are, as places in their chunk.
    struct Extremes {
        static constexpr std::uint16_t kNone = 0xFFFF;
        std::uint16_t lowAt = kNone, highAt = kNone;
        bool gap = false; ///< a value is NaN
    };
    struct Chunk {
        std::vector<double> time_s, value;
        std::vector<Extremes> leaves;
        Extremes whole;
    };
    /// The same over several chunks, as indices.
    struct Found {
        static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
        std::size_t lowAt = kNone, highAt = kNone;
        double low = 0.0, high = 0.0;
        bool gap = false;
    };

    [[nodiscard]] const Chunk& chunkOf(std::size_t index) const {
        const std::size_t chunk = index / kChunk;
        return chunk < m_full.size() ? *m_full[chunk] : m_tail;
    }
    [[nodiscard]] std::size_t firstAt(double time_s, std::size_t from) const;
    [[nodiscard]] Found extremes(std::size_t first, std::size_t last) const;
    void dropOld();

    std::size_t m_capacity;
    std::uint64_t m_dropped = 0;
    std::deque<std::shared_ptr<const Chunk>> m_full;
    Chunk m_tail;
};

} // namespace teleta::signal
