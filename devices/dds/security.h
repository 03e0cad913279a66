// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <QString>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace teleta::dds {

/// How a participant proves who it is and what it may do: the keys that `teleta site keys` checks. All that
/// it sends is encrypted, and it takes part with programs that have keys of the same authorities only.
struct Security {
    /// The folder of one member, for example keys/console1, with cert.pem, key.pem and permissions.p7s. The
    /// folder that holds it has identity_ca.pem, permissions_ca.pem and governance.p7s.
    std::string folder;
};

/// Whether these keys are safe to use now, as site_keys::checkMember() tells. The middleware by itself takes
/// a key that does not belong to its certificate, and keys with which each member could sign permissions of
/// its own. Failure: refused, with the file and the reason; notFound or ioFailed, the folder. Thread: any.
[[nodiscard]] core::Expected<void> checkSecurity(const Security& security);

/// Properties of a participant by which the middleware finds the files and its plugins. Thread: any.
/// Source: OMG DDS Security 1.1, 9.3.1 and 9.4.1; Cyclone DDS 0.10, security.md.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> propertiesOf(const Security& security);

/// Governance and permissions as they are signed. The middleware reads them once for each domain and applies
/// them until the program ends, whatever later participants name. Failure: ioFailed. Thread: any.
[[nodiscard]] core::Expected<std::string> signedRights(const Security& security);

/// Why somebody was refused, from what the middleware reports; its own words where they are not known.
/// Translated. Thread: any (pure).
[[nodiscard]] QString securityReason(std::string_view line);

} // namespace teleta::dds
