// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/array_layout.h"
#include "backend/core/keys/keys.h"

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace teleta::taxels {

/// Where the taxels of a described array stand, and how what they tell becomes the loads of its grid.
/// A grid may have places without a taxel. Positions have to lie on such a grid, within 1 % of its pitch.
/// Of three components the load is the one that presses: the negative force along z of {s}.
class TaxelGrid {
public:
    static constexpr int kMostComponents = 3;

    /// The table [layout].
    void describeKeys(core::Keys& keys);
    /// Of it, only where the taxels are.
    void describePlaces(core::Keys& keys);
    /// The key "axes".
    void describeAxes(core::Keys& keys);

    [[nodiscard]] const core::ArrayLayout& layout() const { return m_layout; }
    /// Of one taxel: 1 or 3.
    [[nodiscard]] int components() const { return m_components; }
    [[nodiscard]] std::size_t taxels() const { return m_places.size(); }
    /// How many numbers a frame has.
    [[nodiscard]] std::size_t values() const {
        return m_places.size() * static_cast<std::size_t>(m_components);
    }
    [[nodiscard]] const std::string& unit() const { return m_unit; }

    /// values: values() numbers as they came. loads: layout().taxels() entries; NaN where no taxel is.
    void place(std::span<const float> values, std::span<float> loads) const;

    /// A grid of so many taxels at these places in mm, row by row x and y; false when they lie on none.
    [[nodiscard]] bool standAt(const std::vector<std::vector<double>>& positions_mm);
    /// Which component presses, as axes of the raw ones; false when they are no three axes.
    [[nodiscard]] bool setAxes(const std::vector<std::string>& axes);
    void setUnit(std::string unit) { m_unit = std::move(unit); }
    void setComponents(int components) { m_components = components; }

private:
    enum class Order { row, column };

    void describeGrid(core::Keys& keys);
    [[nodiscard]] std::vector<std::size_t> inOrder(Order order, const std::vector<double>& mask) const;

    core::ArrayLayout m_layout{1, 1, 1e-3};
    int m_components = 1;
    std::size_t m_normal = 2;             ///< the raw component along z of {s}
    float m_pressing = 1.0F;              ///< its sign, so that pressing is positive
    std::vector<std::size_t> m_places{0}; ///< of each taxel in the order in which they come, row-major
    std::string m_unit = "counts";
};

} // namespace teleta::taxels
