// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/model/track_builder.h"

#include "backend/pattern/model/bake.h"

#include <algorithm>
#include <utility>

namespace teleta::pattern {

void TrackBuilder::add(std::size_t tactor, Track lines) {
    if (lines.size() >= 2)
        m_stretches[tactor].push_back(std::move(lines));
}

std::size_t TrackBuilder::build(Pattern& pattern) {
    std::size_t overlaps = 0;
    for (std::size_t i = 0; i < core::kTactors; ++i) {
        std::vector<Track>& all = m_stretches[i];
        std::ranges::stable_sort(all, {}, [](const Track& lines) { return lines.front().time_s; });
        Track track;
        for (const Track& lines : all) {
            pattern.duration_s = std::max(pattern.duration_s, lines.back().time_s);
            if (track.empty() || lines.front().time_s >= track.back().time_s) {
                if (!track.empty() && lines.front().time_s > track.back().time_s) {
                    track.push_back({track.back().time_s, 0.0});
                    track.push_back({lines.front().time_s, 0.0});
                }
                track.insert(track.end(), lines.begin(), lines.end());
                continue;
            }
            ++overlaps;
            for (std::size_t k = 1; k < lines.size(); ++k) {
                const double length_s = lines[k].time_s - lines[k - 1].time_s;
                if (length_s > 0.0)
                    pattern.objects.push_back({"",
                                               Ramp{lines[k - 1].time_s,
                                                    length_s,
                                                    {static_cast<int>(i)},
                                                    lines[k - 1].intensity,
                                                    lines[k].intensity,
                                                    Easing::linear},
                                               {}});
            }
        }
        pattern.tracks[i] = trimmed(simplified(track));
        all.clear();
    }
    return overlaps;
}

std::vector<Track> stretches(const Track& lines) {
    std::vector<Track> all;
    bool wasOn = false;
    for (std::size_t k = 1; k < lines.size(); ++k) {
        const Breakpoint& a = lines[k - 1];
        const Breakpoint& b = lines[k];
        const bool step = a.time_s == b.time_s;
        const bool on =
            step ? a.intensity > 0.0 && b.intensity > 0.0 && wasOn : a.intensity > 0.0 || b.intensity > 0.0;
        if (on && !wasOn)
            all.push_back({a});
        if (on)
            all.back().push_back(b);
        wasOn = on;
    }
    return all;
}

} // namespace teleta::pattern
