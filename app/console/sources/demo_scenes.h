// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/chrome/source_chooser.h"

#include <vector>

namespace teleta::console {

/// The scenes of the program's resources that show a source at work, for people, translated. Thread: GUI.
[[nodiscard]] std::vector<chrome::SourceChooser::Demo> demoScenes();

} // namespace teleta::console
