// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <optional>

namespace teleta::touch {

/// Leads the tip of an arm by position: the tip goes where the hand goes, from where both were when the hand
/// took hold.
///   velocity = K (anchor + hand - tip), at most the fastest speed; anchor = tip - hand at the hold
/// The tip is that of age_s ago, and a command takes as long to arrive, plus kOtherDelay_s:
///   x' = K (a - x(t - T))
/// oscillates above K T = 1/e, with growing amplitude above pi/2. So K = min(kGain, kLargestTurn / T).
/// While the clutch is held the tip stands still and the hand moves freely; then a new hold begins.
/// Thread: one.
class PositionGuide {
public:
    static constexpr double kGain_perS = 4.0;    ///< of readings that are young
    static constexpr double kLargestTurn = 0.35; ///< K T, below 1/e
    /// Pictures and commands come at 30 Hz each.
    static constexpr double kOtherDelay_s = 0.07;
    /// Steps lead the tip by no more, so that a tip that was held up does not race off when it is free.
    static constexpr double kLongestLead_m = 0.1;
    /// Nearer than this the tip has arrived.
    static constexpr double kArrived_m = 2e-4;

    /// One look at the hand. hand_m: its displacement, scaled. tip_m: where the arm was told to go, so that
    /// an arm that leans on something does not press ever harder. age_s: of tip_m. Not held, or anything not
    /// finite: lets go.
    [[nodiscard]] Eigen::Vector3d velocity_mPerS(bool held, bool clutch, const Eigen::Vector3d& hand_m,
                                                 const Eigen::Vector3d& tip_m, double fastest_mPerS,
                                                 double age_s = 0.0);
    /// Leads it on by a step, while it is held.
    void step(const Eigen::Vector3d& by_m);
    void letGo() { m_anchor_m.reset(); }
    [[nodiscard]] bool isHeld() const { return m_anchor_m.has_value(); }

private:
    std::optional<Eigen::Vector3d> m_anchor_m;
    Eigen::Vector3d m_way_m = Eigen::Vector3d::Zero(); ///< that was left at the last look
};

} // namespace teleta::touch
