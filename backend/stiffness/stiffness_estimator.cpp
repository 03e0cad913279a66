// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/stiffness/stiffness_estimator.h"

#include "backend/stiffness/compliance_line.h"
#include "backend/stiffness/loading_ramp.h"
#include "backend/stiffness/touch_errors.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <utility>
#include <vector>

namespace teleta::stiffness {

namespace {

constexpr int kSelectionRounds = 20;
/// Larger numbers are refused, so that no product below overflows or underflows.
constexpr double kLargest = 1e100;
/// Tolerance, as a share of the window's width, that keeps samples on its border inside despite the rounding
/// of the fit.
constexpr double kBorderRounding = 1e-9;

std::optional<Refusal> refuse(std::span<const JointSample> samples, const TouchSettings& settings) {
    const double torqueNoise_Nm = settings.torqueNoise_Nm.value_or(0.0);
    const double angleNoise_rad = settings.angleNoise_rad.value_or(0.0);
    bool inRange = true;
    const auto isFinite = [&](std::initializer_list<double> values) {
        for (const double value : values) {
            if (!std::isfinite(value))
                return false;
            inRange = inRange && std::abs(value) <= kLargest;
        }
        return true;
    };
    const double distanceSe_m = settings.contactDistanceSe_m.value_or(0.0);
    const double placeSe_mPerN = settings.placeSe_mPerN.value_or(0.0);
    if (!isFinite({settings.contactDistance_m, distanceSe_m, placeSe_mPerN, settings.linkStiffness_NPerM,
                   settings.linkStiffnessSe_NPerM, settings.window.low_Nm, settings.window.high_Nm,
                   settings.torqueReference_Nm.value_or(0.0), torqueNoise_Nm, angleNoise_rad}))
        return Refusal::notFinite;
    for (const JointSample& sample : samples)
        if (!isFinite({sample.time_s, sample.angle_rad, sample.torque_Nm}))
            return Refusal::notFinite;
    if (settings.contactDistance_m <= 0.0 || settings.linkStiffness_NPerM <= 0.0)
        return Refusal::notPositive;
    if (settings.linkStiffnessSe_NPerM < 0.0 || distanceSe_m < 0.0 || placeSe_mPerN < 0.0 ||
        torqueNoise_Nm < 0.0 || angleNoise_rad < 0.0)
        return Refusal::negativeUncertainty;
    if (settings.window.low_Nm < 0.0 || settings.window.high_Nm <= settings.window.low_Nm)
        return Refusal::badWindow;
    if (!inRange || settings.contactDistance_m < 1.0 / kLargest ||
        settings.linkStiffness_NPerM < 1.0 / kLargest)
        return Refusal::outOfRange;
    if (samples.empty())
        return Refusal::noSamples;
    return std::nullopt;
}

TouchNoise noiseOf(std::span<const JointSample> ramp, const TouchSettings& settings) {
    TouchNoise noise;
    noise.known = settings.torqueNoise_Nm && settings.angleNoise_rad;
    noise.available = noise.known;
    if (!noise.known) {
        const EstimatedNoise estimate = estimateNoise(ramp);
        noise.reading = estimate.noise;
        noise.available = estimate.degreesOfFreedom > 0.0;
        noise.degreesOfFreedom = estimate.degreesOfFreedom;
    }
    noise.reading.torque_Nm = settings.torqueNoise_Nm.value_or(noise.reading.torque_Nm);
    noise.reading.angle_rad = settings.angleNoise_rad.value_or(noise.reading.angle_rad);
    return noise;
}

tl::expected<FittedSlope, Refusal> twoPointSlope(std::span<const JointSample> ramp,
                                                 const TorqueWindow& window, const TouchNoise& noise) {
    const auto nearest = [&](double torque_Nm) -> const JointSample& {
        return *std::min_element(ramp.begin(), ramp.end(), [&](const JointSample& a, const JointSample& b) {
            return std::abs(a.torque_Nm - torque_Nm) < std::abs(b.torque_Nm - torque_Nm);
        });
    };
    const JointSample& low = nearest(window.low_Nm);
    const JointSample& high = nearest(window.high_Nm);
    if (low.torque_Nm > window.middle_Nm() || high.torque_Nm < window.middle_Nm())
        return tl::unexpected(Refusal::windowNotReached);
    FittedSlope slope;
    slope.samples = 2;
    slope.deltaTorque_Nm = high.torque_Nm - low.torque_Nm;
    slope.deltaTheta_rad = high.angle_rad - low.angle_rad;
    if (slope.deltaTorque_Nm <= 0.0)
        return tl::unexpected(Refusal::torqueUnchanged);
    slope.value_radPerNm = slope.deltaTheta_rad / slope.deltaTorque_Nm;
    if (noise.available) {
        slope.se_radPerNm = std::sqrt(2.0) * noise.along_rad(slope.value_radPerNm) / slope.deltaTorque_Nm;
        slope.quantile95 = noise.known ? core::kNormalQuantile95 : studentQuantile95(noise.degreesOfFreedom);
    }
    return slope;
}

tl::expected<FittedSlope, Refusal> regressionSlope(std::span<const JointSample> ramp,
                                                   const TorqueWindow& window, const TouchNoise& noise) {
    // Relative to the first sample, so that no digits are lost where the angle is far from zero.
    const double origin_rad = ramp.front().angle_rad;
    std::vector<TorqueAngle> points(ramp.size());
    std::transform(ramp.begin(), ramp.end(), points.begin(), [&](const JointSample& sample) {
        return TorqueAngle{sample.torque_Nm, sample.angle_rad - origin_rad};
    });
    const double slack_Nm = kBorderRounding * window.width_Nm();
    const auto inWindow = [&](double torque_Nm) {
        return torque_Nm >= window.low_Nm - slack_Nm && torque_Nm <= window.high_Nm + slack_Nm;
    };

    const auto selectWhere = [&](const auto& torqueOf) {
        std::vector<TorqueAngle> selection;
        selection.reserve(points.size());
        std::copy_if(points.begin(), points.end(), std::back_inserter(selection),
                     [&](const TorqueAngle& point) { return inWindow(torqueOf(point)); });
        return selection;
    };

    std::vector<TorqueAngle> selection =
        selectWhere([](const TorqueAngle& point) { return point.torque_Nm; });
    if (selection.empty())
        return tl::unexpected(Refusal::windowNotReached);
    if (selection.size() < 2)
        return tl::unexpected(Refusal::tooFewSamples);
    std::optional<ComplianceLine> line = fitComplianceLine(selection, noise.reading);
    if (!line)
        return tl::unexpected(Refusal::torqueUnchanged);

    const auto fittedTorque_Nm = [&](const TorqueAngle& point) { return line->fittedTorque_Nm(point); };
    for (int round = 0; round < kSelectionRounds && line->points > 2 && line->correlated; ++round) {
        std::vector<TorqueAngle> nextSelection = selectWhere(fittedTorque_Nm);
        if (nextSelection == selection || nextSelection.size() < 3)
            break;
        const std::optional<ComplianceLine> next = fitComplianceLine(nextSelection, noise.reading);
        if (!next || !next->correlated)
            break;
        line = next;
        selection = std::move(nextSelection);
    }

    FittedSlope slope;
    slope.samples = line->points;
    slope.value_radPerNm = line->slope_radPerNm;
    slope.se_radPerNm = line->slopeSe_radPerNm;
    if (line->points > 2)
        slope.quantile95 = studentQuantile95(static_cast<double>(line->points) - 2.0);
    if (noise.known) {
        slope.se_radPerNm = std::max(line->slopeSe_radPerNm.value_or(0.0),
                                     noise.along_rad(line->slope_radPerNm) / line->torqueSpread_Nm);
        slope.quantile95 = core::kNormalQuantile95;
    }
    // An uncorrelated line does not determine where along it a sample belongs.
    const auto alongLine_Nm = [&](const TorqueAngle& point) {
        return line->correlated ? fittedTorque_Nm(point) : point.torque_Nm;
    };
    const auto [lowest, highest] = std::minmax_element(
        selection.begin(), selection.end(),
        [&](const TorqueAngle& a, const TorqueAngle& b) { return alongLine_Nm(a) < alongLine_Nm(b); });
    slope.deltaTorque_Nm = alongLine_Nm(*highest) - alongLine_Nm(*lowest);
    slope.deltaTheta_rad = slope.value_radPerNm * slope.deltaTorque_Nm;
    slope.residuals_rad.reserve(selection.size());
    for (const TorqueAngle& point : selection)
        slope.residuals_rad.push_back(point.angle_rad - line->offset_rad -
                                      line->slope_radPerNm * point.torque_Nm);
    slope.points = std::move(selection);
    return slope;
}

/// What every answer begins with.
struct FittedTouch {
    TaredTouch tared;
    OrderedTouch ordered;
    TouchNoise noise;
    FittedSlope slope;
};

tl::expected<FittedTouch, Refusal> fitTouch(std::span<const JointSample> samples,
                                            const TouchSettings& settings) {
    if (const std::optional<Refusal> refusal = refuse(samples, settings))
        return tl::unexpected(*refusal);
    FittedTouch touch;
    touch.tared = tare(samples, settings);
    touch.ordered = orderedTouch(touch.tared.log, settings.window);
    const auto ramp = touch.ordered.ramp();
    if (ramp.empty())
        return tl::unexpected(Refusal::windowNotReached);
    touch.noise = noiseOf(ramp, settings);
    tl::expected<FittedSlope, Refusal> slope = settings.method == Method::twoPoint
                                                   ? twoPointSlope(ramp, settings.window, touch.noise)
                                                   : regressionSlope(ramp, settings.window, touch.noise);
    if (!slope)
        return tl::unexpected(slope.error());
    touch.slope = std::move(*slope);
    return touch;
}

double objectCompliance_mPerN(const FittedSlope& slope, const TouchSettings& settings) {
    return settings.contactDistance_m * settings.contactDistance_m * slope.value_radPerNm -
           1.0 / settings.linkStiffness_NPerM;
}

bool inOneBand(Material material, double lower_NPerM, double upper_NPerM) {
    return classify(lower_NPerM) == material && classify(upper_NPerM) == material;
}

/// Sets the class of the object and whether the whole interval lies in it.
void classifyObject(TouchStiffness& touch) {
    if (touch.solid) {
        const Interval95& still = touch.solid->static_NPerM;
        touch.material = classify(still.value);
        touch.materialCertain = inOneBand(touch.material, still.lower, still.upper);
        return;
    }
    const Stiffness& object = touch.object;
    touch.material = object.value_NPerM ? classify(*object.value_NPerM) : Material::metal;
    const bool lowerAgrees = object.lower95_NPerM && classify(*object.lower95_NPerM) == touch.material;
    const bool upperAgrees = object.upper95_NPerM ? classify(*object.upper95_NPerM) == touch.material
                                                  : touch.material == Material::metal;
    touch.materialCertain = touch.reliable && lowerAgrees && upperAgrees;
}

/// Sets a standard error from its parts, and the quantile: Student's t for what the scatter tells.
void setError(Compliance& compliance, const std::vector<ErrorPart>& parts, double quantile95) {
    double scatter_mPerN = 0.0;
    double other_mPerN = 0.0;
    for (const ErrorPart& part : parts) {
        const bool isScatter =
            part.source == ErrorSource::noise || part.source == ErrorSource::correlatedNoise;
        double& sum = isScatter ? scatter_mPerN : other_mPerN;
        sum = std::hypot(sum, part.se_mPerN);
    }
    const double se_mPerN = std::hypot(scatter_mPerN, other_mPerN);
    compliance.se_mPerN = se_mPerN;
    compliance.quantile95 = quantile95;
    if (other_mPerN > 0.0)
        compliance.quantile95 = std::hypot(quantile95 * (scatter_mPerN / se_mPerN),
                                           core::kNormalQuantile95 * (other_mPerN / se_mPerN));
}

} // namespace

const char* toString(Method method) {
    return method == Method::twoPoint ? "two-point" : "regression";
}

std::optional<Method> methodFromString(std::string_view text) {
    for (const Method method : {Method::twoPoint, Method::regression})
        if (text == toString(method))
            return method;
    return std::nullopt;
}

bool TouchStiffness::has(TouchWarning warning) const {
    return std::ranges::find(warnings, warning) != warnings.end();
}

tl::expected<double, Refusal> estimateObjectCompliance(std::span<const JointSample> samples,
                                                       const TouchSettings& settings) {
    const tl::expected<FittedTouch, Refusal> fitted = fitTouch(samples, settings);
    if (!fitted)
        return tl::unexpected(fitted.error());
    const double compliance_mPerN = objectCompliance_mPerN(fitted->slope, settings);
    if (!std::isfinite(compliance_mPerN))
        return tl::unexpected(Refusal::outOfRange);
    return compliance_mPerN;
}

tl::expected<TouchStiffness, Refusal> estimateStiffness(std::span<const JointSample> samples,
                                                        const TouchSettings& settings) {
    const tl::expected<FittedTouch, Refusal> fitted = fitTouch(samples, settings);
    if (!fitted)
        return tl::unexpected(fitted.error());
    const FittedSlope& slope = fitted->slope;
    const TouchNoise& noise = fitted->noise;
    TouchErrors errors(fitted->tared, fitted->ordered, slope, noise, settings);
    errors.examine();

    const double distance_m = settings.contactDistance_m;
    const double distanceSquared_m2 = distance_m * distance_m;
    const double link_NPerM = settings.linkStiffness_NPerM;
    TouchStiffness touch;
    touch.method = settings.method;
    touch.samples = slope.samples;
    touch.deltaTorque_Nm = slope.deltaTorque_Nm;
    touch.deltaTheta_rad = slope.deltaTheta_rad;
    touch.totalCompliance.value_mPerN = distanceSquared_m2 * slope.value_radPerNm;
    touch.objectCompliance.value_mPerN = objectCompliance_mPerN(slope, settings);
    if (!std::isfinite(touch.objectCompliance.value_mPerN))
        return tl::unexpected(Refusal::outOfRange);
    if (slope.se_radPerNm) {
        double quantile95 = slope.quantile95;
        if (settings.method == Method::regression && slope.samples > 2 &&
            (!noise.known || errors.inflation() > 1.0))
            quantile95 = studentQuantile95(std::max(errors.effectiveSamples() - 2.0, 1.0));
        const double distanceSe = settings.contactDistanceSe_m.value_or(kLeastDistanceSe * distance_m);
        const double twice = 2.0 * distanceSe / distance_m;
        std::vector<ErrorPart> parts = errors.parts();
        std::vector<ErrorPart> objectParts = parts;
        parts.push_back({ErrorSource::contactDistance, twice * std::abs(touch.totalCompliance.value_mPerN)});
        objectParts.push_back(
            {ErrorSource::contactDistance,
             settings.placeSe_mPerN.value_or(twice * std::abs(touch.totalCompliance.value_mPerN))});
        objectParts.push_back(
            {ErrorSource::linkStiffness, settings.linkStiffnessSe_NPerM / link_NPerM / link_NPerM});
        setError(touch.totalCompliance, parts, quantile95);
        setError(touch.objectCompliance, objectParts, quantile95);
        touch.errorBudget = budgetOf(objectParts);
        if (!std::isfinite(*touch.objectCompliance.se_mPerN) ||
            !std::isfinite(touch.objectCompliance.quantile95))
            return tl::unexpected(Refusal::outOfRange);
    }

    const double resolution_mPerN = kComplianceResolution / link_NPerM;
    const auto isBelowZero = [&](const Compliance& compliance) {
        return compliance.value_mPerN + compliance.margin_mPerN() < -resolution_mPerN;
    };
    if (isBelowZero(touch.totalCompliance))
        return tl::unexpected(Refusal::angleOpposesTorque);
    const double counted =
        errors.explainsResiduals() ? static_cast<double>(slope.samples) : errors.effectiveSamples();
    if (settings.method == Method::regression && counted < kLeastEffectiveSamples)
        return tl::unexpected(Refusal::tooFewSamples);
    touch.stifferThanLink = isBelowZero(touch.objectCompliance);
    touch.total = stiffnessFromCompliance(touch.totalCompliance, link_NPerM);
    touch.object = stiffnessFromCompliance(touch.objectCompliance, link_NPerM);
    errors.tell(touch);
    touch.solid = errors.solid();
    classifyObject(touch);
    return touch;
}

} // namespace teleta::stiffness
