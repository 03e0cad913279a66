// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <string_view>

namespace teleta::simulation {

/// Where in the sensor an effect acts.
enum class EffectStage {
    skin,    ///< on the load, before the firing threshold
    readout, ///< on the reading
};

/// One imperfection of a tactile array, applied to each frame in turn. Thread: one.
struct TaxelEffect {
    std::string_view name;
    EffectStage stage = EffectStage::readout;
    /// load_N: the array's taxels, changed in place. Calls are one sample period apart. A copy keeps what the
    /// function remembers of earlier frames.
    std::function<void(std::span<double> load_N)> apply{};
};

} // namespace teleta::simulation
