// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/finders/camera_contact.h"

#include <vector>

namespace teleta::vision {

/// How fast a contact deepens, from its newest sightings that followed one another without a gap. Their
/// depths are summed up from what the same places of the skin did from frame to frame, so it does not matter
/// how late a touch was seen. Any number of the newest sightings may be taken: a slope over few is quick, one
/// over many is sure.
///   rate = sum((t - mean t) d) / sum((t - mean t)^2),   its standard deviation = noise / sqrt(sum((t - mean
///   t)^2))
/// Thread: one.
class DepthRate {
public:
    /// contact: in a frame; time_s: of its capture, rising; framePeriod_s: since the frame before.
    void add(const CameraContact& contact, double time_s, double framePeriod_s);

    /// The rate that is surely there: the highest, over any number of the newest sightings that are 12 ms
    /// or more apart, of a slope less three standard deviations. 0 without two such sightings.
    [[nodiscard]] double atLeast_mPerS() const;

private:
    struct Sighting {
        double time_s = 0.0;
        double depth_m = 0.0; ///< up to a constant
    };
    struct Slope {
        double rate_mPerS = 0.0;
        double sd_mPerS = 0.0;
    };
    /// Through so many of the newest sightings, at least two.
    [[nodiscard]] Slope slope(std::size_t sightings) const;

    std::vector<Sighting> m_sightings; ///< rising time
    double m_lastDepth_m = 0.0;        ///< as it was seen
    double m_noise_m = 0.0;
};

} // namespace teleta::vision
