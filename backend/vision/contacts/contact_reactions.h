// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/contacts/contact_identities.h"

#include <Eigen/Core>

#include <optional>
#include <span>
#include <vector>

namespace teleta::vision {

/// Sees when something bumps against the skin: a contact that deepens faster than a threshold, beyond what
/// the noise of its depth could make of it, or is deeper than another. Thread: one. Source: VTacArm, section
/// IV-C.
class BumpDetector {
public:
    struct Settings {
        double speed_mPerS = 0.02; ///< > 0
        double depth_m = 0.0015;   ///< > 0
    };
    struct Bump {
        int contact = 0;                                   ///< its identity
        Eigen::Vector3d retreat = Eigen::Vector3d::Zero(); ///< unit vector through the axis, frame {s}
    };
    BumpDetector() = default;
    explicit BumpDetector(const Settings& settings)
        : m_settings(settings) {}

    /// The bump of the newest frame; one a contact. The deepest when there are several.
    [[nodiscard]] std::optional<Bump> update(std::span<const FollowedContact> contacts);

private:
    Settings m_settings;
    std::vector<int> m_bumped; ///< contacts that are still there and have bumped
};

/// How a contact has moved on the tube since its start: the turn about the axis and the way along it that
/// bring the tube after it. Both components of a mixed motion. Thread: any (pure). Source: VTacArm, section
/// IV-C.
struct FollowMotion {
    double turn_rad = 0.0;
    double along_m = 0.0;
};
[[nodiscard]] FollowMotion followMotion(const Eigen::Vector3d& p_Sensor_Start_m,
                                        const Eigen::Vector3d& p_Sensor_Now_m);

} // namespace teleta::vision
