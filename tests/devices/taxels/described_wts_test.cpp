// SPDX-License-Identifier: GPL-3.0-or-later
// A file that describes a Weiss array must give the frames that its driver gives.
#include "devices/taxels/taxels_device.h"
#include "devices/wts/wts_device.h"
#include "tests/backend/core/temporary_folder.h"
#include "tests/devices/manual_clock.h"
#include "tests/devices/taxels/taxel_files.h"
#include "tests/devices/wts/emulated_wts.h"

#include <gtest/gtest.h>

#include <random>

namespace teleta::taxels {
namespace {

using teleta::test::eventually;
using wts::test::Bytes;
using wts::test::EmulatedWts;

constexpr std::uint32_t kFrames = 400;

/// Frames with damaged, cut and noisy ones among them, and how many of them are whole.
Bytes noisyStream(std::size_t& whole) {
    std::mt19937 random(3);
    Bytes stream;
    for (std::uint32_t number = 0; number < kFrames; ++number) {
        std::vector<unsigned> cells(84);
        for (std::size_t i = 0; i < cells.size(); ++i)
            cells[i] = (number * 131 + static_cast<unsigned>(i)) & 0xFFF;
        Bytes frame = wts::test::frame(number * 10, false, cells);
        const unsigned fate = number < 3 || number + 1 == kFrames ? 9 : random() % 10;
        if (fate == 0)
            frame[random() % frame.size()] ^= 0x40;
        else if (fate == 1)
            frame.resize(random() % frame.size());
        else
            ++whole;
        if (fate == 2)
            wts::test::append(stream, {'\r', '\n', 0xAA, 0xAA, 'x', 0xAA});
        wts::test::append(stream, frame);
    }
    return stream;
}

struct Received {
    std::vector<float> values;
    std::vector<std::uint64_t> numbers;
    std::vector<double> steps_s;
    std::uint64_t lost = 0;
};

Received receive(core::TactileSource& device, EmulatedWts& sensor, int starts, const Bytes& stream,
                 std::size_t frames) {
    core::Wakeup wakeup;
    Received received;
    device.start(wakeup);
    EXPECT_TRUE(sensor.waitForRequests(wts::Command::startFrames, starts));
    std::jthread sender([&] { EXPECT_TRUE(sensor.send(stream)); });
    std::vector<double> time_s;
    EXPECT_TRUE(eventually(wakeup, [&] {
        core::SampleBlock block;
        while (device.blocks().pop(block)) {
            received.values.insert(received.values.end(), block.values.begin(), block.values.end());
            for (std::size_t i = 0; i < block.frames(); ++i) {
                received.numbers.push_back(block.firstFrame + i);
                time_s.push_back(block.sourceTime_s[i]);
            }
        }
        return received.numbers.size() >= frames;
    }));
    received.lost = device.status().framesLost;
    for (std::size_t i = 1; i < time_s.size(); ++i)
        received.steps_s.push_back(std::round((time_s[i] - time_s[i - 1]) * 1e6) / 1e6);
    device.stop();
    return received;
}

TEST(DescribedWts, givesTheFramesOfTheDriver) {
    std::size_t whole = 0;
    const Bytes stream = noisyStream(whole);
    EmulatedWts sensor(EmulatedWts::Link::pty);
    wts::WtsConfig config;
    config.address = *wts::parseWtsAddress(sensor.address());
    config.times = {
        .connect_ms = 20'000, .answer_ms = 20'000, .lineSilence_ms = 20'000, .noFrames_ms = 20'000};
    Received driver;
    {
        auto device = wts::WtsDevice::open(config);
        ASSERT_TRUE(device) << core::describe(device.error());
        driver = receive(**device, sensor, 1, stream, whole);
    }
    // The greeting starts the periodic frames: flags 0, delay 0.
    const Bytes start = wts::encodeStartFrames(false, 0);
    const Bytes stop = wts::encodeRequest(wts::Command::stopFrames);
    const auto hex = [](const Bytes& bytes) {
        std::string text;
        for (const std::uint8_t byte : bytes) {
            char digits[3];
            std::snprintf(digits, sizeof digits, "%02X", static_cast<unsigned>(byte));
            text += digits;
        }
        return text;
    };
    TaxelsFile file =
        test::parsed(test::head() + test::serialLink(sensor.address()) + "greeting_bytes = '" + hex(start) +
                     "'\ngoodbye_bytes = '" + hex(stop) + "'\n" + test::kGrid +
                     "[frame]\nencoding = 'binary'\nsync = 'AA AA AA 00'\n"
                     "length_field = { at = 4, type = 'uint16', counts = 'payload' }\n"
                     "checksum = { type = 'crc16-wts' }\ntime = { at = 6, type = 'uint32', unit = 'ms' }\n"
                     "values = { at = 11, type = 'uint16', count = 84 }\n");
    file.times = {.connect_ms = 20'000, .lineSilence_ms = 20'000, .noFrames_ms = 20'000};
    auto described = TaxelsDevice::open(std::move(file));
    ASSERT_TRUE(described) << core::describe(described.error());
    const Received found = receive(**described, sensor, 2, stream, whole);
    EXPECT_EQ(found.values, driver.values);
    EXPECT_EQ(found.numbers, driver.numbers);
    EXPECT_EQ(found.steps_s, driver.steps_s);
    EXPECT_EQ(found.lost, driver.lost);
    EXPECT_GT(found.lost, 0U);
    EXPECT_TRUE(sensor.waitForRequests(wts::Command::stopFrames, 3)) << "it says goodbye";
}

} // namespace
} // namespace teleta::taxels
