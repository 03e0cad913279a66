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

/// The bracelet of a study's scene: computes, frame by frame, how the motors follow a stimulus. Without
/// effects they follow at once. Thread: one.
class StimulusBracelet {
public:
    explicit StimulusBracelet(const study::StudyScene& scene);

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
    /// Computing time of an effect.
    [[nodiscard]] double time_s(const std::string& effect) const;

private:
    const study::StudyScene& m_scene;
    pattern::MotorProfile m_motor;
    std::vector<double> m_onsets_s;
    double m_squares = 0.0;
    std::size_t m_values = 0;
    std::map<std::string, std::int64_t> m_times_ns;
};

} // namespace teleta::scene_run
