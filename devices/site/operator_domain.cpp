// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/site/operator_domain.h"

#include "backend/core/beside_file.h"
#include "backend/core/failure.h"
#include "backend/site_keys/site_keys.h"

#include <QCoreApplication>
#include <QDateTime>

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <memory>
#include <net/if.h>
#include <netinet/in.h>

namespace teleta::site_link {

namespace {

struct OperatorDomainText {
    Q_DECLARE_TR_FUNCTIONS(OperatorDomainText)
};

/// Flags IFF_... of an interface, by its name, by one of its IPv4 addresses, or by an address of its network,
/// as DDS finds it: those that all the interfaces on that network have. Empty: there is none.
std::optional<unsigned> flagsOf(const std::string& interface) {
    ifaddrs* all = nullptr;
    if (getifaddrs(&all) != 0)
        return std::nullopt;
    const std::unique_ptr<ifaddrs, decltype(&freeifaddrs)> owner(all, freeifaddrs);
    in_addr asked{};
    const bool isAddress = inet_pton(AF_INET, interface.c_str(), &asked) == 1;
    const auto addressOf = [](const sockaddr* any) {
        return reinterpret_cast<const sockaddr_in*>(any)->sin_addr.s_addr;
    };
    std::optional<unsigned> onNetwork;
    for (const ifaddrs* one = all; one != nullptr; one = one->ifa_next) {
        if (interface == one->ifa_name)
            return one->ifa_flags;
        if (!isAddress || one->ifa_addr == nullptr || one->ifa_addr->sa_family != AF_INET)
            continue;
        const in_addr_t differs = addressOf(one->ifa_addr) ^ asked.s_addr;
        if (differs == 0)
            return one->ifa_flags;
        if (one->ifa_netmask != nullptr && (differs & addressOf(one->ifa_netmask)) == 0)
            onNetwork = onNetwork ? *onNetwork & one->ifa_flags : one->ifa_flags;
    }
    return onNetwork;
}

} // namespace

core::Expected<void> OperatorDomain::checkInterface() const {
    if (!security || anyInterface || dds::isLoopback(domain.interface))
        return {};
    if (const std::optional<unsigned> flags = flagsOf(domain.interface);
        domain.interface.empty() || (flags && (*flags & IFF_POINTOPOINT) == 0))
        return core::failed(
            core::ErrorKind::badInput,
            domain.interface.empty()
                ? OperatorDomainText::tr("no interface is named, so that each network reaches the site")
                : OperatorDomainText::tr("%1 is no tunnel, so that its whole network reaches the site")
                      .arg(QString::fromStdString(domain.interface)),
            OperatorDomainText::tr("interface: that of a VPN; or security_bind = \"any\""));
    return {};
}

std::vector<std::string> OperatorDomain::keyWarnings() const {
    std::vector<std::string> warnings;
    if (!security)
        return warnings;
    if (const auto report = site_keys::checkMember(security->folder, QDateTime::currentSecsSinceEpoch())) {
        for (const site_keys::KeyFinding& finding : report->findings)
            warnings.push_back(finding.file.empty() ? finding.message
                                                    : finding.file + ": " + finding.message);
    }
    return warnings;
}

OperatorDomain readOperatorDomain(core::TomlTable& root, const std::string& file) {
    OperatorDomain found;
    core::TomlTable table = root.table("operator");
    found.domain.domain =
        static_cast<int>(table.integer("domain", 0, dds::kHighestDomain, OperatorDomain::kDefaultDomain));
    found.domain.interface = table.text("interface");
    found.domain.peers = table.textList("peers");
    if (table.choice("security", {"certificates", "none"}) == 0)
        found.security = dds::Security{core::besideFile(file, table.text("certificates"))};
    else if (!dds::isLoopback(found.domain.interface))
        table.fail(
            "security",
            OperatorDomainText::tr("without certificates anybody on this network could move the arm")
                .toStdString(),
            OperatorDomainText::tr("security = \"certificates\", or interface = \"lo\"").toStdString());
    found.anyInterface = table.has("security_bind") && table.choice("security_bind", {"tunnel", "any"}) == 1;
    table.finish();
    return found;
}

} // namespace teleta::site_link
