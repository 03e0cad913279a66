// SPDX-License-Identifier: GPL-3.0-or-later
// Who may take part in a site, between processes over the loopback interface. Keys are made with the openssl
// program, by the commands that people are told.
#include "backend/site_keys/site_keys.h"
#include "devices/dds/endpoint.h"
#include "devices/dds/participant.h"
#include "tests/support/peer_process.h"

#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <algorithm>
#include <ctime>
#include <memory>

using namespace teleta;
using teleta::test::PeerProcess;

namespace {

const QString kOurs = QStringLiteral(TELETA_SITE_MEMBER);
const QString kRaw = QStringLiteral(TELETA_RAW_MEMBER);
constexpr int kDomain = 90;
constexpr const char* kCommand = "rt/teleta/lab/console/console1/command";
constexpr const char* kState = "rt/teleta/lab/state";

/// The viewer of a folder makes permissions of its own, which let it command, and signs them and a governance
/// with its own key. Its own program is to believe that, so there the authority of identities takes the place
/// of that of permissions.
constexpr const char* kAttack = R"(
cp identity_ca.pem permissions_ca.pem
sed 's,<publish>.*</publish>,<publish><topics><topic>*</topic></topics></publish>,' permissions_viewer1.xml > own.xml
openssl smime -sign -text -in own.xml -out viewer1/permissions.p7s -signer viewer1/cert.pem -inkey viewer1/key.pem
openssl smime -sign -text -in governance.xml -out governance.p7s -signer viewer1/cert.pem -inkey viewer1/key.pem
)";

class SiteSecurity : public ::testing::Test {
protected:
    static void SetUpTestSuite() {
        m_folder = std::make_unique<QTemporaryDir>();
        makeKeys("lab");
    }
    static void TearDownTestSuite() { m_folder.reset(); }

