// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/stiffness/speed_up.h"

#include "backend/stiffness/loading_ramp.h"
#include "backend/stiffness/residual_pattern.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace teleta::stiffness {

namespace {

constexpr std::size_t kLeastInMotion = 20;
/// A joint whose rate stays within this of the last one turns evenly.
constexpr double kEven = 0.8;
/// Where the motion begins, or is another one.
constexpr double kLeastRate = 0.02;
constexpr double kMostRate = 1.5;
/// A motion that lasts so many times its rise tells its drift without the speed-up.
constexpr double kLongest = 50.0;
/// Errors of rates and accelerations that are small enough, as shares.
constexpr double kRateError = 0.05;
constexpr double kAccelerationError = 0.1;
constexpr int kLags = 10;
constexpr int kRefinements = 4;
/// Tenths of the rise.
constexpr int kLeastTrim = 3;
constexpr int kMostTrim = 6;
/// The most that residuals without a pattern have of varianceInflation().
constexpr double kWhite = 1.5;

using Vector5d = Eigen::Matrix<double, 5, 1>;
using Matrix5d = Eigen::Matrix<double, 5, 5>;

/// Rate and acceleration at a time.
struct Motion {
    double rate_radPerS = 0.0;
    double acceleration_radPerS2 = 0.0;
};

std::span<const JointSample> within(std::span<const JointSample> log, double from_s, double to_s) {
    const auto begin = std::ranges::lower_bound(log, from_s, {}, &JointSample::time_s);
    const auto end = std::ranges::upper_bound(begin, log.end(), to_s, {}, &JointSample::time_s);
    return {begin, end};
}

std::optional<Motion> motionAt(std::span<const JointSample> log, double time_s, double halfWidth_s) {
    const auto samples = within(log, time_s - halfWidth_s, time_s + halfWidth_s);
    if (samples.size() < 5 || samples.front().time_s > time_s - 0.5 * halfWidth_s ||
        samples.back().time_s < time_s + 0.5 * halfWidth_s)
        return std::nullopt;
    Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
    Eigen::Vector3d sums = Eigen::Vector3d::Zero();
    const double origin_rad = samples.front().angle_rad;
    for (const JointSample& sample : samples) {
        const double x = (sample.time_s - time_s) / halfWidth_s;
        const Eigen::Vector3d powers(1.0, x, x * x);
        products += powers * powers.transpose();
        sums += powers * (sample.angle_rad - origin_rad);
    }
    const Eigen::LDLT<Eigen::Matrix3d> solver(products);
    if (solver.info() != Eigen::Success || solver.rcond() < 1e-9)
        return std::nullopt;
    const Eigen::Vector3d parabola = solver.solve(sums);
    return Motion{parabola[1] / halfWidth_s, 2.0 * parabola[2] / halfWidth_s / halfWidth_s};
}

class SpeedUpFit {
public:
    SpeedUpFit(std::span<const JointSample> log, std::size_t contact, double likelyDrift_NmPerS)
        : m_log(log)
        , m_free(log.first(contact))
        , m_end_s(m_free.back().time_s)
        , m_step_s((m_end_s - m_free.front().time_s) / static_cast<double>(m_free.size() - 1))
        , m_noise(estimateNoise(m_free).noise)
        , m_likelyDrift_NmPerS(likelyDrift_NmPerS) {}

