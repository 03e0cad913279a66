// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/chrome/source_chooser.h"

#include <vector>

namespace teleta::console {

/// The scenes of the program's resources that show a source at work, for people, translated. Thread: GUI.
[[nodiscard]] std::vector<chrome::SourceChooser::Demo> demoScenes();

/// What the start page offers: these, and a study and patterns. Their places are "study:rehearsal",
/// "study:protocol" and "pattern:ID". Thread: GUI.
[[nodiscard]] std::vector<chrome::SourceChooser::Demo> startCards();

} // namespace teleta::console