    static void sh(const QString& folder, const std::string& commands) {
        QProcess shell;
        shell.setWorkingDirectory(m_folder->filePath(folder));
        shell.setProcessChannelMode(QProcess::MergedChannels);
        shell.start("/bin/sh", {"-ec", QString::fromStdString(commands)});
        ASSERT_TRUE(shell.waitForFinished(60'000));
        ASSERT_EQ(shell.exitCode(), 0) << shell.readAll().toStdString();
    }
    /// Two authorities, and the keys of a site, a console and a viewer of the site "lab".
    static void makeKeys(const QString& folder) {
        const auto commands = site_keys::commandsFor({.folder = m_folder->filePath(folder).toStdString(),
                                                      .site = "lab",
                                                      .consoles = {"console1"},
                                                      .viewers = {"viewer1"}},
                                                     std::time(nullptr));
        ASSERT_TRUE(commands);
        sh({}, *commands);
    }
    /// A copy of the keys that these commands change.
    static void copyKeys(const QString& from, const QString& to, const std::string& commands) {
        sh({}, "cp -r " + from.toStdString() + ' ' + to.toStdString());
        sh(to, commands);
    }

    /// "lab/console1": the folder of its keys; "none" stays.
    static QString keys(const QString& member) {
        return member == "none" ? member : m_folder->filePath(member);
    }
    static std::string receivedFrom(const QString& member) {
        return "received " + keys(member).toStdString();
    }

    /// Whether this program came so far that it may send or take.
    static ::testing::AssertionResult starts(PeerProcess& member, const QString& program, const QString& with,
                                             const QString& what, const char* ddsTopic, int seconds = 60) {
        member.start(program,
                     {QString::number(kDomain), keys(with), what, ddsTopic, QString::number(seconds)}, true);
        if (member.waitFor("started"))
            return ::testing::AssertionSuccess();
        return ::testing::AssertionFailure() << ::testing::PrintToString(member.takeLines());
    }
    /// The line with which a program says why it does not take part.
    static std::string errorOf(const QString& program, const QString& with, const QString& what,
                               const char* ddsTopic) {
        PeerProcess member;
        member.start(program, {QString::number(kDomain), keys(with), what, ddsTopic}, true);
        return member.waitFor("error ").value_or("no error");
    }
    /// Ends a program; whether one of all its lines holds this text.
    static bool said(PeerProcess& member, const std::string& text) {
        member.kill();
        // Reads what is left.
        (void)member.waitFor("\n");
        const std::vector<std::string> lines = member.takeLines();
        return std::ranges::any_of(
            lines, [&](const std::string& line) { return line.find(text) != std::string::npos; });
    }

    static std::unique_ptr<QTemporaryDir> m_folder;
};

std::unique_ptr<QTemporaryDir> SiteSecurity::m_folder;

TEST_F(SiteSecurity, letsAnHonestConsoleReachTheSite) {
    PeerProcess site;
    PeerProcess console;
    ASSERT_TRUE(starts(site, kOurs, "lab/site", "subscribe", kCommand));
    ASSERT_TRUE(starts(console, kOurs, "lab/console1", "publish", kCommand));
    EXPECT_TRUE(console.waitFor("matched 1"));
    EXPECT_TRUE(site.waitFor(receivedFrom("lab/console1")));
}

TEST_F(SiteSecurity, keepsProgramsWithoutKeysOut) {
    constexpr int kSpecified_s = 6;
    PeerProcess site;
    PeerProcess console;
    PeerProcess viewer;
    PeerProcess reader;
    PeerProcess writer;
    ASSERT_TRUE(starts(site, kOurs, "lab/site", "publish", kState));
    ASSERT_TRUE(starts(console, kOurs, "lab/console1", "subscribe", kState));
    ASSERT_TRUE(starts(viewer, kOurs, "lab/viewer1", "subscribe", kCommand));
    ASSERT_TRUE(starts(reader, kOurs, "none", "subscribe", kState, kSpecified_s));
    ASSERT_TRUE(starts(writer, kRaw, "none", "publish", kCommand, kSpecified_s));
    EXPECT_TRUE(reader.waitFor("end"));
    EXPECT_TRUE(writer.waitFor("end"));
    EXPECT_FALSE(said(reader, "matched"));
    EXPECT_FALSE(said(writer, "matched"));
    EXPECT_FALSE(said(viewer, "matched"));
    EXPECT_TRUE(console.waitFor(receivedFrom("lab/site")));
}

TEST_F(SiteSecurity, refusesTheSameNamesOfAnotherAuthority) {
    makeKeys("other");
    PeerProcess site;
    PeerProcess stranger;
    PeerProcess console;
    ASSERT_TRUE(starts(site, kOurs, "lab/site", "subscribe", kCommand));
    ASSERT_TRUE(starts(stranger, kOurs, "other/console1", "publish", kCommand));
    const auto refused = stranger.waitFor("refused ");
    ASSERT_TRUE(refused);
    EXPECT_NE(refused->find("not signed by identity_ca.pem (/O=TeleTA site/CN=site)"), std::string::npos)
        << *refused;
    ASSERT_TRUE(starts(console, kOurs, "lab/console1", "publish", kCommand));
    EXPECT_TRUE(site.waitFor(receivedFrom("lab/console1")));
    EXPECT_FALSE(said(stranger, "matched"));
    EXPECT_FALSE(said(site, receivedFrom("other/console1")));
}

TEST_F(SiteSecurity, refusesACertificateWithAnotherKey) {
    copyKeys("lab", "stolen", "cp viewer1/key.pem console1/key.pem");
    PeerProcess site;
    PeerProcess thief;
    ASSERT_TRUE(starts(site, kOurs, "lab/site", "subscribe", kCommand));
    ASSERT_TRUE(starts(thief, kRaw, "stolen/console1", "publish", kCommand));
    const auto refused = site.waitFor("refused ");
    ASSERT_TRUE(refused);
    EXPECT_NE(refused->find("the key does not belong to the certificate"), std::string::npos) << *refused;
    EXPECT_FALSE(said(thief, "matched"));
}

TEST_F(SiteSecurity, allowsTheTopicsOfTheRoleOnly) {
    const struct {
        const char* member;
        const char* what;
        const char* ddsTopic;
        bool allowed;
    } cases[] = {
        {"lab/viewer1", "publish", kCommand, false},
        {"lab/viewer1", "publish", "rt/teleta/lab/console/viewer1/command", false},
        {"lab/viewer1", "publish", "rt/teleta/lab/console/viewer1/presence", true},
        {"lab/viewer1", "subscribe", kState, true},
        {"lab/console1", "publish", "rt/teleta/lab/console/console2/command", false},
        {"lab/console1", "publish", kState, false},
        {"lab/console1", "subscribe", "rt/joint_states", false},
        {"lab/console1", "publish", kCommand, true},
        {"lab/site", "subscribe", kState, false},
        {"lab/site", "publish", kState, true},
    };
    for (const auto& [member, what, ddsTopic, allowed] : cases) {
        PeerProcess process;
        if (allowed) {
            EXPECT_TRUE(starts(process, kOurs, member, what, ddsTopic));
            continue;
        }
        const std::string expected = std::string("error the permissions do not allow ") +
                                     (std::string(what) == "publish" ? "writing" : "reading") + " topic " +
                                     ddsTopic;
        EXPECT_EQ(errorOf(kOurs, member, what, ddsTopic), expected) << member;
    }
}

TEST_F(SiteSecurity, namesTheFileThatDoesNotFit) {
    const struct {
        const char* commands;
        const char* file;
        const char* reason;
    } cases[] = {
        {"sed -i 's/<not_after>2/<not_after>1/;s/<not_before>2/<not_before>1/' permissions_console1.xml\n"
         "openssl smime -sign -text -in permissions_console1.xml -out console1/permissions.p7s "
         "-signer permissions_ca.pem -inkey permissions_ca_key.pem",
         "console1/permissions.p7s", "expired"},
        {"cp viewer1/permissions.p7s console1/", "console1/permissions.p7s", "CN=console1,O=TeleTA site"},
        {"openssl smime -sign -text -in permissions_console1.xml -out console1/permissions.p7s "
         "-signer console1/cert.pem -inkey console1/key.pem",
         "console1/permissions.p7s", "not signed by permissions_ca.pem"},
        {"rm console1/permissions.p7s", "console1/permissions.p7s", "missing"},
        {"cp viewer1/key.pem console1/key.pem", "console1/key.pem", "does not belong"},
        {"rm console1/key.pem", "console1/key.pem", "missing"},
        {"openssl x509 -req -sha256 -in console1/req.pem -CA permissions_ca.pem -CAkey "
         "permissions_ca_key.pem "
         "-CAcreateserial -days 90 -out console1/cert.pem",
         "console1/cert.pem", "not signed by identity_ca.pem"},
        {"rm governance.p7s", "governance.p7s", "missing"},
    };
    int number = 0;
    for (const auto& [commands, file, reason] : cases) {
        const QString folder = QStringLiteral("wrong%1").arg(++number);
        copyKeys("lab", folder, commands);
        // It has no participant and does not even open the domain.
        const auto participant =
            dds::Participant::open({.domain = kDomain, .interface = "none", .peers = {}}, {},
                                   dds::Security{keys(folder + "/console1").toStdString()});
        ASSERT_FALSE(participant) << commands;
        EXPECT_EQ(participant.error().kind, core::ErrorKind::refused);
        EXPECT_EQ(participant.error().where.file, m_folder->filePath(folder + '/' + file).toStdString());
        EXPECT_NE(participant.error().message.find(reason), std::string::npos) << participant.error().message;
    }
    // Expired permissions: not by the middleware alone either.
    EXPECT_EQ(errorOf(kRaw, "wrong1/console1", "publish", kCommand).find("error no participant"), 0U);
}

TEST_F(SiteSecurity, asksForPermissionsOfTheDomain) {
    copyKeys("lab", "elsewhere",
             "sed -i 's/<min>0</<min>71</;s/<max>230</<max>71</' permissions_console1.xml\n"
             "openssl smime -sign -text -in permissions_console1.xml -out console1/permissions.p7s "
             "-signer permissions_ca.pem -inkey permissions_ca_key.pem");
    const std::string error = errorOf(kOurs, "elsewhere/console1", "publish", kCommand);
    EXPECT_NE(error.find("permissions.p7s) do not allow this domain"), std::string::npos) << error;
}

// Why there are two authorities: the middleware believes a signer whose certificate lies in the document and
// is signed by the authority of permissions. With one authority for both, that is each member.
TEST_F(SiteSecurity, wouldObeyAnyMemberWithOneAuthority) {
    copyKeys("lab", "one", R"(
cp permissions_ca.pem identity_ca.pem
cp permissions_ca_key.pem identity_ca_key.pem
for n in site console1 viewer1; do
    openssl x509 -req -sha256 -in $n/req.pem -CA permissions_ca.pem -CAkey permissions_ca_key.pem -CAcreateserial \
        -days 90 -out $n/cert.pem
done
)");
    copyKeys("one", "one_attack", kAttack);
    PeerProcess site;
    PeerProcess attacker;
    ASSERT_TRUE(starts(site, kRaw, "one/site", "subscribe", kCommand));
    ASSERT_TRUE(starts(attacker, kRaw, "one_attack/viewer1", "publish", kCommand));
    EXPECT_TRUE(site.waitFor(receivedFrom("one_attack/viewer1")));
    // So our own programs do not start with such keys.
    const std::string error = errorOf(kOurs, "one/site", "subscribe", kCommand);
    EXPECT_NE(error.find("permissions_ca.pem: Both authorities share one key"), std::string::npos) << error;
}

TEST_F(SiteSecurity, refusesPermissionsThatAMemberSigned) {
    constexpr int kMessagesAfter = 20;
    copyKeys("lab", "attack", kAttack);
    PeerProcess site;
    PeerProcess console;
    PeerProcess attacker;
    ASSERT_TRUE(starts(site, kOurs, "lab/site", "subscribe", kCommand));
    ASSERT_TRUE(starts(console, kOurs, "lab/console1", "publish", kCommand));
    ASSERT_TRUE(site.waitFor(receivedFrom("lab/console1")));
    ASSERT_TRUE(starts(attacker, kRaw, "attack/viewer1", "publish", kCommand));
    const auto refused = site.waitFor("refused ");
    ASSERT_TRUE(refused);
    EXPECT_NE(refused->find("the permissions are not signed by permissions_ca.pem"), std::string::npos)
        << *refused;
    for (int i = 0; i < kMessagesAfter; ++i)
        ASSERT_TRUE(site.waitFor(receivedFrom("lab/console1")));
    EXPECT_FALSE(said(attacker, "matched"));
    EXPECT_FALSE(said(site, receivedFrom("attack/viewer1")));
}

TEST_F(SiteSecurity, isOncePerProgramAndDomain) {
    const dds::DomainConfig config{.domain = kDomain, .interface = "lo", .peers = {}};
    const dds::Security console{keys("lab/console1").toStdString()};
    const dds::Security viewer{keys("lab/viewer1").toStdString()};
    auto first = dds::Participant::open(config, {}, console);
    ASSERT_TRUE(first) << core::describe(first.error());
    EXPECT_TRUE(dds::Writer<ros::String>::open(*first, kCommand, ros::kCommandWriter));
    for (const dds::Security& security : {console, viewer}) {
        const auto second = dds::Participant::open(config, {}, security);
        ASSERT_FALSE(second);
        EXPECT_EQ(second.error().kind, core::ErrorKind::refused);
        EXPECT_NE(second.error().message.find("domain 90"), std::string::npos) << second.error().message;
    }
    // What it was allowed stays for the program.
    first->reset();
    const auto other = dds::Participant::open(config, {}, viewer);
    ASSERT_FALSE(other);
    EXPECT_EQ(other.error().kind, core::ErrorKind::refused);
    EXPECT_NE(other.error().message.find("other permissions before"), std::string::npos)
        << other.error().message;
    const auto again = dds::Participant::open(config, {}, console);
    ASSERT_TRUE(again) << core::describe(again.error());
    EXPECT_TRUE(dds::Writer<ros::String>::open(*again, kCommand, ros::kCommandWriter));
    EXPECT_FALSE(dds::Writer<ros::String>::open(*again, kState, ros::kCommandWriter));
}

} // namespace
