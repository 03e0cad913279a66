// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/motors/lag_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace teleta::motors {

namespace {

using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;

constexpr int kIterations = 60;
constexpr double kConverged = 1e-10; ///< relative change of the sum of squares

/// The steady speed as a weighted sum of at most two levels.
struct Blend {
    Eigen::Index first = 0;
    double firstShare = 0.0;
    double secondShare = 0.0; ///< of first + 1
};

class LagProblem {
public:
    LagProblem(const MotorRecording& recording, double start, const std::vector<SpeedLevel>& levels,
               const std::vector<bool>& ignored)
        : m_recording(recording)
        , m_ignored(ignored) {
        m_blends.reserve(recording.size());
        for (const double drive : recording.drive)
            m_blends.push_back(drive < start ? Blend{} : blend(levels, drive));
    }

    [[nodiscard]] std::size_t samples() const { return m_recording.size(); }

    struct Result {
        double squares = 0.0;
        Matrix normal;
        Vector gradient; ///< J^T residual
        std::vector<double> predicted_Hz;
        std::size_t moving = 0; ///< samples that depend on the parameters
    };

    /// parameters: ln tau up, ln tau down, speeds of the levels.
    [[nodiscard]] Result evaluate(const Vector& parameters, bool derivatives) const {
        const Eigen::Index count = parameters.size();
        Result result;
        result.normal = Matrix::Zero(count, count);
        result.gradient = Vector::Zero(count);
        result.predicted_Hz.reserve(samples());
        const std::array<double, 2> tau_s{std::exp(parameters[0]), std::exp(parameters[1])};
        double speed_Hz = 0.0;
        Vector slope = Vector::Zero(count);
        for (std::size_t i = 0; i < samples(); ++i) {
            if (m_ignored[i]) {
                speed_Hz = m_recording.speed_Hz[i];
                slope.setZero();
            }
            result.predicted_Hz.push_back(speed_Hz);
            const bool known = m_recording.isKnown(i);
            const double residual_Hz = known ? m_recording.speed_Hz[i] - speed_Hz : 0.0;
            result.squares += residual_Hz * residual_Hz;
            if (derivatives && known) {
                result.normal.selfadjointView<Eigen::Lower>().rankUpdate(slope);
                result.gradient += residual_Hz * slope;
                result.moving += slope.squaredNorm() > 0.0 ? 1 : 0;
            }
            if (i + 1 == samples())
                break;
            const Blend& blend = m_blends[i];
            const double steady_Hz =
                blend.firstShare * parameters[2 + blend.first] +
                (blend.secondShare != 0.0 ? blend.secondShare * parameters[3 + blend.first] : 0.0);
            const Eigen::Index side = steady_Hz > speed_Hz ? 0 : 1;
            const double ratio =
                (m_recording.time_s[i + 1] - m_recording.time_s[i]) / tau_s[static_cast<std::size_t>(side)];
            const double kept = std::exp(-ratio);
            if (derivatives) {
                slope *= kept;
                slope[side] += (speed_Hz - steady_Hz) * kept * ratio;
                slope[2 + blend.first] += blend.firstShare * (1.0 - kept);
                if (blend.secondShare != 0.0)
                    slope[3 + blend.first] += blend.secondShare * (1.0 - kept);
            }
            speed_Hz = steady_Hz + (speed_Hz - steady_Hz) * kept;
        }
        result.normal = result.normal.selfadjointView<Eigen::Lower>();
        return result;
    }

private:
    static Blend blend(const std::vector<SpeedLevel>& levels, double drive) {
        std::size_t next = 1;
        while (next + 1 < levels.size() && levels[next].drive < drive)
            ++next;
        const SpeedLevel& a = levels[next - 1];
        const double share = (drive - a.drive) / (levels[next].drive - a.drive);
        return {static_cast<Eigen::Index>(next) - 1, 1.0 - share, share};
    }

