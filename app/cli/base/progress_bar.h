// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace teleta::cli {

/// A line on standard error that shows how far long work has come: bar, percent, rate. Nothing is shown when
/// standard error is no terminal, or when results are printed to a terminal meanwhile. The line is erased
/// with the object.
class ProgressBar {
public:
    enum class Unit {
        bytes,            ///< of a file; the rate is in MB/s
        simulatedSeconds, ///< the rate is a multiple of real time
        trials,           ///< the rate is in trials a second
        runs,             ///< of a scene; the rate is in runs a second
        share,            ///< of work whose parts take unlike times: no rate is shown
        frames,           ///< of a recording; the rate is in frames a second
    };

    ProgressBar(Unit unit, bool resultsOnTerminal);
    ~ProgressBar() { erase(); }
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    /// Cheap; draws a few times a second. total 0: unknown, only amount and rate are shown.
    void update(double done, double total);
    /// Before results are printed to the same terminal.
    void erase();

private:
    Unit m_unit;
    bool m_shown;
    bool m_drawn = false;
    std::int64_t m_start_ns;
    std::int64_t m_next_ns;
};

} // namespace teleta::cli
