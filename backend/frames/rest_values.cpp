// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/frames/rest_values.h"

#include "backend/core/failure.h"
#include "backend/core/quantile.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <span>

namespace teleta::frames {

namespace {

struct RestText {
    Q_DECLARE_TR_FUNCTIONS(RestText)
};

double meanOf(std::span<const double> values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// The finite readings of a taxel.
std::vector<double> readingsOf(const FrameSeries& frames, std::size_t used, std::size_t taxel) {
    std::vector<double> finite;
    finite.reserve(used);
    for (std::size_t i = 0; i < used; ++i)
        if (const float value = frames.frame(i)[taxel]; std::isfinite(value))
            finite.push_back(static_cast<double>(value));
    return finite;
}

/// sorted: not empty, the unloaded end first. Empty when the readings show none.
std::optional<double> densestUnloaded(std::span<const double> sorted) {
    constexpr std::size_t kFewest = 10;
    constexpr std::size_t kOneIn = 20;
    // Of evenly spread loads the shortest interval is little shorter than its share of the range.
    constexpr double kLongest = 0.7;
    constexpr double kDeepest = 0.1;
    const std::size_t held = std::max(kFewest, (sorted.size() + kOneIn - 1) / kOneIn);
    const double range = sorted.back() - sorted.front();
    const double middle = sorted.front() + 0.5 * range;
    double shortest = range;
    std::optional<std::size_t> found;
    for (std::size_t begin = 0; begin + held <= sorted.size() && sorted[begin + held - 1] <= middle; ++begin)
        if (const double length = sorted[begin + held - 1] - sorted[begin]; length < shortest) {
            shortest = length;
            found = begin;
        }
    if (!found)
        return std::nullopt;
    const double rest = core::quantileOf(sorted.subspan(*found, held), 0.5);
    const double share = static_cast<double>(held) / static_cast<double>(sorted.size());
    const double depth = rest - core::quantileOf(sorted, 0.01);
    if (shortest > kLongest * share * range || depth > kDeepest * range)
        return std::nullopt;
    return rest;
}

} // namespace

std::vector<float> restValues(const FrameSeries& frames, RestRule rule) {
    std::size_t used = frames.frames();
    if (rule == RestRule::first && used > 0) {
        const auto end = std::ranges::upper_bound(frames.time_s, frames.time_s.front() + kFirst_s);
        used = static_cast<std::size_t>(end - frames.time_s.begin());
    }
    std::vector<float> rest(frames.layout.taxels(), std::numeric_limits<float>::quiet_NaN());
    for (std::size_t taxel = 0; taxel < rest.size(); ++taxel) {
        std::vector<double> finite = readingsOf(frames, used, taxel);
        if (!finite.empty())
            rest[taxel] =
                static_cast<float>(rule == RestRule::median ? core::medianOf(finite) : meanOf(finite));
    }
    return rest;
}

core::Expected<std::vector<float>> untouchedValues(const FrameSeries& frames, bool inverted,
                                                   std::span<const std::uint8_t> dead) {
    const std::size_t taxels = frames.layout.taxels();
    const double sign = inverted ? -1.0 : 1.0;
    const auto loadsOf = [&](std::size_t taxel) {
        if (!dead.empty() && dead[taxel] != 0)
            return std::vector<double>();
        std::vector<double> readings = readingsOf(frames, frames.frames(), taxel);
        for (double& reading : readings)
            reading *= sign;
        return readings;
    };
    double widest = 0.0;
    for (std::size_t taxel = 0; taxel < taxels; ++taxel)
        if (const std::vector<double> loads = loadsOf(taxel); !loads.empty()) {
            const auto [least, most] = std::ranges::minmax(loads);
            widest = std::max(widest, most - least);
        }

    constexpr double kUntouchedRange = 0.25;
    std::vector<float> rest(taxels, std::numeric_limits<float>::quiet_NaN());
    for (std::size_t taxel = 0; taxel < taxels; ++taxel) {
        std::vector<double> loads = loadsOf(taxel);
        if (loads.empty())
            continue;
        std::ranges::sort(loads);
        const bool isUntouched = loads.back() - loads.front() <= kUntouchedRange * widest;
        const std::optional<double> found =
            isUntouched ? std::optional(core::quantileOf(loads, 0.5)) : densestUnloaded(loads);
        if (!found)
            return core::refused(
                RestText::tr("The frames do not show the value of taxel %1 without load: it is touched in "
                             "nearly all of them, or nothing touches the array")
                    .arg(taxel),
                RestText::tr("frames of the unloaded array, their median, or a dead taxel"));
        rest[taxel] = static_cast<float>(sign * *found);
    }
    return rest;
}

} // namespace teleta::frames
