// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/bracelet/bracelet_link.h"
#include "backend/core/error.h"
#include "backend/core/threads/stop_switch.h"
#include "devices/sound_bracelet/sound_bracelet_file.h"

#include <memory>

namespace teleta::sound {

/// Opens voice coils on a sound card as a bracelet, which opens the card again by itself after a fault,
/// silent until somebody asks for more. stopSwitch must outlive it. Error: as openSoundOutput. It may take 2
/// s.
[[nodiscard]] core::Expected<std::unique_ptr<core::BraceletLink>>
openSoundBracelet(const SoundBraceletFile& file, const core::StopSwitch& stopSwitch,
                  core::BraceletLinkConfig config = {});

} // namespace teleta::sound
