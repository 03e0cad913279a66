// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene_run/arm/arm_evaluation.h"

#include "backend/scene_run/base/scene_settings.h"
#include "backend/scene_run/base/scene_summary.h"

#include <variant>

namespace teleta::scene_run {

SkinReader::SkinReader(const scene::Scene& scene)
    : m_conditioner(scene.arm().skin.layout.taxels(), {})
    , m_segmenter(scene.arm().skin.layout, channelSettings(scene).segmentation)
    , m_features(scene.arm().skin.layout, channelSettings(scene).features)
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

void reportContacts(const std::vector<ComparedTouch>& touches, nlohmann::ordered_json& measures) {
    std::vector<double> errors_m;
    for (const ComparedTouch& touch : touches)
        if (touch.record.located && !touch.object.empty())
            errors_m.push_back((touch.record.p_Base_Contact_m - touch.p_Base_Truth_m).norm());
    const ErrorStatistics errors = errorStatistics(errors_m);
    measures["contact_error_mean_m"] = errors.mean;
    measures["contact_error_p95_m"] = errors.p95;
    measures["first_contact_s"] =
        touches.empty() ? nlohmann::ordered_json(nullptr) : jsonNumber(touches.front().record.start_s);
}

const char* trueShape(const scene::Outline& outline) {
    struct Name {
        const char* operator()(const scene::RoundOutline&) const { return "circle"; }
        const char* operator()(const scene::RectangleOutline&) const { return "rectangle"; }
        const char* operator()(const scene::TriangleOutline&) const { return "triangle"; }
        const char* operator()(const scene::WallOutline&) const { return "line"; }
    };
    return std::visit(Name(), outline);
}

nlohmann::ordered_json oneOrList(const std::vector<nlohmann::ordered_json>& values) {
    return values.size() == 1 ? values.front() : nlohmann::ordered_json(values);
}

} // namespace teleta::scene_run
