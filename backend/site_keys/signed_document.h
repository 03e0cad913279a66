// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace teleta::site_keys {

/// What a member of a site may do, by its topics.
enum class MemberRole {
    site,    ///< publishes all of the site, subscribes to what consoles send
    console, ///< publishes below its own name, subscribes to all of the site
    viewer   ///< publishes that it is there and probes of the clock, subscribes to all of the site
};

struct MemberTopics {
    std::vector<std::string> publish;
    std::vector<std::string> subscribe;
};
/// The expressions in the permissions of a member of the site `site`, as DDS names topics.
[[nodiscard]] MemberTopics topicsOf(MemberRole role, const std::string& site, const std::string& member);

/// The name of the member that is the site itself.
inline constexpr const char* kSiteMember = "site";

/// What is wrong with the permissions of one member: its subject must be named by a grant that holds at
/// `now_unixS` (times are UTC without a zone), allows the topics of its role and nothing else, and denies
/// what it does not name. The member "site" is the site, others are consoles or viewers.
struct PermissionsCheck {
    std::vector<std::string> problems; ///< sentences, translated
    std::int64_t ends_unixS = 0;       ///< of that grant, or 0
    std::string site;                  ///< in the names of its topics; empty if there is none
    std::optional<MemberRole> role;    ///< nothing if there is a problem with the topics
};
[[nodiscard]] PermissionsCheck checkPermissions(const std::string& xml, const std::string& member,
                                                const std::string& subject, std::int64_t now_unixS);

/// What of the governance is weaker than a site asks for: peers that are not authenticated, joining,
/// discovery, liveliness, reading and writing without protection, messages not signed, data not encrypted.
[[nodiscard]] std::vector<std::string> checkGovernance(const std::string& xml);

} // namespace teleta::site_keys
