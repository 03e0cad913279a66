// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/contacts/contact_identities.h"

#include <Eigen/Core>

#include <optional>
#include <span>
#include <vector>

namespace teleta::vision {

/// Detects bumps against the skin: contacts that certainly deepen faster than one threshold (beyond the noise
/// of their depth), or are deeper than another one. Thread: one. Source: VTacArm, section IV-C.
class BumpDetector {
public:
    struct Settings {
        double speed_mPerS = 0.02; ///< > 0
        double depth_m = 0.0015;   ///< > 0
    };
    struct Bump {
        int contact = 0;                                   ///< identity of the contact
        Eigen::Vector3d retreat = Eigen::Vector3d::Zero(); ///< unit vector towards the axis, in {s}
    };
    BumpDetector() = default;
    explicit BumpDetector(const Settings& settings)
        : m_settings(settings) {}

    /// The bump in the newest frame, or the deepest of several; each contact bumps at most once.
    [[nodiscard]] std::optional<Bump> update(std::span<const FollowedContact> contacts);

private:
    Settings m_settings;
    std::vector<int> m_bumped; ///< identities of the present contacts that have bumped
};

/// Motion of the tube that follows a contact: the turn about the axis and the displacement along it since the
/// start of the contact. Thread: any (pure). Source: VTacArm, section IV-C.
struct FollowMotion {
    double turn_rad = 0.0;
    double along_m = 0.0;
};
[[nodiscard]] FollowMotion followMotion(const Eigen::Vector3d& p_Sensor_Start_m,
                                        const Eigen::Vector3d& p_Sensor_Now_m);

} // namespace teleta::vision
