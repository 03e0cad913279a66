// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <random>
#include <span>
#include <utility>

namespace teleta::study {

/// Random numbers that are the same with every compiler and library: std::mt19937_64, whose output the
/// standard fixes, without the distributions and std::shuffle, which it does not fix. Thread: one.
class PortableRandom {
public:
    explicit PortableRandom(std::uint64_t seed)
        : m_engine(seed) {}

    /// Uniform in 0 .. limit-1; limit > 0. Values in the last, incomplete multiple of limit are redrawn.
    [[nodiscard]] std::uint64_t below(std::uint64_t limit) {
        const std::uint64_t biasedTail = (std::mt19937_64::max() % limit + 1) % limit;
        const std::uint64_t last = std::mt19937_64::max() - biasedTail;
        std::uint64_t x = m_engine();
        while (x > last)
            x = m_engine();
        return x % limit;
    }

    /// Uniform in [0, 1), a multiple of 2^-53.
    [[nodiscard]] double unit() { return static_cast<double>(m_engine() >> 11U) * 0x1p-53; }

    /// Fisher and Yates from the end: i = n-1 .. 1, swapped with j = below(i+1).
    template <typename T>
    void shuffle(std::span<T> items) {
        for (std::size_t i = items.size(); i-- > 1;)
            std::swap(items[i], items[static_cast<std::size_t>(below(i + 1))]);
    }

private:
    std::mt19937_64 m_engine;
};

} // namespace teleta::study
