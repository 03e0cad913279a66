// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace teleta::site_link {

class SiteClient;

/// Why nothing comes from a device of a site, a translated sentence without a full stop. Thread: any.
[[nodiscard]] std::string silenceText(const SiteClient& site);

} // namespace teleta::site_link
