// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/data/taxel_places.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

namespace teleta::core {

namespace {

/// Taxels of a real grid are never exactly on its lines. Four corners of a cell count as on the circle
/// through them while they are off it by less than this share of its diameter.
constexpr double kOffCircle = 0.01;

double distance2_m2(const TaxelPlace& a, const TaxelPlace& b) {
    const double x = a.x_m - b.x_m;
    const double y = a.y_m - b.y_m;
    const double z = a.z_m - b.z_m;
    return x * x + y * y + z * z;
}

double distance_m(const TaxelPlace& a, const TaxelPlace& b) {
    return std::sqrt(distance2_m2(a, b));
}

bool liesBetween(const TaxelPlace& other, const TaxelPlace& a, const TaxelPlace& b, double diameter_m) {
    const TaxelPlace middle{0.5 * (a.x_m + b.x_m), 0.5 * (a.y_m + b.y_m), 0.5 * (a.z_m + b.z_m)};
    return distance_m(other, middle) < (0.5 - kOffCircle) * diameter_m;
}

} // namespace

std::optional<std::pair<std::size_t, std::size_t>>
TaxelPlaces::sameOf(const std::vector<TaxelPlace>& places) {
    for (std::size_t second = 1; second < places.size(); ++second)
        for (std::size_t first = 0; first < second; ++first)
            if (distance2_m2(places[first], places[second]) < kSame_m * kSame_m)
                return std::pair(first, second);
    return std::nullopt;
}

TaxelPlaces::TaxelPlaces(std::vector<TaxelPlace> places)
    : m_places(std::move(places))
    , m_neighbours(m_places.size())
    , m_spacing_m(m_places.size(), kLoneSpacing_m)
    , m_area_m2(m_places.size()) {
    measureSpacings();
    joinNeighbours();
    measureAreas();
}

void TaxelPlaces::measureSpacings() {
    if (m_places.size() < 2)
        return;
    for (std::size_t i = 0; i < m_places.size(); ++i) {
        double nearest_m2 = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < m_places.size(); ++k)
            if (k != i)
                nearest_m2 = std::min(nearest_m2, distance2_m2(m_places[i], m_places[k]));
        m_spacing_m[i] = std::sqrt(nearest_m2);
    }
    std::vector<double> sorted = m_spacing_m;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::ranges::nth_element(sorted, middle);
    m_pitch_m = *middle;
}

void TaxelPlaces::measureAreas() {
    constexpr double kNext =
        1.2; // of a square grid's neighbours, four are a pitch away and four sqrt(2) of it
    constexpr std::ptrdiff_t kInTriangles = 6;
    const auto isNext = [this](std::size_t taxel, std::size_t other) {
        return distance_m(m_places[taxel], m_places[other]) <= kNext * m_spacing_m[taxel];
    };
    const auto isInTriangles = [&](std::size_t taxel) {
        return std::ranges::count_if(m_neighbours[taxel],
                                     [&](std::size_t other) { return isNext(taxel, other); }) == kInTriangles;
    };
    for (std::size_t i = 0; i < m_places.size(); ++i) {
        const bool inTriangles =
            isInTriangles(i) || std::ranges::any_of(m_neighbours[i], [&](std::size_t other) {
                return isNext(other, i) && isInTriangles(other);
            });
        m_area_m2[i] = m_spacing_m[i] * m_spacing_m[i] * (inTriangles ? std::numbers::sqrt3 / 2.0 : 1.0);
    }
}

void TaxelPlaces::joinNeighbours() {
    for (std::size_t i = 0; i < m_places.size(); ++i)
        for (std::size_t k = 0; k < i; ++k) {
            const double apart_m = distance_m(m_places[i], m_places[k]);
            if (apart_m > kReach * std::max(m_spacing_m[i], m_spacing_m[k]) ||
                std::ranges::any_of(m_places, [&](const TaxelPlace& other) {
                    return liesBetween(other, m_places[i], m_places[k], apart_m);
                }))
                continue;
            m_neighbours[i].push_back(k);
            m_neighbours[k].push_back(i);
        }
}

} // namespace teleta::core
