// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/gel/marker_layout.h"

#include "backend/core/quantile.h"

#include <queue>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>

namespace teleta::vision {

namespace {

constexpr double kNeighbourReach = 1.6;
constexpr std::size_t kMostNeighbours = 8;
constexpr double kStepTolerance = 0.35;

std::vector<double> nearestOfEach(std::span<const Eigen::Vector2d> places, std::size_t rank) {
    std::vector<double> nearest;
    std::vector<double> distances;
    for (std::size_t i = 0; i < places.size(); ++i) {
        distances.clear();
        for (std::size_t k = 0; k < places.size(); ++k) {
            if (k != i)
                distances.push_back((places[k] - places[i]).norm());
        }
        nearest.push_back(
            distances.empty() ? 0.0 : core::orderStatistic(distances, std::min(rank, distances.size() - 1)));
    }
    return nearest;
}

struct Steps {
    Eigen::Vector2d along, down;
};

/// Where most differences between neighbouring places lie, of those that are accepted; nothing without any.
template <typename Accept>
std::optional<Eigen::Vector2d> commonStep(const std::vector<Eigen::Vector2d>& steps, double reach_px,
                                          Accept accept) {
    // Of thousands some are as good as all.
    constexpr std::size_t kCandidates = 1000;
    const std::size_t stride = 1 + steps.size() / kCandidates;
    std::size_t most = 0;
    std::optional<Eigen::Vector2d> best;
    for (std::size_t i = 0; i < steps.size(); i += stride) {
        const Eigen::Vector2d& candidate = steps[i];
        if (!accept(candidate))
            continue;
        std::size_t count = 0;
        Eigen::Vector2d sum = Eigen::Vector2d::Zero();
        for (const Eigen::Vector2d& step : steps) {
            // A step and its opposite are the same.
            for (const double sign : {1.0, -1.0}) {
                if ((sign * step - candidate).norm() < reach_px) {
                    ++count;
                    sum += sign * step;
                }
            }
        }
        if (count > most) {
            most = count;
            best = sum / static_cast<double>(count);
        }
    }
    return best;
}

std::optional<Steps> gridSteps(std::span<const Eigen::Vector2d> places, MarkerGrid grid) {
    const double near_px = nearestDistance_px(places);
    if (!(near_px > 0.0))
        return std::nullopt;
    constexpr double kLongest = 2.2; // the other side of an uneven grid
    std::vector<Eigen::Vector2d> differences;
    for (std::size_t i = 0; i < places.size(); ++i) {
        for (std::size_t k = i + 1; k < places.size(); ++k) {
            const Eigen::Vector2d step = places[k] - places[i];
            if (step.norm() < kLongest * near_px)
                differences.push_back(step);
        }
    }
    const double reach_px = 0.25 * near_px;
    const auto first = commonStep(differences, reach_px,
                                  [&](const Eigen::Vector2d& step) { return step.norm() < 1.3 * near_px; });
    if (!first)
        return std::nullopt;
    const double longest_px = (grid == MarkerGrid::hexagonal ? 1.3 : kLongest) * first->norm();
    const double leastSine = grid == MarkerGrid::hexagonal ? 0.75 : 0.9;
    const auto second = commonStep(differences, reach_px, [&](const Eigen::Vector2d& step) {
        const double cross = first->x() * step.y() - first->y() * step.x();
        return step.norm() < longest_px && std::abs(cross) > leastSine * first->norm() * step.norm();
    });
    if (!second)
        return std::nullopt;
    Steps steps{*first, *second};
    if (std::abs(steps.along.x()) * steps.down.norm() < std::abs(steps.down.x()) * steps.along.norm())
        std::swap(steps.along, steps.down);
    if (steps.along.x() < 0.0)
        steps.along = -steps.along;
    if (steps.along.x() * steps.down.y() - steps.along.y() * steps.down.x() < 0.0)
        steps.down = -steps.down;
    return steps;
}

/// A place that may have been found by a step from another one.
struct Reached {
    double off = 0.0;
    std::size_t place = 0;
    int i = 0, j = 0;
    std::size_t from = 0;
    std::size_t direction = 0;
    bool operator<(const Reached& other) const { return off > other.off; }
};

using Numbers = std::vector<std::optional<std::pair<int, int>>>;

Numbers numbered(std::span<const Eigen::Vector2d> places, const Steps& steps, std::size_t seed) {
    constexpr std::array<std::pair<int, int>, 4> kDirections{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
    const std::array<Eigen::Vector2d, 4> common{steps.along, -steps.along, steps.down, -steps.down};
    Numbers numbers(places.size());
    std::map<std::pair<int, int>, std::size_t> taken;
    std::priority_queue<Reached> open;
    open.push({.place = seed, .from = seed});
    std::vector<std::array<Eigen::Vector2d, 4>> own(places.size(), common); // of those that have a number
    while (!open.empty()) {
        const Reached next = open.top();
        open.pop();
        if (numbers[next.place] || taken.contains({next.i, next.j}))
            continue;
        numbers[next.place] = {next.i, next.j};
        taken[{next.i, next.j}] = next.place;
        if (next.from != next.place) {
            // The steps of a bent grid change slowly.
            own[next.place] = own[next.from];
            Eigen::Vector2d& step = own[next.place][next.direction];
            step = 0.5 * (step + places[next.place] - places[next.from]);
            own[next.place][next.direction ^ 1U] = -step;
        }
        for (std::size_t d = 0; d < kDirections.size(); ++d) {
            const Eigen::Vector2d step = own[next.place][d];
            const Eigen::Vector2d expected = places[next.place] + step;
            std::size_t best = places.size();
            double least = kStepTolerance * step.norm();
            for (std::size_t k = 0; k < places.size(); ++k) {
                const double off = (places[k] - expected).norm();
                if (off < least) {
                    least = off;
                    best = k;
                }
            }
            if (best == places.size() || numbers[best])
                continue;
            open.push({.off = least / step.norm(),
                       .place = best,
                       .i = next.i + kDirections[d].first,
                       .j = next.j + kDirections[d].second,
                       .from = next.place,
                       .direction = d});
        }
    }
    return numbers;
}

} // namespace

double nearestDistance_px(std::span<const Eigen::Vector2d> places_px) {
    if (places_px.size() < 2)
        return 0.0;
    std::vector<double> nearest = nearestOfEach(places_px, 0);
    return core::medianOf(nearest);
}

std::vector<std::vector<std::size_t>> markerNeighbours(std::span<const Eigen::Vector2d> places_px) {
    std::vector<std::vector<std::size_t>> neighbours(places_px.size());
    if (places_px.size() < 2)
        return neighbours;
    // The third nearest: the border has few neighbours, and a free grid some close ones.
    const std::vector<double> reach = nearestOfEach(places_px, 2);
    const double usual_px = nearestDistance_px(places_px);
    const auto apart = [&](std::size_t a, std::size_t b) { return (places_px[a] - places_px[b]).norm(); };
    for (std::size_t i = 0; i < places_px.size(); ++i) {
        for (std::size_t k = i + 1; k < places_px.size(); ++k) {
            const double local_px = std::max(usual_px, std::min(reach[i], reach[k]));
            if (apart(i, k) < kNeighbourReach * local_px) {
                neighbours[i].push_back(k);
                neighbours[k].push_back(i);
            }
        }
    }
    for (std::size_t i = 0; i < neighbours.size(); ++i) {
        std::ranges::sort(neighbours[i],
                          [&](std::size_t a, std::size_t b) { return apart(i, a) < apart(i, b); });
        if (neighbours[i].size() > kMostNeighbours)
            neighbours[i].resize(kMostNeighbours);
    }
    return neighbours;
}

std::vector<GridPlace> gridPlaces(std::span<const Eigen::Vector2d> places_px, MarkerGrid grid, int rows,
                                  int columns) {
    std::vector<GridPlace> result(places_px.size());
    const auto steps = grid == MarkerGrid::free ? std::nullopt : gridSteps(places_px, grid);
    if (!steps)
        return result;
    // Beginning where most can be numbered: a false spot is no beginning.
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    for (const Eigen::Vector2d& place : places_px)
        middle += place / static_cast<double>(places_px.size());
    std::vector<std::size_t> seeds(places_px.size());
    for (std::size_t i = 0; i < seeds.size(); ++i)
        seeds[i] = i;
    std::ranges::sort(seeds, [&](std::size_t a, std::size_t b) {
        return (places_px[a] - middle).squaredNorm() < (places_px[b] - middle).squaredNorm();
    });
    constexpr std::size_t kSeeds = 5;
    Numbers numbers;
    std::ptrdiff_t most = 0;
    for (std::size_t s = 0; s < std::min(kSeeds, seeds.size()); ++s) {
        Numbers candidate = numbered(places_px, *steps, seeds[s]);
        const auto count =
            std::ranges::count_if(candidate, [](const auto& number) { return number.has_value(); });
        if (count > most) {
            most = count;
            numbers = std::move(candidate);
        }
    }
    int leftmost = std::numeric_limits<int>::max(), top = leftmost, right = -leftmost, bottom = -leftmost;
    // Twice the place along a row, so that half steps are whole.
    const int lean = grid != MarkerGrid::hexagonal ? 0 : steps->down.dot(steps->along) >= 0.0 ? 1 : -1;
    const auto twiceAlong = [&](const std::pair<int, int>& number) {
        return 2 * number.first + lean * number.second;
    };
    for (const auto& number : numbers) {
        if (!number)
            continue;
        leftmost = std::min(leftmost, twiceAlong(*number));
        right = std::max(right, twiceAlong(*number));
        top = std::min(top, number->second);
        bottom = std::max(bottom, number->second);
    }
    if (grid == MarkerGrid::rectangular) {
        // The part of rows x columns places that has most of them.
        std::size_t best = 0;
        const int firstLeft = leftmost / 2;
        const int firstTop = top;
        const int lastLeft = std::max(firstLeft, right / 2 - columns + 1);
        const int lastTop = std::max(firstTop, bottom - rows + 1);
        for (int j = firstTop; j <= lastTop; ++j) {
            for (int i = firstLeft; i <= lastLeft; ++i) {
                const auto count =
                    static_cast<std::size_t>(std::ranges::count_if(numbers, [&](const auto& n) {
                        return n && n->first >= i && n->first < i + columns && n->second >= j &&
                               n->second < j + rows;
                    }));
                if (count > best) {
                    best = count;
                    leftmost = 2 * i;
                    top = j;
                }
            }
        }
    }
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        if (!numbers[k])
            continue;
        const GridPlace place{.row = numbers[k]->second - top,
                              .column = (twiceAlong(*numbers[k]) - leftmost) / 2};
        const bool isOutside =
            grid == MarkerGrid::rectangular &&
            (place.row < 0 || place.row >= rows || place.column < 0 || place.column >= columns);
        if (!isOutside)
            result[k] = place;
    }
    return result;
}

} // namespace teleta::vision
