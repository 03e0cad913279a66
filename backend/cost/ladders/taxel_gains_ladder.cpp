// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/random_stream.h"
#include "backend/cost/ladders/ladders.h"
#include "backend/cost/limit_rung.h"
#include "backend/equilibration/taxel_gains.h"

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace teleta::cost {

namespace {

constexpr core::ArrayLayout kLayout{.rows = 6, .columns = 14, .pitchX_m = 0.0034};
constexpr double kSpread = 0.2;
constexpr double kNoise = 0.02;
constexpr double kSparks = 0.005;
constexpr double kSpark = 30.0;
constexpr double kMissing = 0.1; ///< of the readings above the mean load

struct Pressed {
    std::vector<double> response;
    std::vector<float> frames;
};

/// A press whose load swings between 0.5 and 1.5; a link that loses readings, the more the harder it is
/// pressed, and sparks.
Pressed simulatePress(std::size_t trial, std::size_t frames) {
    core::RandomStream random(trial, "taxel gains ladder");
    Pressed press;
    for (std::size_t i = 0; i < kLayout.taxels(); ++i)
        press.response.push_back(std::exp(kSpread * random.normal()));
    for (std::size_t frame = 0; frame < frames; ++frame) {
        const double load =
            1.0 + 0.5 * std::sin(20.0 * static_cast<double>(frame) / static_cast<double>(frames));
        for (const double response : press.response) {
            double reading = load * response + kNoise * random.normal();
            const double chance = random.uniform();
            if (chance < kSparks)
                reading = kSpark;
            else if (chance < kSparks + kMissing && load > 1.0)
                reading = std::numeric_limits<double>::quiet_NaN();
            press.frames.push_back(static_cast<float>(reading));
        }
    }
    return press;
}

/// The usual way: the mean of all taxels over that of each one.
std::vector<double> ratioOfMeans(const std::vector<float>& frames) {
    const std::size_t taxels = kLayout.taxels();
    std::vector<double> sum(taxels, 0.0);
    std::vector<double> count(taxels, 0.0);
    for (std::size_t i = 0; i < frames.size(); ++i) {
        if (std::isfinite(frames[i])) {
            sum[i % taxels] += static_cast<double>(frames[i]);
            count[i % taxels] += 1.0;
        }
    }
    double mean = 0.0;
    for (std::size_t i = 0; i < taxels; ++i)
        mean += sum[i] / count[i] / static_cast<double>(taxels);
    std::vector<double> gains;
    for (std::size_t i = 0; i < taxels; ++i)
        gains.push_back(mean * count[i] / sum[i]);
    return gains;
}

/// Nobody knows the load: gains are right when all their products with the responses are the same. No gains
/// are as wrong as the spread of the taxels.
double relativeError(const std::vector<double>& gains, const std::vector<double>& response) {
    double mean = 0.0;
    for (std::size_t i = 0; i < response.size(); ++i)
        mean += gains[i] * response[i] / static_cast<double>(response.size());
    double squares = 0.0;
    for (std::size_t i = 0; i < response.size(); ++i)
        squares += std::pow(gains[i] * response[i] / mean - 1.0, 2) / static_cast<double>(response.size());
    return std::sqrt(squares);
}

template <typename Find>
Rung gainsRung(const std::string& method, std::size_t frames, const Find& find) {
    const std::string count = std::to_string(frames);
    const auto run = [frames, find](Trial& trial) {
        const Pressed press = simulatePress(trial.index(), frames);
        std::vector<double> gains;
        trial.timed(1, [&] { gains = find(press.frames); });
        trial.error(relativeError(gains, press.response));
    };
    return {method + "-" + count, count + " frames", run};
}

std::vector<double> robustGains(const std::vector<float>& frames) {
    const auto found =
        equilibration::findTaxelGains(kLayout, std::array{equilibration::GainPress{frames, {}}});
    std::vector<double> gains(kLayout.taxels(), 1.0);
    for (std::size_t i = 0; found && i < gains.size(); ++i)
        gains[i] = found->taxels[i].isGood() ? found->taxels[i].gain : 1.0;
    return gains;
}

} // namespace

Ladder taxelGainsLadder() {
    Ladder ladder;
    ladder.name = "taxel-gains";
    ladder.topic = Topic::tactileArray;
    ladder.title = LadderText::tr("Gains of an array's taxels from a press").toStdString();
    ladder.truth =
        LadderText::tr(
            "share of the true gains, root mean square of an array; a taxel that is left out counts "
            "as it is")
            .toStdString();
    ladder.errorUnit = "1";
    ladder.trials = 40;
    ladder.makeRungs = []() -> core::Expected<std::vector<Rung>> {
        std::vector<Rung> rungs;
        for (const std::size_t frames : {50U, 200U, 1000U}) {
            rungs.push_back(gainsRung("ratio-of-means", frames, ratioOfMeans));
            rungs.push_back(gainsRung("robust", frames, robustGains));
        }
        const auto frames = std::make_shared<const std::vector<float>>(simulatePress(0, 50).frames);
        rungs.push_back(limitRung("each load of 50 frames read once", 16, [frames](std::size_t) {
            return static_cast<double>(std::accumulate(frames->begin(), frames->end(), 0.0F));
        }));
        return rungs;
    };
    return ladder;
}

} // namespace teleta::cost
