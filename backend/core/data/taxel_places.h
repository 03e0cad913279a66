// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace teleta::core {

/// Where a taxel stands in the sensor frame {s}, and which way its surface looks. Finite; |coordinate| <= 10
/// m.
struct TaxelPlace {
    double x_m = 0.0;
    double y_m = 0.0;
    double z_m = 0.0;
    std::array<double, 3> normal{0.0, 0.0, 1.0}; ///< out of the surface, of length 1

    bool operator==(const TaxelPlace&) const = default;
};

/// The places of taxels that stand on no grid, and what follows from them:
/// - neighbours, by the Gabriel graph: two taxels are neighbours when no other lies inside of the ball whose
///   diameter joins them, and they are no further apart than kReach times the larger of their spacings. On a
///   grid of squares these are the eight around a taxel. The reach ends that in long cells: beyond sides of
///   1 : 2.3 the diagonals are missing, beyond 1 : 2.5 the rows are not joined.
/// - spacing: the distance to the nearest taxel; that of a single taxel is kLoneSpacing_m.
/// Immutable, so that all frames of a source share it. Thread: any.
class TaxelPlaces {
public:
    static constexpr std::size_t kMost = 4096;
    static constexpr double kReach = 2.5;
    static constexpr double kLoneSpacing_m = 1e-3;
    /// Places that are closer are the same.
    static constexpr double kSame_m = 1e-6;

    /// places: 1 to kMost, of which no two are the same (sameOf()).
    explicit TaxelPlaces(std::vector<TaxelPlace> places);

    /// The first two that are the same place, in order of the second; nothing: all differ.
    [[nodiscard]] static std::optional<std::pair<std::size_t, std::size_t>>
    sameOf(const std::vector<TaxelPlace>& places);

    [[nodiscard]] std::size_t size() const { return m_places.size(); }
    [[nodiscard]] const std::vector<TaxelPlace>& all() const { return m_places; }
    [[nodiscard]] const TaxelPlace& operator[](std::size_t taxel) const { return m_places[taxel]; }
    [[nodiscard]] const std::vector<std::vector<std::size_t>>& neighbours() const { return m_neighbours; }
    [[nodiscard]] double spacing_m(std::size_t taxel) const { return m_spacing_m[taxel]; }
    /// The median of the spacings.
    [[nodiscard]] double pitch_m() const { return m_pitch_m; }
    /// Of the cell of a taxel. Square of the spacing p, as on a square grid; sqrt(3) / 2 p^2 where the taxels
    /// stand in triangles: a taxel with six others within 1.2 p, and the next ones to such a taxel.
    [[nodiscard]] double area_m2(std::size_t taxel) const { return m_area_m2[taxel]; }

    bool operator==(const TaxelPlaces& other) const { return m_places == other.m_places; }

private:
    void measureSpacings();
    void joinNeighbours();
    void measureAreas();

    std::vector<TaxelPlace> m_places;
    std::vector<std::vector<std::size_t>> m_neighbours;
    std::vector<double> m_spacing_m;
    std::vector<double> m_area_m2;
    double m_pitch_m = kLoneSpacing_m;
};

} // namespace teleta::core
