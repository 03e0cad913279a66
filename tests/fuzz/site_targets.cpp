// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/site_keys/signed_document.h"
#include "tests/fuzz/fuzz_check.h"
#include "tests/fuzz/fuzz_targets.h"

#include <algorithm>

namespace teleta::fuzz {

bool sitePermissions(Bytes bytes) {
    const std::string text = textOf(bytes);
    bool accepted = false;
    for (const char* member : {"site", "console1", "viewer1"}) {
        const site_keys::PermissionsCheck check = site_keys::checkPermissions(
            text, member, std::string("CN=") + member + ",O=TeleTA site", 1'800'000'000);
        require(std::ranges::none_of(check.problems, &std::string::empty), "a problem has a text");
        require(!check.problems.empty() ||
                    (check.role.has_value() && !check.site.empty() && check.ends_unixS > 1'800'000'000),
                "what is accepted has a role, a site and an end");
        require((check.role == site_keys::MemberRole::site) <= (std::string_view(member) == "site"),
                "nobody else is the site");
        accepted = accepted || check.problems.empty();
    }
    return accepted;
}

bool siteGovernance(Bytes bytes) {
    const std::string text = textOf(bytes);
    const std::vector<std::string> problems = site_keys::checkGovernance(text);
    require(std::ranges::none_of(problems, &std::string::empty), "a problem has a text");
    require(!problems.empty() || text.find("ENCRYPT") != std::string::npos, "what is accepted is encrypted");
    return problems.empty();
}

} // namespace teleta::fuzz
