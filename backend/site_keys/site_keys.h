// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/site_keys/signed_document.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace teleta::site_keys {

/// One thing that is wrong with a set of keys.
struct KeyFinding {
    bool refused = true; ///< a secured site does not start or is not safe with it; else a warning
    std::string file;    ///< relative to the folder
    std::string message; ///< a sentence, translated
};

/// A site, a console or a viewer: a folder with cert.pem, key.pem and permissions.p7s.
struct KeyMember {
    std::string name;
    std::string subject;            ///< in the order of RFC 2253, as permissions name it
    std::int64_t ends_unixS = 0;    ///< when its certificate or its permissions end, the first; 0: unknown
    std::optional<MemberRole> role; ///< as its permissions tell
};

struct KeyReport {
    std::string site;               ///< in the topics of the permissions; empty if there is none
    std::vector<KeyMember> members; ///< by name
    std::vector<KeyFinding> findings;

    [[nodiscard]] bool usable() const;
};

/// Checks what DDS Security of a site's operator domain needs in a folder: identity_ca.pem,
/// permissions_ca.pem, governance.p7s and one folder for each member. Certificates and their dates at
/// `now_unixS`, who signed what, that keys fit and that nobody else can read them, and that no identity
/// verifies against the authority of permissions: its holder could sign permissions of its own. A certificate
/// or permissions that end within 14 days are a warning. Fails when the folder cannot be read. Thread: any.
[[nodiscard]] core::Expected<KeyReport> checkKeys(const std::string& folder, std::int64_t now_unixS);

/// The same for the program of one member, whose own folder this is: "keys/console1". The files of all are in
/// the folder that holds it. Other members are not looked at, and the member's key must be there.
[[nodiscard]] core::Expected<KeyReport> checkMember(const std::string& folder, std::int64_t now_unixS);

/// Who takes part in a site.
struct KeyPlan {
    std::string folder; ///< made by the commands if it is missing
    std::string site;   ///< in the names of topics
    std::vector<std::string> consoles;
    std::vector<std::string> viewers;
};

/// The commands of the openssl program that make the folder, for a POSIX shell: authorities where there are
/// none, governance, and certificates and permissions for 90 days from `now_unixS`; run again, they renew
/// both and keep the keys. Names of sites, consoles and viewers are [a-z][a-z0-9_]{0,30}, each once, none of
/// them "site"; others fail.
[[nodiscard]] core::Expected<std::string> commandsFor(const KeyPlan& plan, std::int64_t now_unixS);

} // namespace teleta::site_keys
