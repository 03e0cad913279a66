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

/// A device of a site: an array, an arm with its skin, or a camera.
struct SiteRequest {
    std::string path;   ///< of the file with which the site was reached
    std::string name;   ///< of the site
    std::string device; ///< its name there
    /// The connection. The open devices keep it; a view does not, since to end it may wait.
    std::weak_ptr<site_link::SiteClient> site;
};

/// What a site has.
struct SiteDevices {
    std::shared_ptr<site_link::SiteClient> site;
    std::vector<SiteRequest> devices; ///< not empty
};

/// Connects to a site and names all its devices; they share the connection. Waits for the site: not on the
/// GUI's thread. Error: that of the file and of site_link::SiteClient::open(); refused, it has no device that
/// can be shown.
[[nodiscard]] core::Expected<SiteDevices> siteDevicesOf(const std::string& path, const core::StopSwitch& stop,
                                                        const std::function<bool()>& cancelled = {});

/// Opens one of them. Error: unavailable, site is null, the connection has ended; badInput, the site does not
/// say what the device is.
[[nodiscard]] core::Expected<std::shared_ptr<pipeline::Channel>>
openRemote(const std::shared_ptr<site_link::SiteClient>& site, const SiteRequest& request);

} // namespace teleta::app
