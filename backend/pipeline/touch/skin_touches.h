// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/arm_device.h"
#include "backend/pipeline/touch/skin_kinematics.h"
#include "backend/pipeline/touch/touch_estimator.h"
#include "backend/pipeline/touch/touch_record.h"
#include "backend/pipeline/touch/touched_place.h"

#include <cstdint>
#include <memory>
#include <optional>

namespace teleta::pipeline {

/// Whether an arm measures torques at all; a sample may miss some of them none the less.
[[nodiscard]] bool tellsTorques(const core::JointSample& sample);

/// Touches of an arm that measures no torques, as its skin alone tells them: where and of which type, but
/// neither a force nor a stiffness (Refusal::noTorques). A touch begins with the first frame over
/// TouchEstimatorSettings::leastSkinForce_N, is recorded when it has lasted kSettle_s, or when it ends sooner
/// after kLeastFrames frames, and ends when the skin has felt nothing for release_s or has been silent for
/// kSilence_s. Its point is that of the joints at the newest frame in which it was felt. Times are those of
/// the arm's stream, so that a recording has the same touches at each speed.
///
/// A sample with an angle that is not finite, or not of each joint, is left out, and so are contacts before
/// the first sample; a discontinuity or a time that runs back ends a touch without a record. Samples and
/// contacts come in order of time. Thread: one.
class SkinTouches {
public:
    static constexpr double kSettle_s = 0.1;
    static constexpr int kLeastFrames = 2;
    static constexpr double kSilence_s = 0.25;

    /// skin: null: touches have no place, and there are none.
    SkinTouches(std::size_t joints, std::shared_ptr<const SkinKinematics> skin);

    /// A record when this sample, or contact, completes a touch.
    [[nodiscard]] std::optional<TouchRecord> update(const core::JointSample& sample,
                                                    const TouchEstimatorSettings& settings);
    [[nodiscard]] std::optional<TouchRecord> update(const SkinContact& contact,
                                                    const TouchEstimatorSettings& settings);
    [[nodiscard]] std::uint64_t touches() const { return m_touches; } ///< records made
    /// What the skin feels now, without a force; empty when it feels nothing.
    [[nodiscard]] std::optional<LiveContact> liveContact() const;

private:
    struct Touch {
        std::int64_t first_ns = 0;
        double first_s = 0.0;
        std::optional<double> left_s; ///< the first frame in which it was felt no more
        int frames = 0;
        bool recorded = false;
        core::JointSample pose; ///< newest in which it was felt
        std::optional<TouchedPlace> place;
    };

    [[nodiscard]] std::optional<TouchRecord> advance(double release_s);
    [[nodiscard]] TouchRecord makeRecord();

    std::size_t m_joints;
    std::shared_ptr<const SkinKinematics> m_skinAt;
    std::optional<core::JointSample> m_newest;
    std::optional<SkinContact> m_skin; ///< newest contact; empty while the skin feels nothing
    double m_felt_s = 0.0;             ///< of m_skin
    std::optional<Touch> m_touch;
    std::uint64_t m_touches = 0;
};

} // namespace teleta::pipeline
