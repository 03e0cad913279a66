// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/replay/recorded_device.h"
#include "tests/devices/manual_clock.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <memory>
#include <string>
#include <unistd.h>
#include <vector>

namespace teleta::test {

constexpr std::int64_t kMs_ns = 1'000'000;
constexpr double kUnpaced = std::numeric_limits<double>::infinity();

/// One frame as the consumer got it.
struct ReceivedFrame {
    float value = 0.0F; ///< of the first taxel: the number of the frame in the file
    double sourceTime_s = 0.0;
    std::int64_t time_ns = 0;
    std::uint64_t number = 0;
    bool discontinuity = false;
};

/// Writes recordings of 1 x 2 taxels at 10 Hz from 100 s on and plays them.
class ReplayTest : public testing::Test {
protected:
    void SetUp() override {
        const auto* info = testing::UnitTest::GetInstance()->current_test_info();
        // Several runs of this program may go on at the same time.
        m_path = testing::TempDir() + info->test_suite_name() + "_" + info->name() + "_" +
                 std::to_string(::getpid()) + ".csv";
    }

    void TearDown() override {
        m_device.reset();
        std::remove(m_path.c_str());
    }

    void write(const std::string& text) { std::ofstream(m_path, std::ios::binary) << text; }

    static std::string rows(int frames, int first = 0) {
        std::string text;
        for (int frame = first; frame < first + frames; ++frame) {
            const std::string number = std::to_string(frame);
            text +=
                std::to_string(100 + frame / 10) + '.' + std::to_string(frame % 10) + ',' + number + ",7\n";
        }
        return text;
    }

    void writeFrames(int frames) { write("time_s,t0,t1\n" + rows(frames)); }

    replay::CsvConfig config() const {
        replay::CsvConfig config;
        config.path = m_path;
        config.layout = {1, 2, 0.01};
        config.clock = m_clock;
        return config;
    }

    void open(replay::CsvConfig config) {
        auto player = replay::RecordedPlayer::open(std::move(config));
        ASSERT_TRUE(player) << describe(player.error());
        m_device = std::make_unique<replay::RecordedArray>(*player);
    }

    /// Opens, starts and waits until the worker has done what is due.
    void play(replay::CsvConfig config) {
        open(std::move(config));
        m_device->start(m_wakeup);
        m_clock->settle();
    }

    std::vector<ReceivedFrame> drain() {
        std::vector<ReceivedFrame> frames;
        core::SampleBlock block;
        while (m_device->blocks().pop(block)) {
            EXPECT_EQ(block.channels, 2U);
            for (std::size_t i = 0; i < block.frames(); ++i) {
                EXPECT_EQ(block.frame(i)[1], 7.0F);
                frames.push_back({block.frame(i)[0], block.sourceTime_s[i], block.time_ns[i],
                                  block.firstFrame + i, i == 0 && block.discontinuity});
            }
        }
        return frames;
    }

    /// Drains until so many frames have come.
    std::vector<ReceivedFrame> take(std::size_t count) {
        std::vector<ReceivedFrame> frames;
        EXPECT_TRUE(eventually(m_wakeup, [&] {
            for (const ReceivedFrame& frame : drain())
                frames.push_back(frame);
            return frames.size() >= count;
        }));
        EXPECT_EQ(frames.size(), count);
        frames.resize(count);
        return frames;
    }

    /// Gives a command and waits for the one frame that it shows.
    template <typename Command>
    ReceivedFrame shownBy(const Command& command) {
        command(*m_device);
        return take(1).front();
    }

    bool comesTo(core::DeviceState state) {
        return eventually(m_wakeup, [&] { return m_device->status().state == state; });
    }

    std::string m_path;
    std::shared_ptr<ManualClock> m_clock = std::make_shared<ManualClock>();
    core::Wakeup m_wakeup;
    std::unique_ptr<replay::RecordedArray> m_device;
};

} // namespace teleta::test
