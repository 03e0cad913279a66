// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/trigger_port.h"

#include <memory>
#include <string>

namespace teleta::trigger {

/// Opens what the settings name; null for none. Error: as SerialTrigger::open() and OscTrigger::open().
/// Thread: any but the GUI's.
[[nodiscard]] core::Expected<std::unique_ptr<core::TriggerPort>>
openTrigger(const core::TriggerSettings& settings);

/// Settings from one word: a path is a serial port, [osc:]HOST:PORT is OSC. Error: badInput. Thread: any.
[[nodiscard]] core::Expected<core::TriggerSettings> triggerSettingsOf(const std::string& word);

} // namespace teleta::trigger
