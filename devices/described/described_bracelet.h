// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/bracelet/bracelet_link.h"
#include "backend/core/error.h"
#include "backend/core/threads/stop_switch.h"

#include <memory>
#include <string>

namespace teleta::described {

/// Opens the bracelet that a TOML file describes, by its kind: "modbus" (modbus::RegisterMap with motors),
/// "hid_bracelet" (bracelet::readHidBracelet) or "sound_bracelet" (sound::readSoundBracelet). stop must
/// outlive it. Error: badInput with file, line and column, or why the device cannot be reached. Thread: any;
/// it may wait for the device.
[[nodiscard]] core::Expected<std::unique_ptr<core::BraceletLink>> openBracelet(const std::string& path,
                                                                               const core::StopSwitch& stop);

} // namespace teleta::described
