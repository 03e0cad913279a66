// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/stiffness/joint_sample.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace teleta::stiffness {

/// When the torque of a joint counts as contact.
struct DetectionSettings {
    double threshold_Nm = 0.05;    ///< deviation from the reference that is a contact; >= noiseFloor_Nm
    double noiseFloor_Nm = 0.0025; ///< deviation that noise does not reach; default five times 0.5 mNm; > 0
    std::size_t capacity =
        100'000; ///< largest number of samples kept of one transition; further ones are counted
};

enum class ContactPhase {
    free,       ///< within the noise of the reference
    transition, ///< above the noise floor, but not yet a contact
    contact,    ///< has exceeded the threshold and is not yet back within half the noise floor
};

/// Detects contacts of one joint: |torque - reference| above the threshold is a contact. The transition is
/// recorded from the first sample above the noise floor; a rise that falls back below half the floor without
/// reaching the threshold is dropped. Non-finite samples are left out and counted. Invalid settings are
/// replaced: a floor <= 0 by the smallest positive number, a threshold below the floor by the floor. Thread:
/// one; update() allocates nothing. Source: TeleTA, section 2.
class ContactDetector {
public:
    explicit ContactDetector(const DetectionSettings& settings = {});

    /// Takes the next sample and returns the phase after it. reference_Nm: the torque that the joint would
    /// have now without contact.
    ContactPhase update(const JointSample& sample, double reference_Nm = 0.0);

    [[nodiscard]] ContactPhase phase() const { return m_phase; }
    /// Samples since the first one above the noise floor, torques relative to the reference. Kept after the
    /// release until the next rise begins.
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
