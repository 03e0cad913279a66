// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/servo/servo_task.h"

#include <cstddef>
#include <optional>

namespace teleta::servo {

enum class ContactState {
    none,      ///< the task does not need contact, and there is none
    touching,  ///< at least one taxel is active, or was until SearchSettings::lostAfter_s ago
    searching, ///< the contact was lost; the sensor retreats and searches for it
    lost,      ///< the search failed; the sensor stands still, retreated from the last surface
};

/// "none", "touching", "searching", "lost".
[[nodiscard]] const char* toString(ContactState state);

/// Retreat and bounded search after a contact was lost. Remembers the last measured pose with contact and the
/// direction of sliding. The sensor retreats from that pose along its own -z, advances to depth_m beyond it,
/// retreats, moves one step back along its path, and so on; it never leaves the box that these bounds span. A
/// target that a limit keeps out of reach, such as the end of a joint, is given up after twice the time
/// needed plus half a second, so every search ends. Thread: one; allocates nothing.
class ContactSearch {
public:
    /// To be called for every frame with contact. X_Base_Sensor: measured pose; slide_Base: velocity of the
    /// sensor.
    void touched(const Eigen::Isometry3d& X_Base_Sensor, const Eigen::Vector3d& slide_Base_mPerS);
    [[nodiscard]] bool hasTouched() const { return m_touched; }

    void begin();
    [[nodiscard]] bool running() const { return m_running; }
    /// All probes are done and the sensor is back at the height of the retreat.
    [[nodiscard]] bool exhausted() const { return m_running && m_probe < 0; }
    void end() { m_running = false; }
    void reset();

    /// Twist in {s} that moves the commanded pose on in this step. dt_s: > 0.
    [[nodiscard]] Twist step(const Eigen::Isometry3d& X_Base_Sensor_commanded, double dt_s,
                             const SearchSettings& settings);

private:
    enum class Stage { retreat, approach, withdraw, shift };

    [[nodiscard]] Eigen::Isometry3d target(const SearchSettings& settings) const;
    void advance(const SearchSettings& settings);

    bool m_touched = false;
    bool m_running = false;
    Eigen::Isometry3d m_X_Base_Last = Eigen::Isometry3d::Identity();
    Eigen::Vector3d m_back_Last =
        -Eigen::Vector3d::UnitX(); ///< opposite to the direction of sliding, in the surface
    Stage m_stage = Stage::retreat;
    int m_probe = 0;                ///< -1: all are done
    std::optional<double> m_left_s; ///< time left for the current target; empty: the target is new
};

} // namespace teleta::servo
