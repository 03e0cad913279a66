// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/stiffness/touch_warning.h"

namespace teleta::stiffness {

const char* toString(TouchWarning warning) {
    switch (warning) {
    case TouchWarning::correlatedNoise:
        return "correlated_noise";
    case TouchWarning::coarseTorque:
        return "coarse_torque";
    case TouchWarning::coarseAngle:
        return "coarse_angle";
    case TouchWarning::torqueOffset:
        return "torque_offset";
    case TouchWarning::torqueDrift:
        return "torque_drift";
    case TouchWarning::nonlinear:
        return "nonlinear";
    case TouchWarning::rateDependent:
        return "rate_dependent";
    case TouchWarning::stickSlip:
        return "stick_slip";
    }
    return "";
}

const char* toString(ErrorSource source) {
    switch (source) {
    case ErrorSource::noise:
        return "noise";
    case ErrorSource::correlatedNoise:
        return "correlated_noise";
    case ErrorSource::quantization:
        return "quantization";
    case ErrorSource::torqueReference:
        return "torque_reference";
    case ErrorSource::torqueDrift:
        return "torque_drift";
    case ErrorSource::contactDistance:
        return "contact_distance";
    case ErrorSource::linkStiffness:
        return "link_stiffness";
    case ErrorSource::curvature:
        return "curvature";
    case ErrorSource::inertia:
        return "inertia";
    }
    return "";
}

} // namespace teleta::stiffness