    const MotorRecording& m_recording;
    const std::vector<bool>& m_ignored;
    std::vector<Blend> m_blends;
};

struct Minimum {
    Vector parameters;
    LagProblem::Result at;
};

Minimum minimise(const LagProblem& problem, Vector parameters) {
    LagProblem::Result here = problem.evaluate(parameters, true);
    double damping = 1e-3;
    for (int i = 0; i < kIterations; ++i) {
        Matrix damped = here.normal;
        damped.diagonal() *= 1.0 + damping;
        const Vector step = damped.ldlt().solve(here.gradient);
        Vector there = parameters + step;
        // Time constants are kept between 0.1 ms and 10 s.
        for (const Eigen::Index k : {0, 1})
            there[k] = std::clamp(there[k], std::log(1e-4), std::log(10.0));
        const bool finite = there.allFinite();
        const double squares =
            finite ? problem.evaluate(there, false).squares : std::numeric_limits<double>::infinity();
        if (squares > here.squares || !finite) {
            damping *= 8.0;
            if (damping > 1e12)
                break;
            continue;
        }
        const bool converged = here.squares - squares <= kConverged * here.squares;
        parameters = there;
        here = problem.evaluate(parameters, true);
        damping = std::max(damping / 10.0, 1e-12);
        if (converged)
            break;
    }
    return {std::move(parameters), std::move(here)};
}

/// Factor that widens the standard errors because neighbouring residuals are correlated.
double widening(const MotorRecording& recording, const std::vector<double>& predicted_Hz) {
    double own = 0.0;
    double shared = 0.0;
    double before_Hz = 0.0;
    for (std::size_t i = 0; i < recording.size(); ++i) {
        const bool counts = predicted_Hz[i] > 0.0 && recording.isKnown(i);
        const double residual_Hz = counts ? recording.speed_Hz[i] - predicted_Hz[i] : 0.0;
        own += residual_Hz * residual_Hz;
        shared += residual_Hz * before_Hz;
        before_Hz = residual_Hz;
    }
    const double correlation = own > 0.0 ? std::clamp(shared / own, 0.0, 0.99) : 0.0;
    return std::sqrt((1.0 + correlation) / (1.0 - correlation));
}

} // namespace

std::optional<LagFit> fitLag(const MotorRecording& recording, double start,
                             const std::vector<SpeedLevel>& levels, const std::vector<bool>& ignored) {
    const LagProblem problem(recording, start, levels, ignored);
    const auto from = [&](double first_s) {
        Vector parameters = Vector::Constant(static_cast<Eigen::Index>(levels.size()) + 2, std::log(first_s));
        for (std::size_t k = 0; k < levels.size(); ++k)
            parameters[static_cast<Eigen::Index>(k) + 2] = levels[k].speed_Hz;
        return minimise(problem, std::move(parameters));
    };
    Minimum best = from(0.03);
    for (const double first_s : {0.01, 0.1}) {
        Minimum minimum = from(first_s);
        if (minimum.at.squares < best.at.squares)
            best = std::move(minimum);
    }
    const auto count = best.parameters.size();
    const Eigen::LDLT<Matrix> factor = best.at.normal.ldlt();
    const Vector diagonal = factor.vectorD();
    if (factor.info() != Eigen::Success || !(diagonal.minCoeff() > 1e-12 * diagonal.maxCoeff()) ||
        best.at.moving <= static_cast<std::size_t>(count))
        return std::nullopt;

    LagFit fit;
    fit.predicted_Hz = std::move(best.at.predicted_Hz);
    double squares = 0.0;
    double mean_Hz = 0.0;
    std::size_t turning = 0;
    for (std::size_t i = 0; i < recording.size(); ++i) {
        if (!(fit.predicted_Hz[i] > 0.0) || !recording.isKnown(i))
            continue;
        const double residual_Hz = recording.speed_Hz[i] - fit.predicted_Hz[i];
        squares += residual_Hz * residual_Hz;
        mean_Hz += recording.speed_Hz[i];
        ++turning;
    }
    mean_Hz /= static_cast<double>(turning);
    double total = 0.0;
    for (std::size_t i = 0; i < recording.size(); ++i)
        if (fit.predicted_Hz[i] > 0.0 && recording.isKnown(i))
            total += (recording.speed_Hz[i] - mean_Hz) * (recording.speed_Hz[i] - mean_Hz);
    fit.residual_Hz = std::sqrt(squares / static_cast<double>(turning));
    fit.explained = total > 0.0 ? 1.0 - squares / total : 0.0;

    const double deviation_Hz =
        std::sqrt(squares /
                  static_cast<double>(std::max<std::size_t>(
                      turning - std::min<std::size_t>(turning - 1, static_cast<std::size_t>(count)), 1))) *
        widening(recording, fit.predicted_Hz);
    const Matrix inverse = factor.solve(Matrix::Identity(count, count));
    const auto error = [&](Eigen::Index k) { return deviation_Hz * std::sqrt(std::max(inverse(k, k), 0.0)); };
    fit.up_s = std::exp(best.parameters[0]);
    fit.upError_s = fit.up_s * error(0);
    fit.down_s = std::exp(best.parameters[1]);
    fit.downError_s = fit.down_s * error(1);
    for (std::size_t k = 0; k < levels.size(); ++k) {
        const auto index = static_cast<Eigen::Index>(k) + 2;
        fit.levels.push_back({levels[k].drive, best.parameters[index], error(index)});
    }
    return fit;
}

} // namespace teleta::motors
