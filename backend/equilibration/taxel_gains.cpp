// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/equilibration/taxel_gains.h"

#include "backend/core/failure.h"
#include "backend/equilibration/press_fit.h"

#include <QCoreApplication>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace teleta::equilibration {

namespace {

struct GainText {
    Q_DECLARE_TR_FUNCTIONS(TaxelGains)
};

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
constexpr std::array<std::string_view, 5> kStates{"good", "dead", "weak", "strong", "stuck"};

/// Logarithms of the responses of all presses, each shifted so that the taxels that are good in all presses
/// have the mean 0; NaN where a taxel is not good. Empty when no taxel is good in all presses.
std::vector<std::vector<double>> alignedLogarithms(std::span<const PressFit> fits) {
    std::vector<std::vector<double>> logarithms;
    for (const PressFit& fit : fits) {
        std::vector<double>& logarithm = logarithms.emplace_back(fit.response.size(), kNothing);
        double sum = 0.0;
        std::size_t common = 0;
        for (std::size_t i = 0; i < logarithm.size(); ++i) {
            if (fit.states[i] != TaxelState::good)
                continue;
            logarithm[i] = std::log(fit.response[i]);
            if (std::ranges::all_of(
                    fits, [i](const PressFit& other) { return other.states[i] == TaxelState::good; })) {
                sum += logarithm[i];
                ++common;
            }
        }
        if (common == 0)
            return {};
        for (double& value : logarithm)
            value -= sum / static_cast<double>(common);
    }
    return logarithms;
}

/// A plane through the logarithms of the responses.
void findTilt(TaxelGains& gains, std::span<const double> logarithms) {
    const core::ArrayLayout& layout = gains.layout;
    const std::size_t n = gains.good();
    const bool hasX = layout.columns > 1;
    const bool hasY = layout.rows > 1;
    const Eigen::Index unknowns = 1 + (hasX ? 1 : 0) + (hasY ? 1 : 0);
    if (unknowns == 1 || static_cast<Eigen::Index>(n) <= unknowns + 2)
        return;
    Eigen::MatrixXd a(static_cast<Eigen::Index>(n), unknowns);
    Eigen::VectorXd b(static_cast<Eigen::Index>(n));
    Eigen::Index row = 0;
    for (std::size_t i = 0; i < gains.taxels.size(); ++i) {
        if (!gains.taxels[i].isGood())
            continue;
        const auto columns = static_cast<std::size_t>(layout.columns);
        // -1/2 .. 1/2 from end to end, so that a slope is the change over the whole array.
        const double x = hasX ? static_cast<double>(i % columns) / (layout.columns - 1) - 0.5 : 0.0;
        const double y = hasY ? static_cast<double>(i / columns) / (layout.rows - 1) - 0.5 : 0.0;
        a(row, 0) = 1.0;
        if (hasX)
            a(row, 1) = x;
        if (hasY)
            a(row, unknowns - 1) = y;
        b(row++) = logarithms[i];
    }
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(a);
    // The good taxels lie on one line.
    if (qr.rank() < unknowns)
        return;
    const Eigen::VectorXd plane = qr.solve(b);
    const double variance = (b - a * plane).squaredNorm() / static_cast<double>(n - unknowns);
    const Eigen::MatrixXd covariance = variance * (a.transpose() * a).inverse();
    // Exceeded by chance once in 2150 for a normal variable, once in 1300 for Student's t with the 81 degrees
    // of freedom of a 6 x 14 array.
    constexpr double kNotByChance = 3.5;
    const auto take = [&](Eigen::Index k, double& tilt) {
        // The response changes over the array by the factor exp(slope): (e^s - 1) over the mean of both ends.
        tilt = 2.0 * std::tanh(0.5 * plane(k));
        if (std::abs(tilt) > kTilt && std::abs(plane(k)) > kNotByChance * std::sqrt(covariance(k, k)))
            gains.isTilted = true;
    };
    if (hasX)
        take(1, gains.tilt_x);
    if (hasY)
        take(unknowns - 1, gains.tilt_y);
}

/// presses: some taxels are good in all of them.
TaxelGains combined(const core::ArrayLayout& layout, std::span<const PressFit> fits,
                    const std::vector<std::vector<double>>& logarithms) {
    TaxelGains gains;
    gains.layout = layout;
    gains.presses = fits.size();
    gains.taxels.resize(layout.taxels());
    std::vector<double> mean(layout.taxels(), kNothing);
    std::vector<std::size_t> counts(layout.taxels(), 0);
    double between = 0.0; // sum of squares about the taxels' means
    std::size_t freedom = 0;
    std::size_t pressed = 0;
    for (std::size_t i = 0; i < gains.taxels.size(); ++i) {
        double sum = 0.0;
        for (const std::vector<double>& logarithm : logarithms) {
            if (std::isfinite(logarithm[i])) {
                sum += logarithm[i];
                ++counts[i];
            }
        }
        if (counts[i] == 0) {
            gains.taxels[i] = {.state = fits.front().states[i], .gain = kNothing, .error = kNothing};
            continue;
        }
        mean[i] = sum / static_cast<double>(counts[i]);
        for (const std::vector<double>& logarithm : logarithms) {
            if (std::isfinite(logarithm[i]))
                between += std::pow(logarithm[i] - mean[i], 2);
        }
        freedom += counts[i] - 1;
        pressed += counts[i];
    }
    const double betweenVariance = freedom > 0 ? between / static_cast<double>(freedom) : 0.0;
    gains.repeatability = pressed > 0 ? std::sqrt(between / static_cast<double>(pressed)) : 0.0;

    double response = 0.0;
    const auto used = static_cast<double>(gains.good());
    for (std::size_t i = 0; i < gains.taxels.size(); ++i)
        response += gains.taxels[i].isGood() ? std::exp(mean[i]) / used : 0.0;
    for (std::size_t i = 0; i < gains.taxels.size(); ++i) {
        TaxelGain& taxel = gains.taxels[i];
        if (!taxel.isGood())
            continue;
        const auto count = static_cast<double>(counts[i]);
        double within = 0.0;
        for (std::size_t press = 0; press < fits.size(); ++press) {
            if (std::isfinite(logarithms[press][i]))
                within += std::pow(fits[press].error[i] / fits[press].response[i] / count, 2);
        }
        taxel.gain = response / std::exp(mean[i]);
        // The differences between presses include the noise within them.
        taxel.error = taxel.gain * std::sqrt(std::max(within, betweenVariance / count));
    }
    double weight = 0.0;
    for (const PressFit& fit : fits) {
        const auto frames = static_cast<double>(fit.frames);
        gains.frames += fit.frames;
        weight += frames;
        gains.level += (fit.level - gains.level) * frames / weight;
        gains.scatter += (fit.scatter - gains.scatter) * frames / weight;
    }
    findTilt(gains, mean);
    return gains;
}

} // namespace

