// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/core/threads/stop_switch.h"
#include "backend/pipeline/channel.h"
#include "devices/site/site_client.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace teleta::app {

/// A device of a site: an array, or an arm with its skin.
struct SiteRequest {
    std::string path;                            ///< of the file with which the site was reached
    std::string device;                          ///< its name there
    std::shared_ptr<site_link::SiteClient> site; ///< not null
};

/// Connects to a site and names all its devices; they share the connection. Waits for the site: not on the
/// GUI's thread. Error: that of the file and of site_link::SiteClient::open(); refused, it has no device that
/// can be shown.
[[nodiscard]] core::Expected<std::vector<SiteRequest>>
siteRequestsOf(const std::string& path, const core::StopSwitch& stop,
               const std::function<bool()>& cancelled = {});

/// Opens one of them. Error: badInput, the site does not say what it is; unavailable.
[[nodiscard]] core::Expected<std::shared_ptr<pipeline::Channel>> openRemote(const SiteRequest& request);

} // namespace teleta::app
