// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/dds/security.h"

#include "backend/core/data/input_file.h"
#include "backend/site_keys/site_keys.h"

#include <QCoreApplication>

#include <chrono>
#include <filesystem>
#include <optional>
#include <tuple>

namespace teleta::dds {

namespace {

struct SecurityText {
    Q_DECLARE_TR_FUNCTIONS(DdsSecurity)
};

struct KeyFolders {
    std::filesystem::path member;
    std::filesystem::path all; ///< holds that of the member
};

KeyFolders foldersOf(const Security& security) {
    // Not only "keys/console1", but also "keys/console1/" and ".".
    const std::filesystem::path member =
        (std::filesystem::absolute(security.folder) / "").lexically_normal().parent_path();
    return {member, member.parent_path()};
}

/// Whom a line is about: "/O=TeleTA site/CN=console1"; empty where it does not say.
std::string_view subjectIn(std::string_view line) {
    constexpr std::string_view kBefore = "subject: ";
    const std::size_t begin = line.find(kBefore);
    if (begin == std::string_view::npos)
        return {};
    const std::string_view rest = line.substr(begin + kBefore.size());
    return rest.substr(0, rest.find("(code"));
}

std::optional<QString> knownReason(std::string_view line) {
    const auto says = [line](std::string_view words) { return line.find(words) != std::string_view::npos; };
    if (says("certificate has expired") || says("Certificate expired"))
        return SecurityText::tr("the certificate has expired");
    if (says("certificate is not yet valid") || says("Certificate start date is in the future"))
        return SecurityText::tr("the certificate is not valid yet");
    if (says("Certificate not valid"))
        return SecurityText::tr("the certificate is not signed by identity_ca.pem");
    // The signature of a handshake is wrong.
    if (says("Failed to finalize digest context"))
        return SecurityText::tr("the key does not belong to the certificate");
    if (says("Failed to parse PKCS7 SMIME document"))
        return SecurityText::tr("the permissions are not signed by permissions_ca.pem");
    if (says("Subject name is invalid"))
        return SecurityText::tr("the permissions do not name the subject of the certificate");
    if (says("validity period expired"))
        return SecurityText::tr("the permissions have expired");
    if (says("validity period has not started yet"))
        return SecurityText::tr("the permissions are not valid yet");
    if (says("participant denied") || says("in permissions"))
        return SecurityText::tr("the permissions (permissions.p7s) do not allow this domain");
    if (says("in governance"))
        return SecurityText::tr("the governance (governance.p7s) does not name this domain");
    if (says("Could not load"))
        return SecurityText::tr("the plugins of DDS Security cannot be loaded");
    return std::nullopt;
}

} // namespace

core::Expected<void> checkSecurity(const Security& security) {
    const auto now = std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
    TELETA_TRY(const site_keys::KeyReport report,
               site_keys::checkMember(security.folder, now.time_since_epoch().count()));
    for (const site_keys::KeyFinding& one : report.findings) {
        if (one.refused)
            return core::Unexpected(core::Error{
                core::ErrorKind::refused, one.message, {}, {(foldersOf(security).all / one.file).string()}});
    }
    return {};
}

std::vector<std::pair<std::string, std::string>> propertiesOf(const Security& security) {
    const auto [member, all] = foldersOf(security);
    std::vector<std::pair<std::string, std::string>> properties;
    for (const auto& [name, path] : {std::pair{"auth.identity_ca", all / "identity_ca.pem"},
                                     {"auth.identity_certificate", member / "cert.pem"},
                                     {"auth.private_key", member / "key.pem"},
                                     {"access.permissions_ca", all / "permissions_ca.pem"},
                                     {"access.governance", all / "governance.p7s"},
                                     {"access.permissions", member / "permissions.p7s"}})
        properties.emplace_back(std::string("dds.sec.") + name, "file:" + path.string());
    for (const auto& [plugin, library, function] :
         {std::tuple{"auth", "dds_security_auth", "authentication"},
          std::tuple{"crypto", "dds_security_crypto", "crypto"},
          std::tuple{"access", "dds_security_ac", "access_control"}}) {
        const std::string prefix = std::string("dds.sec.") + plugin + ".library.";
        properties.emplace_back(prefix + "path", library);
        properties.emplace_back(prefix + "init", std::string("init_") + function);
        properties.emplace_back(prefix + "finalize", std::string("finalize_") + function);
    }
    return properties;
}

core::Expected<std::string> signedRights(const Security& security) {
    const auto [member, all] = foldersOf(security);
    std::string texts;
    for (const std::filesystem::path& path : {all / "governance.p7s", member / "permissions.p7s"}) {
        TELETA_TRY(const std::string text, core::readFile(path.string()));
        texts += text;
    }
    return texts;
}

QString securityReason(std::string_view line) {
    const auto textOf = [](std::string_view text) {
        return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
    };
    const QString reason = knownReason(line).value_or(textOf(line));
    const std::string_view subject = subjectIn(line);
    return subject.empty() ? reason : QStringLiteral("%1 (%2)").arg(reason, textOf(subject));
}

} // namespace teleta::dds
