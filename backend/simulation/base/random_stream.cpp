// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/base/random_stream.h"

#include <cmath>

namespace teleta::simulation {

namespace {

/// FNV-1a over the name, then the finalizer of SplitMix64 so that neighbouring seeds give unrelated streams.
std::uint64_t streamState(std::uint64_t seed, std::string_view name) {
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
    : m_state(streamState(seed, name))
    , m_engine(m_state) {
}

// The distributions of the standard library differ from one library to the next; these do not.
double RandomStream::uniform() {
    return static_cast<double>(m_engine() >> 11) * 0x1.0p-53;
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

std::size_t RandomStream::below(std::size_t count) {
    const std::uint64_t n = count;
    const std::uint64_t limit = std::mt19937_64::max() - std::mt19937_64::max() % n;
    std::uint64_t value = m_engine();
    while (value >= limit)
        value = m_engine();
    return static_cast<std::size_t>(value % n);
}

void RandomStream::restart() {
    m_engine.seed(m_state);
    m_hasSpare = false;
}

} // namespace teleta::simulation
