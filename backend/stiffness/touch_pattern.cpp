// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/stiffness/touch_pattern.h"

#include "backend/core/quantile.h"
#include "backend/stiffness/compliance_line.h"
#include "backend/stiffness/residual_pattern.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace teleta::stiffness {

namespace {

constexpr std::size_t kLeastSamples = 20;
constexpr double kPattern_se = 3.5;
constexpr double kRiseSignificant_se = 2.6;
constexpr double kRelevant = 0.05;      ///< of a slope
constexpr double kRelevantDecay = 0.05; ///< of the window

struct Mean {
    double value = 0.0;
    double count = 0.0;

    void add(double x) {
        count += 1.0;
        value += (x - value) / count;
    }
};

class Examination {
public:
    Examination(const OrderedTouch& touch, std::size_t contact, double noise_Nm, double inflation,
                double stiffness_NmPerRad, const TorqueWindow& window)
        : m_touch(touch)
        , m_contact(contact)
        , m_noise_Nm(noise_Nm)
        , m_meanNoise_Nm(noise_Nm * std::sqrt(inflation))
        , m_stiffness_NmPerRad(stiffness_NmPerRad)
        , m_window(window) {}

    TouchPattern pattern() {
        if (m_touch.end < m_contact + kLeastSamples)
            return m_pattern;
        examineRise();
        examineJumps();
        examineFalls();
        examineTurns();
        examineHold();
        examineUnloading();
        return m_pattern;
    }

private:
    [[nodiscard]] const JointSample& at(std::size_t i) const { return m_touch.log[i]; }

    void examineRise() {
        // Without the last one: with it the log may have ended because its noise was high.
        std::vector<double> angles;
        std::vector<double> torques;
        for (std::size_t i = m_contact; i + 1 < m_touch.end; ++i) {
            angles.push_back((at(i).angle_rad - at(m_contact).angle_rad) * m_stiffness_NmPerRad);
            torques.push_back(at(i).torque_Nm);
        }
        const std::optional<Bend> bend = fitBend(angles, torques);
        if (!bend || bend->residualSd <= 0.0)
            return;
        const double floor_Nm = 1e-6 * m_window.width_Nm();
        const double se = bend->se / bend->residualSd * std::max(m_meanNoise_Nm, floor_Nm);
        m_pattern.softening = -bend->change;
        m_pattern.rateDependent = -bend->change > kRelevant && -bend->change > kRiseSignificant_se * se;
    }

    void examineJumps() {
        constexpr double kJump_sd = 7.0;
        constexpr int kJumps = 2;
        const double limit_Nm = std::max(kJump_sd * std::sqrt(2.0) * m_noise_Nm, 0.02 * m_window.width_Nm());
        int jumps = 0;
        for (std::size_t i = m_contact + 1; i < m_touch.end; ++i) {
            const double elastic_Nm = m_stiffness_NmPerRad * (at(i).angle_rad - at(i - 1).angle_rad);
            jumps += at(i).torque_Nm - at(i - 1).torque_Nm - elastic_Nm < -limit_Nm ? 1 : 0;
        }
        m_pattern.stickSlip = jumps >= kJumps;
    }

    /// A torque that falls back in the middle of the rise is the arm's own: its motion faltered or a joint
    /// slipped. Where it falls out of the window, the rise seems to begin after it.
    void examineFalls() {
        constexpr double kFall_sd = 8.0;
        constexpr double kFall = 0.25; ///< of the window
        std::vector<double> changes_Nm;
        for (std::size_t i = m_contact + 1; i < m_touch.end; ++i)
            changes_Nm.push_back(std::abs(at(i).torque_Nm - at(i - 1).torque_Nm));
        // Of normal noise half of the differences are smaller than 0.674 times their standard deviation.
        const double sd_Nm = core::medianOf(changes_Nm) / 0.6745 / std::sqrt(2.0);
        const double limit_Nm = std::max(kFall * m_window.width_Nm(), kFall_sd * sd_Nm);
        double summit_Nm = at(m_contact).torque_Nm;
        for (std::size_t i = m_contact; i < m_touch.end; ++i) {
            summit_Nm = std::max(summit_Nm, at(i).torque_Nm);
            m_pattern.stickSlip = m_pattern.stickSlip || summit_Nm - at(i).torque_Nm > limit_Nm;
        }
    }

