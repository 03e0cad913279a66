// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/taxels/layout_file.h"

#include "backend/core/keys/toml_keys.h"
#include "devices/taxels/taxels_file.h"

#include <utility>

namespace teleta::taxels {

namespace {

struct LayoutFile {
    TaxelGrid grid;

    void describeKeys(core::Keys& keys) {
        keys.table("layout", "Where the taxels are", core::Need::required,
                   [this](core::Keys& table) { grid.describeKeys(table); });
    }
};

} // namespace

core::Expected<TaxelGrid> readTaxelGrid(const std::string& path) {
    TELETA_TRY(const auto document, core::TomlDocument::open(path));
    if (document.root().has("kind"))
        return readTaxels(path).map([](TaxelsFile file) { return std::move(file.grid); });
    return core::readKeys<LayoutFile>(document).map([](LayoutFile file) { return std::move(file.grid); });
}

} // namespace teleta::taxels
