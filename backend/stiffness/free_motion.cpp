// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/stiffness/free_motion.h"

#include "backend/stiffness/residual_pattern.h"
#include "backend/stiffness/speed_up.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace teleta::stiffness {

namespace {

constexpr std::size_t kLeastFree = 10;
/// The rise must be so much steeper than the free motion.
constexpr double kSteeper = 2.5;
/// The bend must take off so many times the variance of the noise from the squares: noise alone bends a line
/// somewhere, too, by about 2 ln n.
constexpr double kBendSquares = 50.0;
/// Size that a drift may have beside an acceleration, over the rise.
constexpr double kLikelyDrift = 0.2;
/// Samples beyond so many windows or durations would lose the digits of the others.
constexpr double kFarthest = 1e6;

/// Sums for lines through any stretch of samples.
struct Sums {
    double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;

    void add(double px, double py) {
        n += 1.0;
        x += px;
        y += py;
        xx += px * px;
        xy += px * py;
        yy += py * py;
    }
    [[nodiscard]] Sums minus(const Sums& other) const {
        return {n - other.n, x - other.x, y - other.y, xx - other.xx, xy - other.xy, yy - other.yy};
    }
    [[nodiscard]] double spread() const { return xx - x * x / n; }
    [[nodiscard]] double slope() const { return spread() > 1e-12 * xx ? (xy - x * y / n) / spread() : 0.0; }
    [[nodiscard]] double squares() const {
        const double s = slope();
        return std::max(0.0, yy - y * y / n - s * (xy - x * y / n));
    }
};

double medianTorque_Nm(std::span<const JointSample> samples) {
    std::vector<double> torques(samples.size());
    std::ranges::transform(samples, torques.begin(), &JointSample::torque_Nm);
    const auto middle = torques.begin() + static_cast<std::ptrdiff_t>(torques.size() / 2);
    std::ranges::nth_element(torques, middle);
    return *middle;
}

/// The trailing stretch in which the joint turns as quickly as at its end.
std::size_t firstOfEvenMotion(std::span<const JointSample> free) {
    constexpr std::size_t kBlocks = 12;
    const std::size_t length = free.size() / kBlocks;
    if (length < 4)
        return 0;
    const auto turned_rad = [&](std::size_t end) {
        return free[end - 1].angle_rad - free[end - length].angle_rad;
    };
    const auto rate = [&](std::size_t end) {
        const double time_s = free[end - 1].time_s - free[end - length].time_s;
        return time_s > 0.0 ? turned_rad(end) / time_s : 0.0;
    };
    // The last two blocks together set the rate, so that steps of the reading do not.
    const double last = 0.5 * (rate(free.size()) + rate(free.size() - length));
    double noise_rad = 0.0;
    for (std::size_t i = free.size() - 2 * length + 1; i < free.size(); ++i)
        noise_rad = std::max(noise_rad, std::abs(free[i].angle_rad - free[i - 1].angle_rad));
    std::size_t end = free.size() - 2 * length;
    for (; end >= length; end -= length) {
        const double time_s = free[end - 1].time_s - free[end - length].time_s;
        const double slack_rad = 0.5 * std::abs(last) * time_s + 2.0 * noise_rad;
        if (std::abs(turned_rad(end) - last * time_s) > slack_rad)
            return end;
    }
    return 0;
}

/// The torque of a motion that begins, in place of a line over its last part.
void take(const SpeedUp& speedUp, std::size_t from, std::span<const JointSample> log, FreeMotion& free) {
    free.first = from + speedUp.first;
    free.samples = speedUp.samples;
    const JointSample& last = log[free.first + free.samples - 1];
    free.middle_s = last.time_s;
    free.middle_rad = last.angle_rad;
    free.torque_Nm = speedUp.torque_Nm;
    free.torqueSe_Nm = speedUp.torqueSe_Nm;
    free.drift_NmPerS = speedUp.drift_NmPerS;
    free.driftSe_NmPerS = speedUp.driftSe_NmPerS;
    free.rate_radPerS = speedUp.rate_radPerS;
    free.sd_Nm = speedUp.sd_Nm;
    free.inflation = speedUp.inflation;
    free.inertia_kgm2 = speedUp.inertia_kgm2;
    free.accelerationWidth_s = speedUp.halfWidth_s;
}

} // namespace

double FreeMotion::later_s(const JointSample& sample) const {
    const double byTime_s = sample.time_s - middle_s;
    const double turned_rad = sample.angle_rad - middle_rad;
    // An angle that does not turn, or turns back, tells no time.
    if (rate_radPerS == 0.0 || !(turned_rad / rate_radPerS > 0.0) ||
        turned_rad / rate_radPerS > 10.0 * std::abs(byTime_s))
        return byTime_s;
    return 0.5 * (byTime_s + turned_rad / rate_radPerS);
}

