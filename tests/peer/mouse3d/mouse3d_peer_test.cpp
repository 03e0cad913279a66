// SPDX-License-Identifier: GPL-3.0-or-later
// The 3D mouse against the kernel's own HID stack. Runs in the virtual machine of tests/peer/vm.
#include "devices/mouse3d/mouse3d.h"
#include "tests/devices/manual_clock.h"
#include "tests/peer/mouse3d/evdev_view.h"
#include "tests/peer/uhid_device.h"

#include <gtest/gtest.h>

#include <linux/input.h>
#include <memory>
#include <string>
#include <vector>

using namespace teleta;
using core::DeviceState;
using mouse3d::Mouse3d;
using mouse3d::Mouse3dConfig;
using mouse3d::SixAxes;

namespace {

using Bytes = std::vector<std::uint8_t>;

// Multi-axis controller: translation, rotation and two buttons, each in a report of its own.
const Bytes kThreeReports = {
    0x05, 0x01, 0x09, 0x08, 0xA1, 0x01,                         // generic desktop, multi-axis controller
    0x16, 0xA2, 0xFE, 0x26, 0x5E, 0x01, 0x75, 0x10, 0x95, 0x03, // -350 .. 350, three of 16 bits
    0x85, 0x01, 0x09, 0x30, 0x09, 0x31, 0x09, 0x32, 0x81, 0x02, // report 1: X, Y, Z
    0x85, 0x02, 0x09, 0x33, 0x09, 0x34, 0x09, 0x35, 0x81, 0x02, // report 2: Rx, Ry, Rz
    0x85, 0x03, 0x05, 0x09, 0x19, 0x01, 0x29, 0x02, 0x15, 0x00, // report 3: buttons 1 and 2
    0x25, 0x01, 0x75, 0x01, 0x95, 0x02, 0x81, 0x02,             // of one bit
    0x95, 0x0E, 0x81, 0x03, 0xC0};                              // and 14 bits that mean nothing

// The same with all axes in report 1.
const Bytes kMerged = {0x05, 0x01, 0x09, 0x08, 0xA1, 0x01,                         //
                       0x16, 0xA2, 0xFE, 0x26, 0x5E, 0x01, 0x75, 0x10, 0x95, 0x06, // six of 16 bits
                       0x85, 0x01, 0x09, 0x30, 0x09, 0x31, 0x09, 0x32,             //
                       0x09, 0x33, 0x09, 0x34, 0x09, 0x35, 0x81, 0x02,             //
                       0x85, 0x03, 0x05, 0x09, 0x19, 0x01, 0x29, 0x02, 0x15, 0x00, //
                       0x25, 0x01, 0x75, 0x01, 0x95, 0x02, 0x81, 0x02,             //
                       0x95, 0x0E, 0x81, 0x03, 0xC0};

// An ordinary mouse: three buttons, X and Y of 8 bits.
const Bytes kOrdinaryMouse = {0x05, 0x01, 0x09, 0x02, 0xA1, 0x01, 0x09, 0x01, 0xA1, 0x00, 0x05, 0x09, 0x19,
                              0x01, 0x29, 0x03, 0x15, 0x00, 0x25, 0x01, 0x75, 0x01, 0x95, 0x03, 0x81, 0x02,
                              0x75, 0x05, 0x95, 0x01, 0x81, 0x03, 0x05, 0x01, 0x09, 0x30, 0x09, 0x31, 0x15,
                              0x81, 0x25, 0x7F, 0x75, 0x08, 0x95, 0x02, 0x81, 0x06, 0xC0, 0xC0};

const Bytes kPressed = {0x03, 0x01, 0x00};
const Bytes kOtherPressed = {0x03, 0x02, 0x00};
const Bytes kReleased = {0x03, 0x00, 0x00};
const Bytes kRight = {0x01, 0x5E, 0x01, 0x00, 0x00, 0x00, 0x00};

/// A report of axes.
Bytes axesReport(std::uint8_t id, const std::vector<int>& counts) {
    Bytes bytes = {id};
    for (const int count : counts) {
        bytes.push_back(static_cast<std::uint8_t>(count & 0xFF));
        bytes.push_back(static_cast<std::uint8_t>((count >> 8) & 0xFF));
    }
    return bytes;
}

/// For a machine that is emulated and busy: a cap that was deflected counts on and on.
Mouse3dConfig patient() {
    return {.axesLifetime_ns = 600'000'000'000, .restLifetime_ns = 600'000'000'000};
}

class Mouse3dPeer : public testing::Test {
protected:
    void plugIn(const Bytes& descriptor = kThreeReports) {
        m_mouse.plugIn({"Cap with six axes", "3D-7", 0x0002, descriptor});
    }
    void start(const Mouse3dConfig& config) {
        m_device = std::make_unique<Mouse3d>(config);
        m_device->start(m_wakeup);
        ASSERT_TRUE(becomes(DeviceState::live));
    }
    template <typename Condition>
    [[nodiscard]] bool eventually(const Condition& condition) {
        return test::eventually(m_wakeup, condition);
    }
    [[nodiscard]] bool becomes(DeviceState state) {
        return eventually([&] { return m_device->status().state == state; });
    }
    /// Sends reports and waits until all of them are taken.
    [[nodiscard]] bool send(const std::vector<Bytes>& reports) {
        const std::uint64_t all = m_device->status().framesRead + reports.size();
        for (const Bytes& report : reports)
            m_mouse.sendInput(report);
        return eventually([&] { return m_device->status().framesRead == all; });
    }

