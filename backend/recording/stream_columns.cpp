// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/recording/stream_columns.h"

#include "backend/core/data/column_unit.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace teleta::recording {

bool isColour(const StreamInfo& stream) {
    constexpr std::size_t kColours = 3;
    return stream.type == ValueType::grey8 && stream.shape.size() == 3 && stream.shape[2] == kColours;
}

bool isVectorArray(const StreamInfo& stream) {
    return stream.kind == StreamKind::array && stream.shape.size() == 2 && stream.shape[1] == 3 &&
           stream.columns.size() == stream.channels();
}

StreamInfo jointStream(double nominalRate_Hz, std::size_t joints) {
    StreamInfo info;
    info.name = "joints";
    info.kind = StreamKind::joints;
    info.type = ValueType::float64;
    info.shape = {kJointKinds * joints};
    info.nominalRate_Hz = nominalRate_Hz;
    struct Part {
        const char* name;
        const char* unit;
    };
    for (const Part& part : {Part{"q", "rad"}, Part{"tau", "Nm"}, Part{"ref", "rad"}}) {
        for (std::size_t joint = 1; joint <= joints; ++joint)
            info.columns.push_back({part.name + std::to_string(joint), part.unit});
    }
    return info;
}

std::optional<std::size_t> jointsOf(const StreamInfo& stream) {
    const std::size_t joints = stream.channels() / kJointKinds;
    if (stream.kind != StreamKind::joints || stream.type != ValueType::float64 || joints == 0 ||
        joints > core::JointVector::kCapacity || stream.channels() != kJointKinds * joints)
        return std::nullopt;
    return joints;
}

std::vector<double> jointValues(const core::JointSample& sample, std::size_t joints) {
    std::vector<double> values;
    values.reserve(kJointKinds * joints);
    for (const core::JointVector* kind : {&sample.angle_rad, &sample.torque_Nm, &sample.reference_rad})
        for (std::size_t joint = 0; joint < joints; ++joint)
            values.push_back(joint < kind->size() ? (*kind)[joint]
                                                  : std::numeric_limits<double>::quiet_NaN());
    return values;
}

core::JointSample jointSample(std::span<const double> values) {
    const std::size_t joints = values.size() / kJointKinds;
    core::JointSample sample;
    for (core::JointVector* kind : {&sample.angle_rad, &sample.torque_Nm, &sample.reference_rad}) {
        const std::span<const double> told = values.first(joints);
        if (!std::ranges::all_of(told, [](double value) { return std::isnan(value); }))
            *kind = core::JointVector::of(told).value_or(core::JointVector());
        values = values.subspan(joints);
    }
    return sample;
}

std::vector<Column> featureColumns(const std::string& loadUnit, bool vectors) {
    const std::string load = "_" + core::columnUnit(loadUnit);
    const std::string unit = loadUnit.empty() ? core::columnUnit(loadUnit) : loadUnit;
    std::vector<Column> columns{{"contact_type", ""}, {"force" + load, unit}, {"cop_x_m", "m"},
                                {"cop_y_m", "m"},     {"coc_x_m", "m"},       {"coc_y_m", "m"},
                                {"dzmp_x_m", "m"},    {"dzmp_y_m", "m"},      {"alpha_z_rad", "rad"},
                                {"lambda1_m2", "m2"}, {"lambda2_m2", "m2"},   {"active", ""}};
    if (!vectors)
        return columns;
    columns.push_back({"shear_x" + load, unit});
    columns.push_back({"shear_y" + load, unit});
    columns.push_back({"moment_z_" + core::momentColumnUnit(loadUnit), loadUnit == "N" ? "Nm" : unit + " m"});
    columns.push_back({"friction_ratio", ""});
    return columns;
}

const std::vector<Column>& touchColumns() {
    static const std::vector<Column> columns{{"touch", ""},
                                             {"start_s", "s"},
                                             {"contact_distance_m", "m"},
                                             {"side_rad", "rad"},
                                             {"x_m", "m"},
                                             {"y_m", "m"},
                                             {"z_m", "m"},
                                             {"delta_theta_rad", "rad"},
                                             {"delta_torque_nm", "Nm"},
                                             {"total_stiffness_n_per_m", "N/m"},
                                             {"object_stiffness_n_per_m", "N/m"},
                                             {"object_stiffness_lower_95", "N/m"},
                                             {"object_stiffness_upper_95", "N/m"},
                                             {"level", ""}};
    return columns;
}

const std::vector<Column>& contactColumns() {
    static const std::vector<Column> columns{
        {"contact_id", ""}, {"u_px", "px"}, {"v_px", "px"}, {"x_m", "m"},  {"y_m", "m"},
        {"z_m", "m"},       {"dx_m", "m"},  {"dy_m", "m"},  {"dz_m", "m"}, {"area_px", "px2"}};
    return columns;
}

const std::vector<Column>& gelContactColumns() {
    static const std::vector<Column> columns{{"contact_id", ""},
                                             {"x_m", "m"},
                                             {"y_m", "m"},
                                             {"area_m2", "m2"},
                                             {"normal_proxy_m2", "m2"},
                                             {"shear_proxy_x_m", "m"},
                                             {"shear_proxy_y_m", "m"},
                                             {"torsion_rad", "rad"},
                                             {"slip_index", ""}};
    return columns;
}

std::vector<Column> temperatureColumns(std::size_t chips) {
    std::vector<Column> columns;
    for (std::size_t chip = 0; chip < chips; ++chip)
        columns.push_back({"temperature_" + std::to_string(chip) + "_degc", "degC"});
    return columns;
}

const std::vector<Column>& wrenchColumns() {
    static const std::vector<Column> columns{{"force_x_n", "N"},    {"force_y_n", "N"},
                                             {"force_z_n", "N"},    {"torque_x_nm", "Nm"},
                                             {"torque_y_nm", "Nm"}, {"torque_z_nm", "Nm"}};
    return columns;
}

} // namespace teleta::recording
