// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "devices/site/operator_domain.h"

#include <string>
#include <string_view>

namespace teleta::site_link {

/// A site as a console sees it (kind = "remote_site").
struct RemoteSiteFile {
    std::string name;     ///< of the site, as its own file has it
    std::string console;  ///< of this console, as in its certificate
    std::string person;   ///< who operates it; may be empty
    bool viewer = false;  ///< only looks
    std::string meshPath; ///< folder with the meshes of the site's arms, at the console; empty: none
    OperatorDomain meeting;
};

/// Error: notFound, ioFailed, badInput with file, line and column. Thread: any.
[[nodiscard]] core::Expected<RemoteSiteFile> readRemoteSite(const std::string& path);
/// The same of a text; file: named in errors.
[[nodiscard]] core::Expected<RemoteSiteFile> parseRemoteSite(std::string_view text, const std::string& file);

/// A name of a site, console or device; errors stay with the table's document. Thread: any.
[[nodiscard]] std::string readSiteName(core::TomlTable& table, std::string_view key);

} // namespace teleta::site_link
