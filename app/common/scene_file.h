// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/scene/scene.h"
#include "backend/study/session/study_scene.h"

#include <QStringList>

#include <string>
#include <variant>
#include <vector>

namespace teleta::app {

/// Reads a scene from a file, or one of those that come with the programs by its name ("teleta-touch") or its
/// resource (":/scenes/teleta-touch.toml"). A file of that name goes first. Failure: as scene::readScene().
[[nodiscard]] core::Expected<scene::Scene> readScene(const std::string& pathOrName);

/// Where such a scene is: the path itself, or the resource.
[[nodiscard]] std::string scenePlace(const std::string& pathOrName);

/// A scene of either kind: a world that devices sense, or a study.
using AnyScene = std::variant<scene::Scene, study::StudyScene>;
/// The same for both kinds. Failure: also as study::parseStudyScene().
[[nodiscard]] core::Expected<AnyScene> readAnyScene(const std::string& pathOrName);

/// The text of such a scene. Failure: notFound, ioFailed.
[[nodiscard]] core::Expected<std::string> sceneText(const std::string& pathOrName);
/// The same, empty when it cannot be read.
[[nodiscard]] std::string readSceneText(const std::string& pathOrName);

/// Names of the scenes that come with the programs, in alphabetical order.
[[nodiscard]] std::vector<std::string> sceneNames();

/// Where a sweep is: the path itself, or the resource of one that comes with the programs.
[[nodiscard]] std::string sweepPlace(const std::string& pathOrName);
/// Names of the sweeps that come with the programs, in alphabetical order.
[[nodiscard]] QStringList sweepNames();

} // namespace teleta::app
