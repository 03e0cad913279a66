// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene_run/arm/arm_logs.h"

#include <array>
#include <string_view>
#include <utility>

namespace teleta::scene_run {

core::Expected<ArmLogs> ArmLogs::open(const RunOptions& options, const scene::Scene& scene,
                                      const core::ArmGenerator& arm) {
    constexpr std::array<std::string_view, 13> kColumns{
        "time_s", "q1", "q2", "q3", "q4", "tau1", "tau2", "tau3", "tau4", "ref1", "ref2", "ref3", "ref4"};
    ArmLogs logs;
    if (!options.outFolder.empty()) {
        TELETA_TRY(auto joints, core::CsvWriter::create(options.outFolder + "/joints.csv", kColumns));
        logs.m_joints = std::move(joints);
    }
    const core::SourceDescription skin = arm.skinDescription();
    TELETA_TRY(auto frames, FrameLog::open(options.outFolder, skin.layout.taxels()));
    logs.m_skin = std::move(frames);
    TELETA_TRY(auto recording, SceneRecording::open(options, scene));
    logs.m_recording = std::move(recording);
    logs.m_recording.beginArray(skin, scene);
    logs.m_recording.beginArm(arm.description());
    return logs;
}

void ArmLogs::add(const core::JointSample& sample) {
    m_recording.addJoints(sample);
    if (!m_joints)
        return;
    m_joints->number(sample.sourceTime_s);
    for (const core::JointVector* values : {&sample.angle_rad, &sample.torque_Nm, &sample.reference_rad})
        for (const double value : *values)
            m_joints->number(value);
    m_joints->endRow();
}

void ArmLogs::addFrame(double time_s, std::span<const float> values) {
    ++m_frames;
    m_skin.add(time_s, values);
    m_recording.addFrame(time_s, values);
}

core::Expected<void> ArmLogs::finish() {
    for (core::Expected<void> written :
         {m_joints ? m_joints->finish() : core::Expected<void>(), m_skin.finish(), m_recording.finish()})
        if (!written)
            return written;
    return {};
}

} // namespace teleta::scene_run
