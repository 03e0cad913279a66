// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/arm_model/serial_chain.h"
#include "backend/arm_model/urdf_reader.h"
#include "backend/core/device/arm_device.h"

#include <gtest/gtest.h>

#include <memory>
#include <numbers>
#include <string>

namespace teleta::test {

/// The chain of a URDF file of this repository, from its base.
inline std::shared_ptr<const arm_model::SerialChain>
chainOf(const std::string& file, const std::string& tip = "tool0", const std::string& base = "base_link") {
    const auto model = arm_model::readUrdf(TELETA_SOURCE_DIR "/" + file);
    EXPECT_TRUE(model) << core::describe(model.error());
    const auto made =
        arm_model::SerialChain::create(std::make_shared<arm_model::ArmModel>(*model), base, tip);
    EXPECT_TRUE(made) << core::describe(made.error());
    return std::make_shared<const arm_model::SerialChain>(*made);
}

/// A pad on the fifth link of the arm with seven joints; joint 4 presses it.
inline core::PadPlacement padOnLinkFive() {
    return {.link = "link_5",
            .position_m = {0.05, 0.01, 0.12},
            .rollPitchYaw_rad = {0.0, std::numbers::pi / 2, 0.0},
            .jointStiffness_NmPerRad = {4000, 4000, 3000, 2000, 1000, 500, 500}};
}

} // namespace teleta::test