    std::optional<SpeedUp> fit() {
        if (!(m_step_s > 0.0) || turnsEvenly() || !chooseRateWidth() || !findMotion() ||
            !chooseAccelerationWidth())
            return std::nullopt;
        readAccelerations();
        // The torque begins to rise before the contact is noticed. The first fit without a pattern counts.
        std::optional<SpeedUp> best;
        for (int trimmed = kLeastTrim; trimmed <= kMostTrim; ++trimmed) {
            m_end_s = m_free.back().time_s - 0.1 * trimmed * m_rise_s;
            if (!fitTorques())
                break;
            const SpeedUp answer = this->answer();
            if (!best || answer.inflation < best->inflation)
                best = answer;
            if (best->inflation <= kWhite)
                break;
        }
        return best;
    }

private:
    /// By the ends of a few stretches, which takes no time.
    [[nodiscard]] bool turnsEvenly() const {
        constexpr std::size_t kStretches = 24;
        const std::size_t length = m_free.size() / kStretches;
        if (length < 2)
            return false;
        const auto rateBefore = [&](std::size_t end, std::size_t samples) {
            const JointSample& first = m_free[end - 1 - samples];
            const JointSample& last = m_free[end - 1];
            return (last.angle_rad - first.angle_rad) / (last.time_s - first.time_s);
        };
        const double rate_radPerS = rateBefore(m_free.size(), 4 * length);
        const double noise_radPerS = 4.0 * m_noise.angle_rad / (static_cast<double>(length) * m_step_s);
        for (std::size_t end = m_free.size(); end > length; end -= length)
            // Also where two times are the same and the rate is no number.
            if (!(std::abs(rateBefore(end, length) - rate_radPerS) <=
                  (1.0 - kEven) * std::abs(rate_radPerS) + noise_radPerS))
                return false;
        return true;
    }

    /// Wide enough to tell the rate at the end.
    bool chooseRateWidth() {
        const double longest_s = 0.25 * (m_end_s - m_free.front().time_s);
        for (m_halfWidth_s = 5.0 * m_step_s; m_halfWidth_s < longest_s; m_halfWidth_s *= 1.25) {
            const auto motion = motionAt(m_free, m_end_s - m_halfWidth_s, m_halfWidth_s);
            if (!motion)
                continue;
            const double error_radPerS = m_noise.angle_rad * std::sqrt(3.0 / samplesWithin()) / m_halfWidth_s;
            m_result.rate_radPerS = motion->rate_radPerS;
            if (error_radPerS < kRateError * std::abs(motion->rate_radPerS))
                return true;
        }
        return false;
    }

    /// Back to where the joint stands or moves otherwise. False: it turns evenly.
    bool findMotion() {
        double first_s = m_end_s - m_halfWidth_s;
        double slow_s = first_s; // where it has a tenth of its rate
        double quick_s = first_s;
        double least = 1.0;
        for (double at_s = first_s; at_s > m_free.front().time_s; at_s -= 0.5 * m_halfWidth_s) {
            const auto motion = motionAt(m_free, at_s, m_halfWidth_s);
            if (!motion)
                break;
            const double share = motion->rate_radPerS / m_result.rate_radPerS;
            if (share < kLeastRate || share > kMostRate)
                break;
            first_s = at_s;
            least = std::min(least, share);
            if (share > 0.9)
                quick_s = at_s;
            if (share > 0.1)
                slow_s = at_s;
        }
        m_rise_s = std::max(quick_s - slow_s, m_halfWidth_s);
        m_result.first = static_cast<std::size_t>(within(m_free, first_s, m_end_s).data() - m_free.data());
        return least < kEven && m_free.size() - m_result.first >= kLeastInMotion &&
               m_end_s - first_s <= kLongest * m_rise_s;
    }

    /// Wide enough to tell an acceleration, but shorter than the rise of the rate.
    bool chooseAccelerationWidth() {
        const double largest_radPerS2 = std::abs(m_result.rate_radPerS) / m_rise_s;
        for (; m_halfWidth_s <= 0.5 * m_rise_s; m_halfWidth_s *= 1.25) {
            const double error_radPerS2 =
                m_noise.angle_rad * std::sqrt(45.0 / samplesWithin()) / m_halfWidth_s / m_halfWidth_s;
            if (error_radPerS2 < kAccelerationError * largest_radPerS2) {
                m_result.halfWidth_s = m_halfWidth_s;
                return true;
            }
        }
        return false;
    }

