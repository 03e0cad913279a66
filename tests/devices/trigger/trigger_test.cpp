// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/trigger/osc_trigger.h"
#include "devices/trigger/serial_trigger.h"
#include "devices/trigger/trigger_opener.h"
#include "tests/backend/core/temporary_folder.h"
#include "tests/support/pseudo_terminal.h"
#include "tests/support/udp_listener.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace teleta::trigger {

namespace {

using core::TriggerEvent;
using Kind = core::TriggerEvent::Kind;

TriggerEvent event(Kind kind, std::size_t index = 0) {
    TriggerEvent made;
    made.kind = kind;
    made.index = index;
    return made;
}

} // namespace

TEST(TriggerEvent, hasTheBytesOfTheTable) {
    EXPECT_EQ(event(Kind::session).byte(), 1);
    EXPECT_EQ(event(Kind::sessionEnd).byte(), 2);
    EXPECT_EQ(event(Kind::pause).byte(), 3);
    EXPECT_EQ(event(Kind::goOn).byte(), 4);
    EXPECT_EQ(event(Kind::fault).byte(), 5);
    EXPECT_EQ(event(Kind::stimulus, 1).byte(), 101);
    EXPECT_EQ(event(Kind::stimulus, 9).byte(), 109);
    EXPECT_EQ(event(Kind::answer, 1).byte(), 201);
    EXPECT_EQ(event(Kind::noAnswer).byte(), 200);
    EXPECT_EQ(event(Kind::answer, 4000).byte(), 255) << "never another event's byte";
    EXPECT_EQ(event(Kind::stimulus, 4000).byte(), 199);
}

// Written down by hand from the specification of Open Sound Control 1.0: texts end in one to four zero bytes,
// numbers are big-endian. 0.25 is 3E800000 as a float.
TEST(OscTrigger, sendsTheBytesOfTheSpecification) {
    TriggerEvent made = event(Kind::stimulus, 3);
    made.session = "20261103T142233";
    made.trial = 258;
    made.level = 0.25F;
    made.time_ns = 0x0102030405060708;
    const std::string expected("/teleta/trial\0\0\0"
                               ",ssifh\0\0"
                               "stimulus_3\0\0"
                               "20261103T142233\0"
                               "\0\0\x01\x02"
                               "\x3E\x80\0\0"
                               "\x01\x02\x03\x04\x05\x06\x07\x08",
                               16 + 8 + 12 + 16 + 4 + 4 + 8);
    const std::vector<char> message = oscMessage(made);
    EXPECT_EQ(std::string(message.begin(), message.end()), expected);

    const test::UdpListener listener;
    const auto port = OscTrigger::open("127.0.0.1", listener.port());
    ASSERT_TRUE(port) << core::describe(port.error());
    ASSERT_TRUE((*port)->write(made));
    EXPECT_EQ(listener.read(), expected);
    made.level.reset();
    const std::vector<char> none = oscMessage(made);
    EXPECT_EQ(std::string(none.begin() + 56, none.begin() + 60), std::string("\x7F\xC0\0\0", 4)) << "NaN";
}

TEST(OscTrigger, needsNobodyWhoListens) {
    std::uint16_t port = 0;
    {
        const test::UdpListener gone;
        port = gone.port();
    }
    const auto line = OscTrigger::open("127.0.0.1", port).value();
    for (int i = 0; i < 5; ++i)
        EXPECT_TRUE(line->write(event(Kind::pause)));
    EXPECT_EQ(OscTrigger::open("no-such-host.invalid", 9).error().kind, core::ErrorKind::notFound);
}

TEST(SerialTrigger, writesOneByteAnEventAndAZero) {
    const test::PseudoTerminal line;
    const auto port = SerialTrigger::open(line.name(), 5.0);
    ASSERT_TRUE(port) << core::describe(port.error());
    EXPECT_EQ((*port)->pulse_ns(), 5'000'000);
    ASSERT_TRUE((*port)->write(event(Kind::session)));
    ASSERT_TRUE((*port)->write(event(Kind::stimulus, 2)));
    ASSERT_TRUE((*port)->clear());
    // Neither newlines nor control characters are changed on the way.
    ASSERT_TRUE((*port)->write(event(Kind::pause)));
    ASSERT_TRUE((*port)->write(event(Kind::goOn)));
    EXPECT_EQ(line.read(5), (std::vector<std::uint8_t>{1, 102, 0, 3, 4}));
}

TEST(SerialTrigger, saysWhatIsWrongWithALine) {
    const test::TemporaryFolder folder;
    EXPECT_EQ(SerialTrigger::open(folder.path("ttyUSB7"), 5.0).error().kind, core::ErrorKind::notFound);
    const auto file = SerialTrigger::open(folder.write("file", ""), 5.0);
    ASSERT_FALSE(file);
    EXPECT_EQ(file.error().kind, core::ErrorKind::refused);
    EXPECT_NE(file.error().message.find("not a serial line"), std::string::npos);
    test::PseudoTerminal line;
    const auto first = SerialTrigger::open(line.name(), 5.0).value();
    EXPECT_FALSE(SerialTrigger::open(line.name(), 5.0)) << "in use";
    line.hangUp();
    EXPECT_EQ(first->write(event(Kind::session)).error().kind, core::ErrorKind::ioFailed);
}

TEST(TriggerSettings, comeFromOneWord) {
    EXPECT_EQ(triggerSettingsOf("/dev/ttyUSB0")->device, "/dev/ttyUSB0");
    EXPECT_EQ(triggerSettingsOf("/dev/ttyUSB0")->kind, core::TriggerSettings::Kind::serial);
    for (const char* word : {"osc:lab.local:9000", "lab.local:9000"}) {
        const auto settings = triggerSettingsOf(word);
        ASSERT_TRUE(settings) << word;
        EXPECT_EQ(settings->kind, core::TriggerSettings::Kind::osc);
        EXPECT_EQ(settings->host, "lab.local");
        EXPECT_EQ(settings->port, 9000);
    }
    for (const char* word : {"", "lab", "lab:", ":9000", "lab:0", "lab:65536", "lab:x"})
        EXPECT_EQ(triggerSettingsOf(word).error().kind, core::ErrorKind::badInput) << word;
    EXPECT_EQ(openTrigger({}).value(), nullptr);
}

} // namespace teleta::trigger
