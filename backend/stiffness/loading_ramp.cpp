// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/stiffness/loading_ramp.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>
#include <utility>

namespace teleta::stiffness {

namespace {

bool comesBefore(const JointSample& a, const JointSample& b) {
    return std::tie(a.time_s, a.torque_Nm, a.angle_rad) < std::tie(b.time_s, b.torque_Nm, b.angle_rad);
}

} // namespace

std::vector<JointSample> inOrderOfTime(std::span<const JointSample> samples) {
    std::vector<JointSample> log(samples.begin(), samples.end());
    if (!std::is_sorted(log.begin(), log.end(), comesBefore))
        std::sort(log.begin(), log.end(), comesBefore);
    log.erase(std::unique(log.begin(), log.end()), log.end());
    return log;
}

std::vector<JointSample> loadingRamp(std::span<const JointSample> samples, const TorqueWindow& window,
                                     double torqueReference_Nm) {
    std::vector<JointSample> log = inOrderOfTime(samples);
    for (JointSample& sample : log)
        sample.torque_Nm -= torqueReference_Nm;
    const OrderedTouch touch = orderedTouch(std::move(log), window);
    return {touch.ramp().begin(), touch.ramp().end()};
}

OrderedTouch orderedTouch(std::vector<JointSample> samples, const TorqueWindow& window) {
    OrderedTouch touch;
    touch.log = std::move(samples);
    std::vector<JointSample>& log = touch.log;

    // The direction of the touch is read where the torque is well above the noise.
    auto touched = std::find_if(log.begin(), log.end(), [&](const JointSample& sample) {
        return std::abs(sample.torque_Nm) >= window.middle_Nm();
    });
    if (touched == log.end())
        touched = std::max_element(log.begin(), log.end(), [](const JointSample& a, const JointSample& b) {
            return std::abs(a.torque_Nm) < std::abs(b.torque_Nm);
        });
    if (touched == log.end() || std::abs(touched->torque_Nm) < window.low_Nm)
        return touch;
    if (touched->torque_Nm < 0.0) {
        touch.turned = true;
        for (JointSample& sample : log) {
            sample.torque_Nm = -sample.torque_Nm;
            sample.angle_rad = -sample.angle_rad;
        }
    }

    const auto lessTorque = [](const JointSample& a, const JointSample& b) {
        return a.torque_Nm < b.torque_Nm;
    };
    auto reached = std::find_if(log.begin(), log.end(), [&](const JointSample& sample) {
        return sample.torque_Nm >= window.high_Nm;
    });
    if (reached == log.end())
        reached = std::max_element(log.begin(), log.end(), lessTorque);

    const double margin_Nm = kWindowMargin * window.width_Nm();
    const double least_Nm = std::max(window.low_Nm - margin_Nm, 0.5 * window.low_Nm);
    const double middle_Nm = 0.5 * (window.low_Nm + std::min(reached->torque_Nm, window.high_Nm));
    const auto left = std::find_if(reached + 1, log.end(), [&](const JointSample& sample) {
        return sample.torque_Nm < middle_Nm || sample.torque_Nm > window.high_Nm + margin_Nm;
    });
    // The last of equal summits: a coarse torque reading has many of them while the joint stands still.
    const auto top =
        std::max_element(std::make_reverse_iterator(left), std::make_reverse_iterator(reached), lessTorque)
            .base();
    auto first = reached;
    while (first != log.begin() && (first - 1)->torque_Nm >= least_Nm)
        --first;
    touch.first = static_cast<std::size_t>(first - log.begin());
    touch.end = static_cast<std::size_t>(top - log.begin());
    return touch;
}

EstimatedNoise estimateNoise(std::span<const JointSample> ramp) {
    double torqueSquares = 0.0;
    double angleSquares = 0.0;
    std::size_t triples = 0;
    for (std::size_t i = 1; i + 1 < ramp.size(); ++i) {
        const JointSample& before = ramp[i - 1];
        const JointSample& after = ramp[i + 1];
        const double span_s = after.time_s - before.time_s;
        if (span_s <= 0.0)
            continue;
        const double a = (ramp[i].time_s - before.time_s) / span_s;
        const double weight = 1.0 + (1.0 - a) * (1.0 - a) + a * a;
        const auto offset = [&](double low, double here, double high) {
            return (here - low) - a * (high - low);
        };
        const double torque_Nm = offset(before.torque_Nm, ramp[i].torque_Nm, after.torque_Nm);
        const double angle_rad = offset(before.angle_rad, ramp[i].angle_rad, after.angle_rad);
        torqueSquares += torque_Nm * torque_Nm / weight;
        angleSquares += angle_rad * angle_rad / weight;
        ++triples;
    }
    EstimatedNoise estimate;
    if (triples > 0) {
        const auto count = static_cast<double>(triples);
        estimate.noise = {std::sqrt(torqueSquares / count), std::sqrt(angleSquares / count)};
        estimate.degreesOfFreedom = std::max(1.0, 18.0 / 35.0 * count);
    }
    return estimate;
}

} // namespace teleta::stiffness
