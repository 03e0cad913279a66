// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/backend/contact/contact_frames.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace teleta::contact::test {

/// A plain implementation of the watershed, for comparison: water falls taxel by taxel from the highest load
/// (of equal ones, the first) to the threshold. A taxel that emerges joins the basin of its highest neighbour
/// that is already dry, or starts a basin; where basins meet at it, every one whose summit rises less than
/// height_N over it joins the one with the highest summit. Quadratic. Returns the region of each taxel, 0 for
/// none, numbered by the first taxel of a region.
inline std::vector<std::int32_t> slowWatershed(const Frame& frame, float threshold_N, double height_N) {
    const int rows = frame.layout.rows;
    const int columns = frame.layout.columns;
    const std::size_t taxels = frame.load_N.size();
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < taxels; ++i)
        if (frame.load_N[i] >= threshold_N)
            order.push_back(i);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return frame.load_N[a] > frame.load_N[b]; });
    std::vector<std::size_t> rank(taxels, taxels);
    for (std::size_t i = 0; i < order.size(); ++i)
        rank[order[i]] = i;

    // A basin is named by the rank of its summit, so the smaller name is the higher summit.
    std::vector<std::size_t> basin(taxels, taxels);
    for (const std::size_t taxel : order) {
        const int row = static_cast<int>(taxel) / columns;
        const int column = static_cast<int>(taxel) % columns;
        std::vector<std::size_t> dry;
        for (int r = std::max(0, row - 1); r <= std::min(rows - 1, row + 1); ++r)
            for (int c = std::max(0, column - 1); c <= std::min(columns - 1, column + 1); ++c)
                if (rank[frame.index(r, c)] < rank[taxel])
                    dry.push_back(frame.index(r, c));
        if (dry.empty()) {
            basin[taxel] = rank[taxel];
            continue;
        }
        const std::size_t highest =
            *std::ranges::min_element(dry, {}, [&](std::size_t other) { return rank[other]; });
        basin[taxel] = basin[highest];
        std::size_t winner = taxels;
        for (const std::size_t other : dry)
            winner = std::min(winner, basin[other]);
        std::vector<std::size_t> losers;
        for (const std::size_t other : dry) {
            const float summit = frame.load_N[order[basin[other]]];
            const float pass = frame.load_N[taxel];
            if (basin[other] != winner &&
                (summit == pass || static_cast<double>(summit) - static_cast<double>(pass) < height_N))
                losers.push_back(basin[other]);
        }
        for (std::size_t& name : basin)
            if (std::ranges::find(losers, name) != losers.end())
                name = winner;
    }

    std::vector<std::int32_t> labels(taxels, 0);
    std::vector<std::int32_t> number(taxels, 0);
    std::int32_t count = 0;
    for (std::size_t i = 0; i < taxels; ++i) {
        if (basin[i] == taxels)
            continue;
        if (number[basin[i]] == 0)
            number[basin[i]] = ++count;
        labels[i] = number[basin[i]];
    }
    return labels;
}

/// Labels renumbered by the first taxel of each region.
inline std::vector<std::int32_t> canonical(std::span<const std::int32_t> labels) {
    std::vector<std::int32_t> number(labels.size() + 1, 0);
    std::vector<std::int32_t> result(labels.size(), 0);
    std::int32_t count = 0;
    for (std::size_t i = 0; i < labels.size(); ++i) {
        if (labels[i] == 0)
            continue;
        std::int32_t& name = number[static_cast<std::size_t>(labels[i])];
        if (name == 0)
            name = ++count;
        result[i] = name;
    }
    return result;
}

} // namespace teleta::contact::test
