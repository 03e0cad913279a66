// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene_run/arm/arm_logs.h"

namespace teleta::scene_run {

core::Expected<ArmLogs> ArmLogs::open(const RunOptions& options, const scene::Scene& scene,
                                      const core::ArmGenerator& arm) {
    ArmLogs logs;
    TELETA_TRY(logs.m_joints, RunCsv::open(options.outFolder, "joints.csv",
                                           "time_s,q1,q2,q3,q4,tau1,tau2,tau3,tau4,ref1,ref2,ref3,ref4"));
    const core::SourceDescription skin = arm.skinDescription();
    TELETA_TRY(logs.m_skin, RunCsv::openFrames(options.outFolder, skin.layout.taxels()));
    TELETA_TRY(logs.m_recording, SceneRecording::open(options, scene));
    logs.m_recording.beginArray(skin, scene);
    logs.m_recording.beginArm(arm.description());
    return logs;
}

void ArmLogs::add(const core::JointSample& sample) {
    m_recording.addJoints(sample);
    m_joints.row(sample.sourceTime_s, sample.angle_rad, sample.torque_Nm, sample.reference_rad);
}

void ArmLogs::addFrame(double time_s, std::span<const float> values) {
    ++m_frames;
    m_skin.row(time_s, values);
    m_recording.addFrame(time_s, values);
}

core::Expected<void> ArmLogs::finish() {
    for (const core::Expected<void>& written : {m_joints.finish(), m_skin.finish(), m_recording.finish()})
        TELETA_CHECK(written);
    return {};
}

} // namespace teleta::scene_run
