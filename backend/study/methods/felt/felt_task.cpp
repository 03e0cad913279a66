// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/methods/felt/felt_task.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

namespace teleta::study {

namespace {

constexpr int kSamples = 400;

struct StimulusFacts {
    std::vector<std::size_t> tactors;
    double strongest = 0.0;
};

/// Sampled, since tracks, objects and strokes may overlap.
StimulusFacts factsOf(const pattern::Pattern& stimulus) {
    StimulusFacts facts;
    std::array<bool, core::kTactors> used{};
    for (int i = 0; i < kSamples; ++i) {
        const core::Intensities now = pattern::evaluate(stimulus, stimulus.duration_s * (i + 0.5) / kSamples);
        for (std::size_t tactor = 0; tactor < core::kTactors; ++tactor) {
            used[tactor] = used[tactor] || now[tactor] > 0.0;
            facts.strongest = std::max(facts.strongest, now[tactor]);
        }
    }
    for (std::size_t tactor = 0; tactor < core::kTactors; ++tactor) {
        if (used[tactor])
            facts.tactors.push_back(tactor);
    }
    return facts;
}

} // namespace

FeltTask feltTask(const StudyTask& task, const pattern::Pattern& stimulus) {
    const StimulusFacts facts = factsOf(stimulus);
    FeltTask felt{task.id, task.design, task.levels.vary, {}, facts.strongest, {}};
    for (const LevelTrack& track : task.levels.tracks) {
        FeltTask::Track& one = felt.tracks[track.id];
        one.tactors = track.tactors.empty() ? facts.tactors : track.tactors;
        one.reference = track.reference.empty() ? one.tactors : track.reference;
    }
    std::size_t sweeps = 0;
    for (const pattern::PatternObject& object : stimulus.objects) {
        if (const auto* sweep = std::get_if<pattern::Sweep>(&object.form)) {
            felt.burst_s = sweep->burst_s;
            ++sweeps;
        }
    }
    if (sweeps != 1)
        felt.burst_s.reset();
    return felt;
}

std::optional<MotorStrength> motorStrength(const pattern::MotorProfiles& motors,
                                           std::span<const std::size_t> tactors, double intensity) {
    if (tactors.empty() || !(intensity >= 0.0 && intensity <= 1.0))
        return std::nullopt;
    MotorStrength strength;
    for (const std::size_t tactor : tactors) {
        const pattern::MotorProfile& motor = motors[tactor];
        if (motor.assumed)
            return std::nullopt;
        const double speed_Hz = pattern::steadySpeed_Hz(motor, pattern::driveOf(motor, intensity));
        const double share = speed_Hz / pattern::steadySpeed_Hz(motor, motor.fullDrive);
        strength.speed_Hz += speed_Hz / static_cast<double>(tactors.size());
        strength.force += share * share / static_cast<double>(tactors.size());
    }
    return strength;
}

} // namespace teleta::study