    core::Wakeup m_wakeup;
    peer::UhidDevice m_mouse;
    std::unique_ptr<Mouse3d> m_device;
};

struct Form {
    const char* name;
    const Bytes& descriptor;
    bool merged;
};

class Mouse3dPeerForm : public Mouse3dPeer, public testing::WithParamInterface<Form> {
protected:
    void SetUp() override { plugIn(GetParam().descriptor); }
    [[nodiscard]] bool sendAxes(const std::vector<int>& counts) {
        if (GetParam().merged)
            return send({axesReport(1, counts)});
        return send({axesReport(1, {counts.begin(), counts.begin() + 3}),
                     axesReport(2, {counts.begin() + 3, counts.end()})});
    }
};

} // namespace

TEST_F(Mouse3dPeer, isFoundAndAnOrdinaryMouseIsNot) {
    peer::UhidDevice ordinary;
    ordinary.plugIn({"Ordinary mouse", "M-1", 0x0003, kOrdinaryMouse});
    ASSERT_TRUE(eventually([] { return peer::findEvdev("Ordinary mouse").has_value(); }));
    EXPECT_TRUE(mouse3d::listMice().empty());
    EXPECT_EQ(mouse3d::openFirstMouse().error().kind, core::ErrorKind::unavailable);
    plugIn();
    ASSERT_TRUE(eventually([] { return !mouse3d::listMice().empty(); }));
    const auto mice = mouse3d::listMice();
    ASSERT_EQ(mice.size(), 1U);
    EXPECT_EQ(mice[0].product, "Cap with six axes");
    EXPECT_EQ(mice[0].vendorId, 0x1209);
    EXPECT_EQ(mice[0].productId, 0x0002);
    start({});
    EXPECT_EQ(m_device->name(), "Cap with six axes");
    EXPECT_EQ(m_device->motion(), SixAxes{}) << "a mouse at rest";
}

// The kernel reads the reports by their descriptor, and knows nothing of how the device reads them.
TEST_P(Mouse3dPeerForm, readsFromEveryAxisAndButtonWhatTheKernelReads) {
    ASSERT_TRUE(eventually([] { return peer::findEvdev("Cap with six axes").has_value(); }));
    const peer::EvdevView kernel(*peer::findEvdev("Cap with six axes"));
    Mouse3dConfig linear = patient();
    linear.limits = {.fullScale_counts = 350.0, .deadZone = 0.0};
    start(linear);
    const std::vector<std::vector<int>> all = {{1, -2, 3, -4, 5, -6},
                                               {-350, 256, -255, 350, -256, 255},
                                               {17, 350, -350, -128, 127, -1},
                                               {0, 0, 0, 0, 0, 0}};
    for (const std::vector<int>& counts : all) {
        ASSERT_TRUE(sendAxes(counts));
        const SixAxes axes = m_device->reading().axes;
        // {m} is the mouse's frame turned by half a turn about x.
        const double sign[3] = {1.0, -1.0, -1.0};
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_DOUBLE_EQ(axes.translation[i] * 350.0, sign[i] * kernel.axis(ABS_X + static_cast<int>(i)));
            EXPECT_DOUBLE_EQ(axes.rotation[i] * 350.0, sign[i] * kernel.axis(ABS_RX + static_cast<int>(i)));
            EXPECT_EQ(kernel.axis(ABS_X + static_cast<int>(i)), counts[i]);
            EXPECT_EQ(kernel.axis(ABS_RX + static_cast<int>(i)), counts[3 + i]);
        }
    }
    for (const std::uint8_t buttons : {1, 2, 3, 0}) {
        ASSERT_TRUE(send({Bytes{0x03, buttons, 0x00}}));
        EXPECT_EQ(m_device->reading().buttons, buttons);
        EXPECT_EQ((m_device->reading().buttons & 1U) != 0, kernel.button(BTN_0));
        EXPECT_EQ((m_device->reading().buttons & 2U) != 0, kernel.button(BTN_1));
    }
}