    /// Samples of forward and of backward motion have another torque at the same angle when there is play.
    void examineTurns() {
        double range_rad = 0.0;
        double step_rad = 0.0;
        for (std::size_t i = m_contact + 1; i < m_touch.end; ++i) {
            range_rad = std::max(range_rad, std::abs(at(i).angle_rad - at(m_contact).angle_rad));
            step_rad = std::max(step_rad, std::abs(at(i).angle_rad - at(i - 1).angle_rad));
        }
        const double turn_rad = std::max(0.01 * range_rad, 2.0 * step_rad);
        std::vector<double> angles;
        std::vector<double> torques;
        std::vector<int> directions;
        double extreme_rad = at(m_contact).angle_rad;
        int direction = 1;
        int turns = 0;
        for (std::size_t i = m_contact; i < m_touch.end; ++i) {
            const double angle_rad = at(i).angle_rad;
            if (direction * (angle_rad - extreme_rad) > 0.0)
                extreme_rad = angle_rad;
            else if (direction * (extreme_rad - angle_rad) > turn_rad) {
                direction = -direction;
                extreme_rad = angle_rad;
                ++turns;
            }
            if (at(i).torque_Nm < m_window.low_Nm)
                continue;
            angles.push_back((angle_rad - at(m_contact).angle_rad) * m_stiffness_NmPerRad);
            torques.push_back(at(i).torque_Nm);
            directions.push_back(direction);
        }
        std::vector<double> residuals(angles.size());
        if (turns == 0 || !fitBend(angles, torques, residuals))
            return;
        Mean forward;
        Mean backward;
        for (std::size_t i = 0; i < residuals.size(); ++i)
            (directions[i] > 0 ? forward : backward).add(residuals[i]);
        if (forward.count < 5.0 || backward.count < 5.0)
            return;
        const double se_Nm = m_meanNoise_Nm * std::sqrt(1.0 / forward.count + 1.0 / backward.count);
        const double gap_Nm = std::abs(forward.value - backward.value);
        m_pattern.stickSlip = m_pattern.stickSlip ||
                              (gap_Nm > kPattern_se * se_Nm && gap_Nm > kRelevantDecay * m_window.width_Nm());
    }

    void examineHold() {
        const std::size_t size = m_touch.log.size();
        if (m_touch.end >= size)
            return;
        const double turned_rad = at(m_touch.end - 1).angle_rad - at(m_contact).angle_rad;
        const double slack_rad = 0.02 * std::abs(turned_rad);
        // The joint may still come to rest: the hold begins where the angle no longer changes.
        std::size_t end = m_touch.end;
        double highest_rad = at(end - 1).angle_rad;
        while (end < size && at(end).torque_Nm > 0.2 * m_window.low_Nm &&
               at(end).angle_rad > highest_rad - slack_rad) {
            highest_rad = std::max(highest_rad, at(end).angle_rad);
            ++end;
        }
        std::size_t begin = end;
        while (begin > m_touch.first && at(begin - 1).angle_rad > highest_rad - slack_rad)
            --begin;
        if (end - begin < kLeastSamples)
            return;
        m_pattern.holdBegin = begin;
        m_pattern.holdEnd = end;
        const std::size_t fifth = (end - begin) / 5;
        Mean early;
        Mean late;
        for (std::size_t i = 0; i < fifth; ++i) {
            const auto held_Nm = [&](std::size_t k) {
                return at(k).torque_Nm - m_stiffness_NmPerRad * (at(k).angle_rad - highest_rad);
            };
            early.add(held_Nm(begin + i));
            late.add(held_Nm(end - 1 - i));
        }
        const double decay_Nm = early.value - late.value;
        const double se_Nm = m_meanNoise_Nm * std::sqrt(2.0 / early.count);
        if (decay_Nm > kPattern_se * se_Nm && decay_Nm > kRelevantDecay * m_window.width_Nm())
            m_pattern.rateDependent = true;
    }

    void examineUnloading() {
        const auto begin = std::max(m_touch.end, m_pattern.holdEnd);
        std::vector<TorqueAngle> points;
        for (std::size_t i = begin; i < m_touch.log.size() && at(i).torque_Nm > m_window.low_Nm; ++i)
            if (at(i).torque_Nm < m_window.high_Nm)
                points.push_back({at(i).torque_Nm, at(i).angle_rad - at(m_contact).angle_rad});
        if (points.size() < kLeastSamples || points.size() > m_touch.log.size())
            return;
        const auto line = fitComplianceLine(points, {m_noise_Nm, 0.0});
        if (!line || !line->correlated || !line->slopeSe_radPerNm)
            return;
        const double expected = 1.0 / m_stiffness_NmPerRad;
        const double inflation = m_noise_Nm > 0.0 ? m_meanNoise_Nm / m_noise_Nm : 1.0;
        const double se = std::sqrt(2.0) * inflation * *line->slopeSe_radPerNm;
        const double difference = std::abs(line->slope_radPerNm - expected);
        if (difference > kPattern_se * se && difference > kRelevant * expected)
            m_pattern.rateDependent = true;
    }

    const OrderedTouch& m_touch;
    std::size_t m_contact;
    double m_noise_Nm;
    double m_meanNoise_Nm;
    double m_stiffness_NmPerRad;
    TorqueWindow m_window;
    TouchPattern m_pattern;
};

} // namespace

TouchPattern examineTouch(const OrderedTouch& touch, std::size_t contact, double noise_Nm, double inflation,
                          double stiffness_NmPerRad, const TorqueWindow& window) {
    return Examination(touch, contact, noise_Nm, inflation, stiffness_NmPerRad, window).pattern();
}

} // namespace teleta::stiffness
