// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pipeline/touch/touch_record.h"

#include <optional>

namespace teleta::test {

/// A touch whose object has this stiffness and 95 % interval; without an upper end rigid is not excluded.
inline stiffness::TouchStiffness estimateOf(double value_NPerM, double lower_NPerM,
                                            std::optional<double> upper_NPerM) {
    stiffness::TouchStiffness touch;
    touch.samples = 31;
    touch.deltaTheta_rad = 10.82e-4; // rubber sponge (TeleTA, Table 1)
    touch.deltaTorque_Nm = 3.0e-2;
    touch.object.value_NPerM = value_NPerM;
    touch.object.lower95_NPerM = lower_NPerM;
    touch.object.upper95_NPerM = upper_NPerM;
    touch.material = stiffness::classify(value_NPerM);
    touch.materialCertain = stiffness::classify(lower_NPerM) == touch.material && upper_NPerM &&
                            stiffness::classify(*upper_NPerM) == touch.material;
    return touch;
}

/// A touch of something that is not told from rigid.
inline stiffness::TouchStiffness boundOf(double lower_NPerM) {
    stiffness::TouchStiffness touch;
    touch.samples = 31;
    touch.object.lower95_NPerM = lower_NPerM;
    touch.material = stiffness::Material::metal;
    touch.materialCertain = stiffness::classify(lower_NPerM) == stiffness::Material::metal;
    return touch;
}

/// A located touch 2 s after the one before it; the force along x cannot be observed.
inline pipeline::TouchRecord recordOf(std::uint64_t number,
                                      const std::optional<stiffness::TouchStiffness>& stiffness) {
    pipeline::TouchRecord record;
    record.number = number;
    record.start_s = 2.0 * static_cast<double>(number);
    record.ready_s = record.start_s + 0.046;
    record.start_ns = static_cast<std::int64_t>(number) * 2'000'000'000;
    record.ready_ns = record.start_ns + 46'000'000;
    record.joint = 3;
    record.torque_Nm = 0.05;
    record.located = true;
    record.contactDistance_m = 0.17;
    record.p_Base_Contact_m = {0.47, -0.05, -0.012};
    arm::ContactForce force;
    force.force_N = {0.0, -0.35, 1.2};
    force.forceSd_N = {0.0, 0.01, 0.02};
    force.observable = {false, true, true};
    force.observedDirections = 2;
    force.conditionNumber = 12.5;
    record.force = force;
    record.stiffness = stiffness;
    return record;
}

} // namespace teleta::test
