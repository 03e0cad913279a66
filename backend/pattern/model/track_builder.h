// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pattern/model/pattern.h"

#include <cstddef>
#include <vector>

namespace teleta::pattern {

/// Puts stretches in which a tactor is on, in any order, together to tracks. What overlaps with an earlier
/// stretch on its tactor becomes ramps, so that the stronger one counts and nothing is lost.
class TrackBuilder {
public:
    /// lines: straight segments, times never decrease; fewer than two are ignored.
    void add(std::size_t tactor, Track lines);

    /// Puts tracks and ramps into a pattern and makes it long enough for them.
    void build(Pattern& pattern);

private:
    std::array<std::vector<Track>, core::kTactors> m_stretches;
};

/// Stretches of a track that are on, each with its own ends: what lies between them is silent. lines:
/// straight segments.
[[nodiscard]] std::vector<Track> stretches(const Track& lines);

} // namespace teleta::pattern
