// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/described/described_bracelet.h"

#include "backend/core/keys/toml_table.h"
#include "devices/bracelet/hid_bracelet.h"
#include "devices/bracelet/hid_bracelet_file.h"
#include "devices/modbus/modbus_bracelet.h"
#include "devices/sound_bracelet/sound_bracelet.h"

namespace teleta::described {

core::Expected<std::unique_ptr<core::BraceletLink>> openBracelet(const std::string& path,
                                                                 const core::StopSwitch& stop) {
    TELETA_TRY(const auto document, core::TomlDocument::open(path));
    core::TomlTable root = document.root();
    const bool named = root.has("kind");
    const std::size_t kind = named ? root.choice("kind", {"modbus", "hid_bracelet", "sound_bracelet"}) : 0;
    if (document.firstError())
        return core::Unexpected(*document.firstError());
    if (kind == 1) {
        TELETA_TRY(const auto file, bracelet::readHidBracelet(path));
        return bracelet::openHidBracelet(file.config, stop);
    }
    if (kind == 2) {
        TELETA_TRY(const auto file, sound::readSoundBracelet(path));
        return sound::openSoundBracelet(file, stop);
    }
    TELETA_TRY(const auto map, modbus::readRegisterMap(path));
    return modbus::openModbusBracelet(map, stop);
}

} // namespace teleta::described