std::optional<FreeMotion> findFreeMotion(std::span<const JointSample> log, const TorqueWindow& window) {
    if (log.size() < 2 * kLeastFree)
        return std::nullopt;
    const std::size_t start = std::clamp<std::size_t>(log.size() / 20, 5, 50);
    const double first_Nm = medianTorque_Nm(log.first(start));
    const auto rise_Nm = [&](std::size_t i) { return log[i].torque_Nm - first_Nm; };
    std::size_t risen = 0;
    while (risen < log.size() && std::abs(rise_Nm(risen)) < window.middle_Nm())
        ++risen;
    if (risen == log.size() || risen < kLeastFree)
        return std::nullopt;
    const double direction = rise_Nm(risen) < 0.0 ? -1.0 : 1.0;
    std::size_t low = risen;
    while (low > 0 && direction * rise_Nm(low - 1) >= 0.5 * window.low_Nm)
        --low;

    // No further back than a few times the rise lasts, counted in samples.
    const std::size_t reach = 20 * (risen - low + 1) + 400;
    const std::size_t from = risen > reach ? risen - reach : 0;
    const double span_s = log[risen].time_s - log[from].time_s;
    if (!(span_s > 0.0))
        return std::nullopt;
    std::vector<Sums> sums(risen - from + 1);
    for (std::size_t i = from; i < risen; ++i) {
        const double x = (log[i].time_s - log[risen].time_s) / span_s;
        const double y = direction * rise_Nm(i) / window.width_Nm();
        if (std::abs(x) > kFarthest || std::abs(y) > kFarthest)
            return std::nullopt;
        sums[i - from + 1] = sums[i - from];
        sums[i - from + 1].add(x, y);
    }
    constexpr std::size_t kLeastRise = 3;
    const Sums& all = sums.back();
    double least = all.squares();
    std::size_t bend = 0;
    for (std::size_t k = kLeastFree; k + kLeastRise < sums.size(); ++k) {
        const double squares = sums[k].squares() + all.minus(sums[k]).squares();
        if (squares < least) {
            least = squares;
            bend = k;
        }
    }
    const double freedom = static_cast<double>(sums.size()) - 5.0;
    if (bend == 0 || (all.squares() - least) * freedom < kBendSquares * least)
        return std::nullopt;
    const double steep = all.minus(sums[bend]).slope();
    if (!(steep > 0.0) || steep < kSteeper * std::abs(sums[bend].slope()))
        return std::nullopt;

    FreeMotion free;
    free.contact = from + bend;
    const std::size_t guard = std::max<std::size_t>(2, bend / 50);
    std::size_t last = from + bend - std::min(guard, bend);
    if (last < from + kLeastFree)
        return std::nullopt;
    free.first = from + firstOfEvenMotion(log.subspan(from, last - from));
    free.samples = last - free.first;
    if (free.samples < kLeastFree)
        return std::nullopt;
    const auto stretch = log.subspan(free.first, free.samples);
    const auto count = static_cast<double>(free.samples);
    for (const JointSample& sample : stretch) {
        free.middle_s += (sample.time_s - log[risen].time_s) / count;
        free.middle_rad += (sample.angle_rad - stretch.back().angle_rad) / count;
        free.torque_Nm += (sample.torque_Nm - first_Nm) / count;
    }
    free.middle_s += log[risen].time_s;
    free.middle_rad += stretch.back().angle_rad;
    free.torque_Nm += first_Nm;
    double timeSquares = 0.0;
    double torqueProducts = 0.0;
    double angleProducts = 0.0;
    for (const JointSample& sample : stretch) {
        const double t = (sample.time_s - free.middle_s) / span_s;
        timeSquares += t * t;
        torqueProducts += t * (sample.torque_Nm - free.torque_Nm);
        angleProducts += t * (sample.angle_rad - free.middle_rad);
    }
    std::vector<double> residuals(free.samples);
    const double slope_Nm = timeSquares > 0.0 ? torqueProducts / timeSquares : 0.0;
    double largest = 0.0;
    for (std::size_t i = 0; i < free.samples; ++i) {
        residuals[i] = (stretch[i].torque_Nm - free.torque_Nm -
                        slope_Nm * (stretch[i].time_s - free.middle_s) / span_s) /
                       window.width_Nm();
        largest += residuals[i] * residuals[i];
    }
    free.sd_Nm = window.width_Nm() * std::sqrt(largest / (count - 2.0));
    constexpr double kRoundingOfWindow = 1e-6;
    if (free.sd_Nm > kRoundingOfWindow * window.width_Nm())
        free.inflation = varianceInflation(residuals, 2);
    const double sd_Nm = free.sd_Nm * std::sqrt(free.inflation);
    free.torqueSe_Nm = sd_Nm / std::sqrt(count);
    if (timeSquares > 0.0) {
        free.drift_NmPerS = slope_Nm / span_s;
        free.driftSe_NmPerS = sd_Nm / std::sqrt(timeSquares) / span_s;
        free.rate_radPerS = angleProducts / timeSquares / span_s;
    }
    const double likelyDrift_NmPerS = kLikelyDrift * steep * window.width_Nm() / span_s;
    if (const auto speedUp = findSpeedUp(log.subspan(from), last - from, likelyDrift_NmPerS))
        take(*speedUp, from, log, free);
    return free;
}

} // namespace teleta::stiffness
