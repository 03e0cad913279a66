// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/device/node_claim.h"
#include "devices/bracelet/bracelet_reports.h"
#include "devices/bracelet/hid_bracelet.h"
#include "devices/bracelet/hid_bracelet_port.h"
#include "tests/backend/core/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <vector>

using namespace teleta::bracelet;
using teleta::core::BoardReport;
using teleta::core::BraceletPort;

namespace {

using Bytes = std::vector<std::uint8_t>;

struct Script {
    Bytes feature{};
    std::deque<Bytes> inputs{};
    std::vector<Bytes> outputs{};
    bool gone = false;
};

class ScriptedTransport : public teleta::hid::HidDevice {
public:
    explicit ScriptedTransport(Script& script)
        : m_script(script) {}
    bool write(std::span<const std::uint8_t> report) override {
        m_script.outputs.emplace_back(report.begin(), report.end());
        return !m_script.gone;
    }
    int read(std::span<std::uint8_t> report, int /*timeout_ms*/) override {
        if (m_script.gone)
            return -1;
        if (m_script.inputs.empty())
            return 0;
        const Bytes bytes = m_script.inputs.front();
        m_script.inputs.pop_front();
        return copy(bytes, report);
    }
    int getFeature(std::span<std::uint8_t> report) override {
        if (m_script.gone || report[0] != 3)
            return -1;
        return copy(m_script.feature, report);
    }

private:
    static int copy(const Bytes& bytes, std::span<std::uint8_t> to) {
        const std::size_t size = std::min(bytes.size(), to.size());
        std::copy_n(bytes.begin(), size, to.begin());
        return static_cast<int>(size);
    }
    Script& m_script;
};

/// Model 7, firmware 1.2, serial "A1", 4095, 200 Hz, 1000 ms.
Bytes identity() {
    return {0x03, 0x01, 0x07, 0x00, 0x01, 0x02, 'A', '1', 0,    0,    0,    0,    0,    0,   0,
            0,    0,    0,    0,    0,    0,    0,   6,   0xFF, 0x0F, 0xC8, 0x00, 0xE8, 0x03};
}

} // namespace

TEST(HidBraceletPort, asksTheBoardWhoItIs) {
    Script script{.feature = identity()};
    const auto opened = openHidBraceletPort(std::make_unique<ScriptedTransport>(script));
    ASSERT_TRUE(opened) << describe(opened.error());
    EXPECT_EQ(opened->description.serial, "A1");
    EXPECT_EQ(opened->description.model, "7");
    EXPECT_EQ(opened->description.firmware, "1.2");
    EXPECT_EQ(opened->description.maximumRate_Hz, 200.0);
    EXPECT_EQ(opened->description.highestDrive, 4095);
    EXPECT_EQ(opened->description.longestTimeout_ms, 1000);
    EXPECT_FALSE(opened->description.simulated);
    EXPECT_NE(opened->description.name.find("A1"), std::string::npos);
}

TEST(HidBraceletPort, refusesADeviceThatAnswersOtherwise) {
    Script silent;
    EXPECT_FALSE(openHidBraceletPort(std::make_unique<ScriptedTransport>(silent)));
    Script gone{.feature = identity(), .gone = true};
    EXPECT_FALSE(openHidBraceletPort(std::make_unique<ScriptedTransport>(gone)));
    Script newer{.feature = identity()};
    newer.feature[1] = 9;
    const auto opened = openHidBraceletPort(std::make_unique<ScriptedTransport>(newer));
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.error().kind, teleta::core::ErrorKind::unavailable);
    EXPECT_FALSE(opened.error().expected.empty());
}

TEST(HidBraceletPort, writesAFrameAsOneReport) {
    Script script;
    HidBraceletPort port(std::make_unique<ScriptedTransport>(script));
    EXPECT_TRUE(port.write(7, {0x001, 0x002, 0xFFF, 0x800, 0xABC, 0x123}, 100));
    ASSERT_EQ(script.outputs.size(), 1U);
    EXPECT_EQ(script.outputs[0],
              (Bytes{0x01, 0x07, 0x00, 0x01, 0x20, 0x00, 0xFF, 0x0F, 0x80, 0xBC, 0x3A, 0x12, 0x64, 0x00}));
    script.gone = true;
    EXPECT_FALSE(port.write(8, {}, 100));
}

TEST(HidBraceletPort, tellsReportsFromNothingDamageAndLoss) {
    Script script;
    script.inputs = {{0x02, 0x07, 0x00, 0x01, 0x88, 0x13, 0xFA, 0x00}, {0x02, 0x07}, Bytes(64, 0x55)};
    HidBraceletPort port(std::make_unique<ScriptedTransport>(script));
    BoardReport report;
    EXPECT_EQ(port.read(report), BraceletPort::Read::report);
    EXPECT_EQ(report.sequence, 7);
    EXPECT_EQ(port.read(report), BraceletPort::Read::damaged);
    EXPECT_EQ(port.read(report), BraceletPort::Read::damaged);
    EXPECT_EQ(report.sequence, 7);
    EXPECT_EQ(port.read(report), BraceletPort::Read::nothing);
    script.gone = true;
    EXPECT_EQ(port.read(report), BraceletPort::Read::lost);
}

// hidapi itself, on a machine that has no such device.
TEST(HidBracelet, saysWhatIsMissingWhenNoneIsPluggedIn) {
    const teleta::core::StopSwitch stop;
    const HidBraceletConfig config{.vendorId = 0xFFFE, .productId = 0xFFFD, .serial = "A1"};
    EXPECT_TRUE(listHidBracelets(config).empty());
    const auto bracelet = openHidBracelet(config, stop);
    ASSERT_FALSE(bracelet);
    EXPECT_EQ(bracelet.error().kind, teleta::core::ErrorKind::unavailable);
    EXPECT_NE(bracelet.error().expected.find("fffe:fffd"), std::string::npos);
    EXPECT_NE(bracelet.error().expected.find("A1"), std::string::npos);
}

TEST(HidBracelet, saysThatADeviceCannotBeOpened) {
    const auto missing = openBraceletNode("/dev/hidraw-that-is-not-there");
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().kind, teleta::core::ErrorKind::unavailable);
    EXPECT_NE(missing.error().message.find("/dev/hidraw-that-is-not-there"), std::string::npos);
}

TEST(HidBracelet, ofAnotherProgramIsNotOpenedAndSaysSo) {
    const teleta::test::TemporaryFolder folder;
    const std::string node = folder.write("hidraw", "");
    const auto other = teleta::core::NodeClaim::take(node);
    ASSERT_TRUE(other && *other);
    const auto taken = openBraceletNode(node);
    ASSERT_FALSE(taken);
    EXPECT_EQ(taken.error().kind, teleta::core::ErrorKind::unavailable);
    EXPECT_NE(taken.error().message.find("Another program uses the bracelet at " + node), std::string::npos)
        << taken.error().message;
    EXPECT_FALSE(taken.error().expected.empty()) << "what to do";
}
