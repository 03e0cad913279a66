// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/modbus/register_link.h"

#include <cstdint>
#include <span>
#include <vector>

namespace teleta::modbus {

/// Reads a set of inputs with the fewest requests. Thread: one.
class InputReader {
public:
    explicit InputReader(std::vector<InputRegister> inputs);

    /// values: one for each input, in its unit. Stops at the first request that fails, whose values and all
    /// later ones are NaN.
    [[nodiscard]] Answer read(RegisterLink& link, std::span<double> values);

    [[nodiscard]] std::size_t inputs() const { return m_inputs.size(); }
    [[nodiscard]] std::size_t requests() const { return m_plan.size(); }

private:
    std::vector<InputRegister> m_inputs;
    std::vector<ReadRequest> m_plan;
    std::vector<std::uint16_t> m_words;
};

} // namespace teleta::modbus
