// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/bracelet/hid_bracelet_file.h"
#include "devices/described/described_bracelet.h"
#include "tests/backend/core/temporary_folder.h"

#include <gtest/gtest.h>

namespace teleta::bracelet {
namespace {

class HidBraceletFileTest : public testing::Test {
protected:
    core::Error errorOf(const std::string& text) {
        const auto read = readHidBracelet(m_folder.write("own.toml", text));
        EXPECT_FALSE(read) << text;
        return read ? core::Error{} : read.error();
    }
    test::TemporaryFolder m_folder;
};

constexpr const char* kOwn =
    "kind = \"hid_bracelet\"\nname = \"Ours\"\nvendor_id = 0xCAFE\nproduct_id = 66\n";

} // namespace

TEST_F(HidBraceletFileTest, theFileThatComesWithTheProgramNamesTheIdsOfAProgramWithoutAFile) {
    const auto read = readHidBracelet(TELETA_SOURCE_DIR "/resources/devices/usb-bracelet.toml");
    ASSERT_TRUE(read) << core::describe(read.error());
    EXPECT_EQ(read->config.vendorId, HidBraceletConfig{}.vendorId);
    EXPECT_EQ(read->config.productId, HidBraceletConfig{}.productId);
    EXPECT_EQ(read->config.serial, "");
}

TEST_F(HidBraceletFileTest, readsIdsAndSerial) {
    const auto read = readHidBracelet(m_folder.write("own.toml", std::string(kOwn) + "serial = \"B7\"\n"));
    ASSERT_TRUE(read) << core::describe(read.error());
    EXPECT_EQ(read->name, "Ours");
    EXPECT_EQ(read->config.vendorId, 0xCAFE);
    EXPECT_EQ(read->config.productId, 66);
    EXPECT_EQ(read->config.serial, "B7");
}

TEST_F(HidBraceletFileTest, saysWhereAFileIsWrong) {
    EXPECT_EQ(readHidBracelet(m_folder.path("none.toml")).error().kind, core::ErrorKind::notFound);
    const std::string head = "kind = \"hid_bracelet\"\nname = \"Ours\"\n";
    EXPECT_EQ(errorOf(head + "vendor_id = 0x10000\nproduct_id = 1\n").where.line, 3);
    EXPECT_EQ(errorOf(head + "vendor_id = 0\nproduct_id = 1\n").where.line, 3);
    EXPECT_NE(core::describe(errorOf(head + "vendor_id = 1\n")).find("product_id"), std::string::npos);
    EXPECT_NE(core::describe(errorOf(std::string(kOwn) + "serail = \"B7\"\n")).find("serail"),
              std::string::npos);
    EXPECT_EQ(errorOf(std::string(kOwn) + "serial = \"\"\n").where.line, 5);
}

TEST_F(HidBraceletFileTest, aDeviceFileIsOpenedByItsKind) {
    const core::StopSwitch stop;
    const auto refused = [&](const std::string& text) {
        const auto opened = described::openBracelet(m_folder.write("device.toml", text), stop);
        EXPECT_FALSE(opened) << text;
        return opened ? core::Error{} : opened.error();
    };
    // A board of these ids is plugged in nowhere.
    const core::Error missing = refused(kOwn);
    EXPECT_EQ(missing.kind, core::ErrorKind::unavailable);
    EXPECT_NE(missing.expected.find("cafe:0042"), std::string::npos) << missing.expected;
    EXPECT_EQ(refused("kind = \"hid_bracelet\"\nname = \"Ours\"\n").kind, core::ErrorKind::badInput);
    EXPECT_EQ(refused("kind = \"camera\"\n").where.line, 1);
    // Without motors it is no bracelet.
    EXPECT_NE(core::describe(refused("kind = \"modbus\"\nname = \"Arm\"\n[link]\nkind = \"tcp\"\n"
                                     "host = \"127.0.0.1\"\nunit = 1\n"))
                  .find("device.toml"),
              std::string::npos);
    EXPECT_EQ(described::openBracelet(m_folder.path("none.toml"), stop).error().kind,
              core::ErrorKind::notFound);
}

} // namespace teleta::bracelet
