// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/scene/scene.h"

#include <optional>

namespace teleta::simulation {

class ServoLoop;

/// Notices when the array of a servo is, and for 0.2 s stays, aligned. On an edge: its direction within 1
/// degree, and DZMP and the centre of pressure across the edge within 0.5 mm. On a point: the centre of
/// pressure within 0.5 mm. All by the true loads of the taxels. Thread: one.
class AlignmentWatch {
public:
    explicit AlignmentWatch(const scene::ServoTaskSettings& task)
        : m_copY_m(task.copY_m) {}

    /// After every cycle of the loop.
    void add(const ServoLoop& loop);

    /// Since when it was aligned for the first time; empty: never yet.
    [[nodiscard]] std::optional<double> since_s() const { return m_aligned_s; }

private:
    double m_copY_m;
    std::optional<double> m_present_s; ///< it has been aligned since then
    std::optional<double> m_aligned_s;
};

} // namespace teleta::simulation
