// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/taxel_layout.h"
#include "backend/core/keys/keys.h"

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace teleta::taxels {

/// Where the taxels of a described array stand, and how what they tell becomes a frame of its layout. A grid
/// may have places without a taxel. Positions that lie on a grid, within 1 % of its pitches, and fill half of
/// it become one; others stay where they are. The origin of {s} is the middle of the box around all taxels.
/// Three components are turned into x, y and z of {s}.
class TaxelGrid {
public:
    static constexpr int kMostComponents = 3;

    /// The table [layout].
    void describeKeys(core::Keys& keys);
    /// Of it, only where the taxels are.
    void describePlaces(core::Keys& keys);
    /// The key "axes".
    void describeAxes(core::Keys& keys);

    [[nodiscard]] core::TaxelLayout layout() const;
    /// Of one taxel: 1 or 3.
    [[nodiscard]] int components() const { return m_components; }
    [[nodiscard]] std::size_t taxels() const { return m_places.size(); }
    /// How many numbers a frame has.
    [[nodiscard]] std::size_t values() const {
        return m_places.size() * static_cast<std::size_t>(m_components);
    }
    [[nodiscard]] const std::string& unit() const { return m_unit; }
    /// What one unit is in N, where the file says it.
    [[nodiscard]] std::optional<double> newtonsPerUnit() const { return m_newtonsPerUnit; }
    /// Unit of the loads: N where it can be.
    [[nodiscard]] std::string loadUnit() const { return m_newtonsPerUnit ? "N" : m_unit; }

    /// values: values() numbers as they came. frame: layout().values() entries; NaN where no taxel is.
    void place(std::span<const float> values, std::span<float> frame) const;

    /// The key "positions_mm", of so many taxels (0: any number), with the keys "heights_mm" and "normals".
    /// Whether there are positions.
    bool describePositions(core::Keys& keys, std::size_t count, core::Need need);
    /// Which axis of {s} each raw component is; false when they are no three axes.
    [[nodiscard]] bool setAxes(const std::vector<std::string>& axes);
    void setUnit(std::string unit) { m_unit = std::move(unit); }
    void setComponents(int components) { m_components = components; }

private:
    enum class Order { row, column };

    void describeGrid(core::Keys& keys);
    void standAt(std::vector<core::TaxelPlace> places);
    [[nodiscard]] bool standOnGrid(const std::vector<core::TaxelPlace>& places);
    [[nodiscard]] std::vector<std::size_t> inOrder(Order order, const std::vector<double>& mask) const;

    core::ArrayLayout m_grid{1, 1, 1e-3};
    std::shared_ptr<const core::TaxelPlaces> m_free; ///< null: the taxels stand on the grid
    int m_components = 1;
    std::array<std::size_t, kMostComponents> m_axis{0, 1, 2}; ///< of {s}, of each raw component
    std::array<float, kMostComponents> m_sign{1.0F, 1.0F, 1.0F};
    std::vector<std::size_t> m_places{0}; ///< of each taxel in the order in which they come, row-major
    std::string m_unit = "counts";
    std::optional<double> m_newtonsPerUnit;
};

} // namespace teleta::taxels
