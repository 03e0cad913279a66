// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/signal/signal_name.h"

#include "backend/core/data/column_unit.h"

namespace teleta::signal {

std::vector<recording::Column> columnsOf(const recording::StreamInfo& stream) {
    if (stream.type == recording::ValueType::grey8)
        return {};
    std::vector<recording::Column> columns = stream.columns;
    for (std::size_t i = columns.size(); i < stream.channels(); ++i)
        columns.push_back({"t" + std::to_string(i), stream.unit});
    return columns;
}

bool isOfEvents(const recording::StreamInfo& stream) {
    return stream.kind == recording::StreamKind::touches || stream.kind == recording::StreamKind::contacts;
}

std::string nameWithUnit(const std::string& name, const std::string& unit) {
    const std::string ending = "_" + core::columnUnit(unit);
    return unit.empty() || ending.size() == 1 || name.ends_with(ending) ? name : name + ending;
}

} // namespace teleta::signal
