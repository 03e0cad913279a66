// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/finders/camera_contact.h"

#include <Eigen/Core>

#include <deque>
#include <optional>
#include <span>

namespace teleta::vision {

/// Watches a probe touching the skin and takes one pixel per touch: the mean centre once the contact has been
/// steady for a while. The next pixel is taken only after the probe was lifted. Thread: one. Source: VTacArm,
/// section III-B.
class PairCollector {
public:
    struct Settings {
        double steady_s = 0.3;         ///< how long the contact must be steady; > 0
        double steady_px = 1.5;        ///< how far the centre may move meanwhile; > 0
        double steadyDepth_m = 0.0002; ///< how far the depth may change meanwhile; > 0
        double secondShare =
            0.5; ///< a second contact deeper than this share of the deepest one prevents taking a pixel
        double leastDepth_m = 0.00015; ///< a lighter touch has no exact centre; one of less than half of this
                                       ///< does not count as a touch
    };
    enum class Phase {
        free,     ///< nothing touches
        touching, ///< not yet steady or deep enough
        several,  ///< more than one contact, so that the probe cannot be identified
        taken,    ///< the pixel was taken; the probe has to be lifted
        refused,  ///< the current touch does not count; the probe has to be lifted
    };

    PairCollector() = default;
    explicit PairCollector(const Settings& settings)
        : m_settings(settings) {}

    /// Takes the contacts of the next frame in any order. time_s: time of capture, rising. Returns the pixel
    /// in the frame in which it is taken.
    [[nodiscard]] std::optional<Eigen::Vector2d> next(std::span<const CameraContact> contacts, double time_s);
    /// To be called for an unusable frame: the contact must be steady anew.
    void skip() { m_touch.clear(); }
    /// The current touch does not count; the probe has to be lifted first.
    void awaitLift() {
        m_touch.clear();
        m_phase = Phase::refused;
    }

    [[nodiscard]] Phase phase() const { return m_phase; }
    /// Share of steady_s that has passed, 0 .. 1.
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
    std::deque<Sample> m_touch; ///< of the current contact while it is steady
};

} // namespace teleta::vision
