// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene_run/arm_evaluation.h"

#include "backend/scene_run/scene_settings.h"

#include <array>
#include <string_view>
#include <utility>
#include <variant>

namespace teleta::scene_run {

core::Expected<JointLog> JointLog::open(const std::string& outFolder) {
    constexpr std::array<std::string_view, 13> kColumns{
        "time_s", "q1", "q2", "q3", "q4", "tau1", "tau2", "tau3", "tau4", "ref1", "ref2", "ref3", "ref4"};
    JointLog log;
    if (outFolder.empty())
        return log;
    core::Expected<core::CsvWriter> csv = core::CsvWriter::create(outFolder + "/joints.csv", kColumns);
    if (!csv)
        return core::Unexpected(csv.error());
    log.m_csv = std::move(*csv);
    return log;
}

void JointLog::add(const core::JointSample& sample) {
    if (!m_csv)
        return;
    m_csv->number(sample.sourceTime_s);
    for (const core::JointArray* values : {&sample.angle_rad, &sample.torque_Nm, &sample.reference_rad})
        for (const double value : *values)
            m_csv->number(value);
    m_csv->endRow();
}

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
