// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/site/site_file.h"
#include "backend/site_keys/signed_document.h"
#include "devices/site/remote_site_file.h"
#include "devices/site/site_topics.h"
#include "devices/site/stream_descriptions.h"
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

bool siteFile(Bytes bytes) {
    const core::Expected<site_program::SiteFile> file = site_program::parseSite(textOf(bytes), kInput);
    if (!file) {
        requireExplained(file.error());
        return false;
    }
    require(site_link::isSiteName(file->name) && !file->devices.empty(), "a site has a name and a device");
    require(file->meeting.security || dds::isLoopback(file->meeting.domain.interface),
            "without security nobody else is reached");
    require(file->times.motion_ns >= 60'000'000 && file->times.motion_ns <= 300'000'000,
            "the motion lease has bounds");
    for (const site_program::SiteDevice& device : file->devices)
        require(site_link::isSiteName(device.id), "a device has a name");
    return true;
}

bool remoteSiteFile(Bytes bytes) {
    const core::Expected<site_link::RemoteSiteFile> file = site_link::parseRemoteSite(textOf(bytes), kInput);
    if (!file) {
        requireExplained(file.error());
        return false;
    }
    require(site_link::isSiteName(file->name) && site_link::isSiteName(file->console), "names are names");
    require(file->meeting.security || dds::isLoopback(file->meeting.domain.interface),
            "without security nobody else is reached");
    return true;
}

bool siteStreams(Bytes bytes) {
    const auto streams = site_link::readStreams(textOf(bytes), kInput);
    if (!streams) {
        requireExplained(streams.error());
        return false;
    }
    const auto again = site_link::readStreams(site_link::describeStreams(*streams), kInput);
    require(again.has_value() && again->size() == streams->size(), "what is read can be told");
    return true;
}

} // namespace teleta::fuzz
