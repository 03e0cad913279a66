// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/sound_bracelet/sound_bracelet.h"

#include "devices/sound_bracelet/sound_bracelet_port.h"
#include "devices/sound_bracelet/sound_output.h"

#include <utility>

namespace teleta::sound {

core::Expected<std::unique_ptr<core::BraceletLink>> openSoundBracelet(const SoundBraceletFile& file,
                                                                      const core::StopSwitch& stopSwitch,
                                                                      core::BraceletLinkConfig config) {
    core::BraceletOpener opener = [file, &stopSwitch] {
        return openSoundBraceletPort(file, stopSwitch, openSoundOutput);
    };
    TELETA_TRY(auto opened, opener());
    return std::make_unique<core::BraceletLink>(std::move(opened), std::move(opener), stopSwitch,
                                                std::move(config));
}

} // namespace teleta::sound
