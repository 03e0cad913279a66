// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contact/contact_segmenter.h"

#include <Eigen/Core>

#include <optional>
#include <span>
#include <vector>

namespace teleta::view3d {

/// Remembers where each contact began, so that its displacement can be drawn.
/// Thread: one.
class FirstTouch {
public:
    /// How long a contact may be away and still be the same touch.
    static constexpr double kMemory_s = 0.2;

    /// Takes the contacts of the newest frame. A time that goes back forgets everything: another stretch is
    /// shown.
    void update(std::span<const contact::Contact> contacts, double time_s);
    void clear() { m_touches.clear(); }
    /// Where contact `id` was first seen, in the array's frame.
    [[nodiscard]] std::optional<Eigen::Vector2d> startOf(int id) const;

private:
    struct Touch {
        int id;
        Eigen::Vector2d start_m;
        double lastSeen_s;
    };
    std::vector<Touch> m_touches;
    double m_time_s = 0.0;
};

} // namespace teleta::view3d
