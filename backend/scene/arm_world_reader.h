// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/toml_table.h"
#include "backend/scene/arm_world.h"

#include <optional>
#include <vector>

namespace teleta::scene {

/// The tables of a scene with an arm; unknown: of the places, when there is one. What is wrong is reported to
/// their document. Thread: one.
[[nodiscard]] ArmWorld readArmWorld(core::TomlTable arm, core::TomlTable skin, core::TomlTable program,
                                    const std::vector<core::TomlTable>& objects,
                                    const std::optional<core::TomlTable>& unknown = {});

} // namespace teleta::scene
