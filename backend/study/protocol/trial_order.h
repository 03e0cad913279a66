// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace teleta::study {

/// How the trials of a block are ordered.
enum class OrderMethod {
    fullRandom,    ///< all repetitions together
    blockedRandom, ///< each repetition of all patterns separately
};

/// "full_random" or "blocked_random", as in files.
[[nodiscard]] const char* toString(OrderMethod method);

/// Patterns 0 .. patterns-1, each `repetitions` times, in random order: the list 0, 1, .., 0, 1, .. shuffled
/// with core::RandomStream, as a whole or each repetition in turn. The same seed gives the same order
/// everywhere. Thread: any.
[[nodiscard]] std::vector<std::size_t> trialOrder(OrderMethod method, std::size_t patterns,
                                                  std::size_t repetitions, std::uint64_t seed);

/// Rows of a Williams square: orders of 0 .. conditions-1 in which each condition occurs equally often at
/// each position and after each other condition. n rows for even n, 2n for odd n (one row for n = 1); two
/// conditions give AB, BA. Participant i takes row i mod rows. Thread: any. Source: Williams 1949,
/// doi:10.1071/CH9490149.
[[nodiscard]] std::vector<std::vector<std::size_t>> williamsSquare(std::size_t conditions);

/// Seed of a part of something that has a seed: output number `part` of SplitMix64. Different parts get
/// different seeds. Thread: any. Source: Steele, Lea and Flood 2014, doi:10.1145/2714064.2660195.
[[nodiscard]] std::uint64_t derivedSeed(std::uint64_t seed, std::uint64_t part);

} // namespace teleta::study
