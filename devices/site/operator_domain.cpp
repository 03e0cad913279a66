// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/site/operator_domain.h"

#include "backend/core/beside_file.h"
#include "backend/site_keys/site_keys.h"

#include <QCoreApplication>
#include <QDateTime>

namespace teleta::site_link {

namespace {

struct OperatorDomainText {
    Q_DECLARE_TR_FUNCTIONS(OperatorDomainText)
};

} // namespace

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
    table.finish();
    return found;
}

} // namespace teleta::site_link
