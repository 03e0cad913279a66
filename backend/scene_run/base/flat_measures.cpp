// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene_run/base/flat_measures.h"

namespace teleta::scene_run {

namespace {

void flatten(const nlohmann::ordered_json& value, const std::string& name, FlatMeasures& flat) {
    if (value.is_number()) {
        flat.numbers.emplace_back(name, value.get<double>());
    } else if (value.is_boolean()) {
        flat.numbers.emplace_back(name, value.get<bool>() ? 1.0 : 0.0);
    } else if (value.is_string()) {
        flat.texts.emplace_back(name, value.get<std::string>());
    } else if (value.is_array()) {
        for (std::size_t i = 0; i < value.size(); ++i) {
            const nlohmann::ordered_json& entry = value[i];
            // ["align", 1.5] is a number with a name.
            if (entry.is_array() && entry.size() == 2 && entry[0].is_string())
                flatten(entry[1], name + "." + entry[0].get<std::string>(), flat);
            else
                flatten(entry, name + "[" + std::to_string(i) + "]", flat);
        }
    }
}

} // namespace

FlatMeasures flatMeasures(const nlohmann::ordered_json& measures) {
    FlatMeasures flat;
    for (const auto& [name, value] : measures.items())
        flatten(value, name, flat);
    return flat;
}

} // namespace teleta::scene_run
