// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <string_view>

namespace teleta::simulation {

/// The random numbers of one effect. The stream follows from the scene's seed and the effect's name alone, so
/// adding or leaving out another effect does not change it.
/// Thread: one.
class RandomStream {
public:
    RandomStream(std::uint64_t seed, std::string_view name);

    /// Uniform in [0, 1).
    double uniform();
    /// Normal with mean 0 and standard deviation 1 (polar method).
    double normal();
    /// Uniform in 0 .. count - 1 without bias; count > 0.
    std::size_t below(std::size_t count);
    /// Begins the stream anew.
    void restart();

private:
    std::uint64_t m_state;
    std::mt19937_64 m_engine;
    double m_spare = 0.0;
    bool m_hasSpare = false;
};

} // namespace teleta::simulation
