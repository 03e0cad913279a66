// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/finders/camera_contact.h"

#include <vector>

namespace teleta::vision {

/// Estimates how fast a contact deepens from its newest sightings without a gap. Depths are accumulated from
/// the motion of the same places of the skin from frame to frame, so it does not matter how late a touch was
/// first seen. The slope is computed over any number of the newest sightings: over few it is fast, over many
/// it is certain.
///   rate = sum((t - mean t) d) / sum((t - mean t)^2),   its standard deviation = noise / sqrt(sum((t - mean
///   t)^2))
/// Thread: one.
class DepthRate {
public:
    /// Adds a sighting. time_s: time of capture, rising; framePeriod_s: time since the previous frame, > 0.
    void add(const CameraContact& contact, double time_s, double framePeriod_s);

    /// A certain lower bound of the rate: the maximum, over all numbers of newest sightings that span at
    /// least 12 ms, of the slope minus three standard deviations. 0 without two such sightings.
    [[nodiscard]] double atLeast_mPerS() const;

private:
    struct Sighting {
        double time_s = 0.0;
        double depth_m = 0.0; ///< relative to an arbitrary origin
    };
    struct Slope {
        double rate_mPerS = 0.0;
        double sd_mPerS = 0.0;
    };
    /// Slope through this number of the newest sightings, at least two.
    [[nodiscard]] Slope slope(std::size_t sightings) const;

    std::vector<Sighting> m_sightings; ///< rising time
    double m_lastDepth_m = 0.0;        ///< as seen
    double m_noise_m = 0.0;
};

} // namespace teleta::vision
