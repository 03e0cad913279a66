// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/bracelet/hid_bracelet_file.h"

#include "backend/core/keys/toml_keys.h"

namespace teleta::bracelet {

void HidBraceletFile::describeKeys(core::Keys& keys) {
    const core::WholeRange ids{1, 0xFFFF};
    keys.word("kind", "hid_bracelet", "A bracelet over USB");
    keys.text("name", name, "Name on the screen");
    keys.whole("vendor_id", config.vendorId, ids, "USB vendor of the board");
    keys.whole("product_id", config.productId, ids, "USB product of the board");
    keys.text("serial", config.serial, "Serial number; otherwise the first board with these ids",
              core::Need::optional);
}

core::Expected<HidBraceletFile> readHidBracelet(const std::string& path) {
    return core::TomlDocument::open(path).and_then(core::readKeys<HidBraceletFile>);
}

core::Expected<HidBraceletFile> parseHidBracelet(std::string_view text, const std::string& file) {
    return core::TomlDocument::parse(text, file).and_then(core::readKeys<HidBraceletFile>);
}

} // namespace teleta::bracelet
