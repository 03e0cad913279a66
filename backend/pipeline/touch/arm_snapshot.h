// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/arm_device.h"
#include "backend/pipeline/touch/found_objects.h"
#include "backend/pipeline/touch/touch_estimator.h"
#include "backend/pipeline/touch/touch_record.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace teleta::pipeline {

/// How one arm's samples are turned into touches and a contour; changed while it runs.
struct ArmSettings {
    TouchEstimatorSettings touch;
    ContourSettings contour;
};

/// Time that the stages of the newest batch of samples took, in s.
struct ArmStageTimes {
    double touch_s = 0.0;   ///< the estimator, all samples of the batch
    double contour_s = 0.0; ///< spline and shape, of the newest batch with a located touch
    double queue_s = 0.0;   ///< from the read of the batch's oldest sample to the start of its processing
};

/// What the pipeline knows of one arm after its newest sample. Views get it as a constant and own no truth.
struct ArmSnapshot {
    core::JointSample newest;
    core::ArmDrive drive = core::ArmDrive::held;
    /// Of the first sample since the arm began anew, with a time of its own that ran back: objects and
    /// touches are of what came after it. 0: it has not. A recording that is sought back does not.
    std::int64_t begun_ns = 0;
    JointPhases phases{};
    core::JointVector reference_Nm; ///< torque of each joint without contact
    std::optional<LiveContact> contact;
    std::optional<TouchRecord> lastTouch;
    ExploredContour contour; ///< of the object that was touched last
    std::vector<FoundObject> objects;
    std::uint64_t objectsRevision = 0; ///< grows with each change of the objects
    ArmStageTimes stages;
    std::uint64_t samplesProcessed = 0;
    std::uint64_t samplesLeftOut = 0; ///< not finite
    std::uint64_t touches = 0;
    std::uint64_t touchesTooGentle = 0;
    std::uint64_t touchesByInertia = 0;
};

} // namespace teleta::pipeline
