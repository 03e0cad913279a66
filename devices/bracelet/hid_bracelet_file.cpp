// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/bracelet/hid_bracelet_file.h"

#include "backend/core/data/toml_table.h"

namespace teleta::bracelet {

namespace {

core::Expected<HidBraceletFile> readDocument(const core::TomlDocument& document) {
    constexpr long long kLargestId = 0xFFFF;
    core::TomlTable root = document.root();
    (void)root.choice("kind", {"hid_bracelet"});
    HidBraceletFile file;
    file.name = root.text("name");
    file.config.vendorId = static_cast<std::uint16_t>(root.integer("vendor_id", 1, kLargestId));
    file.config.productId = static_cast<std::uint16_t>(root.integer("product_id", 1, kLargestId));
    if (root.has("serial"))
        file.config.serial = root.text("serial");
    root.finish();
    if (document.firstError())
        return core::Unexpected(*document.firstError());
    return file;
}

} // namespace

core::Expected<HidBraceletFile> readHidBracelet(const std::string& path) {
    return core::TomlDocument::open(path).and_then(readDocument);
}

core::Expected<HidBraceletFile> parseHidBracelet(std::string_view text, const std::string& file) {
    return core::TomlDocument::parse(text, file).and_then(readDocument);
}

} // namespace teleta::bracelet
