// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/dds/security.h"

#include <gtest/gtest.h>

#include <map>

namespace teleta::dds {
namespace {

TEST(DdsSecurity, namesTheFilesOfAMember) {
    for (const char* folder : {"/keys/console1", "/keys/console1/", "/keys/site/../console1/."}) {
        std::map<std::string, std::string> properties;
        for (const auto& [name, value] : propertiesOf({folder}))
            properties[name] = value;
        EXPECT_EQ(properties.size(), 15U);
        EXPECT_EQ(properties["dds.sec.auth.identity_ca"], "file:/keys/identity_ca.pem") << folder;
        EXPECT_EQ(properties["dds.sec.auth.private_key"], "file:/keys/console1/key.pem") << folder;
        EXPECT_EQ(properties["dds.sec.access.governance"], "file:/keys/governance.p7s");
        EXPECT_EQ(properties["dds.sec.access.permissions"], "file:/keys/console1/permissions.p7s");
        EXPECT_EQ(properties["dds.sec.access.library.path"], "dds_security_ac");
        EXPECT_EQ(properties["dds.sec.access.library.init"], "init_access_control");
        EXPECT_EQ(properties["dds.sec.auth.library.finalize"], "finalize_authentication");
    }
}

// Lines of Cyclone DDS 0.10.2.
TEST(DdsSecurity, tellsReasonsInPlainWords) {
    const auto reason = [](const char* line) { return securityReason(line).toStdString(); };
    EXPECT_EQ(
        reason("Begin handshake reply failed: Certificate not valid: error: certificate signature failure; "
               "subject: /O=TeleTA site/CN=site(code: 200)"),
        "the certificate is not signed by identity_ca.pem (/O=TeleTA site/CN=site)");
    EXPECT_EQ(
        reason("Error occurred while validating local permission: Certificate not valid: error: certificate "
               "has expired; subject: /O=TeleTA site/CN=console1(code: 200)"),
        "the certificate has expired (/O=TeleTA site/CN=console1)");
    EXPECT_EQ(reason("Process handshake failed: Failed to finalize digest context: (code: 200)"),
              "the key does not belong to the certificate");
    EXPECT_EQ(
        reason("Could not get remote participant f88d02d4:625d367b:a3394864:1c1 permissions from plugin: "
               "Failed to parse PKCS7 SMIME document: C0761F433C7F0000:error:10800075:PKCS7 "
               "routines:PKCS7_verify:certificate verify error:../crypto/pkcs7/pk7_smime.c:291:Verify "
               "error: unable to get local issuer certificate\n(code: 127)"),
        "the permissions are not signed by permissions_ca.pem");
    EXPECT_EQ(reason("Error occurred while validating local permissions: Subject name is invalid(code: 146)"),
              "the permissions do not name the subject of the certificate");
    EXPECT_EQ(
        reason("Error occurred while validating local permissions: Permissions validity period expired for "
               "CN=console1,O=TeleTA site (expired: 2026-01-01T00:00:00)(code: 147)"),
        "the permissions have expired");
    EXPECT_EQ(
        reason("It is not allowed to create participant: participant denied by default rule(code: 145)"),
        "the permissions (permissions.p7s) do not allow this domain");
    // Others as they are: this one names its file.
    const char* other =
        "load_file_into_BIO: File could not be found, opened or is empty, path: /a/key.pem(code: 117)";
    EXPECT_EQ(reason(other), other);
}

} // namespace
} // namespace teleta::dds
