// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace teleta::core {

/// How far the chips of an array have moved from the temperatures at which its tare was taken: what they read
/// at rest moves with temperature. Thread: one (pure).
class TemperatureDrift {
public:
    static constexpr double kTold_K = 5.0; ///< isTold() once a chip has moved by more than this,
    static constexpr double kOver_K = 4.0; ///< until all chips have moved by less than this

    struct Move {
        std::size_t chip = 0; ///< from 0
        double change_K = 0.0;
    };

    /// The next temperatures are those of the tare; of a chip that tells none then, the first that it tells.
    void restart();
    /// The tare was taken at these temperatures, one a chip. A chip without one that is finite says nothing;
    /// none does where they are of another number of chips, as where there are none.
    void restart(std::span<const float> atTare_degC);
    /// Temperatures in degrees Celsius, one a chip. One that is not finite says nothing of its chip.
    void take(std::span<const float> values_degC);

    /// Of the tare; empty: not known.
    [[nodiscard]] const std::vector<float>& atTare() const { return m_atTare; }
    /// Of the chip that has moved most; nothing before the second temperatures since the tare.
    [[nodiscard]] const std::optional<Move>& largest() const { return m_largest; }
    [[nodiscard]] bool isTold() const { return m_told; }

private:
    std::vector<float> m_atTare;
    bool m_given = false; ///< m_atTare is not taken from what the chips tell
    std::optional<Move> m_largest;
    bool m_told = false;
};

} // namespace teleta::core
