// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/simulation/camera/skin/sphere_imprint.h"

#include <cmath>
#include <numbers>
#include <vector>

namespace teleta::simulation {

/// A place on the tube's surface: angle about its axis from x toward y, and z. Frame {s} of the sensor.
struct SkinPlace {
    double angle_rad = 0.0;
    double z_m = 0.0;
};

/// A ball that presses on the skin and drags it along.
struct SkinPress {
    SkinPlace centre;           ///< where the ball is now
    double ballRadius_m = 0.01; ///< > 0
    double depth_m = 0.0;       ///< <= 0: it does not touch
    double dragAround_m =
        0.0;                  ///< tangential displacement of the skin in the contact, along the circumference
    double dragAlong_m = 0.0; ///< and along z
};

/// The same angle in -pi .. pi, of one within three half turns.
[[nodiscard]] inline double wrapped_rad(double angle_rad) {
    constexpr double kPi = std::numbers::pi;
    if (angle_rad > kPi)
        return angle_rad - 2.0 * kPi;
    return angle_rad < -kPi ? angle_rad + 2.0 * kPi : angle_rad;
}

/// The skin under all presses, in closed form. Depths and drags of several presses add up.
/// Thread: any (const).
class SkinDeformation {
public:
    SkinDeformation(double tubeRadius_m, double reach_m)
        : m_tubeRadius_m(tubeRadius_m)
        , m_reach_m(reach_m) {}

    void set(const std::vector<SkinPress>& presses) {
        m_presses.clear();
        for (const SkinPress& press : presses) {
            if (SphereImprint imprint(press.ballRadius_m, press.depth_m, m_reach_m);
                imprint.deepest_m() > 0.0)
                m_presses.push_back({press, std::move(imprint)});
        }
    }

    /// Inward depth of the surface at a place.
    [[nodiscard]] double depth_m(double angle_rad, double z_m) const {
        double depth_m = 0.0;
        for (const Press& press : m_presses) {
            const double s_m = distance_m(press, angle_rad, z_m);
            if (s_m < press.imprint.influence_m())
                depth_m += press.imprint.depth_m(s_m);
        }
        return depth_m;
    }

    /// Where the skin that is now at a place is at rest.
    [[nodiscard]] SkinPlace atRest(double angle_rad, double z_m) const {
        SkinPlace rest{angle_rad, z_m};
        for (const Press& press : m_presses) {
            const double s_m = distance_m(press, angle_rad, z_m);
            if (s_m >= press.imprint.influence_m())
                continue;
            const double share = press.imprint.dragShare(s_m);
            rest.angle_rad -= share * press.press.dragAround_m / m_tubeRadius_m;
            rest.z_m -= share * press.press.dragAlong_m;
        }
        return rest;
    }

    /// Upper bound of depth_m over the whole skin.
    [[nodiscard]] double deepest_m() const {
        double deepest_m = 0.0;
        for (const Press& press : m_presses)
            deepest_m += press.imprint.deepest_m();
        return deepest_m;
    }

    struct Press {
        SkinPress press;
        SphereImprint imprint;
    };
    /// Those that touch.
    [[nodiscard]] const std::vector<Press>& presses() const { return m_presses; }
    [[nodiscard]] double tubeRadius_m() const { return m_tubeRadius_m; }

private:
    [[nodiscard]] double distance_m(const Press& press, double angle_rad, double z_m) const {
        double turn_rad = angle_rad - press.press.centre.angle_rad;
        turn_rad -= 2.0 * std::numbers::pi * std::floor(turn_rad / (2.0 * std::numbers::pi) + 0.5);
        const double around_m = m_tubeRadius_m * turn_rad;
        const double along_m = z_m - press.press.centre.z_m;
        // Several times a pixel: hypot, which guards against overflow, took a third of the picture's time.
        return std::sqrt(around_m * around_m + along_m * along_m);
    }

    double m_tubeRadius_m;
    double m_reach_m;
    std::vector<Press> m_presses;
};

} // namespace teleta::simulation
