// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <span>
#include <string_view>
#include <utility>

namespace teleta::core {

/// Random numbers that are the same with every compiler and library: std::mt19937_64, whose output the
/// standard fixes, without the distributions and std::shuffle, which it does not fix. Thread: one.
class RandomStream {
public:
    explicit RandomStream(std::uint64_t seed)
        : m_seed(seed)
        , m_engine(seed) {}
    /// A stream that depends on this seed and name alone: effects of a simulation each have their own, so
    /// that adding or removing one does not change the others.
    RandomStream(std::uint64_t seed, std::string_view name);

    /// Uniform in [0, 1), a multiple of 2^-53.
    [[nodiscard]] double uniform() { return static_cast<double>(m_engine() >> 11U) * 0x1p-53; }
    /// Normal with mean 0 and standard deviation 1 (polar method).
    [[nodiscard]] double normal();
    /// Uniform in 0 .. limit-1 without bias; limit > 0. Values of the last, incomplete run of limit are drawn
    /// again.
    [[nodiscard]] std::uint64_t below(std::uint64_t limit);
    /// Fisher and Yates from the end: i = n-1 .. 1, swapped with j = below(i+1).
    template <typename T>
    void shuffle(std::span<T> items) {
        for (std::size_t i = items.size(); i-- > 1;)
            std::swap(items[i], items[static_cast<std::size_t>(below(i + 1))]);
    }
    /// Starts the stream over.
    void restart();

private:
    std::uint64_t m_seed;
    std::mt19937_64 m_engine;
    double m_spare = 0.0; ///< the polar method makes two normal values at a time
    bool m_hasSpare = false;
};

} // namespace teleta::core
