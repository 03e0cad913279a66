// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/scene/scene.h"
#include "backend/simulation/camera/simulated_tube.h"
#include "backend/vision/calibration/camera_calibration.h"
#include "backend/vision/contacts/probe_watcher.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

namespace teleta::scene_run {

/// A person who probes the simulated tube of a scene, and the pairs that are taken from it, frame by frame:
/// contacts are found with the camera as it is designed, one pair a steady touch. Deterministic: same scene,
/// same seed, same pairs. Thread: one.
class SimulatedProbing {
public:
    struct Taken {
        vision::CalibrationPair pair;
        std::size_t hole = 0; ///< of the plan, as the person noted it
    };

    /// Error: badInput: the scene is not valid, or nobody probes in it.
    [[nodiscard]] static core::Expected<std::unique_ptr<SimulatedProbing>> make(const scene::Scene& scene,
                                                                                std::uint64_t seed);

    /// Moves on by one frame; a pair in the frame in which it is taken.
    [[nodiscard]] std::optional<Taken> next();

    [[nodiscard]] simulation::SimulatedTube& tube() { return *m_tube; }
    [[nodiscard]] const simulation::ProbingPlan& plan() const { return *m_tube->probing(); }
    /// What the pairs are to be calibrated with.
    [[nodiscard]] vision::CalibrationSettings settings() const;
    /// The tube with nothing touching it.
    [[nodiscard]] const cv::Mat1b& reference() const { return m_reference; }
    /// Frames in which nothing could be found.
    [[nodiscard]] std::uint64_t unusable() const { return m_watcher->unusable(); }

private:
    SimulatedProbing() = default;

    std::unique_ptr<simulation::SimulatedTube> m_tube;
    std::unique_ptr<vision::ProbeWatcher> m_watcher;
    cv::Mat1b m_reference;
    cv::Mat1b m_frame;
};

} // namespace teleta::scene_run