// The mouse's axes: x right, y towards the operator, z down; the operator's: x right, y away, z up.
TEST_P(Mouse3dPeerForm, movesToWhereTheHandPushesAndTurns) {
    start(patient());
    ASSERT_TRUE(send({kReleased, kPressed}));
    const struct {
        const char* push;
        std::vector<int> counts;
        SixAxes motion;
    } pushes[] = {
        {"right", {350, 0, 0, 0, 0, 0}, {{1, 0, 0}, {}}},
        {"left", {-350, 0, 0, 0, 0, 0}, {{-1, 0, 0}, {}}},
        {"towards the operator", {0, 350, 0, 0, 0, 0}, {{0, -1, 0}, {}}},
        {"away", {0, -350, 0, 0, 0, 0}, {{0, 1, 0}, {}}},
        {"down", {0, 0, 350, 0, 0, 0}, {{0, 0, -1}, {}}},
        {"up", {0, 0, -350, 0, 0, 0}, {{0, 0, 1}, {}}},
        {"tilted about x", {0, 0, 0, 350, 0, 0}, {{}, {1, 0, 0}}},
        {"tilted about y", {0, 0, 0, 0, 350, 0}, {{}, {0, -1, 0}}},
        {"turned clockwise, seen from above", {0, 0, 0, 0, 0, 350}, {{}, {0, 0, -1}}},
        {"let go", {0, 0, 0, 0, 0, 0}, {}},
    };
    for (const auto& push : pushes) {
        ASSERT_TRUE(sendAxes(push.counts));
        EXPECT_EQ(m_device->motion(), push.motion) << push.push;
    }
}

INSTANTIATE_TEST_SUITE_P(Forms, Mouse3dPeerForm,
                         testing::Values(Form{"threeReports", kThreeReports, false},
                                         Form{"merged", kMerged, true}),
                         [](const auto& tested) { return tested.param.name; });

TEST_F(Mouse3dPeer, movesOnlyWhileTheDeadManButtonIsHeld) {
    plugIn();
    start(patient());
    ASSERT_TRUE(send({kRight}));
    EXPECT_EQ(m_device->reading().axes.translation[0], 1.0);
    EXPECT_EQ(m_device->motion(), SixAxes{});
    ASSERT_TRUE(send({kOtherPressed}));
    EXPECT_EQ(m_device->motion(), SixAxes{}) << "another button";
    ASSERT_TRUE(send({kPressed}));
    EXPECT_EQ(m_device->motion().translation[0], 1.0);
    ASSERT_TRUE(send({kReleased, kRight}));
    EXPECT_EQ(m_device->motion(), SixAxes{});
}

TEST_F(Mouse3dPeer, comesToRestWhenADeflectedCapFallsSilent) {
    plugIn();
    start({});
    ASSERT_TRUE(send({kOtherPressed, kReleased, kPressed}));
    ASSERT_TRUE(eventually([&] {
        m_mouse.sendInput(kRight);
        return m_device->motion().translation[0] == 1.0;
    }));
    EXPECT_TRUE(eventually([&] { return m_device->motion() == SixAxes{}; }));
    EXPECT_FALSE(m_device->reading().deadManHeld) << "a release may have been lost";
    EXPECT_EQ(m_device->status().state, DeviceState::live);
}

TEST_F(Mouse3dPeer, restsWhenUnpluggedWhileDeflectedAndWantsTheButtonAnewWhenItIsBack) {
    plugIn();
    start(patient());
    ASSERT_TRUE(send({kReleased, kPressed, kRight}));
    ASSERT_EQ(m_device->motion().translation[0], 1.0);
    m_mouse.unplug();
    ASSERT_TRUE(becomes(DeviceState::lost));
    EXPECT_FALSE(m_device->status().message.empty());
    ASSERT_TRUE(eventually([&] { return m_device->motion() == SixAxes{}; }));
    EXPECT_FALSE(m_device->reading().deadManHeld);
    EXPECT_EQ(m_device->reading().axes, SixAxes{});

    plugIn();
    ASSERT_TRUE(becomes(DeviceState::live));
    EXPECT_TRUE(m_device->status().message.empty());
    EXPECT_EQ(m_device->motion(), SixAxes{});
    // The cap is deflected and the button held all the while; a mouse tells of a button only when it changes.
    ASSERT_TRUE(send({kRight, kRight, kRight}));
    EXPECT_EQ(m_device->reading().axes.translation[0], 1.0);
    EXPECT_EQ(m_device->motion(), SixAxes{});
    ASSERT_TRUE(send({kReleased, kRight}));
    EXPECT_EQ(m_device->motion(), SixAxes{});
    ASSERT_TRUE(send({kPressed, kRight}));
    EXPECT_EQ(m_device->motion().translation[0], 1.0);
}
