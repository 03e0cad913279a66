// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/taxels/layout_file.h"

#include "backend/core/keys/toml_keys.h"
#include "devices/taxels/taxels_file.h"

#include <utility>

namespace teleta::taxels {

void LayoutFile::describeKeys(core::Keys& keys) {
    keys.number("threshold", threshold, core::NumberRange::positive(),
                "Load above which a taxel counts as touched");
    keys.table("layout", "Where the taxels are", core::Need::required,
               [this](core::Keys& table) { grid.describeKeys(table); });
}

core::Expected<LayoutFile> readLayout(const std::string& path) {
    TELETA_TRY(const auto document, core::TomlDocument::open(path));
    if (document.root().has("kind"))
        return readTaxels(path).map([](TaxelsFile file) {
            return LayoutFile{std::move(file.grid), file.threshold};
        });
    return core::readKeys<LayoutFile>(document);
}

} // namespace teleta::taxels