    /// At even steps from the longest lag before the motion to the end.
    void readAccelerations() {
        m_gridStep_s = 0.25 * m_halfWidth_s;
        m_gridStart_s = m_free[m_result.first].time_s - m_rise_s;
        for (double at_s = m_gridStart_s; at_s <= m_end_s + m_gridStep_s; at_s += m_gridStep_s) {
            const auto motion = motionAt(m_log, at_s, m_halfWidth_s);
            if (!motion && at_s > m_end_s - m_halfWidth_s)
                break;
            m_accelerations.push_back(motion ? motion->acceleration_radPerS2 : 0.0);
        }
    }

    /// The accelerations behind a low-pass of first order, without a unit.
    [[nodiscard]] std::vector<double> filtered(double lag_s) const {
        std::vector<double> result(m_accelerations.size());
        const double keeps = lag_s > 0.0 ? std::exp(-m_gridStep_s / lag_s) : 0.0;
        for (std::size_t i = 1; i < result.size(); ++i)
            result[i] =
                keeps * result[i - 1] + (1.0 - keeps) * 0.5 * (m_accelerations[i - 1] + m_accelerations[i]);
        const double scale = m_rise_s / m_result.rate_radPerS;
        std::ranges::for_each(result, [scale](double& value) { value *= scale; });
        return result;
    }

    [[nodiscard]] double between(const std::vector<double>& grid, double time_s) const {
        const double at = std::max(0.0, (time_s - m_gridStart_s) / m_gridStep_s);
        const auto index = static_cast<std::size_t>(at);
        // A log that ends at the contact has no acceleration there.
        if (index + 1 >= grid.size())
            return grid.back();
        const double share = at - static_cast<double>(index);
        return (1.0 - share) * grid[index] + share * grid[index + 1];
    }

    /// One Gauss-Newton step from a lag: torque, drift, gravity, inertia and the change of the lag. False:
    /// the motion cannot tell them apart.
    bool step(double lag_s, double inertia_Nm) {
        const double apart_s = 0.02 * m_rise_s;
        const std::vector<double> here = filtered(lag_s);
        const double shorter_s = std::max(0.0, lag_s - apart_s);
        const std::vector<double> before = filtered(shorter_s);
        const std::vector<double> after = filtered(lag_s + apart_s);
        const double perLag = m_rise_s / (lag_s + apart_s - shorter_s);
        const auto samples = within(m_free.subspan(m_result.first), m_gridStart_s, m_end_s);
        if (samples.size() < kLeastInMotion)
            return false;
        m_result.samples = samples.size();
        m_origin_Nm = samples.back().torque_Nm;
        m_rows.resize(static_cast<Eigen::Index>(samples.size()), Eigen::NoChange);
        Eigen::VectorXd torques(samples.size());
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const double time_s = samples[i].time_s;
            const double time = (time_s - m_end_s) / m_rise_s;
            const double angle =
                (samples[i].angle_rad - samples.back().angle_rad) / m_result.rate_radPerS / m_rise_s;
            const auto row = static_cast<Eigen::Index>(i);
            m_rows.row(row) << 1.0, time, angle - time, between(here, time_s),
                inertia_Nm * perLag * (between(after, time_s) - between(before, time_s));
            torques[row] = samples[i].torque_Nm - m_origin_Nm;
        }
        Matrix5d products = m_rows.transpose() * m_rows;
        // Known beforehand: a likely drift, and a lag about as long as the rise or shorter.
        const double variance_Nm2 = std::max(m_noise.torque_Nm * m_noise.torque_Nm, 1e-18);
        const double drift_Nm = m_likelyDrift_NmPerS * m_rise_s;
        products(1, 1) += variance_Nm2 / drift_Nm / drift_Nm;
        products(4, 4) += variance_Nm2;
        const Eigen::LDLT<Matrix5d> solver(products);
        if (solver.info() != Eigen::Success || !solver.isPositive() || solver.vectorD().minCoeff() <= 0.0)
            return false;
        m_values = solver.solve(m_rows.transpose() * torques);
        m_covariance = solver.solve(Matrix5d::Identity());
        m_residuals_Nm = torques - m_rows * m_values;
        m_squares_Nm2 = m_residuals_Nm.squaredNorm();
        return m_values.allFinite() && m_covariance.allFinite();
    }

