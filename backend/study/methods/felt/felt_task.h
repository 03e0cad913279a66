// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/bracelet/tactors.h"
#include "backend/pattern/model/pattern.h"
#include "backend/pattern/motors/motor_model.h"
#include "backend/study/protocol/protocol.h"

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace teleta::study {

/// Where and how the levels of a task are felt.
struct FeltTask {
    struct Track {
        std::vector<std::size_t> tactors;   ///< from 0
        std::vector<std::size_t> reference; ///< where the reference is felt
    };

    std::string task;
    Design design = Design::interval;
    Vary vary = Vary::intensity;
    std::map<std::string, Track> tracks; ///< by id
    double strongest = 1.0;              ///< intensity of the stimulus at its strongest, 0 .. 1
    std::optional<double> burst_s;       ///< of its only sweep
};

/// stimulus: of the task, which has levels. Thread: any (pure).
[[nodiscard]] FeltTask feltTask(const StudyTask& task, const pattern::Pattern& stimulus);

/// What motors do at an intensity, means over several.
struct MotorStrength {
    double speed_Hz = 0.0; ///< steady
    double force = 0.0;    ///< square of the speed over that at full drive, 0 .. 1
};

/// Empty without tactors, where the curve of one of them is assumed and not measured, and for an intensity
/// outside 0 .. 1. motors: valid(). Thread: any (pure).
[[nodiscard]] std::optional<MotorStrength>
motorStrength(const pattern::MotorProfiles& motors, std::span<const std::size_t> tactors, double intensity);

} // namespace teleta::study
