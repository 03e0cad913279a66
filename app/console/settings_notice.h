// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/chrome/message_bar.h"

#include <optional>

namespace teleta::console {

class ConsoleSettings;

/// What the user is told of the settings file at the start: that it was damaged and where its copy is, that a
/// newer version made it, or that it cannot be written. Empty: nothing is wrong with it. Thread: GUI.
[[nodiscard]] std::optional<chrome::Message> settingsNotice(const ConsoleSettings& settings);

} // namespace teleta::console
