// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/modbus/register_map.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace teleta::modbus {

namespace {

constexpr int kLongestRead = 125;

int endOf(const InputRegister& input) {
    return input.address + static_cast<int>(registersOf(input.format.type));
}

} // namespace

std::string linkName(const RegisterMap& map) {
    if (const auto* rtu = std::get_if<RtuLink>(&map.link))
        return rtu->path;
    const auto& tcp = std::get<TcpLink>(map.link);
    // An address of IP 6 has colons itself.
    const bool bare = tcp.host.find(':') == std::string::npos;
    return "tcp://" + (bare ? tcp.host : '[' + tcp.host + ']') + ':' + std::to_string(tcp.port);
}

std::vector<std::uint16_t> tactorWords(const TactorRegisters& tactors, const core::Intensities& intensities) {
    std::vector<std::uint16_t> words;
    words.reserve(tactors.registers());
    for (const double intensity : intensities) {
        const double limited = std::isnan(intensity) ? 0.0 : std::clamp(intensity, 0.0, 1.0);
        const double value =
            limited > 0.0 ? tactors.start + (tactors.full - tactors.start) * limited : tactors.off;
        const RegisterWords raw = encode(tactors.format, value);
        words.insert(words.end(), raw.begin(),
                     raw.begin() + static_cast<std::ptrdiff_t>(registersOf(tactors.format.type)));
    }
    return words;
}

std::vector<ReadRequest> planReads(const std::vector<InputRegister>& inputs) {
    std::vector<std::size_t> order(inputs.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
        return std::pair(inputs[a].table, inputs[a].address) < std::pair(inputs[b].table, inputs[b].address);
    });
    std::vector<ReadRequest> plan;
    for (const std::size_t index : order) {
        const InputRegister& input = inputs[index];
        if (!plan.empty()) {
            ReadRequest& last = plan.back();
            const int end = std::max(last.address + last.count, endOf(input));
            if (last.table == input.table && input.address <= last.address + last.count &&
                end - last.address <= kLongestRead) {
                last.count = end - last.address;
                last.inputs.push_back(index);
                continue;
            }
        }
        plan.push_back({.table = input.table,
                        .address = input.address,
                        .count = endOf(input) - input.address,
                        .inputs = {index}});
    }
    return plan;
}

} // namespace teleta::modbus
