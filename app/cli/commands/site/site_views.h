// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <optional>
#include <string>

namespace teleta::cli {

struct SiteOptions {
    std::string path;             ///< of the file with which the site is reached (kind = "remote_site")
    std::string out;              ///< with recordSite(): the recording
    std::optional<double> time_s; ///< ends after that; empty: with Ctrl-C
    bool json = false;
};

// Nothing of these moves an arm. Error: those of the file and of site_link::SiteClient::open(). Thread: one;
// they wait.

/// Prints the sites in the domain of the file and who controls them.
[[nodiscard]] core::Expected<void> listSites(const SiteOptions& options);
/// Prints a row for each change of the state.
[[nodiscard]] core::Expected<void> watchSite(const SiteOptions& options);
/// Prints the offset of the site's clock once a second.
[[nodiscard]] core::Expected<void> watchClock(const SiteOptions& options);
/// Records all that the site sends. Error: also as recording::Recorder::start().
[[nodiscard]] core::Expected<void> recordSite(const SiteOptions& options);

} // namespace teleta::cli
