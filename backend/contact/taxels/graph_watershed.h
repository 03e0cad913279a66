// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace teleta::contact {

/// Watershed over a graph: nodes are flooded in order of falling height, and each joins its neighbour whose
/// region has the highest summit. Where regions meet, the lower ones are merged into the highest when they
/// rise too little above the pass. Thread: one; allocates nothing after the first frames.
class GraphWatershed {
public:
    static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

    /// height: finite, one entry a node. neighbours: of each node. takesPart(node): whether it is flooded.
    /// merges(summit, pass): whether a region whose summit has this height ends at a pass of this one.
    template <typename TakesPart, typename Merges>
    void flood(std::span<const double> height, std::span<const std::vector<std::size_t>> neighbours,
               TakesPart takesPart, Merges merges) {
        m_parent.assign(height.size(), kNone);
        m_order.clear();
        for (std::size_t i = 0; i < height.size(); ++i)
            if (takesPart(i))
                m_order.push_back(i);
        std::ranges::sort(m_order, [&](std::size_t a, std::size_t b) {
            return height[a] != height[b] ? height[a] > height[b] : a < b;
        });
        // Roots are summits, because a node joins a higher neighbour.
        for (const std::size_t i : m_order) {
            std::size_t own = kNone;
            for (const std::size_t k : neighbours[i]) {
                if (m_parent[k] == kNone)
                    continue;
                const std::size_t other = rootOf(k);
                if (own == kNone) {
                    own = other;
                } else if (other != own) {
                    const std::size_t higher = height[own] >= height[other] ? own : other;
                    const std::size_t lower = higher == own ? other : own;
                    if (merges(height[lower], height[i]))
                        m_parent[lower] = higher;
                    own = higher;
                }
            }
            m_parent[i] = own == kNone ? i : own;
        }
    }

    /// The nodes that take part, the highest first; of the last flood().
    [[nodiscard]] std::span<const std::size_t> order() const { return m_order; }
    /// The summit of the region of a node that takes part; of the last flood().
    [[nodiscard]] std::size_t rootOf(std::size_t node) {
        while (m_parent[node] != node)
            node = m_parent[node] = m_parent[m_parent[node]];
        return node;
    }

private:
    std::vector<std::size_t> m_order;
    std::vector<std::size_t> m_parent; ///< union-find; kNone: not flooded yet
};

} // namespace teleta::contact
