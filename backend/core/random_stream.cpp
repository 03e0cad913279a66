// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/random_stream.h"

#include <cmath>

namespace teleta::core {

namespace {

/// FNV-1a over the name, then the finalizer of SplitMix64 so that neighbouring seeds give unrelated streams.
std::uint64_t seedOf(std::uint64_t seed, std::string_view name) {
    std::uint64_t hash = 0xcbf29ce484222325U;
    for (const char c : name)
        hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
    std::uint64_t z = hash + seed * 0x9e3779b97f4a7c15U;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31);
}

} // namespace

RandomStream::RandomStream(std::uint64_t seed, std::string_view name)
    : RandomStream(seedOf(seed, name)) {
}

double RandomStream::normal() {
    if (m_hasSpare) {
        m_hasSpare = false;
        return m_spare;
    }
    double u = 0.0;
    double v = 0.0;
    double square = 0.0;
    do {
        u = 2.0 * uniform() - 1.0;
        v = 2.0 * uniform() - 1.0;
        square = u * u + v * v;
    } while (square >= 1.0 || square == 0.0);
    const double factor = std::sqrt(-2.0 * std::log(square) / square);
    m_spare = v * factor;
    m_hasSpare = true;
    return u * factor;
}

std::uint64_t RandomStream::below(std::uint64_t limit) {
    const std::uint64_t biasedTail = (std::mt19937_64::max() % limit + 1) % limit;
    const std::uint64_t last = std::mt19937_64::max() - biasedTail;
    std::uint64_t x = m_engine();
    while (x > last)
        x = m_engine();
    return x % limit;
}

void RandomStream::restart() {
    m_engine.seed(m_seed);
    m_hasSpare = false;
}

} // namespace teleta::core
