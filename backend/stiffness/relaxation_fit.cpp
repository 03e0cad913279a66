// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/stiffness/relaxation_fit.h"

#include "backend/stiffness/compliance_line.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace teleta::stiffness {

namespace {

constexpr std::size_t kParameters = 4;
constexpr std::size_t kLeastOfFit = 40;
using Parameters = std::array<double, kParameters>; ///< logarithms of K_s, K_m, T; angle of contact
using Matrix4 = std::array<std::array<double, kParameters>, kParameters>;

/// Inverse of a symmetric positive matrix by Gauss and Jordan; empty when it is singular.
std::optional<Matrix4> inverse(Matrix4 a) {
    Matrix4 result{};
    for (std::size_t i = 0; i < kParameters; ++i)
        result[i][i] = 1.0;
    for (std::size_t column = 0; column < kParameters; ++column) {
        std::size_t pivot = column;
        for (std::size_t row = column; row < kParameters; ++row)
            if (std::abs(a[row][column]) > std::abs(a[pivot][column]))
                pivot = row;
        if (!std::isnormal(a[pivot][column]))
            return std::nullopt;
        std::swap(a[pivot], a[column]);
        std::swap(result[pivot], result[column]);
        const double scale = 1.0 / a[column][column];
        for (std::size_t k = 0; k < kParameters; ++k) {
            a[column][k] *= scale;
            result[column][k] *= scale;
        }
        for (std::size_t row = 0; row < kParameters; ++row) {
            const double factor = a[row][column];
            if (row == column || factor == 0.0)
                continue;
            for (std::size_t k = 0; k < kParameters; ++k) {
                a[row][k] -= factor * a[column][k];
                result[row][k] -= factor * result[column][k];
            }
        }
    }
    return result;
}

/// In units of the rise: angle over its range, torque over its highest, time over the span.
class Fit {
public:
    Fit(std::span<const JointSample> samples, double joint)
        : m_samples(samples)
        , m_joint(joint)
        , m_model(samples.size()) {}

    double cost(const Parameters& p) {
        simulate(p, m_model);
        double sum = 0.0;
        for (std::size_t i = 0; i < m_model.size(); ++i)
            sum += (m_samples[i].torque_Nm - m_model[i]) * (m_samples[i].torque_Nm - m_model[i]);
        return sum;
    }

    /// False when it does not converge to a bounded answer.
    bool solve(Parameters& p) {
        constexpr int kRounds = 60;
        double damping = 1e-3;
        double best = cost(p);
        for (int round = 0; round < kRounds; ++round) {
            const std::array<double, kParameters> step = gradientStep(p, damping);
            Parameters next = p;
            double largest = 0.0;
            for (std::size_t i = 0; i < kParameters; ++i) {
                next[i] += std::clamp(step[i], -1.0, 1.0);
                largest = std::max(largest, std::abs(step[i]));
            }
            if (!inBounds(next)) {
                damping *= 4.0;
                if (damping > 1e9)
                    return false;
                continue;
            }
            const double now = cost(next);
            if (now <= best) {
                p = next;
                const bool done = best - now <= 1e-10 * best && largest < 1e-5;
                best = now;
                damping = std::max(damping * 0.3, 1e-12);
                if (done)
                    return true;
            } else {
                damping *= 4.0;
                if (damping > 1e9)
                    return true;
            }
        }
        return true;
    }

    [[nodiscard]] std::optional<Matrix4> covariance(const Parameters& p) {
        Matrix4 normal{};
        std::array<double, kParameters> unused{};
        normalEquations(p, normal, unused);
        return inverse(normal);
    }

private:
    static bool inBounds(const Parameters& p) {
        return std::abs(p[0]) < 12.0 && std::abs(p[1]) < 12.0 && p[2] > -9.0 && p[2] < 3.0 &&
               std::abs(p[3]) < 1.0;
    }

    void simulate(const Parameters& p, std::vector<double>& torques) const {
        const double ks = std::exp(p[0]);
        const double km = std::exp(p[1]);
        const double relaxation = std::exp(p[2]);
        double depth = 0.0;
        double branch = 0.0;
        double lastTime = m_samples.front().time_s;
        for (std::size_t i = 0; i < m_samples.size(); ++i) {
            const double pressed = std::max(0.0, m_samples[i].angle_rad - p[3]);
            const double span = (m_samples[i].time_s - lastTime) / relaxation;
            const double decay = std::exp(-span);
            const double gain = span > 1e-9 ? (1.0 - decay) / span : 1.0;
            // The joint's spring and the body share the angle.
            depth = (m_joint * pressed - decay * branch + km * gain * depth) / (m_joint + ks + km * gain);
            depth = std::max(depth, 0.0);
            torques[i] = m_joint * (pressed - depth);
            branch = torques[i] - ks * depth;
            lastTime = m_samples[i].time_s;
        }
    }

