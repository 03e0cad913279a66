// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pipeline/gel_snapshot.h"
#include "backend/scene/gel_world.h"
#include "backend/scene_run/camera/carrier_end.h"
#include "backend/simulation/camera/carrier_arm.h"
#include "backend/vision/gel/gel_bumps.h"

#include <memory>
#include <optional>
#include <vector>

namespace teleta::scene_run {

/// Turns what is seen of a flat gel into what the arm that carries it is asked to do: draw back along the
/// gel's normal after a bump, or follow the oldest contact in the plane of the gel by
///   velocity = gain x shear of the skin under it,
/// so that what drags at the gel takes it along. Thread: one.
class ReactingGel {
public:
    /// period_s: between two pictures, > 0; a command acts for so long before the next one.
    ReactingGel(const scene::GelWorld& world, double period_s);

    /// The velocity for the time until the next picture. pose: of the arm as its encoders say. noise_m: of a
    /// marker's place.
    [[nodiscard]] simulation::TubeVelocity decide(const std::vector<vision::GelContactState>& contacts,
                                                  double time_s, double noise_m,
                                                  const simulation::TubePose& pose);

    /// The contact that was a bump in the newest picture; 0: none.
    [[nodiscard]] int bump() const { return m_bump; }
    /// The arm was stopped by a bump.
    [[nodiscard]] bool stopped() const { return m_from_m.has_value(); }
    /// Identity of the contact that is followed; 0: none.
    [[nodiscard]] int followed() const { return m_followed; }

private:
    [[nodiscard]] simulation::TubeVelocity retreat(const scene::GelBumpReaction& reaction,
                                                   double along_m) const;
    [[nodiscard]] simulation::TubeVelocity follow(const scene::FollowReaction& reaction,
                                                  const std::vector<vision::GelContactState>& contacts);

    scene::GelReaction m_reaction;
    scene::CarrierLimits m_limits;
    double m_period_s;
    std::optional<vision::GelBumps> m_bumps; ///< of a GelBumpReaction
    int m_bump = 0;
    std::optional<double> m_from_m; ///< where the arm was at the bump, along the normal
    int m_followed = 0;
};

/// Lets the simulated arm of a scene with a gel react as the scene says, over its link. Thread: one.
class GelSceneReaction : public pipeline::GelReaction {
public:
    /// link: not null.
    GelSceneReaction(const scene::GelWorld& world, double period_s,
                     std::shared_ptr<simulation::CarrierLink> link);

    int react(const std::vector<vision::GelContactState>& contacts, double time_s, double noise_m,
              bool allowed) override;
    void hold() override { m_end.hold(); }
    void forget() override;
    [[nodiscard]] pipeline::CarrierReport report() const override;

private:
    scene::GelWorld m_world;
    double m_period_s;
    CarrierEnd m_end;
    std::optional<ReactingGel> m_arm;
};

} // namespace teleta::scene_run
