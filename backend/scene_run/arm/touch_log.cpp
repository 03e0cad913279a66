// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene_run/arm/touch_log.h"

#include "backend/scene_run/base/scene_summary.h"

#include <cmath>
#include <limits>
#include <string_view>

namespace teleta::scene_run {

namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// Infinite condition numbers, too, are written as not available.
double known(double value) {
    return std::isfinite(value) ? value : kUnknown;
}

void writeForce(core::CsvWriter& csv, const std::optional<arm::ContactForce>& force) {
    for (std::size_t i = 0; i < 3; ++i)
        csv.number(force && force->observable[i] ? force->force_N[static_cast<Eigen::Index>(i)] : kUnknown);
    csv.number(force ? known(force->conditionNumber) : kUnknown);
}

void writeStiffness(core::CsvWriter& csv, const std::optional<stiffness::TouchStiffness>& touch) {
    if (!touch) {
        for (int i = 0; i < 10; ++i)
            csv.number(kUnknown);
        return;
    }
    csv.text(stiffness::toString(touch->method));
    csv.integer(static_cast<long long>(touch->samples));
    csv.number(touch->deltaTheta_rad);
    csv.number(touch->deltaTorque_Nm);
    csv.number(touch->total.value_NPerM);
    csv.number(touch->object.value_NPerM);
    csv.number(touch->object.lower95_NPerM);
    csv.number(touch->object.upper95_NPerM);
    csv.text(stiffness::toString(touch->material));
    csv.integer(stiffness::level(touch->material));
}

} // namespace

const std::vector<std::string>& touchColumns() {
    static const std::vector<std::string> columns{"touch",
                                                  "start_s",
                                                  "ready_s",
                                                  "contact_distance_m",
                                                  "side_rad",
                                                  "x_m",
                                                  "y_m",
                                                  "z_m",
                                                  "force_x_n",
                                                  "force_y_n",
                                                  "force_z_n",
                                                  "condition_number",
                                                  "method",
                                                  "samples",
                                                  "delta_theta_rad",
                                                  "delta_torque_nm",
                                                  "total_stiffness_n_per_m",
                                                  "object_stiffness_n_per_m",
                                                  "object_stiffness_lower_95",
                                                  "object_stiffness_upper_95",
                                                  "material",
                                                  "level",
                                                  "true_object",
                                                  "true_stiffness_n_per_m",
                                                  "true_x_m",
                                                  "true_y_m",
                                                  "true_z_m"};
    return columns;
}

core::Expected<void> writeTouches(const std::string& path, const std::vector<ComparedTouch>& touches) {
    const std::vector<std::string_view> columns(touchColumns().begin(), touchColumns().end());
    TELETA_TRY(core::CsvWriter csv, core::CsvWriter::create(path, columns));
    for (const ComparedTouch& touch : touches) {
        const pipeline::TouchRecord& record = touch.record;
        csv.integer(static_cast<long long>(record.number));
        csv.number(record.start_s);
        csv.number(record.ready_s);
        csv.number(record.located ? record.contactDistance_m : kUnknown);
        csv.number(record.located ? record.side_rad : kUnknown);
        for (const double coordinate : record.p_Base_Contact_m)
            csv.number(record.located ? coordinate : kUnknown);
        writeForce(csv, record.force);
        writeStiffness(csv, record.stiffness);
        csv.text(touch.object.empty() ? "NA" : touch.object);
        csv.number(touch.object.empty() ? kUnknown : touch.trueStiffness_NPerM);
        for (const double coordinate : touch.p_Base_Truth_m)
            csv.number(touch.object.empty() ? kUnknown : coordinate);
        csv.endRow();
    }
    return csv.finish();
}

nlohmann::ordered_json touchEvent(const ComparedTouch& touch) {
    nlohmann::ordered_json event{{"time_s", touch.record.ready_s},
                                 {"event", "touch"},
                                 {"touch", touch.record.number},
                                 {"object", touch.object.empty() ? nlohmann::ordered_json(nullptr)
                                                                 : nlohmann::ordered_json(touch.object)}};
    if (!touch.record.stiffness)
        return event;
    const stiffness::TouchStiffness& estimate = *touch.record.stiffness;
    event["object_stiffness_n_per_m"] = orNull(estimate.object.value_NPerM);
    event["object_stiffness_lower_95"] = orNull(estimate.object.lower95_NPerM);
    event["object_stiffness_upper_95"] = orNull(estimate.object.upper95_NPerM);
    event["material"] = stiffness::toString(estimate.material);
    event["safe"] = stiffness::isSafe(estimate.material);
    event["level"] = stiffness::level(estimate.material);
    return event;
}

} // namespace teleta::scene_run
