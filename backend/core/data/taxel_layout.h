// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/array_layout.h"
#include "backend/core/data/taxel_places.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace teleta::core {

/// What a frame of a tactile source looks like: where its taxels stand in {s}, and what each of them tells.
/// - On a grid, of which some places may have no taxel. What a frame has there is NaN.
/// - Or at places of their own. grid() then is one row of all taxels: use it only for the
/// number of taxels. Components: 1, the load that presses, or 3, the force (or field) on the taxel along x, y
/// and z of {s}, one taxel after the other. What presses has a negative z there, and is a positive load.
/// Values of this type are cheap to copy and compare. Thread: any.
class TaxelLayout {
public:
    static constexpr int kVector = 3;

    /// A grid of loads converts by itself: it is what most sources have.
    TaxelLayout(const ArrayLayout& grid = {}, int components = 1) // NOLINT(google-explicit-constructor)
        : m_grid(grid)
        , m_components(components) {}
    /// places: not null.
    explicit TaxelLayout(std::shared_ptr<const TaxelPlaces> places, int components = 1)
        : m_grid{1, static_cast<int>(places->size()), places->pitch_m()}
        , m_places(std::move(places))
        , m_components(components) {}

    /// Places of the grid without a taxel: 1, one entry a place; of another size: each has one.
    void setAbsent(std::vector<std::uint8_t> absent) {
        m_absent = absent.size() != taxels() || std::ranges::find(absent, 1) == absent.end()
                       ? nullptr
                       : std::make_shared<const std::vector<std::uint8_t>>(std::move(absent));
    }

    [[nodiscard]] const ArrayLayout& grid() const { return m_grid; }
    /// Null: the taxels stand on the grid.
    [[nodiscard]] const std::shared_ptr<const TaxelPlaces>& places() const { return m_places; }
    [[nodiscard]] bool isGrid() const { return m_places == nullptr; }
    /// As setAbsent().
    [[nodiscard]] std::span<const std::uint8_t> absent() const {
        return m_absent ? std::span<const std::uint8_t>(*m_absent) : std::span<const std::uint8_t>();
    }
    [[nodiscard]] bool isAbsent(std::size_t taxel) const { return m_absent && (*m_absent)[taxel] != 0; }
    [[nodiscard]] int components() const { return m_components; }
    [[nodiscard]] bool isVector() const { return m_components == kVector; }

    /// Of the grid all places, also those without a taxel.
    [[nodiscard]] std::size_t taxels() const { return m_grid.taxels(); }
    /// Numbers of a frame.
    [[nodiscard]] std::size_t values() const { return taxels() * static_cast<std::size_t>(m_components); }
    /// The distance of neighbouring taxels, the larger one of a grid, the median of places.
    [[nodiscard]] double pitch_m() const { return m_grid.largerPitch_m(); }
    [[nodiscard]] double x_m(std::size_t taxel) const {
        return m_places ? (*m_places)[taxel].x_m : m_grid.x_m(static_cast<double>(taxel % columns()));
    }
    [[nodiscard]] double y_m(std::size_t taxel) const {
        return m_places ? (*m_places)[taxel].y_m : m_grid.y_m(static_cast<double>(taxel / columns()));
    }
    [[nodiscard]] double area_m2(std::size_t taxel) const {
        return m_places ? m_places->area_m2(taxel) : m_grid.taxelArea_m2();
    }

    bool operator==(const TaxelLayout& other) const {
        return m_grid == other.m_grid && m_components == other.m_components &&
               isSame(m_places, other.m_places) && isSame(m_absent, other.m_absent);
    }

private:
    [[nodiscard]] std::size_t columns() const { return static_cast<std::size_t>(m_grid.columns); }
    template <typename T>
    static bool isSame(const std::shared_ptr<T>& a, const std::shared_ptr<T>& b) {
        return a == b || (a && b && *a == *b);
    }

    ArrayLayout m_grid;
    std::shared_ptr<const TaxelPlaces> m_places;
    std::shared_ptr<const std::vector<std::uint8_t>> m_absent;
    int m_components = 1;
};

} // namespace teleta::core