std::string_view toString(TaxelState state) {
    return kStates[static_cast<std::size_t>(state)];
}

std::optional<TaxelState> taxelState(std::string_view text) {
    const auto found = std::find(kStates.begin(), kStates.end(), text);
    if (found == kStates.end())
        return std::nullopt;
    return static_cast<TaxelState>(found - kStates.begin());
}

std::size_t TaxelGains::good() const {
    return static_cast<std::size_t>(
        std::count_if(taxels.begin(), taxels.end(), [](const TaxelGain& taxel) { return taxel.isGood(); }));
}

std::optional<GainRange> TaxelGains::range() const {
    std::optional<GainRange> range;
    for (const TaxelGain& taxel : taxels) {
        if (!taxel.isGood())
            continue;
        if (!range)
            range = GainRange{taxel.gain, taxel.gain, 0.0};
        range->least = std::min(range->least, taxel.gain);
        range->greatest = std::max(range->greatest, taxel.gain);
        range->largestError = std::max(range->largestError, taxel.error / taxel.gain);
    }
    return range;
}

std::vector<float> TaxelGains::values() const {
    std::vector<float> values;
    values.reserve(taxels.size());
    for (const TaxelGain& taxel : taxels)
        values.push_back(taxel.isGood() ? static_cast<float>(taxel.gain)
                                        : std::numeric_limits<float>::quiet_NaN());
    return values;
}

core::Expected<TaxelGains> findTaxelGains(const core::ArrayLayout& layout,
                                          std::span<const GainPress> presses) {
    if (presses.empty())
        return core::refused(GainText::tr("There is no press."), GainText::tr("at least one"));
    std::vector<PressFit> fits;
    for (const GainPress& press : presses) {
        if (press.frames.size() % layout.taxels() != 0)
            return core::failed(core::ErrorKind::badInput,
                                GainText::tr("The frames have %1 values in total.").arg(press.frames.size()),
                                GainText::tr("a multiple of %1").arg(layout.taxels()));
        TELETA_TRY(auto fit, fitPress(layout.taxels(), press));
        fits.push_back(std::move(fit));
    }
    const std::vector<std::vector<double>> logarithms = alignedLogarithms(fits);
    if (logarithms.empty())
        return core::refused(GainText::tr("No taxel is good in all presses."),
                             GainText::tr("presses of the whole array"));
    return combined(layout, fits, logarithms);
}

} // namespace teleta::equilibration
