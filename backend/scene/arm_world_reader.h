// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/scene/arm_world.h"
#include "backend/scene/toml_table.h"

#include <vector>

namespace teleta::scene {

/// The tables of a scene with an arm. What is wrong is reported to their document. Thread: one.
[[nodiscard]] ArmWorld readArmWorld(TomlTable arm, TomlTable skin, TomlTable program,
                                    const std::vector<TomlTable>& objects);

} // namespace teleta::scene
