// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/stiffness/touch_errors.h"

#include "backend/stiffness/speed_up.h"

#include <algorithm>
#include <functional>
#include <numbers>

namespace teleta::stiffness {

namespace {

constexpr double kSeen_se = 3.5;
constexpr double kBent_se = 4.0;
/// Residuals below such a share of the range are the rounding of the numbers.
constexpr double kRounding = 1e-6;
/// An offset or a step is told when it is over such a share of the window.
constexpr double kToldOffset = 0.05;
constexpr double kCoarse = 0.1;
/// A slope that changes by more within the window is no stiffness.
constexpr double kMostBend = 0.1;
/// A drift that was taken off may have changed by so much of itself since it was seen.
constexpr double kDriftChange = 0.1;
/// Samples of the log after the contact for each of the free motion, from which its drift is taken over.
constexpr std::size_t kLongestTouch = 10;

/// Share of a step that the noise does not smooth (Widrow and Kollar, Quantization Noise, 2008).
double undithered(double step, double noise) {
    const double own = step * step / 12.0;
    const double ratio = std::max(noise * noise - own, 0.0) / (step * step);
    return std::exp(-2.0 * std::numbers::pi * std::numbers::pi * std::min(ratio, 10.0));
}

} // namespace

TaredTouch tare(std::span<const JointSample> samples, const TouchSettings& settings) {
    TaredTouch tared;
    tared.log = inOrderOfTime(samples);
    tared.free = findFreeMotion(tared.log, settings.window);
    const std::optional<FreeMotion>& free = tared.free;
    double middle_Nm = settings.torqueReference_Nm.value_or(0.0);
    if (free) {
        // A short free motion tells no drift of a long touch.
        const bool lasts = free->samples * kLongestTouch >= tared.log.size() - free->contact;
        tared.driftSeen = lasts && std::abs(free->drift_NmPerS) > kSeen_se * free->driftSe_NmPerS;
        // Beside an acceleration a drift may be large and yet not seen.
        if (tared.driftSeen || (lasts && free->spedUp()))
            tared.drift_NmPerS = free->drift_NmPerS;
        const double seen_Nm =
            free->torque_Nm + tared.drift_NmPerS * free->later_s(tared.log[free->contact]) - middle_Nm;
        tared.offsetSeen = std::abs(seen_Nm) > kSeen_se * free->torqueSe_Nm &&
                           std::abs(seen_Nm) > kToldOffset * settings.window.width_Nm();
        if (!settings.torqueReference_Nm)
            middle_Nm = free->torque_Nm;
        else
            middle_Nm -= tared.drift_NmPerS * free->later_s(tared.log[free->contact]);
        tared.reference_Nm = middle_Nm + tared.drift_NmPerS * free->later_s(tared.log[free->contact]);
    } else {
        tared.reference_Nm = middle_Nm;
    }
    for (JointSample& sample : tared.log) {
        sample.torque_Nm -= middle_Nm;
        if (tared.drift_NmPerS != 0.0)
            sample.torque_Nm -= tared.drift_NmPerS * free->later_s(sample);
    }
    return tared;
}

void TouchErrors::findInflation() {
    m_inflation = 1.0;
    if (m_settings.method == Method::twoPoint)
        return;
    double squares_rad2 = 0.0;
    for (const double residual_rad : m_slope.residuals_rad)
        squares_rad2 += residual_rad * residual_rad / static_cast<double>(m_slope.residuals_rad.size());
    if (std::sqrt(squares_rad2) > kRounding * std::abs(m_slope.deltaTheta_rad))
        m_inflation = varianceInflation(m_slope.residuals_rad, 2);
    if (m_tared.free)
        m_inflation = std::max(m_inflation, m_tared.free->inflation);
}

void TouchErrors::findSteps() {
    const auto ramp = m_touch.ramp();
    std::vector<double> torques(ramp.size());
    std::vector<double> angles(ramp.size());
    // The drift that was taken off would hide the steps of the torque.
    for (std::size_t i = 0; i < ramp.size(); ++i) {
        torques[i] =
            ramp[i].torque_Nm + (m_tared.drift_NmPerS != 0.0 ? m_tared.drift_NmPerS * later_s(ramp[i]) : 0.0);
        angles[i] = ramp[i].angle_rad;
    }
    m_torqueStep_Nm = readingStep(torques).value_or(0.0);
    m_angleStep_rad = readingStep(angles).value_or(0.0);
}

double TouchErrors::later_s(const JointSample& sample) const {
    // The touch is turned to be positive; the free motion is as it was read.
    const double sign = m_touch.turned ? -1.0 : 1.0;
    return sign * m_tared.free->later_s({sample.time_s, sign * sample.angle_rad, 0.0});
}

void TouchErrors::findBend() {
    if (m_slope.points.empty() || !std::isnormal(m_stiffness_NmPerRad))
        return;
    std::vector<double> torques(m_slope.points.size());
    std::vector<double> angles(m_slope.points.size());
    for (std::size_t i = 0; i < torques.size(); ++i) {
        torques[i] = m_slope.points[i].torque_Nm;
        angles[i] = m_slope.points[i].angle_rad * m_stiffness_NmPerRad;
    }
    // Of the noisier reading over the other.
    const bool byAngle = m_noise.reading.torque_Nm >= m_stiffness_NmPerRad * m_noise.reading.angle_rad;
    std::vector<double> residuals(torques.size());
    const std::optional<Bend> bend =
        byAngle ? fitBend(angles, torques, residuals) : fitBend(torques, angles, residuals);
    if (!bend)
        return;
    m_bend = *bend;
    if (!byAngle) {
        m_bend.change = -bend->change;
        m_bend.firstSlope = bend->firstSlope != 0.0 ? 1.0 / bend->firstSlope : 0.0;
        m_bend.lastSlope = bend->lastSlope != 0.0 ? 1.0 / bend->lastSlope : 0.0;
    }
    const double inflation = std::min(
        m_inflation, std::max(varianceInflation(residuals, 3), m_tared.free ? m_tared.free->inflation : 1.0));
    const double change = std::abs(m_bend.change);
    // Rounding bends a perfect line, too.
    m_bends = change > kBent_se * m_bend.se * std::sqrt(inflation) && change > 1e-4;
    if (m_bends)
        m_inflation = inflation;
}

void TouchErrors::findPattern() {
    const auto ramp = m_touch.ramp();
    std::size_t contact = m_touch.first;
    if (m_tared.free && m_tared.free->contact < m_touch.end)
        contact = std::max(m_tared.free->contact, m_touch.first > ramp.size() + 2000
                                                      ? m_touch.first - ramp.size() - 2000
                                                      : std::size_t{0});
    m_contact = contact;
    m_pattern =
        examineTouch(m_touch, contact, noise_Nm(), m_tared.free ? m_tared.free->inflation : m_inflation,
                     m_stiffness_NmPerRad, m_settings.window);
    if (m_settings.patternsAreErrors)
        m_pattern.rateDependent = false;
}

double TouchErrors::noise_Nm() const {
    const double neighbours_Nm =
        std::hypot(m_noise.reading.torque_Nm, m_noise.reading.angle_rad * m_stiffness_NmPerRad);
    return std::max(m_tared.free ? m_tared.free->sd_Nm : 0.0, neighbours_Nm);
}

void TouchErrors::examine() {
    findInflation();
    findSteps();
    findBend();
    // A smooth pattern is no worse than the scatter of a few independent samples.
    constexpr double kLeastOfPattern = 4.0;
    if (m_settings.patternsAreErrors)
        m_inflation = std::clamp(static_cast<double>(m_slope.samples) / kLeastOfPattern, 1.0, m_inflation);
    if (std::isnormal(m_stiffness_NmPerRad))
        findPattern();
}

std::vector<ErrorPart> TouchErrors::parts() const {
    std::vector<ErrorPart> parts;
    if (!m_slope.se_radPerNm)
        return parts;
    const double distance_m = m_settings.contactDistance_m;
    const double squared_m2 = distance_m * distance_m;
    const double noise_mPerN = squared_m2 * *m_slope.se_radPerNm;
    const double value_mPerN = squared_m2 * std::abs(m_slope.value_radPerNm);
    const double rise_Nm = m_slope.deltaTorque_Nm;
    parts.push_back({ErrorSource::noise, noise_mPerN});
    const auto add = [&parts](ErrorSource source, double se_mPerN) {
        if (se_mPerN > 0.0 && std::isfinite(se_mPerN))
            parts.push_back({source, se_mPerN});
    };
    add(ErrorSource::correlatedNoise, noise_mPerN * std::sqrt(m_inflation - 1.0));
    double quantization = 0.0;
    if (m_torqueStep_Nm > 0.0 && rise_Nm > 0.0) {
        const double steps = std::max(rise_Nm / m_torqueStep_Nm, 1.0);
        quantization = undithered(m_torqueStep_Nm, m_noise.reading.torque_Nm) / steps / std::sqrt(steps);
    }
    if (m_angleStep_rad > 0.0 && m_slope.deltaTheta_rad > 0.0) {
        const double steps = std::max(m_slope.deltaTheta_rad / m_angleStep_rad, 1.0);
        quantization = std::hypot(quantization, undithered(m_angleStep_rad, m_noise.reading.angle_rad) /
                                                    steps / std::sqrt(steps));
    }
    add(ErrorSource::quantization, value_mPerN * quantization);
    if (m_bends)
        add(ErrorSource::curvature, value_mPerN * std::abs(m_bend.change) / 8.0);
    if (!m_tared.free || !(rise_Nm > 0.0))
        return parts;
    const FreeMotion& free = *m_tared.free;
    if (m_bends)
        add(ErrorSource::torqueReference, value_mPerN * std::abs(m_bend.change) * free.torqueSe_Nm / rise_Nm);
    const auto ramp = m_touch.ramp();
    const auto inWindow = [this](const JointSample& sample) {
        return sample.torque_Nm >= m_settings.window.low_Nm;
    };
    const auto begin = std::ranges::find_if(ramp, inWindow);
    const auto past = std::ranges::find_if(begin, ramp.end(), [this](const JointSample& sample) {
        return sample.torque_Nm > m_settings.window.high_Nm;
    });
    if (begin == ramp.end() || past == begin)
        return parts;
    const JointSample& last = *(past - 1);
    const double lasts_s = last.time_s - begin->time_s;
    const double seen = value_mPerN * free.driftSe_NmPerS * lasts_s / rise_Nm;
    if (free.spedUp()) {
        const double inertia_Nm = std::abs(free.inertia_kgm2) * changeOfAcceleration(*begin, last);
        if (inertia_Nm > kRounding * rise_Nm)
            add(ErrorSource::inertia, value_mPerN * inertia_Nm / rise_Nm);
    }
    if (m_tared.drift_NmPerS == 0.0) {
        // A free motion that is too short to tell does not widen the answer without end.
        add(ErrorSource::torqueDrift, std::min(seen, noise_mPerN * std::sqrt(m_inflation)));
        return parts;
    }
    const double turned_s = free.rate_radPerS != 0.0
                                ? std::abs((last.angle_rad - begin->angle_rad) / free.rate_radPerS)
                                : lasts_s;
    const double drift = value_mPerN * std::abs(m_tared.drift_NmPerS) / rise_Nm;
    add(ErrorSource::torqueDrift, std::hypot(seen, kDriftChange * drift * lasts_s,
                                             0.5 * drift * std::min(std::abs(turned_s - lasts_s), lasts_s)));
    return parts;
}

double TouchErrors::changeOfAcceleration(const JointSample& begin, const JointSample& last) const {
    const auto at = [this](double time_s) {
        return accelerationAt(m_touch.log, time_s, m_tared.free->accelerationWidth_s).value_or(0.0);
    };
    return std::abs(at(last.time_s) - at(begin.time_s));
}

void TouchErrors::tell(TouchStiffness& touch) const {
    const auto warn = [&touch](TouchWarning warning, bool seen) {
        if (seen)
            touch.warnings.push_back(warning);
    };
    const bool coarseTorque = m_torqueStep_Nm > kCoarse * m_settings.window.width_Nm();
    const bool coarseAngle = m_angleStep_rad > kCoarse * std::abs(m_slope.deltaTheta_rad);
    const bool bendsMuch = !m_settings.patternsAreErrors && m_bends && std::abs(m_bend.change) > kMostBend;
    warn(TouchWarning::correlatedNoise, m_inflation > 4.0);
    warn(TouchWarning::coarseTorque, coarseTorque);
    warn(TouchWarning::coarseAngle, coarseAngle);
    warn(TouchWarning::torqueOffset, m_tared.offsetSeen);
    warn(TouchWarning::torqueDrift, m_tared.driftSeen);
    warn(TouchWarning::nonlinear, m_bends && !m_pattern.rateDependent);
    warn(TouchWarning::rateDependent, m_pattern.rateDependent);
    warn(TouchWarning::stickSlip, m_pattern.stickSlip);
    touch.reliable =
        !(coarseTorque || coarseAngle || bendsMuch || m_pattern.rateDependent || m_pattern.stickSlip);
    touch.effectiveSamples = effectiveSamples();
    touch.torqueReference_Nm = m_tared.reference_Nm;
    touch.torqueDrift_NmPerS = m_tared.drift_NmPerS;
    if (!touch.has(TouchWarning::nonlinear))
        return;
    const auto objectOf = [&](double joint_NmPerRad) -> std::optional<double> {
        const double distance_m = m_settings.contactDistance_m;
        const double object_mPerN =
            distance_m * distance_m / joint_NmPerRad - 1.0 / m_settings.linkStiffness_NPerM;
        if (!(object_mPerN * m_settings.linkStiffness_NPerM > kComplianceResolution))
            return std::nullopt;
        return 1.0 / object_mPerN;
    };
    // fitBend() has both in the unit of the window's stiffness.
    touch.tangent_NPerM = objectOf(m_bend.lastSlope * m_stiffness_NmPerRad);
    touch.secant_NPerM = objectOf(0.5 * (m_bend.firstSlope + m_bend.lastSlope) * m_stiffness_NmPerRad);
}

std::optional<StandardLinearSolid> TouchErrors::solid() const {
    if (!m_pattern.rateDependent || m_pattern.holdEnd <= m_pattern.holdBegin)
        return std::nullopt;
    const double distance_m = m_settings.contactDistance_m;
    const double distanceSe = m_settings.contactDistanceSe_m.value_or(kLeastDistanceSe * distance_m);
    const double linkSe = m_settings.linkStiffnessSe_NPerM / m_settings.linkStiffness_NPerM;
    const double linkShare = m_stiffness_NmPerRad / distance_m / distance_m / m_settings.linkStiffness_NPerM;
    RelaxationSettings settings;
    settings.joint_NmPerRad = m_settings.linkStiffness_NPerM * distance_m * distance_m;
    settings.contactDistance_m = distance_m;
    settings.relativeSe = std::hypot(2.0 * distanceSe / distance_m, linkShare * linkSe);
    settings.inflation = m_tared.free ? m_tared.free->inflation : 1.0;
    return fitStandardLinearSolid(std::span(m_touch.log).subspan(m_contact, m_pattern.holdEnd - m_contact),
                                  noise_Nm(), settings);
}

ErrorBudget budgetOf(const std::vector<ErrorPart>& parts) {
    double largest_mPerN = 0.0;
    for (const ErrorPart& part : parts)
        largest_mPerN = std::max(largest_mPerN, part.se_mPerN);
    ErrorBudget budget;
    if (!(largest_mPerN > 0.0))
        return budget;
    double sum = 0.0;
    for (const ErrorPart& part : parts) {
        if (!(part.se_mPerN > 0.0))
            continue;
        const double share = std::pow(part.se_mPerN / largest_mPerN, 2);
        budget.push_back({part.source, share});
        sum += share;
    }
    for (ErrorShare& part : budget)
        part.share /= sum;
    std::ranges::stable_sort(budget, std::greater(), &ErrorShare::share);
    return budget;
}

} // namespace teleta::stiffness
