// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/stiffness/joint_sample.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace teleta::stiffness {

/// When the torque of a joint means contact.
struct DetectionSettings {
    double threshold_Nm = 0.05;     ///< deviation from the reference that is a contact; >= noiseFloor_Nm
    double noiseFloor_Nm = 0.0025;  ///< deviation that noise does not reach: five times 0.5 mNm; > 0
    std::size_t capacity = 100'000; ///< samples of one transition that are kept; the rest is counted
};

enum class ContactPhase {
    free,       ///< within the noise of the reference
    transition, ///< over the noise floor, not yet a contact
    contact,    ///< over the threshold since, and not yet back within half the noise floor
};

/// Watches one joint: |torque - reference| over the threshold is a contact. The transition is recorded from
/// the first sample over the noise floor; a rise that falls back below half the floor was none. A sample that
/// is not finite is left out and counted. Settings that are not valid are replaced: a floor <= 0 by the
/// smallest positive number, a threshold under the floor by the floor. Thread: one; update() allocates
/// nothing. Source: TeleTA, section 2.
class ContactDetector {
public:
    explicit ContactDetector(const DetectionSettings& settings = {});

    /// reference_Nm: torque that the joint would have without contact at this moment. Returns the phase with
    /// this sample.
    ContactPhase update(const JointSample& sample, double reference_Nm = 0.0);

    [[nodiscard]] ContactPhase phase() const { return m_phase; }
    /// Samples since the first over the noise floor, torques relative to the reference. It is kept after the
    /// release, until the next rise begins.
    [[nodiscard]] std::span<const JointSample> transition() const { return m_transition; }
    [[nodiscard]] std::uint64_t samplesLeftOut() const { return m_leftOut; } ///< not finite
    [[nodiscard]] std::uint64_t samplesBeyondCapacity() const { return m_beyondCapacity; }
    void reset();

private:
    DetectionSettings m_settings;
    ContactPhase m_phase = ContactPhase::free;
    std::vector<JointSample> m_transition;
    std::uint64_t m_leftOut = 0;
    std::uint64_t m_beyondCapacity = 0;
};

} // namespace teleta::stiffness
