// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pipeline/touch/touch_estimator.h"
#include "tests/backend/pipeline/scripted_arm.h"

#include <cmath>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace teleta::test {

/// Runs an arm and its skin (200 Hz) through the estimator.
class TouchRun {
public:
    explicit TouchRun(ScriptedArm touched, pipeline::TouchEstimatorSettings settings = withoutInertia())
        : arm(std::move(touched))
        , estimator(paperArm(), settings) {}

    /// The scripted arm has none, so that its touches may be as quick as they like.
    static pipeline::TouchEstimatorSettings withoutInertia() {
        pipeline::TouchEstimatorSettings settings;
        settings.leastRise_s = 0.0;
        return settings;
    }

    /// The elbow's torque goes linearly from where it is to this one.
    void elbowTo(double torque_Nm, int samples) {
        const double from_Nm = m_elbow_Nm;
        for (int i = 1; i <= samples; ++i) {
            m_elbow_Nm = from_Nm + (torque_Nm - from_Nm) * i / samples;
            step(arm.forceFor_N(m_elbow_Nm));
        }
    }
    void forceTo(double force_N, int samples) {
        const double from_N = m_force_N;
        for (int i = 1; i <= samples; ++i)
            step(from_N + (force_N - from_N) * i / samples);
    }
    void step(double force_N) {
        m_force_N = force_N;
        core::JointSample sample = arm.next(force_N);
        if (corrupt)
            corrupt(sample);
        keep(estimator.update(sample));
        if (skinWorks && ++m_samples % 5 == 0) {
            // Below 0.05 N no taxel fires.
            keep(estimator.update(arm.skin(std::abs(force_N) > 0.05 ? std::abs(force_N) : 0.0)));
        }
    }
    void idle(int samples) {
        for (int i = 0; i < samples; ++i)
            step(0.0);
        m_elbow_Nm = 0.0;
    }

    ScriptedArm arm;
    pipeline::TouchEstimator estimator;
    bool skinWorks = true;
    std::function<void(core::JointSample&)> corrupt;
    std::vector<pipeline::TouchRecord> records;

private:
    void keep(std::optional<pipeline::TouchRecord> record) {
        if (record)
            records.push_back(*record);
    }

    double m_elbow_Nm = 0.0;
    double m_force_N = 0.0;
    int m_samples = 0;
};

} // namespace teleta::test
