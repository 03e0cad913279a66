// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/scene/scene.h"

#include <string>
#include <string_view>

namespace teleta::scene {

/// Reads a scene file (TOML). Unknown keys, effects and shapes, keys without their unit, wrong types and
/// values out of range are errors with file, line, column and what was expected.
/// Error: notFound, ioFailed, badInput.
/// Thread: any.
[[nodiscard]] core::Expected<Scene> readScene(const std::string& path);

/// The same from text; file is the name that errors show.
[[nodiscard]] core::Expected<Scene> parseScene(std::string_view text, const std::string& file);

} // namespace teleta::scene
