// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/random_stream.h"
#include "backend/cost/ladders/ladders.h"
#include "backend/cost/limit_rung.h"
#include "backend/stiffness/stiffness_estimator.h"

#include <array>
#include <cmath>
#include <memory>

namespace teleta::cost {

namespace {

constexpr double kTouchDistance_m = 0.19;
constexpr double kTorqueNoise_Nm = 0.0005;
constexpr double kAngleNoise_rad = 2e-6;
/// Sponge, rubber sponge, rubber, wood of the paper.
constexpr std::array kTouched_NPerM{282.0, 1325.9, 7223.9, 8562.9};

struct Touch {
    std::vector<stiffness::JointSample> samples;
    double object_NPerM = 0.0;
};

/// The log of one touch, so dense that the window holds so many samples, its borders among them:
///   angle = torque / (P_C^2 k_i),  1/k_i = 1/k_o + 1/k_ri
Touch simulateTouch(std::size_t trial, std::size_t samplesInWindow) {
    core::RandomStream random(trial, "stiffness ladder");
    const stiffness::TorqueWindow window;
    Touch touch{{}, kTouched_NPerM[trial % kTouched_NPerM.size()]};
    const double total_NPerM = 1.0 / (1.0 / touch.object_NPerM + 1.0 / stiffness::kPaperLinkStiffness_NPerM);
    const double step_Nm = window.width_Nm() / static_cast<double>(samplesInWindow - 1);
    constexpr double kRate_Hz = 1000.0;
    // From rest to a little beyond the window.
    const auto before = static_cast<int>(std::ceil(window.low_Nm / step_Nm));
    const auto after =
        static_cast<int>(samplesInWindow) + static_cast<int>(std::ceil(0.2 * window.width_Nm() / step_Nm));
    for (int i = -before; i < after; ++i) {
        const double torque_Nm = std::max(0.0, window.low_Nm + step_Nm * i);
        const double angle_rad = torque_Nm / (kTouchDistance_m * kTouchDistance_m * total_NPerM);
        touch.samples.push_back({(before + i) / kRate_Hz, angle_rad + kAngleNoise_rad * random.normal(),
                                 torque_Nm + kTorqueNoise_Nm * random.normal()});
    }
    return touch;
}

/// An answer that is a bound stands for itself; no answer is as wrong as no object.
double relativeError(const tl::expected<stiffness::TouchStiffness, stiffness::Refusal>& answer,
                     double truth_NPerM) {
    if (!answer)
        return 1.0;
    const double answer_NPerM =
        answer->object.value_NPerM.value_or(answer->object.lower95_NPerM.value_or(0.0));
    return std::abs(answer_NPerM - truth_NPerM) / truth_NPerM;
}

Rung stiffnessRung(stiffness::Method method, std::size_t samples) {
    const std::string count = std::to_string(samples);
    const auto run = [method, samples](Trial& trial) {
        const Touch touch = simulateTouch(trial.index(), samples);
        stiffness::TouchSettings settings;
        settings.contactDistance_m = kTouchDistance_m;
        settings.method = method;
        settings.torqueNoise_Nm = kTorqueNoise_Nm;
        settings.angleNoise_rad = kAngleNoise_rad;
        const std::size_t calls = 1 + 400 / samples;
        tl::expected<stiffness::TouchStiffness, stiffness::Refusal> answer;
        trial.timed(calls, [&] {
            for (std::size_t i = 0; i < calls; ++i)
                answer = stiffness::estimateStiffness(touch.samples, settings);
        });
        trial.error(relativeError(answer, touch.object_NPerM));
    };
    return {std::string(stiffness::toString(method)) + "-" + count, count + " samples", run};
}

} // namespace

Ladder stiffnessLadder() {
    Ladder ladder;
    ladder.name = "stiffness";
    ladder.topic = Topic::touchedObject;
    ladder.title = LadderText::tr("Stiffness of a touched object").toStdString();
    ladder.truth = LadderText::tr("share of the true stiffness of the object; a bound counts as the value, a "
                                  "refused touch as 1")
                       .toStdString();
    ladder.errorUnit = "1";
    ladder.trials = 200;
    ladder.makeRungs = []() -> core::Expected<std::vector<Rung>> {
        std::vector<Rung> rungs;
        for (const stiffness::Method method : {stiffness::Method::twoPoint, stiffness::Method::regression})
            for (const std::size_t samples : {2U, 10U, 30U, 100U, 300U, 1000U})
                rungs.push_back(stiffnessRung(method, samples));
        const auto shortest = std::make_shared<const Touch>(simulateTouch(0, 2));
        constexpr std::size_t kCalls = 256;
        rungs.push_back(limitRung("each sample of the shortest touch read once", kCalls, [=](std::size_t) {
            double sum = 0.0;
            for (const stiffness::JointSample& sample : shortest->samples)
                sum += sample.angle_rad * sample.torque_Nm;
            return sum;
        }));
        return rungs;
    };
    return ladder;
}

} // namespace teleta::cost
