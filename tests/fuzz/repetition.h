// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <random>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace teleta::fuzz {

/// The mutation of libFuzzer, and now and then one that it lacks: a short part of the input many times in a
/// row. It finds readers that call themselves for every level, or take a square of the length: a key like
/// a.a.a.a, a hundred thousand brackets. Returns the new size.
inline std::size_t mutateWithRepetition(std::uint8_t* data, std::size_t size, std::size_t most,
                                        unsigned seed) {
    constexpr unsigned kOneIn = 64;
    constexpr std::size_t kLongestPart = 8;
    std::minstd_rand random(seed);
    if (size == 0 || size >= most || random() % kOneIn != 0)
        return LLVMFuzzerMutate(data, size, most);
    const std::size_t begin = random() % size;
    const std::size_t part = std::min<std::size_t>(1 + random() % kLongestPart, size - begin);
    const std::size_t highest = std::bit_width(most / part);
    const std::size_t times = std::min((std::size_t{1} << (1 + random() % highest)), (most - size) / part);
    const std::size_t added = times * part;
    std::memmove(data + begin + added, data + begin, size - begin);
    for (std::size_t i = 0; i < added; ++i)
        data[begin + i] = data[begin + added + i % part];
    return size + added;
}

} // namespace teleta::fuzz
