// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pipeline/recorded/recorded_loads.h"

#include <QCoreApplication>

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace teleta::pipeline {

namespace {

using equilibration::LoadCalibration;
using nlohmann::ordered_json;

struct RecordedLoadsText {
    Q_DECLARE_TR_FUNCTIONS(RecordedLoads)
};

constexpr double kGreatestGain = 1e12;

ordered_json listOf(const Eigen::VectorXd& values) {
    return std::vector<double>(values.begin(), values.end());
}

ordered_json rowsOf(const Eigen::MatrixXd& values) {
    ordered_json rows = ordered_json::array();
    for (Eigen::Index row = 0; row < values.rows(); ++row)
        rows.push_back(listOf(values.row(row).transpose()));
    return rows;
}

/// Names of a list, each of known, none twice.
template <typename Known>
std::vector<std::string> readNames(core::JsonReader& reader, const ordered_json& json, const char* key,
                                   const Known& known) {
    std::vector<std::string> names;
    for (const ordered_json& value : reader.array(reader.member(json, key), 1, std::size(known))) {
        std::string name = reader.text(value);
        if (std::ranges::find(known, name) == std::end(known))
            reader.fail(value, RecordedLoadsText::tr("the array does not have this"), {});
        if (std::ranges::find(names, name) != names.end())
            reader.fail(value, RecordedLoadsText::tr("this is listed twice"), {});
        names.push_back(std::move(name));
    }
    return names;
}

Eigen::VectorXd readColumn(core::JsonReader& reader, const ordered_json& list, std::size_t size,
                           double lowest) {
    Eigen::VectorXd values = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(size));
    Eigen::Index next = 0;
    for (const ordered_json& value : reader.array(list, size, size))
        values[next++] = reader.number(value, lowest, kGreatestGain);
    return values;
}

Eigen::MatrixXd readRows(core::JsonReader& reader, const ordered_json& json, const char* key,
                         std::size_t rows, std::size_t columns, double lowest) {
    Eigen::MatrixXd values =
        Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(columns));
    Eigen::Index next = 0;
    for (const ordered_json& row : reader.array(reader.member(json, key), rows, rows))
        values.row(next++) = readColumn(reader, row, columns, lowest).transpose();
    return values;
}

} // namespace

ordered_json loadsJson(const LoadCalibration& calibration) {
    return {{"names", calibration.loads},
            {"signals", calibration.channels},
            {"gain", rowsOf(calibration.gain)},
            {"gain_se", rowsOf(calibration.error)},
            {"rest", listOf(calibration.rest)},
            {"least", listOf(calibration.least)},
            {"greatest", listOf(calibration.greatest)},
            {"scatter", listOf(calibration.scatter)}};
}

std::optional<LoadCalibration> readCalibration(core::JsonReader& reader, const ordered_json& details,
                                               const std::vector<std::string>& known) {
    const ordered_json* json = reader.find(details, "loads");
    if (json == nullptr)
        return std::nullopt;
    const auto list = [&](const char* key, std::size_t size, double lowest) {
        return readColumn(reader, reader.member(*json, key), size, lowest);
    };
    LoadCalibration calibration{.loads = readNames(reader, *json, "names", equilibration::kLoadColumns),
                                .channels = readNames(reader, *json, "signals", known)};
    const std::size_t loads = calibration.loads.size();
    const std::size_t channels = calibration.channels.size();
    calibration.gain = readRows(reader, *json, "gain", loads, channels, -kGreatestGain);
    calibration.error = readRows(reader, *json, "gain_se", loads, channels, 0.0);
    calibration.rest = list("rest", channels, -kGreatestGain);
    calibration.least = list("least", channels, -kGreatestGain);
    calibration.greatest = list("greatest", channels, -kGreatestGain);
    calibration.scatter = list("scatter", loads, 0.0);
    if (!reader.error() && (calibration.least.array() > calibration.greatest.array()).any())
        reader.fail(*json, RecordedLoadsText::tr("least is above greatest"), {});
    if (reader.error())
        return std::nullopt;
    return calibration;
}

std::optional<FrameLoads> readLoads(core::JsonReader& reader, const ordered_json& details,
                                    const core::TaxelLayout& layout, const std::string& loadUnit) {
    auto calibration = readCalibration(reader, details, FrameLoads::signalsOf(layout, loadUnit));
    if (!calibration)
        return std::nullopt;
    return FrameLoads(*std::move(calibration), layout, loadUnit);
}

} // namespace teleta::pipeline
