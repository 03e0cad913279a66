// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/scene/arm_world.h"
#include "backend/scene/toml_table.h"

#include <optional>
#include <vector>

namespace teleta::scene {

/// The tables of a scene with an arm; unknown: of the places, when there is one. What is wrong is reported to
/// their document. Thread: one.
[[nodiscard]] ArmWorld readArmWorld(TomlTable arm, TomlTable skin, TomlTable program,
                                    const std::vector<TomlTable>& objects,
                                    const std::optional<TomlTable>& unknown = {});

} // namespace teleta::scene
