// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contact/contact_segmenter.h"

#include <Eigen/Core>

#include <map>
#include <optional>
#include <span>

namespace teleta::view3d {

/// Remembers where each contact began, to draw its displacement. Thread: one.
class FirstTouch {
public:
    /// Longest interruption after which a contact is still the same touch.
    static constexpr double kMemory_s = 0.2;

    /// Takes the contacts of the newest frame. When time goes back everything is forgotten.
    void update(std::span<const contact::Contact> contacts, double time_s);
    void clear() { m_touches.clear(); }
    /// Where contact `id` began, in the array's frame.
    [[nodiscard]] std::optional<Eigen::Vector2d> startOf(int id) const;

private:
    struct Touch {
        Eigen::Vector2d start_m;
        double lastSeen_s;
    };
    std::map<int, Touch> m_touches; ///< by identity
    double m_time_s = 0.0;
};

} // namespace teleta::view3d
