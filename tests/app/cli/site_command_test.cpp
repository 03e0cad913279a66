// SPDX-License-Identifier: GPL-3.0-or-later
// The openssl program makes the keys, by the commands that teleta prints.
#include "tests/app/cli/program_run.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <string>

using teleta::test::ProgramResult;
using teleta::test::readAll;
using teleta::test::run;
using teleta::test::TemporaryFolder;

namespace {

class SiteCommand : public ::testing::Test {
protected:
    void SetUp() override {
        const ProgramResult made =
            run({"site", "keys", m_keys, "--make", "lab", "--console", "console1", "--viewer", "viewer1"});
        ASSERT_EQ(made.exitCode, 0) << made.err;
        sh("sh '" + m_folder.write("make_keys.sh", made.out) + "'");
    }
    void sh(const std::string& commands) const {
        const std::string line = "set -e; { mkdir -p \"" + m_keys + "\"; cd \"" + m_keys + "\"; " + commands +
                                 "; } >'" + m_log + "' 2>&1";
        ASSERT_EQ(std::system(line.c_str()), 0) << line << '\n' << readAll(m_log);
    }
    [[nodiscard]] ProgramResult check() const { return run({"site", "keys", m_keys}); }

    TemporaryFolder m_folder;
    std::string m_keys = m_folder.path("keys of 'lab'");
    std::string m_log = m_folder.path("log");
};

} // namespace

TEST_F(SiteCommand, acceptsTheKeysThatItsCommandsMake) {
    const ProgramResult result = check();
    EXPECT_EQ(result.exitCode, 0) << result.out << result.err;
    EXPECT_NE(result.out.find("console1 (console): CN=console1,O=TeleTA site, until 20"), std::string::npos);
    EXPECT_NE(result.out.find("site (site): CN=site,O=TeleTA site, until 20"), std::string::npos);
    EXPECT_NE(result.out.find("viewer1 (viewer): "), std::string::npos) << result.out;
    EXPECT_EQ(result.out.find("Refused"), std::string::npos) << result.out;
}

TEST_F(SiteCommand, writesTheSameAsJson) {
    const nlohmann::json good = nlohmann::json::parse(run({"site", "keys", m_keys, "--json"}).out);
    EXPECT_EQ(good["usable"], true);
    EXPECT_EQ(good["site"], "lab");
    ASSERT_EQ(good["members"].size(), 3U);
    EXPECT_EQ(good["members"][2]["name"], "viewer1");
    EXPECT_EQ(good["members"][2]["role"], "viewer");
    EXPECT_EQ(good["members"][2]["subject"], "CN=viewer1,O=TeleTA site");
    EXPECT_TRUE(good["findings"].empty());

    sh("rm viewer1/cert.pem; chmod 640 site/key.pem");
    const ProgramResult bad = run({"site", "keys", m_keys, "--json"});
    EXPECT_EQ(bad.exitCode, 1);
    const nlohmann::json document = nlohmann::json::parse(bad.out);
    EXPECT_EQ(document["usable"], false);
    EXPECT_TRUE(document["members"][2]["ends"].is_null());
    EXPECT_TRUE(document["members"][2]["role"].is_null());
    ASSERT_EQ(document["findings"].size(), 2U) << bad.out;
    EXPECT_EQ(document["findings"][0]["file"], "site/key.pem");
    EXPECT_EQ(document["findings"][1]["file"], "viewer1/cert.pem");
    EXPECT_EQ(document["findings"][1]["refused"], true);
}

TEST_F(SiteCommand, refusesWhatMakesASiteUnsafe) {
    const struct {
        const char* commands;
        const char* says;
    } cases[] = {
        {"chmod 644 console1/key.pem",
         "Refused: console1/key.pem: Others can read or write this private key"},
        {"openssl x509 -req -in site/req.pem -CA identity_ca.pem -CAkey identity_ca_key.pem -CAcreateserial "
         "-days 0 -out site/cert.pem",
         "Refused: site/cert.pem: The certificate has expired."},
        {"openssl x509 -req -in site/req.pem -CA permissions_ca.pem -CAkey permissions_ca_key.pem "
         "-CAcreateserial -days 90 -out site/cert.pem",
         "Refused: site/cert.pem: It verifies against permissions_ca.pem"},
        {"cp permissions_ca.pem identity_ca.pem; cp permissions_ca_key.pem identity_ca_key.pem",
         "Refused: permissions_ca.pem: Both authorities share one key."},
        {"sed -i s/DENY/ALLOW/ console1/permissions.p7s",
         "Refused: console1/permissions.p7s: It is not signed"},
        {"rm -r console1 site viewer1", "Refused: There is no folder for a site, a console or a viewer."},
    };
    sh("cp -a . ../good");
    for (const auto& [commands, says] : cases) {
        sh("rm -r ./*; cp -a ../good/. .");
        sh(commands);
        const ProgramResult result = check();
        EXPECT_EQ(result.exitCode, 1) << commands;
        EXPECT_NE(result.out.find(says), std::string::npos) << commands << '\n' << result.out;
        EXPECT_NE(result.err.find("not safe"), std::string::npos) << result.err;
    }
}

TEST_F(SiteCommand, refusesFoldersAndNamesThatItCannotUse) {
    EXPECT_EQ(run({"site", "keys", m_folder.path("nothing")}).exitCode, 3);
    EXPECT_EQ(run({"site", "keys", m_keys, "--make", "La b"}).exitCode, 3);
    EXPECT_EQ(run({"site", "keys", m_keys, "--console", "console1"}).exitCode, 2);
    EXPECT_EQ(run({"site", "keys"}).exitCode, 2);
}
