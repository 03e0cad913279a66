// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/motors/lag_fit.h"

#include "backend/core/quantile.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <cstddef>
#include <limits>

namespace teleta::motors {

namespace {

using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;

constexpr int kIterations = 60;
constexpr double kConverged = 1e-10;  ///< relative change of the sum of squares
constexpr double kSmallestRest = 0.1; ///< share of the information that the other steps hold at least

/// The steady speed as a weighted sum of at most two levels.
struct Blend {
    Eigen::Index first = 0;
    double firstShare = 0.0;
    double secondShare = 0.0; ///< of first + 1
};

constexpr Eigen::Index kUp = 0;
constexpr Eigen::Index kDown = 1;
constexpr Eigen::Index kLead = 2;
constexpr Eigen::Index kLevels = 3; ///< the first of the steady speeds

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
        struct Step {
            Matrix normal;
            Vector gradient;
        };
        std::vector<Step> steps; ///< shares of the times between two changes of the drive
        std::vector<double> predicted_Hz;
        std::size_t moving = 0; ///< samples that depend on the parameters
    };

    /// parameters: ln tau up, ln tau down, lead (share of a sample by which a change of the drive acts before
    /// the first sample that shows it), speeds of the levels.
    [[nodiscard]] Result evaluate(const Vector& parameters, bool derivatives) const {
        const Eigen::Index count = parameters.size();
        Result result;
        result.normal = Matrix::Zero(count, count);
        result.gradient = Vector::Zero(count);
        result.predicted_Hz.reserve(samples());
        Motion motion{0.0, Vector::Zero(count)};
        Result::Step step{Matrix::Zero(count, count), Vector::Zero(count)};
        const auto endStep = [&] {
            if (!derivatives)
                return;
            step.normal = step.normal.selfadjointView<Eigen::Lower>();
            result.normal += step.normal;
            result.gradient += step.gradient;
            result.steps.push_back(step);
            step.normal.setZero();
            step.gradient.setZero();
        };
        for (std::size_t i = 0; i < samples(); ++i) {
            if (m_ignored[i]) {
                motion.speed_Hz = m_recording.speed_Hz[i];
                motion.slope.setZero();
            }
            result.predicted_Hz.push_back(motion.speed_Hz);
            const bool known = m_recording.isKnown(i);
            const double residual_Hz = known ? m_recording.speed_Hz[i] - motion.speed_Hz : 0.0;
            result.squares += residual_Hz * residual_Hz;
            if (derivatives && known) {
                step.normal.selfadjointView<Eigen::Lower>().rankUpdate(motion.slope);
                step.gradient += residual_Hz * motion.slope;
                result.moving += motion.slope.squaredNorm() > 0.0 ? 1 : 0;
            }
            if (i + 1 == samples())
                break;
            const double duration_s = m_recording.time_s[i + 1] - m_recording.time_s[i];
            if (m_recording.drive[i] == m_recording.drive[i + 1]) {
                advance(motion, m_blends[i], parameters, duration_s, 0.0, derivatives);
                continue;
            }
            endStep();
            const double lead_s = parameters[kLead] * duration_s;
            advance(motion, m_blends[i], parameters, duration_s - lead_s, -duration_s, derivatives);
            advance(motion, m_blends[i + 1], parameters, lead_s, duration_s, derivatives);
        }
        endStep();
        return result;
    }

private:
    struct Motion {
        double speed_Hz = 0.0;
        Vector slope; ///< of the speed over the parameters
    };

    /// perLead_s: change of the duration with the lead.
    static void advance(Motion& motion, const Blend& blend, const Vector& parameters, double duration_s,
                        double perLead_s, bool derivatives) {
        const double steady_Hz =
            blend.firstShare * parameters[kLevels + blend.first] +
            (blend.secondShare != 0.0 ? blend.secondShare * parameters[kLevels + 1 + blend.first] : 0.0);
        const Eigen::Index side = steady_Hz > motion.speed_Hz ? kUp : kDown;
        const double tau_s = std::exp(parameters[side]);
        const double ratio = duration_s / tau_s;
        const double kept = std::exp(-ratio);
        const double off_Hz = (motion.speed_Hz - steady_Hz) * kept;
        if (derivatives) {
            motion.slope *= kept;
            motion.slope[side] += off_Hz * ratio;
            motion.slope[kLead] -= off_Hz * perLead_s / tau_s;
            motion.slope[kLevels + blend.first] += blend.firstShare * (1.0 - kept);
            if (blend.secondShare != 0.0)
                motion.slope[kLevels + 1 + blend.first] += blend.secondShare * (1.0 - kept);
        }
        motion.speed_Hz = steady_Hz + off_Hz;
    }

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
        there[kLead] = std::clamp(there[kLead], 0.0, 1.0);
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
        std::vector<double> guess{std::log(first_s), std::log(first_s), 0.5};
        for (const SpeedLevel& level : levels)
            guess.push_back(level.speed_Hz);
        return minimise(problem, Vector::Map(guess.data(), static_cast<Eigen::Index>(guess.size())));
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
    // What differs from step to step, such as the moment at which a busy computer wrote it, shows between the
    // steps only: each is left out in turn, to first order.
    const auto betweenSteps = [&](Eigen::Index k) {
        const Vector column = inverse.col(k);
        double variance = 0.0;
        double sharesSquared = 0.0;
        for (const LagProblem::Result::Step& step : best.at.steps) {
            const Vector informed = step.normal * column;
            const double share = column.dot(informed) / inverse(k, k);
            const double change = column.dot(step.gradient) / std::max(1.0 - share, kSmallestRest);
            variance += change * change;
            sharesSquared += share * share;
        }
        // A few large steps hold most of what is known of a lag, so 1.96 errors are made Student's 95 %.
        const double widened =
            boost::math::quantile(boost::math::students_t(std::max(1.0 / sharesSquared - 1.0, 1.0)), 0.975) /
            core::kNormalQuantile95;
        return variance * widened * widened;
    };
    const auto fromResiduals = [&](Eigen::Index k) {
        return deviation_Hz * deviation_Hz * std::max(inverse(k, k), 0.0);
    };
    // A level is held in one or two steps, which say nothing about the scatter between steps.
    const auto error = [&](Eigen::Index k) {
        return std::sqrt(k < kLevels ? std::max(fromResiduals(k), betweenSteps(k)) : fromResiduals(k));
    };
    fit.up_s = std::exp(best.parameters[0]);
    fit.upError_s = fit.up_s * error(kUp);
    fit.down_s = std::exp(best.parameters[1]);
    fit.downError_s = fit.down_s * error(kDown);
    for (std::size_t k = 0; k < levels.size(); ++k) {
        const auto index = static_cast<Eigen::Index>(k) + kLevels;
        fit.levels.push_back({levels[k].drive, best.parameters[index], error(index)});
    }
    return fit;
}

} // namespace teleta::motors
