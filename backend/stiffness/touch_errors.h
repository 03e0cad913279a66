// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/stiffness/compliance_line.h"
#include "backend/stiffness/free_motion.h"
#include "backend/stiffness/loading_ramp.h"
#include "backend/stiffness/residual_pattern.h"
#include "backend/stiffness/stiffness_estimator.h"
#include "backend/stiffness/touch_pattern.h"

#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace teleta::stiffness {

/// Result of either method before the contact distance is applied.
struct FittedSlope {
    double value_radPerNm = 0.0;
    std::optional<double> se_radPerNm;
    double quantile95 = core::kNormalQuantile95;
    double deltaTorque_Nm = 0.0;
    double deltaTheta_rad = 0.0;
    std::size_t samples = 0;
    /// Of a regression: the samples that it used, in order of time, and their distances from the line.
    std::vector<TorqueAngle> points;
    std::vector<double> residuals_rad;
};

/// Noise of both readings and where it is from.
struct TouchNoise {
    ReadingNoise reading;
    bool known = false;            ///< both were given
    bool available = false;        ///< both are known or estimated
    double degreesOfFreedom = 0.0; ///< of an estimate

    /// Standard deviation of a sample from the line, in angle.
    [[nodiscard]] double along_rad(double slope_radPerNm) const {
        return std::hypot(reading.angle_rad, slope_radPerNm * reading.torque_Nm);
    }
};

/// The log without the torque of the free joint.
struct TaredTouch {
    std::vector<JointSample> log;
    std::optional<FreeMotion> free;
    double reference_Nm = 0.0; ///< taken off at the contact
    double drift_NmPerS = 0.0; ///< taken off
    bool driftSeen = false;
    bool offsetSeen = false;
};

/// Takes off what the free motion shows, or the reference that is told. Thread: any (pure).
[[nodiscard]] TaredTouch tare(std::span<const JointSample> samples, const TouchSettings& settings);

/// One part of the error of a compliance.
struct ErrorPart {
    ErrorSource source = ErrorSource::noise;
    double se_mPerN = 0.0;
};

/// Shares of the variance, the largest first. Thread: any (pure).
[[nodiscard]] ErrorBudget budgetOf(const std::vector<ErrorPart>& parts);

/// What the samples of a touch tell about its error, besides the scatter about the line. Keeps references to
/// all that it is given. Thread: one.
class TouchErrors {
public:
    TouchErrors(const TaredTouch& tared, const OrderedTouch& touch, const FittedSlope& slope,
                const TouchNoise& noise, const TouchSettings& settings)
        : m_tared(tared)
        , m_touch(touch)
        , m_slope(slope)
        , m_noise(noise)
        , m_settings(settings)
        , m_stiffness_NmPerRad(slope.value_radPerNm > 0.0 ? 1.0 / slope.value_radPerNm : 0.0) {}

    void examine();

    [[nodiscard]] double inflation() const { return m_inflation; }
    [[nodiscard]] double effectiveSamples() const {
        return static_cast<double>(m_slope.samples) / m_inflation;
    }
    [[nodiscard]] bool explainsResiduals() const {
        return m_settings.patternsAreErrors || m_pattern.rateDependent || m_pattern.stickSlip || m_bends;
    }
    void tell(TouchStiffness& touch) const;
    /// Those of the total compliance, but for distance and link.
    [[nodiscard]] std::vector<ErrorPart> parts() const;
    [[nodiscard]] std::optional<StandardLinearSolid> solid() const;

private:
    void findInflation();
    void findSteps();
    void findBend();
    void findPattern();
    [[nodiscard]] double later_s(const JointSample& sample) const;
    /// In rad/s^2.
    [[nodiscard]] double changeOfAcceleration(const JointSample& begin, const JointSample& last) const;
    /// Of the torque about a line, from the free motion or the neighbours.
    [[nodiscard]] double noise_Nm() const;

    const TaredTouch& m_tared;
    const OrderedTouch& m_touch;
    const FittedSlope& m_slope;
    const TouchNoise& m_noise;
    const TouchSettings& m_settings;
    double m_stiffness_NmPerRad;
    double m_inflation = 1.0;
    double m_torqueStep_Nm = 0.0;
    double m_angleStep_rad = 0.0;
    Bend m_bend;          ///< zero when there are too few points
    bool m_bends = false; ///< significantly
    std::size_t m_contact = 0;
    TouchPattern m_pattern;
};

} // namespace teleta::stiffness
