// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/base/array_input.h"
#include "app/python/base/array_output.h"
#include "app/python/core/core_bindings.h"
#include "backend/stiffness/stiffness_estimator.h"

#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace teleta::python {

namespace {

using stiffness::Refusal;
using stiffness::TouchStiffness;

py::dict toDict(const stiffness::Interval95& interval) {
    py::dict fields;
    fields["value"] = interval.value;
    fields["lower_95"] = interval.lower;
    fields["upper_95"] = interval.upper;
    return fields;
}

/// The keys of `teleta stiffness --json`.
py::dict toDict(const TouchStiffness& touch) {
    py::list warnings;
    for (const stiffness::TouchWarning warning : touch.warnings)
        warnings.append(stiffness::toString(warning));
    py::list budget;
    for (const stiffness::ErrorShare& part : touch.errorBudget)
        budget.append(py::make_tuple(stiffness::toString(part.source), part.share));
    py::dict fields;
    fields["method"] = stiffness::toString(touch.method);
    fields["samples"] = touch.samples;
    fields["delta_theta_rad"] = touch.deltaTheta_rad;
    fields["delta_torque_nm"] = touch.deltaTorque_Nm;
    fields["total_stiffness_n_per_m"] = orNone(touch.total.value_NPerM);
    fields["total_stiffness_se"] = orNone(touch.total.se_NPerM);
    fields["object_stiffness_n_per_m"] = orNone(touch.object.value_NPerM);
    fields["object_stiffness_lower_95"] = orNone(touch.object.lower95_NPerM);
    fields["object_stiffness_upper_95"] = orNone(touch.object.upper95_NPerM);
    const bool known = touch.materialKnown();
    fields["material"] = known ? py::object(py::str(stiffness::toString(touch.material))) : py::none();
    fields["safe"] = known ? py::object(py::bool_(stiffness::isSafe(touch.material))) : py::none();
    fields["level"] = known ? py::object(py::int_(stiffness::level(touch.material))) : py::none();
    fields["reliable"] = touch.reliable;
    fields["warnings"] = py::tuple(warnings);
    fields["error_budget"] = py::tuple(budget);
    fields["effective_samples"] = touch.effectiveSamples;
    fields["torque_reference_nm"] = touch.torqueReference_Nm;
    fields["torque_drift_nm_per_s"] = touch.torqueDrift_NmPerS;
    fields["tangent_stiffness_n_per_m"] = orNone(touch.tangent_NPerM);
    fields["secant_stiffness_n_per_m"] = orNone(touch.secant_NPerM);
    if (touch.solid) {
        py::dict solid;
        solid["static_stiffness_n_per_m"] = toDict(touch.solid->static_NPerM);
        solid["ratio"] = toDict(touch.solid->ratio);
        solid["relaxation_s"] = toDict(touch.solid->relaxation_s);
        fields["standard_linear_solid"] = solid;
    } else {
        fields["standard_linear_solid"] = py::none();
    }
    return fields;
}

core::Error explain(Refusal refusal) {
    const auto refused = [](const char* message, const char* expected) {
        return core::Error{core::ErrorKind::refused, message, expected, {}};
    };
    switch (refusal) {
    case Refusal::noSamples:
        return {core::ErrorKind::badInput, "the log has no samples", "a sample of each instant", {}};
    case Refusal::windowNotReached:
        return refused("the torque window has no sample in one of its halves", "torques that cross it");
    case Refusal::tooFewSamples:
        return refused("fewer than 20 independent samples lie in the torque window",
                       "a slower touch or quicker sampling; method='two-point' needs two samples");
    case Refusal::torqueUnchanged:
        return refused("the torque does not change within the window", "torque that rises through it");
    case Refusal::angleOpposesTorque:
        return refused("the joint turns against the rising torque",
                       "angle and torque that rise together; the sign of one may be turned");
    case Refusal::tooQuick:
        return refused("the torque rises so quickly that the arm's inertia is part of it", "a slower touch");
    case Refusal::notFinite:
    case Refusal::notPositive:
    case Refusal::negativeUncertainty:
    case Refusal::outOfRange:
    case Refusal::badWindow:
    case Refusal::noTorques:
        break;
    }
    return refused("the numbers are too large or too small to compute with", "SI units");
}

py::dict estimate(const py::object& time_s, const py::object& angle_rad, const py::object& torque_Nm,
                  double contactDistance_m, const std::optional<double>& contactDistanceSe_m,
                  const std::optional<double>& linkStiffness_NPerM, double linkStiffnessSe_NPerM,
                  const std::optional<double>& torqueReference_Nm, const std::string& method, double low_Nm,
                  double high_Nm) {
    const std::vector<double> times_s = numbers(time_s, "time_s");
    const std::vector<double> angles_rad = numbers(angle_rad, "joint_angle_rad", times_s.size());
    const std::vector<double> torques_Nm = numbers(torque_Nm, "joint_torque_nm", times_s.size());
    stiffness::TouchSettings settings;
    settings.contactDistance_m = positive(contactDistance_m, "contact_distance_m");
    if (contactDistanceSe_m)
        settings.contactDistanceSe_m = notNegative(*contactDistanceSe_m, "contact_distance_se_m");
    if (linkStiffness_NPerM)
        settings.linkStiffness_NPerM = positive(*linkStiffness_NPerM, "link_stiffness_n_per_m");
    settings.linkStiffnessSe_NPerM = notNegative(linkStiffnessSe_NPerM, "link_stiffness_se_n_per_m");
    if (torqueReference_Nm && !std::isfinite(*torqueReference_Nm))
        throw wrongValue("torque_reference_nm", "a finite number or None",
                         std::string(py::repr(py::float_(*torqueReference_Nm))));
    settings.torqueReference_Nm = torqueReference_Nm;
    const auto chosen = stiffness::methodFromString(method);
    if (!chosen)
        throw wrongValue("method", "'regression' or 'two-point'", std::string(py::repr(py::str(method))));
    settings.method = *chosen;
    if (!(std::isfinite(low_Nm) && std::isfinite(high_Nm) && low_Nm >= 0.0 && high_Nm > low_Nm))
        throw wrongValue("window_nm", "a lower end of 0 or more and a higher upper one",
                         std::string(py::repr(py::make_tuple(low_Nm, high_Nm))));
    settings.window = {low_Nm, high_Nm};

    std::vector<stiffness::JointSample> log;
    log.reserve(times_s.size());
    for (std::size_t i = 0; i < times_s.size(); ++i)
        log.push_back({times_s[i], angles_rad[i], torques_Nm[i]});
    tl::expected<TouchStiffness, Refusal> touch;
    {
        const py::gil_scoped_release released;
        touch = stiffness::estimateStiffness(log, settings);
    }
    if (!touch)
        throw Failure(explain(touch.error()));
    return toDict(*touch);
}

} // namespace

void bindTouch(py::module_& module) {
    module.def("stiffness", &estimate);
}

} // namespace teleta::python
