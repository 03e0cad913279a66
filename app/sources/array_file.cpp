// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sources/array_file.h"

#include "backend/core/keys/toml_table.h"

#include <utility>

namespace teleta::app {

bool isArrayFileKind(std::string_view kind) {
    return taxels::isArrayKind(kind) || ros_array::isRosArrayKind(kind);
}

core::Expected<ArrayFile> readArrayFile(const std::string& path) {
    TELETA_TRY(const core::TomlDocument document, core::TomlDocument::open(path));
    if (ros_array::isRosArrayKind(document.root().text("kind", std::string()))) {
        TELETA_TRY(ros_array::RosArrayFile file, ros_array::readRosArray(path));
        return file;
    }
    TELETA_TRY(taxels::TaxelsFile file, taxels::readTaxels(path));
    return file;
}

} // namespace teleta::app
