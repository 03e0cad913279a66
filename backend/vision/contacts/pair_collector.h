// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/finders/camera_contact.h"

#include <Eigen/Core>

#include <deque>
#include <optional>
#include <span>

namespace teleta::vision {

/// Watches a probe touch the skin and takes one pixel a touch: the mean centre once the contact has been
/// steady for a while. The next one is taken only after the probe was lifted. Thread: one.
/// Source: VTacArm, section III-B.
class PairCollector {
public:
    struct Settings {
        double steady_s = 0.3;         ///< how long; > 0
        double steady_px = 1.5;        ///< how far the centre may wander meanwhile; > 0
        double steadyDepth_m = 0.0002; ///< how far the depth; > 0
        double secondShare = 0.5; ///< of the deepest contact's depth: a second one that is as deep disturbs
        double leastDepth_m = 0.00015; ///< a lighter touch has no exact centre, one half as deep is none
    };
    enum class Phase {
        free,     ///< nothing touches
        touching, ///< not steady, or not deep enough yet
        several,  ///< more than one contact: which one is the probe?
        taken,    ///< the pixel was taken; lift the probe
        refused,  ///< the touch that goes on does not count; lift the probe
    };

    PairCollector() = default;
    explicit PairCollector(const Settings& settings)
        : m_settings(settings) {}

    /// contacts: of the next frame, in any order; time_s: of its capture, rising. Returns the pixel in the
    /// frame in which it is taken.
    [[nodiscard]] std::optional<Eigen::Vector2d> next(std::span<const CameraContact> contacts, double time_s);
    /// A frame that cannot be used: what was steady so far does not count.
    void skip() { m_touch.clear(); }
    /// A touch that goes on now does not count: the probe has to be lifted first.
    void awaitLift() {
        m_touch.clear();
        m_phase = Phase::refused;
    }

    [[nodiscard]] Phase phase() const { return m_phase; }
    /// How much of the time for which the contact must be steady has passed, 0 .. 1.
    [[nodiscard]] double progress() const;

private:
    struct Sample {
        double time_s = 0.0;
        Eigen::Vector2d pixel;
        double depth_m = 0.0;
    };
    [[nodiscard]] bool wanders(const Sample& sample) const;

    Settings m_settings;
    Phase m_phase = Phase::free;
    std::deque<Sample> m_touch; ///< of the contact as it is now, while it is steady
};

} // namespace teleta::vision
