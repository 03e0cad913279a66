// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/core/keys/toml_table.h"
#include "devices/dds/domain_config.h"
#include "devices/dds/participant.h"
#include "devices/dds/security.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace teleta::site_link {

/// Where a site and its consoles meet: the table [operator] of their files.
struct OperatorDomain {
    static constexpr int kDefaultDomain = 71;

    dds::DomainConfig domain;
    std::optional<dds::Security> security; ///< empty: none, on the loopback interface only
    bool anyInterface = false; ///< security_bind = "any": a site may be on a network that others use, too

    /// Error: as dds::Participant::open(). Thread: any.
    [[nodiscard]] core::Expected<std::shared_ptr<const dds::Participant>> join() const {
        return dds::Participant::open(domain, {}, security);
    }
    /// Whether a site may be there: on the loopback interface, on a tunnel such as that of a VPN, or wherever
    /// anyInterface says so. Whoever reaches the ports reaches the middleware before anybody has proven who
    /// he is. Error: badInput. An interface that does not exist is join()'s to refuse. Thread: any.
    [[nodiscard]] core::Expected<void> checkInterface() const;
    /// What to know of the keys although they may be used, a translated sentence each: for example that they
    /// end within 14 days. Reads the files. Thread: any.
    [[nodiscard]] std::vector<std::string> keyWarnings() const;
};

/// Reads the table. Without certificates only the loopback interface is accepted: nobody else may listen or
/// move an arm. file: from whose folder paths count. Errors stay with the table's document. Thread: any.
[[nodiscard]] OperatorDomain readOperatorDomain(core::TomlTable& root, const std::string& file);

} // namespace teleta::site_link
