// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/toml_table.h"
#include "backend/scene/servo_world.h"

namespace teleta::scene {

/// The tables of a scene with an arm that servoes. What is wrong is reported to their document. Thread: one.
[[nodiscard]] ServoWorld readServoWorld(core::TomlTable robot, core::TomlTable sensor, core::TomlTable object, core::TomlTable task);

/// True when every value of a world that a program made is in its range. Thread: any (pure).
[[nodiscard]] bool isValidServoWorld(const ServoWorld& world);

} // namespace teleta::scene
