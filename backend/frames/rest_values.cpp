// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/frames/rest_values.h"

#include "backend/core/quantile.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>

namespace teleta::frames {

namespace {

double meanOf(std::span<const double> values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

} // namespace

std::vector<float> restValues(const FrameSeries& frames, RestRule rule) {
    std::size_t used = frames.frames();
    if (rule == RestRule::first && used > 0) {
        const auto end = std::ranges::upper_bound(frames.time_s, frames.time_s.front() + kFirst_s);
        used = static_cast<std::size_t>(end - frames.time_s.begin());
    }
    std::vector<float> rest(frames.layout.taxels(), std::numeric_limits<float>::quiet_NaN());
    std::vector<double> finite;
    for (std::size_t taxel = 0; taxel < rest.size(); ++taxel) {
        finite.clear();
        for (std::size_t i = 0; i < used; ++i)
            if (const float value = frames.frame(i)[taxel]; std::isfinite(value))
                finite.push_back(static_cast<double>(value));
        if (!finite.empty())
            rest[taxel] =
                static_cast<float>(rule == RestRule::median ? core::medianOf(finite) : meanOf(finite));
    }
    return rest;
}

} // namespace teleta::frames
