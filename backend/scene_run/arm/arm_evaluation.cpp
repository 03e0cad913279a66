// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene_run/arm/arm_evaluation.h"

#include "backend/pipeline/touch/skin_contact.h"
#include "backend/scene_run/base/run_csv.h"
#include "backend/scene_run/base/scene_settings.h"
#include "backend/scene_run/base/scene_summary.h"

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>
#include <variant>

namespace teleta::scene_run {

namespace {

using nlohmann::ordered_json;

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

constexpr std::string_view kTouchColumns =
    "touch,start_s,ready_s,contact_distance_m,side_rad,x_m,y_m,z_m,force_x_n,force_y_n,force_z_n,"
    "condition_number,method,samples,delta_theta_rad,delta_torque_nm,total_stiffness_n_per_m,"
    "object_stiffness_n_per_m,object_stiffness_lower_95,object_stiffness_upper_95,material,level,reliable,"
    "warnings,"
    "true_object,true_stiffness_n_per_m,true_x_m,true_y_m,true_z_m";

/// Separated by spaces; nothing: there is none.
std::optional<std::string> warningsOf(const stiffness::TouchStiffness& touch) {
    std::string text;
    for (const stiffness::TouchWarning warning : touch.warnings)
        text += (text.empty() ? "" : " ") + std::string(stiffness::toString(warning));
    return valueIf(!text.empty(), text);
}

/// The observed components and the condition number; an infinite one, too, is not available.
std::array<double, 4> forceColumns(const std::optional<arm::ContactForce>& force) {
    std::array<double, 4> columns{kUnknown, kUnknown, kUnknown, kUnknown};
    if (!force)
        return columns;
    for (std::size_t i = 0; i < 3; ++i)
        if (force->observable[i])
            columns[i] = force->force_N[static_cast<Eigen::Index>(i)];
    if (std::isfinite(force->conditionNumber))
        columns[3] = force->conditionNumber;
    return columns;
}

} // namespace

SkinReader::SkinReader(const scene::Scene& scene)
    : m_conditioner(scene.arm().skin.layout.taxels(), {})
    , m_segmenter(scene.arm().skin.layout, channelSettings(scene).segmentation)
    , m_features(scene.arm().skin.layout, channelSettings(scene).features)
    , m_layout(scene.arm().skin.layout)
    , m_load_N(scene.arm().skin.layout.taxels())
    , m_dead(scene.arm().skin.layout.taxels()) {
}

pipeline::SkinContact SkinReader::read(std::span<const float> values, const core::JointSample& sample) {
    m_conditioner.apply(values, m_load_N, m_dead);
    const auto found = m_segmenter.segment(m_load_N, m_dead);
    pipeline::SkinContact contact;
    contact.time_ns = sample.time_ns;
    contact.sourceTime_s = sample.sourceTime_s;
    if (found.empty())
        return contact;
    contact.touching = true;
    contact.x_m = found.front().x_m;
    contact.y_m = found.front().y_m;
    contact.force_N = found.front().force_N;
    contact.type = m_features.compute(m_load_N, m_dead).type;
    pipeline::setPlaceErrors(contact, found.front(), m_layout, m_segmenter.settings().threshold_N);
    return contact;
}

ComparedTouch compared(const pipeline::TouchRecord& record, const simulation::SimulatedArm& arm) {
    ComparedTouch touch;
    touch.record = record;
    const auto& truths = arm.truth().touches;
    for (auto truth = truths.rbegin(); truth != truths.rend(); ++truth) {
        if (truth->begin_s > record.ready_s)
            continue;
        const simulation::ArmObjectTruth& object = arm.objects()[truth->object];
        touch.object = object.name;
        touch.trueStiffness_NPerM = object.stiffness_NPerM;
        touch.p_Base_Truth_m = truth->strongest.p_Base_Contact_m;
        break;
    }
    return touch;
}

core::Expected<void> writeTouches(const std::string& outFolder, const std::vector<ComparedTouch>& touches) {
    TELETA_TRY(RunCsv csv, RunCsv::open(outFolder, "touches.csv", kTouchColumns));
    for (const ComparedTouch& touch : touches) {
        const pipeline::TouchRecord& record = touch.record;
        const bool located = record.located;
        const bool estimated = record.stiffness.has_value();
        const stiffness::TouchStiffness found = record.stiffness.value_or(stiffness::TouchStiffness{});
        const bool classified = estimated && found.materialKnown();
        const bool known = !touch.object.empty();
        const Eigen::Vector3d unknown_m = Eigen::Vector3d::Constant(kUnknown);
        csv.row(record.number, record.start_s, record.ready_s, valueIf(located, record.contactDistance_m),
                valueIf(located, record.side_rad), located ? record.p_Base_Contact_m : unknown_m,
                forceColumns(record.force), valueIf(estimated, stiffness::toString(found.method)),
                valueIf(estimated, found.samples), valueIf(estimated, found.deltaTheta_rad),
                valueIf(estimated, found.deltaTorque_Nm), found.total.value_NPerM, found.object.value_NPerM,
                found.object.lower95_NPerM, found.object.upper95_NPerM,
                valueIf(classified, stiffness::toString(found.material)),
                valueIf(classified, stiffness::level(found.material)),
                valueIf(estimated, found.reliable ? "true" : "false"), warningsOf(found),
                valueIf(known, touch.object), valueIf(known, touch.trueStiffness_NPerM),
                known ? touch.p_Base_Truth_m : unknown_m);
    }
    return csv.finish();
}

ordered_json touchEvent(const ComparedTouch& touch) {
    ordered_json event{{"time_s", touch.record.ready_s},
                       {"event", "touch"},
                       {"touch", touch.record.number},
                       {"object", touch.object.empty() ? ordered_json() : ordered_json(touch.object)}};
    if (touch.record.refusal)
        event["refusal"] = stiffness::toString(*touch.record.refusal);
    if (!touch.record.stiffness)
        return event;
    const stiffness::TouchStiffness& estimate = *touch.record.stiffness;
    event["object_stiffness_n_per_m"] = orNull(estimate.object.value_NPerM);
    event["object_stiffness_lower_95"] = orNull(estimate.object.lower95_NPerM);
    event["object_stiffness_upper_95"] = orNull(estimate.object.upper95_NPerM);
    const bool known = estimate.materialKnown();
    event["material"] = known ? ordered_json(stiffness::toString(estimate.material)) : nullptr;
    event["safe"] = known ? ordered_json(stiffness::isSafe(estimate.material)) : nullptr;
    event["level"] = known ? ordered_json(stiffness::level(estimate.material)) : nullptr;
    event["reliable"] = estimate.reliable;
    event["warnings"] = ordered_json::array();
    for (const stiffness::TouchWarning warning : estimate.warnings)
        event["warnings"].push_back(stiffness::toString(warning));
    return event;
}

void reportContacts(const std::vector<ComparedTouch>& touches, ordered_json& measures) {
    std::vector<double> errors_m;
    for (const ComparedTouch& touch : touches)
        if (touch.record.located && !touch.object.empty())
            errors_m.push_back((touch.record.p_Base_Contact_m - touch.p_Base_Truth_m).norm());
    reportContactErrors(errors_m, measures);
    measures["first_contact_s"] =
        touches.empty() ? ordered_json() : jsonNumber(touches.front().record.start_s);
}

void reportStiffnessCovered(const std::vector<ComparedTouch>& touches, nlohmann::ordered_json& measures) {
    int known = 0;
    int covered = 0;
    std::vector<double> errors;
    for (const ComparedTouch& touch : touches) {
        if (touch.object.empty() || !touch.record.stiffness || !touch.record.stiffness->reliable ||
            !touch.record.stiffness->object.lower95_NPerM)
            continue;
        const stiffness::Stiffness& object = touch.record.stiffness->object;
        ++known;
        covered += *object.lower95_NPerM <= touch.trueStiffness_NPerM &&
                           (!object.upper95_NPerM || touch.trueStiffness_NPerM <= *object.upper95_NPerM)
                       ? 1
                       : 0;
        if (object.value_NPerM)
            errors.push_back(std::abs(*object.value_NPerM / touch.trueStiffness_NPerM - 1.0));
    }
    measures["stiffness_error_mean"] = jsonNumber(mean(errors));
    measures["stiffness_covered"] = orNull(valueIf(known > 0, static_cast<double>(covered) / known));
}

const char* trueShape(const scene::Outline& outline) {
    constexpr std::array kNames{"circle", "rectangle", "triangle", "line"};
    static_assert(kNames.size() == std::variant_size_v<scene::Outline>);
    return kNames[outline.index()];
}

ordered_json oneOrList(const std::vector<ordered_json>& values) {
    return values.size() == 1 ? values.front() : ordered_json(values);
}

} // namespace teleta::scene_run
