// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pipeline/touch/touch_snapshot.h"

#include <cstddef>
#include <functional>

class QWidget;

namespace teleta::tactile {

/// How many taxels of an array press now.
struct LoadedTaxels {
    std::size_t usable = 0; ///< that are not dead
    std::size_t loaded = 0; ///< of them, from the threshold on

    bool operator==(const LoadedTaxels&) const = default;
};

/// Thread: any (pure).
[[nodiscard]] LoadedTaxels loadedTaxels(const pipeline::TouchSnapshot& snapshot, double threshold_N);

/// Calls tare at once while nothing is under load, otherwise after a question whose usual answer is no: what
/// presses during a tare counts as no load afterwards. The question is the parent's. Thread: GUI.
void askToTare(QWidget* parent, const LoadedTaxels& taxels, std::function<void()> tare);

} // namespace teleta::tactile
