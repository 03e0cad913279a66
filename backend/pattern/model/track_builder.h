// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pattern/model/pattern.h"

#include <cstddef>
#include <vector>

namespace teleta::pattern {

/// Assembles tracks from pieces in which a tactor is on, given in any order. A piece that overlaps an earlier
/// one on its tactor becomes ramps, so that the stronger one counts and nothing is lost. Thread: one.
class TrackBuilder {
public:
    /// lines: straight segments, times never decrease; fewer than two points are ignored.
    void add(std::size_t tactor, Track lines);

    /// Puts tracks and ramps into a pattern and extends it to their length. Returns the number of pieces that
    /// became ramps.
    std::size_t build(Pattern& pattern);

private:
    std::array<std::vector<Track>, core::kTactors> m_stretches;
};

/// Splits a track into the pieces that are on, each with its own end points; it is silent between them.
/// lines: straight segments. Thread: any (pure).
[[nodiscard]] std::vector<Track> stretches(const Track& lines);

} // namespace teleta::pattern
