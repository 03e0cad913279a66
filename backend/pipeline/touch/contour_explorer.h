// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contour/shape_recogniser.h"
#include "backend/pipeline/touch/touch_record.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace teleta::pipeline {

struct ContourSettings {
    contour::RecognitionSettings recognition;
    std::size_t maximumPoints = 360; ///< the oldest are forgotten beyond; >= 1
    int samplesPerSegment = 12;      ///< of the sampled curve; >= 1
};

/// Collects the contact points of successive touches and tells the shape that they outline: an interpolating
/// spline, closed when the contour comes back to its start, the recognised shape and the mean height. Each
/// touch counts, also one where the object was touched before. Fewer than
/// ExploredContour::kLeastPoints touches tell no shape: one is on every object, and two are on a line.
/// An object is called a point after ExploredContour::kLeastOfAPoint touches in one place.
/// Thread: one; about a millisecond for 60 points. Source: TeleTA, section 3.
class ContourExplorer {
public:
    explicit ContourExplorer(const ContourSettings& settings = {});

    /// False, and nothing changes, when a coordinate is not finite or beyond contour::kMaximumCoordinate_m.
    bool add(const Eigen::Vector3d& p_Base_Contact_m);
    /// The same points, seen with other settings.
    void setSettings(const ContourSettings& settings);
    /// Forgets the points; the revision grows as with every change, unless there was nothing to forget.
    void reset();

    [[nodiscard]] const ExploredContour& contour() const { return m_contour; }

private:
    void recompute();
    void sampleCurve(bool closed);

    ContourSettings m_settings;
    ExploredContour m_contour;
    std::vector<double> m_heights_m; ///< one a point
};

} // namespace teleta::pipeline
