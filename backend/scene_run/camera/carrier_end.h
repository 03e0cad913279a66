// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pipeline/camera_snapshot.h"
#include "backend/simulation/camera/carrier_arm.h"

#include <memory>

namespace teleta::scene_run {

/// The end of a reaction at its simulated arm: passes on what is asked of the arm, and reports what it does.
/// Thread: one.
class CarrierEnd {
public:
    /// What a reaction decided on a picture.
    struct Wish {
        simulation::TubeVelocity asked;
        double away_mPerS = 0.0; ///< how fast that leads away from a bump
        bool stopped = false;    ///< by a bump, now or before
        int bump = 0;            ///< the contact of a bump that stopped the arm just now; 0: none
        int followed = 0;        ///< the contact that is followed; 0: none
    };

    /// link: not null.
    explicit CarrierEnd(std::shared_ptr<simulation::CarrierLink> link);

    [[nodiscard]] simulation::TubePose pose() const { return m_link->state.get().pose; }
    void ask(const Wish& wish);
    /// The arm stands until the next ask().
    void hold();
    /// No contact has been followed or retreated from.
    void forget();
    /// All but the pose.
    [[nodiscard]] pipeline::CarrierReport report() const;

private:
    std::shared_ptr<simulation::CarrierLink> m_link;
    pipeline::CarrierReport::Doing m_doing = pipeline::CarrierReport::Doing::stands;
    int m_contact = 0;
};

} // namespace teleta::scene_run
