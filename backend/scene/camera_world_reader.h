// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/toml_table.h"
#include "backend/scene/scene.h"

#include <cstddef>
#include <optional>
#include <set>
#include <vector>

namespace teleta::scene {

/// The tables of a scene file that describe a camera's world, which must be asked for before the root is
/// finished.
struct CameraTables {
    explicit CameraTables(core::TomlTable& root);

    core::TomlTable camera;
    core::TomlTable skin;
    std::vector<core::TomlTable> fingers;
    std::optional<core::TomlTable> probing, reaction, limits;
};

/// Errors are kept by the document.
[[nodiscard]] CameraWorld readCameraWorld(CameraTables& tables);

/// An effect of a camera; listed: kinds that were read before.
[[nodiscard]] Effect readCameraEffect(core::TomlTable& table, std::set<std::size_t>& listed);

} // namespace teleta::scene