    void normalEquations(const Parameters& p, Matrix4& normal, std::array<double, kParameters>& right) {
        constexpr double kStep = 1e-5;
        simulate(p, m_model);
        std::array<std::vector<double>, kParameters> columns;
        for (std::size_t k = 0; k < kParameters; ++k) {
            Parameters moved = p;
            moved[k] += kStep;
            columns[k].resize(m_samples.size());
            simulate(moved, columns[k]);
            for (std::size_t i = 0; i < m_samples.size(); ++i)
                columns[k][i] = (columns[k][i] - m_model[i]) / kStep;
        }
        for (std::size_t i = 0; i < m_samples.size(); ++i) {
            const double residual = m_samples[i].torque_Nm - m_model[i];
            for (std::size_t a = 0; a < kParameters; ++a) {
                right[a] += columns[a][i] * residual;
                for (std::size_t b = 0; b < kParameters; ++b)
                    normal[a][b] += columns[a][i] * columns[b][i];
            }
        }
    }

    std::array<double, kParameters> gradientStep(const Parameters& p, double damping) {
        Matrix4 normal{};
        std::array<double, kParameters> right{};
        normalEquations(p, normal, right);
        for (std::size_t k = 0; k < kParameters; ++k)
            normal[k][k] = normal[k][k] * (1.0 + damping) + 1e-12;
        std::array<double, kParameters> step{};
        if (const auto inverted = inverse(normal))
            for (std::size_t a = 0; a < kParameters; ++a)
                for (std::size_t b = 0; b < kParameters; ++b)
                    step[a] += (*inverted)[a][b] * right[b];
        return step;
    }

    std::span<const JointSample> m_samples;
    double m_joint;
    std::vector<double> m_model;
};

} // namespace

std::optional<StandardLinearSolid> fitStandardLinearSolid(std::span<const JointSample> samples,
                                                          double noise_Nm,
                                                          const RelaxationSettings& settings) {
    constexpr double kNoiseFactor = 1.5;
    constexpr double kLeastNoise = 1e-4; ///< of the highest torque: what the integration itself leaves
    if (samples.size() < kLeastOfFit)
        return std::nullopt;
    const double span_s = samples.back().time_s - samples.front().time_s;
    double high_Nm = 0.0;
    double low_rad = std::numeric_limits<double>::infinity();
    double high_rad = -low_rad;
    for (const JointSample& sample : samples) {
        high_Nm = std::max(high_Nm, sample.torque_Nm);
        low_rad = std::min(low_rad, sample.angle_rad);
        high_rad = std::max(high_rad, sample.angle_rad);
    }
    const double range_rad = high_rad - low_rad;
    const double unit_NmPerRad = high_Nm / range_rad;
    if (!std::isnormal(span_s) || !std::isnormal(range_rad) || !std::isnormal(unit_NmPerRad))
        return std::nullopt;
    std::vector<JointSample> scaled;
    scaled.reserve(samples.size());
    for (const JointSample& sample : samples)
        scaled.push_back({(sample.time_s - samples.front().time_s) / span_s,
                          (sample.angle_rad - low_rad) / range_rad, sample.torque_Nm / high_Nm});
    Fit fit(scaled, std::min(settings.joint_NmPerRad / unit_NmPerRad, 1e5));
    Parameters best{};
    double least = std::numeric_limits<double>::infinity();
    for (const double relaxation : {0.02, 0.06, 0.2, 0.5}) {
        Parameters p{0.0, 0.0, std::log(relaxation), 0.0};
        if (!fit.solve(p))
            continue;
        if (const double cost = fit.cost(p); cost < least) {
            least = cost;
            best = p;
        }
    }
    const auto count = static_cast<double>(samples.size());
    if (!std::isfinite(least))
        return std::nullopt;
    const double sd = std::sqrt(least / (count - static_cast<double>(kParameters)));
    if (sd > kNoiseFactor * std::max(noise_Nm / high_Nm, kLeastNoise))
        return std::nullopt;
    const auto covariance = fit.covariance(best);
    if (!covariance)
        return std::nullopt;
    const double scale = std::max(sd, kLeastNoise) * std::sqrt(settings.inflation);
    const double quantile = studentQuantile95(count - static_cast<double>(kParameters));
    const auto logSe = [&](double variance) { return scale * std::sqrt(std::max(variance, 0.0)); };
    const auto interval = [](double value, double margin) {
        return Interval95{value, value * std::exp(-margin), value * std::exp(margin)};
    };
    const Matrix4& c = *covariance;
    const double static_NPerM =
        std::exp(best[0]) * unit_NmPerRad / settings.contactDistance_m / settings.contactDistance_m;
    const double staticMargin = std::hypot(quantile * logSe(c[0][0]), quantile * settings.relativeSe);
    const double ratioMargin = quantile * logSe(c[0][0] + c[1][1] - 2.0 * c[0][1]);
    const double timeMargin = quantile * logSe(c[2][2]);
    // A margin of a factor of 2 says nothing.
    const double bounded = std::log(2.0);
    const double relaxation = std::exp(best[2]);
    if (!(staticMargin < bounded && ratioMargin < bounded && timeMargin < bounded) || relaxation > 3.0 ||
        relaxation * count < 3.0)
        return std::nullopt;
    return StandardLinearSolid{interval(static_NPerM, staticMargin),
                               interval(std::exp(best[1] - best[0]), ratioMargin),
                               interval(relaxation * span_s, timeMargin)};
}

} // namespace teleta::stiffness
