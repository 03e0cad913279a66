// SPDX-License-Identifier: GPL-3.0-or-later
// The openssl program makes the keys by the commands that are told to people.
#include "backend/site_keys/site_keys.h"

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <algorithm>
#include <ctime>

using namespace teleta::site_keys;

namespace {

constexpr std::int64_t kDay_s = 86'400;

constexpr const char* kConsoleRule =
    "<allow_rule><publish><topics><topic>rt/teleta/lab/console/console1/*</topic></topics></publish>"
    "<subscribe><topics><topic>rt/teleta/lab/*</topic></topics></subscribe></allow_rule>";

class SiteKeys : public ::testing::Test {
protected:
    void SetUp() override {
        const auto commands = commandsFor({.folder = m_folder.path().toStdString(),
                                           .site = "lab",
                                           .consoles = {"console1"},
                                           .viewers = {"viewer1"}},
                                          std::time(nullptr));
        ASSERT_TRUE(commands);
        sh(*commands);
    }

    void write(const QString& file, const QString& text) const {
        QFile out(m_folder.filePath(file));
        ASSERT_TRUE(out.open(QIODevice::WriteOnly));
        out.write(text.toUtf8());
    }
    /// Permissions of console1 with these topics, signed by the authority.
    void writePermissions(const QString& from, const QString& to,
                          const QString& byDefault = QStringLiteral("DENY"),
                          const QString& rules = QString::fromLatin1(kConsoleRule),
                          const QString& subject = QStringLiteral("CN=console1,O=TeleTA site")) const {
        write(QStringLiteral("permissions_console1.xml"),
              QStringLiteral("<dds><permissions><grant name=\"console1\"><subject_name>%1</subject_name>"
                             "<validity><not_before>%2</not_before><not_after>%3</not_after></validity>"
                             "%4<default>%5</default></grant></permissions></dds>\n")
                  .arg(subject, from, to, rules, byDefault));
        sign("console1");
    }
    void writeRules(const QString& rules) const {
        writePermissions(QStringLiteral("2026-01-01T00:00:00"), QStringLiteral("2126-01-01T00:00:00"),
                         QStringLiteral("DENY"), rules);
    }
    void sh(const std::string& commands) const {
        QProcess shell;
        shell.setWorkingDirectory(m_folder.path());
        shell.setProcessChannelMode(QProcess::MergedChannels);
        shell.start("/bin/sh", {"-ec", QString::fromStdString(commands)});
        ASSERT_TRUE(shell.waitForFinished(60'000));
        ASSERT_EQ(shell.exitCode(), 0) << shell.readAll().toStdString();
    }
    void sign(const std::string& name) const {
        sh("openssl smime -sign -text -in permissions_" + name + ".xml -out " + name +
           "/permissions.p7s -signer permissions_ca.pem -inkey permissions_ca_key.pem");
    }
    [[nodiscard]] KeyReport check(std::int64_t later_s = 0) const {
        const auto report = checkKeys(m_folder.path().toStdString(), std::time(nullptr) + 60 + later_s);
        EXPECT_TRUE(report);
        return report.value_or(KeyReport{});
    }
    /// Whether this file is refused with these words, and no other.
    [[nodiscard]] ::testing::AssertionResult refuses(const std::string& file, const std::string& words,
                                                     std::int64_t later_s = 0) const {
        const KeyReport report = check(later_s);
        bool found = false;
        for (const KeyFinding& one : report.findings) {
            found =
                found || (one.refused && one.file == file && one.message.find(words) != std::string::npos);
            if (one.refused && one.file != file)
                return ::testing::AssertionFailure() << one.file << ": " << one.message;
        }
        return found ? ::testing::AssertionSuccess() : ::testing::AssertionFailure() << "not refused";
    }

    QTemporaryDir m_folder;
};

} // namespace

TEST_F(SiteKeys, acceptWhatTheirCommandsMake) {
    const KeyReport report = check();
    EXPECT_TRUE(report.usable()) << (report.findings.empty() ? "" : report.findings.front().message);
    EXPECT_TRUE(report.findings.empty());
    EXPECT_EQ(report.site, "lab");
    ASSERT_EQ(report.members.size(), 3U);
    EXPECT_EQ(report.members[0].name, "console1");
    EXPECT_EQ(report.members[0].role, MemberRole::console);
    EXPECT_EQ(report.members[1].role, MemberRole::site);
    EXPECT_EQ(report.members[2].role, MemberRole::viewer);
    EXPECT_EQ(report.members[0].subject, "CN=console1,O=TeleTA site");
    EXPECT_NEAR(static_cast<double>(report.members[0].ends_unixS - std::time(nullptr)), 90.0 * kDay_s, 600);
}

TEST_F(SiteKeys, warnBeforeACertificateEndsAndRefuseItAfter) {
    const KeyReport soon = check(80 * kDay_s);
    EXPECT_TRUE(soon.usable());
    EXPECT_EQ(soon.findings.size(), 6U); // certificate and permissions of each
    const KeyReport over = check(91 * kDay_s);
    EXPECT_FALSE(over.usable());
    EXPECT_TRUE(std::any_of(over.findings.begin(), over.findings.end(), [](const KeyFinding& one) {
        return one.refused && one.file == "site/cert.pem" && one.message.find("expired") != std::string::npos;
    }));
}

TEST_F(SiteKeys, areCheckedForOneMember) {
    // Other members are none of its business.
    sh("rm site/key.pem viewer1/key.pem viewer1/permissions.p7s");
    const std::int64_t now_s = std::time(nullptr) + 60;
    for (const char* folder : {"console1", "console1/", "console1/."}) {
        const auto report = checkMember(m_folder.filePath(folder).toStdString(), now_s);
        ASSERT_TRUE(report) << folder;
        EXPECT_TRUE(report->findings.empty()) << folder;
        ASSERT_EQ(report->members.size(), 1U);
        EXPECT_EQ(report->members[0].name, "console1");
    }
    const std::string folder = m_folder.filePath("console1").toStdString();
    // The permissions end before the certificate.
    const QDateTime end = QDateTime::fromSecsSinceEpoch(now_s + 13 * kDay_s, Qt::UTC);
    writePermissions("2026-01-01T00:00:00", end.toString("yyyy-MM-ddTHH:mm:ss"));
    const auto soon = checkMember(folder, now_s);
    ASSERT_TRUE(soon);
    EXPECT_TRUE(soon->usable());
    EXPECT_EQ(soon->members[0].ends_unixS, now_s + 13 * kDay_s);
    ASSERT_EQ(soon->findings.size(), 1U);
    EXPECT_EQ(soon->findings[0].file, "console1/permissions.p7s");
    sh("rm console1/key.pem");
    const auto keyless = checkMember(folder, now_s);
    ASSERT_TRUE(keyless);
    EXPECT_FALSE(keyless->usable());
    EXPECT_FALSE(checkMember(folder + "2", now_s));
}

TEST_F(SiteKeys, refuseOneAuthorityForBoth) {
    // The holder of such a certificate could sign permissions of its own.
    sh("cp permissions_ca.pem identity_ca.pem; cp permissions_ca_key.pem identity_ca_key.pem\n"
       "for n in site console1; do openssl x509 -req -sha256 -in $n/req.pem -CA identity_ca.pem -CAkey "
       "identity_ca_key.pem -CAcreateserial -days 90 -out $n/cert.pem; done");
    const KeyReport report = check();
    EXPECT_FALSE(report.usable());
    for (const char* file : {"site/cert.pem", "console1/cert.pem"})
        EXPECT_TRUE(std::any_of(report.findings.begin(), report.findings.end(), [&](const KeyFinding& one) {
            return one.refused && one.file == file &&
                   one.message.find("verifies against permissions_ca.pem") != std::string::npos;
        }));
}

TEST_F(SiteKeys, refusePermissionsThatAMemberSigned) {
    sh("openssl smime -sign -text -in permissions_console1.xml -out console1/permissions.p7s "
       "-signer console1/cert.pem -inkey console1/key.pem");
    EXPECT_TRUE(refuses("console1/permissions.p7s", "not signed by permissions_ca.pem"));
}

TEST_F(SiteKeys, refuseACertificateOfAnotherAuthority) {
    sh("openssl req -x509 -newkey ec -pkeyopt ec_paramgen_curve:prime256v1 -nodes -keyout other_key -out "
       "other -days 30 "
       "-subj '/O=TeleTA site/CN=identity_ca'\n"
       "openssl x509 -req -sha256 -in site/req.pem -CA other -CAkey other_key -CAcreateserial -days 90 -out "
       "site/cert.pem");
    EXPECT_TRUE(refuses("site/cert.pem", "not signed by identity_ca.pem"));
}

TEST_F(SiteKeys, refuseKeysOfOthersAndForOthers) {
    sh("chmod 644 site/key.pem");
    EXPECT_TRUE(refuses("site/key.pem", "chmod 600"));
    sh("cp console1/key.pem site/key.pem; chmod 600 site/key.pem");
    EXPECT_TRUE(refuses("site/key.pem", "does not belong"));
    sh("rm site/key.pem");
    EXPECT_TRUE(check().usable());
    EXPECT_EQ(check().findings.size(), 1U);
}

TEST_F(SiteKeys, refusePermissionsOfAnotherSubjectOrTime) {
    const std::string file = "console1/permissions.p7s";
    sh("cp site/permissions.p7s console1/permissions.p7s");
    EXPECT_TRUE(refuses(file, "CN=console1,O=TeleTA site"));
    writePermissions("2020-01-01T00:00:00", "2021-01-01T00:00:00");
    EXPECT_TRUE(refuses(file, "expired"));
    writePermissions("2125-01-01T00:00:00", "2126-01-01T00:00:00");
    EXPECT_TRUE(refuses(file, "are not valid yet"));
    writePermissions("2020-01-01T00:00:00Z", "2121-01-01T00:00:00Z");
    EXPECT_TRUE(refuses(file, "without a time zone"));
    writePermissions("2020-01-01T00:00:00", "2121-01-01T00:00:00", "ALLOW");
    EXPECT_TRUE(refuses(file, "DENY"));
}

TEST_F(SiteKeys, refuseASubjectInTheOrderOfTheCertificate) {
    // As `openssl x509 -noout -subject` writes it. DDS compares the order of RFC 2253.
    for (const char* subject :
         {"O=TeleTA site,CN=console1", "O = TeleTA site, CN = console1", "CN=console1, O=TeleTA site"}) {
        writePermissions("2026-01-01T00:00:00", "2126-01-01T00:00:00", "DENY", kConsoleRule, subject);
        EXPECT_TRUE(refuses("console1/permissions.p7s", "CN=console1,O=TeleTA site")) << subject;
    }
}

TEST_F(SiteKeys, refuseTopicsThatAreNotOfTheRole) {
    const std::string file = "console1/permissions.p7s";
    writeRules(kConsoleRule);
    EXPECT_TRUE(check().usable());
    const auto rules = [](const QString& publish, const QString& subscribe) {
        return QStringLiteral("<allow_rule><publish><topics>%1</topics></publish>"
                              "<subscribe><topics>%2</topics></subscribe></allow_rule>")
            .arg(publish, subscribe);
    };
    const QString all = QStringLiteral("<topic>rt/teleta/lab/*</topic>");
    const QString own = QStringLiteral("<topic>rt/teleta/lab/console/console1/*</topic>");
    // What the site publishes, what another console commands, and everything.
    writeRules(rules(all, all));
    EXPECT_TRUE(refuses(file, "console1 must not publish rt/teleta/lab/*."));
    writeRules(rules(own + "<topic>rt/teleta/lab/console/console2/*</topic>", all));
    EXPECT_TRUE(refuses(file, "console1 must not publish rt/teleta/lab/console/console2/*."));
    writeRules(rules(own + "<topic>*</topic>", all));
    EXPECT_TRUE(refuses(file, "console1 must not publish *."));
    writeRules(rules(own, all + "<topic>rt/joint_states</topic>"));
    EXPECT_TRUE(refuses(file, "console1 must not subscribe to rt/joint_states."));
    // In a second rule, too.
    writeRules(kConsoleRule + rules(all, {}));
    EXPECT_TRUE(refuses(file, "console1 must not publish rt/teleta/lab/*."));
    // Too little.
    writeRules(rules({}, all));
    EXPECT_TRUE(refuses(file, "console1 needs to publish rt/teleta/lab/console/console1/*."));
    writeRules(rules(own, {}));
    EXPECT_TRUE(refuses(file, "console1 needs to subscribe to rt/teleta/lab/*."));
    writeRules(rules("<topic>rt/teleta/lab/console/console1/presence</topic>", all));
    EXPECT_TRUE(refuses(file, "console1 needs to publish rt/teleta/lab/console/console1/clock_probe."));
    writeRules({});
    EXPECT_TRUE(refuses(file, "No topic of a site"));
    // Another site, and rules that turn others round.
    writeRules(QString::fromLatin1(kConsoleRule).replace("/lab/", "/shop/"));
    EXPECT_TRUE(refuses(file, "the site shop, those of other permissions to lab"));
    writeRules(kConsoleRule + QStringLiteral("<deny_rule/>"));
    EXPECT_TRUE(refuses(file, "deny_rule"));
}

TEST_F(SiteKeys, refuseWhatWasChangedAfterItWasSigned) {
    sh("sed -i 's/not_after>2/not_after>3/' console1/permissions.p7s; grep -q 'not_after>3' "
       "console1/permissions.p7s");
    EXPECT_TRUE(refuses("console1/permissions.p7s", "not signed by permissions_ca.pem"));
    sh("sed -i 's/SIGN/NONE/' governance.p7s");
    const KeyReport report = check();
    EXPECT_EQ(std::ranges::count_if(report.findings, [](const KeyFinding& one) { return one.refused; }), 2);
}

TEST_F(SiteKeys, refuseAnAuthorityWithoutItsKeyUsage) {
    const auto remake = [this](const std::string& extensions) {
        sh("openssl req -x509 -new -sha256 -key permissions_ca_key.pem -days 30 -subj "
           "'/O=TeleTA site/CN=permissions_ca' -addext 'basicConstraints=critical,CA:TRUE' " +
           extensions + " -out permissions_ca.pem");
    };
    for (const char* extensions : {"", "-addext keyUsage=critical,keyCertSign,cRLSign"}) {
        remake(extensions);
        const KeyReport report = check();
        EXPECT_TRUE(std::ranges::any_of(report.findings, [](const KeyFinding& one) {
            return one.refused && one.file == "permissions_ca.pem" &&
                   one.message.find("key usage") != std::string::npos;
        })) << extensions;
    }
    // A certificate of a member is no authority.
    sh("cp site/cert.pem permissions_ca.pem");
    EXPECT_FALSE(check().usable());
}

TEST_F(SiteKeys, areRenewedByTheSameCommands) {
    sh("cp identity_ca.pem before.pem; cp site/key.pem before_key.pem; rm site/cert.pem");
    SetUp();
    sh("cmp identity_ca.pem before.pem; cmp site/key.pem before_key.pem");
    EXPECT_TRUE(check().usable());
}

TEST_F(SiteKeys, refuseAWeakGovernance) {
    sh("sed -i 's/<rtps_protection_kind>SIGN/<rtps_protection_kind>NONE/' governance.xml\n"
       "openssl smime -sign -text -in governance.xml -out governance.p7s -signer permissions_ca.pem -inkey "
       "permissions_ca_key.pem");
    EXPECT_TRUE(refuses("governance.p7s", "rtps_protection_kind must be SIGN"));
    sh("rm governance.p7s");
    EXPECT_TRUE(refuses("governance.p7s", "missing"));
}

TEST_F(SiteKeys, refuseAFolderNamedOtherwise) {
    sh("mv console1 console2");
    const KeyReport report = check();
    EXPECT_TRUE(std::ranges::any_of(report.findings, [](const KeyFinding& one) {
        return one.refused && one.file == "console2/cert.pem" &&
               one.message.find("the folder is called console2") != std::string::npos;
    }));
}

TEST(SignedDocuments, areAcceptedAsTheMiddlewareTookThem) {
    // Documents with which Cyclone DDS 0.10.2 let a site, a console and a viewer talk.
    const auto read = [](const std::string& name) {
        QFile file(QStringLiteral(TELETA_SOURCE_DIR "/tests/data/site_keys/%1.xml").arg(name.c_str()));
        EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << name;
        return file.readAll().toStdString();
    };
    EXPECT_TRUE(checkGovernance(read("governance")).empty());
    for (const auto& [name, role] : {std::pair{"site", MemberRole::site},
                                     {"console1", MemberRole::console},
                                     {"viewer1", MemberRole::viewer}}) {
        const std::string subject = std::string("CN=") + name + ",O=TeleTA site";
        const PermissionsCheck permissions =
            checkPermissions(read(std::string("permissions_") + name), name, subject, 1'800'000'000);
        EXPECT_TRUE(permissions.problems.empty()) << permissions.problems.front();
        EXPECT_EQ(permissions.role, role);
        EXPECT_EQ(permissions.site, "lab");
        EXPECT_EQ(permissions.ends_unixS, 1'830'297'600); // date -u -d 2028-01-01 +%s
    }
}

TEST(SiteKeysOfNothing, areAnError) {
    EXPECT_FALSE(checkKeys("/no/such/folder", 0));
    const QTemporaryDir empty;
    const auto report = checkKeys(empty.path().toStdString(), 0);
    ASSERT_TRUE(report);
    EXPECT_FALSE(report->usable());
}

/// A folder above that is closed to this user is the usual case, which a test as root has not: a path that
/// runs in a circle is as little known to exist or not.
TEST(SiteKeysOfNothing, areNotSaidToBeMissingWhereNobodyKnows) {
    const QTemporaryDir folder;
    const QString circle = folder.filePath("circle");
    ASSERT_TRUE(QFile::link(circle, circle));
    const auto report = checkMember((circle + "/site").toStdString(), 0);
    ASSERT_FALSE(report);
    EXPECT_EQ(report.error().kind, teleta::core::ErrorKind::ioFailed);
    EXPECT_EQ(report.error().message, "The folder " + circle.toStdString() + "/site cannot be read.");
}

TEST(SiteKeysOfNothing, haveNoCommandsForNamesThatAShellWouldRead) {
    for (const char* name : {"", "Site", "a b", "a;b", "$(a)", "a\n", "1a"}) {
        EXPECT_FALSE(commandsFor({"keys", "lab", {name}, {}}, 0)) << name;
        EXPECT_FALSE(commandsFor({"keys", "lab", {}, {name}}, 0)) << name;
        EXPECT_FALSE(commandsFor({"keys", name, {}, {}}, 0)) << name;
    }
    EXPECT_FALSE(commandsFor({"keys", "lab", {"site"}, {}}, 0));
    EXPECT_FALSE(commandsFor({"keys", "lab", {"one"}, {"one"}}, 0));
    const auto quoted = commandsFor({"it's $HOME", "lab", {}, {}}, 0);
    ASSERT_TRUE(quoted);
    EXPECT_NE(quoted->find("cd -- 'it'\\''s $HOME'\n"), std::string::npos) << *quoted;
}
