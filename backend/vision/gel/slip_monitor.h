// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace teleta::vision {

/// A place of a contact and how far it has moved since the contact began.
struct ContactPlace {
    Eigen::Vector2d rest_m = Eigen::Vector2d::Zero();
    Eigen::Vector2d moved_m = Eigen::Vector2d::Zero();
};

/// A rigid motion that most places of a contact share, and how many do.
struct SharedMotion {
    double turn_rad = 0.0;
    std::vector<bool> sticks{}; ///< of each place: its residual is within the tolerance
    std::size_t sticking = 0;
    double slipShare = 0.0; ///< of the contact that stays behind the motion, 0..1
    /// They went some way, and one rigid motion explains at least half of it; otherwise nothing slips.
    bool movesAsOne = false;
};

/// The rigid motion of the places that stick: each pair of places proposes one, and that with which most
/// places agree counts. Where fewer than half of them agree, it is the one that moves furthest of those with
/// at least 45 % as many, since what slips lags behind. It is fitted to the places that agree. A place
/// agrees, and sticks, while its residual is within 3 noise_m + 1 % of the largest motion.
/// Slip share: places that lag against the motion by more than the tolerance, and what the tolerance hides of
/// them where there are at least 25: lags grow from the edge of what sticks with the power 3/2 of the
/// distance (K. L. Johnson, Contact Mechanics, 7.2), so the area behind by more than l is linear in l^(2/3)
/// and is read at 0. None while the places have moved by less than 3 tolerances, or one rigid motion explains
/// less than half of how they moved: what spreads does not slip.
/// Nothing for fewer than five places: what sticks cannot be told from what slips. Thread: any (pure).
[[nodiscard]] std::optional<SharedMotion> sharedMotion(std::span<const ContactPlace> places, double noise_m);

/// Slip indices from which a contact begins to slip, and slips.
inline constexpr double kIncipientSlipIndex = 0.3;
inline constexpr double kSlipIndex = 0.8;

enum class SlipEvent { none, incipientSlip, slip };

/// Says when a contact slips. incipientSlip: the slip index is at least kIncipientSlipIndex for two frames.
/// slip: it is at least kSlipIndex for two frames, or the shear has fallen by 20 % from its peak while the
/// rim goes on moving the way of the shear. Each is told once until the index is below 0.2 again. Thread:
/// one.
class SlipMonitor {
public:
    /// index: nothing when it is undefined, which counts as no frame. shear_m: of the contact. rimMoved_m:
    /// mean motion of its rim since the last frame. noise_m: of one marker.
    [[nodiscard]] SlipEvent next(std::optional<double> index, const Eigen::Vector2d& shear_m,
                                 const Eigen::Vector2d& rimMoved_m, double noise_m);

private:
    int m_partly = 0; ///< frames in a row
    int m_wholly = 0;
    bool m_toldPartly = false;
    bool m_toldWholly = false;
    double m_peak_m = 0.0;
};

} // namespace teleta::vision
