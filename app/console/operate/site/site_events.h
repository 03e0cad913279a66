// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/site/site_client.h"

#include <QString>

namespace teleta::console {

/// What happened at a site, as a translated sentence. An event of a site that knows more than this program is
/// told in the site's own words. Thread: any (pure).
[[nodiscard]] QString siteEventText(const QString& site, const site_link::RemoteEvent& event);

/// The event is worth a notice, and nothing else on the page tells it. Thread: any (pure).
[[nodiscard]] bool isNotice(const site_link::RemoteEvent& event);

} // namespace teleta::console
