// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/base/command_io.h"
#include "app/cli/base/interruption.h"
#include "app/cli/base/options.h"
#include "app/cli/commands/site/site_commands.h"
#include "app/cli/commands/site/site_views.h"
#include "backend/core/failure.h"
#include "backend/site_keys/site_keys.h"

#include <QCoreApplication>
#include <QDateTime>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace teleta::cli {

namespace {

struct SiteCommandText {
    Q_DECLARE_TR_FUNCTIONS(SiteCommandText)
};

/// When the certificate or the permissions end, in UTC; empty if that cannot be read.
std::string timeOf(const site_keys::KeyMember& member) {
    if (member.ends_unixS == 0)
        return {};
    return QDateTime::fromSecsSinceEpoch(member.ends_unixS, Qt::UTC).toString(Qt::ISODate).toStdString();
}

/// As scripts read it; empty where the permissions do not tell.
std::string roleOf(const site_keys::KeyMember& member) {
    if (!member.role)
        return {};
    switch (*member.role) {
    case site_keys::MemberRole::site:
        return "site";
    case site_keys::MemberRole::console:
        return "console";
    case site_keys::MemberRole::viewer:
        break;
    }
    return "viewer";
}

QString orDash(const std::string& text) {
    return text.empty() ? QStringLiteral("-") : QString::fromStdString(text);
}

class SiteCommand : public CommandGroup {
public:
    void declare(CLI::App& app) {
        app.require_subcommand(1);
        CLI::App& keys = addPart(
            app, "keys",
            SiteCommandText::tr(
                "Check the certificates and permissions of a site, or print the commands that create them"),
            [this] { return checkOrTell(); });
        addOption(
            keys, "folder", m_plan.folder,
            SiteCommandText::tr(
                "Folder with identity_ca.pem, permissions_ca.pem, governance.p7s and one folder for each "
                "site, console and viewer"),
            "DIR")
            ->required();
        addOption(keys, "--make", m_plan.site,
                  SiteCommandText::tr(
                      "Instead of checking, print the openssl commands that create the folder for a "
                      "site of this name"),
                  "SITE");
        addOption(keys, "--console", m_plan.consoles, SiteCommandText::tr("Consoles that may take control"),
                  "NAME")
            ->needs("--make");
        addOption(keys, "--viewer", m_plan.viewers, SiteCommandText::tr("Consoles that only watch"), "NAME")
            ->needs("--make");
        declareJson(keys, m_json);
        declareView(app, "list", SiteCommandText::tr("List the sites that are there and who controls them"),
                    listSites);
        declareTime(
            declareView(app, "watch", SiteCommandText::tr("Print each change of a site's state"), watchSite));
        declareTime(declareView(app, "clock",
                                SiteCommandText::tr("Print the offset of a site's clock, and its bound"),
                                watchClock));
        CLI::App& record = declareView(
            app, "record", SiteCommandText::tr("Record all that a site sends, without a screen"), recordSite);
        declareTime(record);
        addOption(record, "-o,--out", m_options.out, SiteCommandText::tr("File of the recording"),
                  "FILE.teleta")
            ->required();
    }

private:
    CLI::App& declareView(CLI::App& app, const char* name, const QString& summary,
                          core::Expected<void> (*work)(const SiteOptions&)) {
        CLI::App& part = addPart(app, name, summary, [this, work] {
            m_options.json = m_json;
            return unlessCut(work(m_options));
        });
        addOption(part, "site", m_options.path,
                  SiteCommandText::tr("File with which the site is reached (kind = \"remote_site\")"),
                  "SITE.toml")
            ->required();
        if (work != recordSite)
            declareJson(part, m_json);
        return part;
    }
    void declareTime(CLI::App& part) {
        addOption(part, "--seconds", m_options.time_s,
                  SiteCommandText::tr("End after that time; default: Ctrl-C"), "S")
            ->check(positive());
    }

    [[nodiscard]] core::Expected<void> checkOrTell() const { return m_plan.site.empty() ? check() : tell(); }

    [[nodiscard]] core::Expected<void> tell() const {
        TELETA_TRY(const std::string commands,
                   site_keys::commandsFor(m_plan, QDateTime::currentSecsSinceEpoch()));
        return cli::printText(commands);
    }

    [[nodiscard]] core::Expected<void> check() const {
        TELETA_TRY(const site_keys::KeyReport report,
                   site_keys::checkKeys(m_plan.folder, QDateTime::currentSecsSinceEpoch()));
        TELETA_CHECK(m_json ? printJson(report) : printLines(report));
        if (!report.usable())
            return core::refused(SiteCommandText::tr("These keys are not safe to use."));
        return {};
    }

    [[nodiscard]] static core::Expected<void> printJson(const site_keys::KeyReport& report) {
        nlohmann::ordered_json members = nlohmann::ordered_json::array();
        for (const site_keys::KeyMember& one : report.members)
            members.push_back({{"name", one.name},
                               {"role", textOrNull(roleOf(one))},
                               {"subject", textOrNull(one.subject)},
                               {"ends", textOrNull(timeOf(one))}});
        nlohmann::ordered_json findings = nlohmann::ordered_json::array();
        for (const site_keys::KeyFinding& one : report.findings)
            findings.push_back(
                {{"file", textOrNull(one.file)}, {"refused", one.refused}, {"message", one.message}});
        return printDocument({{"usable", report.usable()},
                              {"site", textOrNull(report.site)},
                              {"members", members},
                              {"findings", findings}});
    }

    [[nodiscard]] static core::Expected<void> printLines(const site_keys::KeyReport& report) {
        std::string text;
        for (const site_keys::KeyMember& one : report.members)
            text += SiteCommandText::tr("%1 (%2): %3, until %4")
                        .arg(orDash(one.name), orDash(roleOf(one)), orDash(one.subject), orDash(timeOf(one)))
                        .toStdString() +
                    '\n';
        for (const site_keys::KeyFinding& one : report.findings) {
            const QString message = one.file.empty() ? QString::fromStdString(one.message)
                                                     : QString::fromStdString(one.file + ": " + one.message);
            text += (one.refused ? SiteCommandText::tr("Refused: %1") : SiteCommandText::tr("Warning: %1"))
                        .arg(message)
                        .toStdString() +
                    '\n';
        }
        return cli::printText(text);
    }

    site_keys::KeyPlan m_plan;
    SiteOptions m_options;
    bool m_json = false;
};

} // namespace

Command siteCommand() {
    return makeCommand<SiteCommand>(
        "site", SiteCommandText::tr("Sites at which robots are, and their keys"),
        "teleta site keys keys --make lab --console console1 --viewer viewer1 > make_keys.sh\n"
        "  sh make_keys.sh\n"
        "  teleta site keys keys");
}

} // namespace teleta::cli
