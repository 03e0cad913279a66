// SPDX-License-Identifier: GPL-3.0-or-later
// Skins of magnetometers against a board in Python over a pseudo-terminal.
#include "devices/taxels/taxels_device.h"
#include "devices/taxels/taxels_probe.h"
#include "tests/backend/core/temporary_folder.h"
#include "tests/devices/manual_clock.h"
#include "tests/devices/taxels/board.h"
#include "tests/devices/taxels/taxel_files.h"

#include <gtest/gtest.h>

#include <cmath>

namespace teleta::taxels {
namespace {

using teleta::test::eventually;
using test::Board;

constexpr const char* kPlaces = "positions_mm = [[0, 0], [7, 0], [-7, 0], [0, 7], [0, -7]]\n";

std::string skinOn(const std::string& port, const char* format = "binary") {
    return "kind = 'magnetometers'\nname = 'skin'\npath = '" + port + "'\nchips = 5\nformat = '" + format +
           "'\n" + kPlaces + "axes = ['+x', '+y', '-z']\nthreshold_uT = 40.0\n";
}

/// The same described byte by byte.
std::string describedOn(const std::string& port) {
    return test::head() + test::serialLink(port) + "[layout]\ncomponents = 3\naxes = ['+x', '+y', '-z']\n" +
           kPlaces +
           "unit = 'uT'\n[frame]\nencoding = 'binary'\nend = '0D 0A'\nlength = 82\n"
           "values = { at = 4, type = 'float32', count = 15, stride = 16 }\n";
}

constexpr float kNone = -9999.0F;

/// The field at each chip in the board's frame of this number, on the grid of the cross; its z is turned.
std::vector<float> expected(int number) {
    std::vector<float> frame;
    for (const int chip : {-1, 4, -1, 2, 0, 1, -1, 3, -1}) {
        const auto n = static_cast<float>(chip);
        if (chip < 0)
            frame.insert(frame.end(), 3, kNone);
        else
            frame.insert(frame.end(), {n + 0.25F, -static_cast<float>(number),
                                       -10.0F * n - static_cast<float>(number) / 8});
    }
    return frame;
}

using Frames = std::vector<std::vector<float>>;

Frames receive(core::TactileSource& device, core::Wakeup& wakeup, std::size_t frames) {
    Frames found;
    EXPECT_TRUE(eventually(wakeup, [&] {
        core::SampleBlock block;
        while (device.blocks().pop(block))
            for (std::size_t i = 0; i < block.frames(); ++i) {
                const auto values = block.frame(i);
                found.emplace_back(values.begin(), values.end());
                for (float& value : found.back())
                    value = std::isnan(value) ? kNone : value;
            }
        return found.size() >= frames;
    }));
    return found;
}

TEST(Magnetometers, giveWholeFramesBetweenCutNoisyAndDoubledOnesAndAfterTheyWereUnplugged) {
    teleta::test::TemporaryFolder folder;
    const std::string port = folder.path("port");
    const TaxelsTimes times{.connect_ms = 20'000,
                            .lineSilence_ms = 20'000,
                            .stale_ms = 20'000,
                            .noFrames_ms = 20'000,
                            .firstRetry_ms = 5,
                            .longestRetry_ms = 20};
    Board board("pty", "skin", port);
    std::vector<Frames> both;
    for (const std::string& text : {skinOn(port), describedOn(port)}) {
        TaxelsFile file = test::parsed(text);
        file.times = times;
        auto device = TaxelsDevice::open(std::move(file));
        ASSERT_TRUE(device) << core::describe(device.error());
        core::Wakeup wakeup;
        (*device)->start(wakeup);
        board.say("write noise:0011223344 0-3 cut:4 5-7 noise:0D0A0D 8-9 twice:10 11-12");
        const Frames found = receive(**device, wakeup, 13);
        ASSERT_EQ(found.size(), 13U);
        std::size_t i = 0;
        for (const int number : {0, 1, 2, 3, 5, 6, 7, 8, 9, 10, 10, 11, 12})
            EXPECT_EQ(found[i++], expected(number)) << number;
        EXPECT_EQ((*device)->counters().line.droppedBytes, 5U + 54U + 3U);
        EXPECT_EQ((*device)->status().framesLost, 0U);
        EXPECT_FALSE((*device)->countsLosses()) << "the sensor does not count its frames";
        ASSERT_TRUE(board.done());

        ASSERT_TRUE(board.command("unplug"));
        ASSERT_TRUE(eventually(wakeup, [&] { return (*device)->counters().failedAttempts >= 1; }));
        ASSERT_TRUE(board.command("plug"));
        ASSERT_TRUE(eventually(wakeup, [&] { return (*device)->counters().connections == 2; }));
        board.say("write 40-42");
        const Frames again = receive(**device, wakeup, 3);
        ASSERT_FALSE(again.empty());
        EXPECT_EQ(again.front(), expected(40));
        ASSERT_TRUE(board.done());
        std::vector<std::size_t> after; // an outage
        core::TemperatureSample sample;
        for (std::size_t n = 0; (*device)->temperatures().pop(sample); ++n)
            if (sample.discontinuity)
                after.push_back(n);
        if ((*device)->chips() > 0) {
            EXPECT_EQ(after, (std::vector<std::size_t>{13})) << "after the outage";
        }
        both.push_back(found);
    }
    EXPECT_EQ(both[0], both[1]) << "a described AnySkin gives what the driver gives";
}

/// The board's chips warm up by 1 K in 64 frames, from 25 degC.
TEST(Magnetometers, tellTheTemperaturesOfTheirChips) {
    teleta::test::TemporaryFolder folder;
    for (const char* format : {"binary", "reskin_text"}) {
        const std::string port = folder.path(format);
        Board board("pty", std::string(format) == "binary" ? "skin" : "skintext", port);
        auto device = TaxelsDevice::open(test::parsed(skinOn(port, format)));
        ASSERT_TRUE(device) << core::describe(device.error());
        EXPECT_EQ((*device)->chips(), 5U);
        core::Wakeup wakeup;
        (*device)->start(wakeup);
        board.say("write 0-63 cut:64 noise:0A 65-80");
        (void)receive(**device, wakeup, 79);
        std::vector<float> found;
        core::TemperatureSample sample;
        while ((*device)->temperatures().pop(sample)) {
            ASSERT_EQ(sample.values_degC.size(), 5U);
            EXPECT_GT(sample.time_ns, 0);
            found.push_back(sample.values_degC[4]);
        }
        const std::size_t first = std::string(format) == "binary" ? 0 : 1; // the first line may be cut
        ASSERT_GE(found.size(), 79U);
        EXPECT_EQ(found.front(), 25.0F + static_cast<float>(first) / 64);
        EXPECT_EQ(found.back(), 25.0F + 80.0F / 64);
    }
}

/// Nobody takes them, and more come than are kept.
TEST(Magnetometers, countTemperaturesThatAreDropped) {
    teleta::test::TemporaryFolder folder;
    Board board("pty", "skin", folder.path("port"));
    auto device = TaxelsDevice::open(test::parsed(skinOn(folder.path("port"))));
    ASSERT_TRUE(device) << core::describe(device.error());
    const std::size_t kept = (*device)->temperatures().capacity();
    core::Wakeup wakeup;
    (*device)->start(wakeup);
    board.say("write 0-" + std::to_string(kept + 9));
    (void)receive(**device, wakeup, kept + 10);
    EXPECT_EQ((*device)->temperatures().overflow(), 10U);
    core::TemperatureSample sample;
    while ((*device)->temperatures().pop(sample))
        EXPECT_FALSE(sample.discontinuity);
    board.say("write 0-1");
    (void)receive(**device, wakeup, 2);
    ASSERT_TRUE((*device)->temperatures().pop(sample));
    EXPECT_TRUE(sample.discontinuity) << "samples before it were dropped";
    ASSERT_TRUE((*device)->temperatures().pop(sample));
    EXPECT_FALSE(sample.discontinuity);
}

TEST(Magnetometers, areTakenForWarmedWhenTheirChipsMovedWhileTheyWereProbed) {
    teleta::test::TemporaryFolder folder;
    Board board("pty", "skin", folder.path("port"));
    const TaxelsFile file = test::parsed(skinOn(folder.path("port")));
    board.say("write pause:100 0-3 352");
    const auto probe = probeTaxels(file, {.wait_s = 20.0, .measure_s = 0.3});
    ASSERT_TRUE(probe) << core::describe(probe.error());
    ASSERT_EQ(probe->frames.size(), 5U);
    ASSERT_TRUE(probe->drift.largest());
    EXPECT_DOUBLE_EQ(probe->drift.largest()->change_K, 352.0 / 64);
    EXPECT_TRUE(probe->drift.isTold());
}

TEST(Magnetometers, takeTheMedianOfFiftyFramesForTheirRest) {
    teleta::test::TemporaryFolder folder;
    Board board("pty", "skin", folder.path("port"));
    const TaxelsFile file = test::parsed(skinOn(folder.path("port")));
    // The last number is far from the others, as if the skin was touched while it was opened.
    board.say("write pause:100 0-40 900-910");
    const auto rest = measureRest(file);
    ASSERT_TRUE(rest) << core::describe(rest.error());
    ASSERT_EQ(rest->values.size(), 27U);
    // z of the chip in the middle falls from frame to frame, so the upper of the two middle ones is frame 24.
    EXPECT_EQ(rest->values[14], -24.0F / 8);
    EXPECT_TRUE(std::isnan(rest->values[0]));
    // It warms up, and the upper of the two middle ones is frame 25.
    EXPECT_EQ(rest->temperatures_degC, std::vector<float>(5, 25.0F + 25.0F / 64));
}

TEST(Magnetometers, areNotOpenedWithAnotherNumberOfChips) {
    teleta::test::TemporaryFolder folder;
    Board board("pty", "skin", folder.path("port"));
    std::string text = skinOn(folder.path("port"));
    const std::size_t last = text.rfind(", [", text.find("]]"));
    text.erase(last, text.find("]]") + 1 - last);
    if (const std::size_t chips = text.find("chips = 5\n"); chips != std::string::npos)
        text.erase(chips, 10);
    const TaxelsFile file = test::parsed(text);
    EXPECT_EQ(file.temperatures, 4U) << "as many as there are positions";
    board.say("write pause:100 0-80");
    const auto rest = measureRest(file);
    ASSERT_FALSE(rest);
    EXPECT_NE(rest.error().message.find("5 chips"), std::string::npos) << core::describe(rest.error());
    EXPECT_NE(rest.error().expected.find("4 chips"), std::string::npos) << core::describe(rest.error());
}

TEST(Magnetometers, sayGoodbyeWhenTheirMeasurementIsCancelled) {
    teleta::test::TemporaryFolder folder;
    Board board("pty", "skin", folder.path("port"));
    TaxelsFile file = test::parsed(skinOn(folder.path("port")));
    file.greeting = "s";
    file.goodbye = "x";
    bool cancelled = false;
    const auto rest = measureRest(file, [&] { return std::exchange(cancelled, true); });
    ASSERT_FALSE(rest);
    EXPECT_EQ(rest.error().kind, core::ErrorKind::cancelled);
    EXPECT_EQ(board.heard(), "7378");
}

TEST(Magnetometers, sayHowManyFramesAreMissingForTheirTare) {
    teleta::test::TemporaryFolder folder;
    const std::string path = folder.path("bytes.bin");
    {
        Board board("file", "skin", path);
        ASSERT_TRUE(board.command("write 0-6"));
    }
    TaxelsFile file = test::parsed(skinOn(path));
    file.address = link::FileAddress{path};
    const auto rest = measureRest(file);
    ASSERT_FALSE(rest);
    EXPECT_EQ(rest.error().kind, core::ErrorKind::unavailable);
    EXPECT_NE(rest.error().message.find("only 7 of 50"), std::string::npos) << rest.error().message;
}

TEST(Magnetometers, mayBeSlowerThanTheWaitForTheirWholeTare) {
    teleta::test::TemporaryFolder folder;
    Board board("pty", "skin", folder.path("port"));
    TaxelsFile file = test::parsed(skinOn(folder.path("port")));
    file.restFrames = 3;
    // 3.6 s for three frames, which is longer than the wait for one of them.
    board.say("write pause:100 0 1 pause:1800 2 3 pause:1800 4 5");
    EXPECT_TRUE(measureRest(file));
}

TEST(Magnetometers, readTheTextOfReSkin) {
    teleta::test::TemporaryFolder folder;
    Board board("pty", "skintext", folder.path("port"));
    auto device = TaxelsDevice::open(test::parsed(skinOn(folder.path("port"), "reskin_text")));
    ASSERT_TRUE(device) << core::describe(device.error());
    core::Wakeup wakeup;
    (*device)->start(wakeup);
    board.say("write 0-3 cut:4 noise:0A 5");
    const Frames found = receive(**device, wakeup, 4);
    std::size_t i = 0;
    for (const int number : {1, 2, 3, 5})
        EXPECT_EQ(found.at(i++), expected(number)) << "the first line may have been cut";
}

} // namespace
} // namespace teleta::taxels
