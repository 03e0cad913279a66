// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/site/operator_domain.h"

#include "backend/core/beside_file.h"

#include <QCoreApplication>

namespace teleta::site_link {

namespace {

struct OperatorDomainText {
    Q_DECLARE_TR_FUNCTIONS(OperatorDomainText)
};

} // namespace

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
