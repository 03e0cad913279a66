// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/servo/servo_task.h"

#include <cstddef>
#include <optional>

namespace teleta::servo {

enum class ContactState {
    none,      ///< the task needs no contact, and there is none
    touching,  ///< at least one taxel is active, or was a moment ago
    searching, ///< the contact is gone; the sensor retreats and feels for it
    lost,      ///< it was not found; the sensor stands still, off the last surface
};

/// "none", "touching", "searching", "lost".
[[nodiscard]] const char* toString(ContactState state);

/// Retreat and bounded search after a contact was lost.
/// Remembers the last measured pose with contact and the direction of the way. The sensor backs off from that
/// pose along its own -z, goes forward to depth_m beyond it, back, one step back along the way, and so on; it
/// never leaves the box that these bounds span. A place that limits keep it from, such as the end of a joint,
/// is given up after twice the time of the way there and half a second, so every search ends. Thread: one;
/// nothing allocates.
class ContactSearch {
public:
    /// Every frame with contact. X_Base_Sensor: measured; slide_Base: velocity of the sensor.
    void touched(const Eigen::Isometry3d& X_Base_Sensor, const Eigen::Vector3d& slide_Base_mPerS);
    [[nodiscard]] bool hasTouched() const { return m_touched; }

    void begin();
    [[nodiscard]] bool running() const { return m_running; }
    /// All probes were made and the sensor is back at the height of the retreat.
    [[nodiscard]] bool exhausted() const { return m_running && m_probe < 0; }
    void end() { m_running = false; }
    void reset();

    /// Twist in {s} that leads the commanded pose on for this step.
    [[nodiscard]] Twist step(const Eigen::Isometry3d& X_Base_Sensor_commanded, double dt_s,
                             const SearchSettings& settings);

private:
    enum class Stage { retreat, approach, withdraw, shift };

    [[nodiscard]] Eigen::Isometry3d target(const SearchSettings& settings) const;
    void advance(const SearchSettings& settings);

    bool m_touched = false;
    bool m_running = false;
    Eigen::Isometry3d m_X_Base_Last = Eigen::Isometry3d::Identity();
    Eigen::Vector3d m_back_Last = -Eigen::Vector3d::UnitX(); ///< against the way, in the surface
    Stage m_stage = Stage::retreat;
    int m_probe = 0;                ///< -1: all made
    std::optional<double> m_left_s; ///< for the current target; empty: it is new
};

} // namespace teleta::servo