    /// Of the lags of a grid the best, then a few steps from it.
    bool fitTorques() {
        double lag_s = 0.0;
        double least_Nm2 = std::numeric_limits<double>::infinity();
        double inertia_Nm = 0.0;
        for (int i = 0; i <= kLags; ++i) {
            if (!step(m_rise_s * i / kLags, 0.0))
                return false;
            if (m_squares_Nm2 < least_Nm2) {
                least_Nm2 = m_squares_Nm2;
                lag_s = m_rise_s * i / kLags;
                inertia_Nm = m_values[3];
            }
        }
        for (int i = 0; i < kRefinements; ++i) {
            if (!step(lag_s, inertia_Nm))
                return false;
            inertia_Nm = m_values[3];
            lag_s = std::clamp(lag_s + m_values[4] * m_rise_s, 0.0, 1.5 * m_rise_s);
        }
        return true;
    }

    SpeedUp answer() {
        const auto count = static_cast<double>(m_residuals_Nm.size());
        m_result.torque_Nm = m_origin_Nm + m_values[0];
        m_result.drift_NmPerS = m_values[1] / m_rise_s;
        m_result.inertia_kgm2 = m_values[3] * m_rise_s / m_result.rate_radPerS;
        m_result.sd_Nm = std::sqrt(m_squares_Nm2 / (count - 5.0));
        if (m_squares_Nm2 > 0.0)
            m_result.inflation = varianceInflation(
                {m_residuals_Nm.data(), static_cast<std::size_t>(m_residuals_Nm.size())}, 5);
        const double sd_Nm = m_result.sd_Nm * std::sqrt(m_result.inflation);
        m_result.torqueSe_Nm = sd_Nm * std::sqrt(m_covariance(0, 0));
        m_result.driftSe_NmPerS = sd_Nm * std::sqrt(m_covariance(1, 1)) / m_rise_s;
        return m_result;
    }

    [[nodiscard]] double samplesWithin() const { return 2.0 * m_halfWidth_s / m_step_s; }

    std::span<const JointSample> m_log;
    std::span<const JointSample> m_free;
    double m_end_s;
    double m_step_s;
    ReadingNoise m_noise;
    double m_likelyDrift_NmPerS;
    double m_halfWidth_s = 0.0;
    double m_rise_s = 0.0; ///< in which the rate rises from a tenth to nine tenths
    double m_gridStart_s = 0.0;
    double m_gridStep_s = 0.0;
    std::vector<double> m_accelerations; ///< at the steps of the grid
    SpeedUp m_result;
    double m_origin_Nm = 0.0;
    Eigen::Matrix<double, Eigen::Dynamic, 5> m_rows;
    Vector5d m_values;
    Matrix5d m_covariance;
    Eigen::VectorXd m_residuals_Nm;
    double m_squares_Nm2 = 0.0;
};

} // namespace

std::optional<SpeedUp> findSpeedUp(std::span<const JointSample> log, std::size_t contact,
                                   double likelyDrift_NmPerS) {
    if (contact < kLeastInMotion)
        return std::nullopt;
    return SpeedUpFit(log, contact, likelyDrift_NmPerS).fit();
}

std::optional<double> accelerationAt(std::span<const JointSample> log, double time_s, double halfWidth_s) {
    const auto motion = motionAt(log, time_s, halfWidth_s);
    if (!motion)
        return std::nullopt;
    return motion->acceleration_radPerS2;
}

} // namespace teleta::stiffness
