// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/bracelet/tactors.h"
#include "backend/pattern/model/pattern.h"
#include "backend/pattern/motors/motor_model.h"
#include "backend/study/session/study_scene.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace teleta::scene_run {

/// Computing time of effects, by their names; ns.
using EffectTimes = std::map<std::string, std::int64_t>;

/// The bracelet of a study's scene: computes, frame by frame, how the motors follow a stimulus. Without
/// effects they follow at once. Thread: one.
class StimulusBracelet {
public:
    /// times_ns: to which the computing time of its effects is added.
    StimulusBracelet(const study::StudyScene& scene, EffectTimes& times_ns);

    struct Shown {
        std::size_t frames = 0;
        std::size_t lost = 0;
    };
    /// Plays at most atMost_s of the pattern. seed: answerSeed() of the trial, for lost frames if the scene
    /// has them.
    Shown show(const pattern::Pattern& pattern, double atMost_s, std::uint64_t seed);

    /// Time from the first frame of each stimulus until a motor has reached half of its command.
    [[nodiscard]] const std::vector<double>& onsets_s() const { return m_onsets_s; }
    /// Between commanded and felt intensities; empty before the first frame.
    [[nodiscard]] std::optional<double> rmsError() const;

private:
    const study::StudyScene& m_scene;
    EffectTimes& m_times_ns;
    pattern::MotorProfile m_motor;
    std::vector<double> m_onsets_s;
    double m_squares = 0.0;
    std::size_t m_values = 0;
};

} // namespace teleta::scene_run
