// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/modbus/input_reader.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace teleta::modbus {

InputReader::InputReader(std::vector<InputRegister> inputs)
    : m_inputs(std::move(inputs))
    , m_plan(planReads(m_inputs)) {
}

Answer InputReader::read(RegisterLink& link, std::span<double> values) {
    std::ranges::fill(values, std::numeric_limits<double>::quiet_NaN());
    for (const ReadRequest& request : m_plan) {
        m_words.assign(static_cast<std::size_t>(request.count), 0);
        const Answer answer = link.read(request.table, request.address, m_words);
        if (!answer.done())
            return answer;
        for (const std::size_t index : request.inputs) {
            const InputRegister& input = m_inputs[index];
            const auto first = static_cast<std::size_t>(input.address - request.address);
            values[index] = decode(input.format, std::span<const std::uint16_t>(m_words).subspan(
                                                     first, registersOf(input.format.type)));
        }
    }
    return {};
}

} // namespace teleta::modbus
