// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/signal/signal_name.h"

#include <QByteArray>

#include <optional>
#include <vector>

namespace teleta::console {

/// A signal of a plot, whether its source is open or not.
struct PlottedSignal {
    signal::SignalId id;
    bool derivative = false; ///< its derivative is plotted instead
    bool spectrum = false;
    bool operator==(const PlottedSignal& other) const = default;
};

/// What a plot shows, to be kept under a name.
struct PlotLayout {
    std::vector<PlottedSignal> plotted;
    double span_s = 10.0; ///< of the time axis
    bool density = false; ///< spectra show the density of power
    bool clock = false;   ///< times are clock times
};

/// As JSON.
[[nodiscard]] QByteArray toJson(const PlotLayout& layout);
/// Empty: it is none, or of a newer version.
[[nodiscard]] std::optional<PlotLayout> plotLayoutOf(const QByteArray& json);

} // namespace teleta::console
