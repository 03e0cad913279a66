// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/threads/wakeup.h"
#include "backend/playback/player.h"
#include "devices/sound_bracelet/sound_bracelet.h"
#include "devices/sound_bracelet/sound_bracelet_file.h"

#include <gtest/gtest.h>

#include <chrono>
#include <limits>
#include <memory>
#include <string>
#include <thread>

namespace teleta::peer {

inline constexpr core::Drive kSome{500, 1000, 1500, 2000, 2500, 3000};

/// A bracelet on a sound server that the test starts. Thread: one.
class SoundPeer : public testing::Test {
protected:
    static sound::SoundBraceletFile fileOf(const std::string& device, const std::string& more = {}) {
        auto file = sound::parseSoundBracelet("kind = 'sound_bracelet'\nname = 'voice coils'\ndevice = '" +
                                                  device + "'\nchannels = [1, 2, 3, 4, 5, 6]\n" + more,
                                              "coils.toml");
        EXPECT_TRUE(file) << core::describe(file.error());
        return file.value_or(sound::SoundBraceletFile{});
    }

    [[nodiscard]] testing::AssertionResult open(const sound::SoundBraceletFile& file) {
        auto opened = sound::openSoundBracelet(file, m_stop);
        if (!opened)
            return testing::AssertionFailure() << core::describe(opened.error());
        m_bracelet = std::move(*opened);
        m_bracelet->start(m_wakeup);
        return eventually([this] { return m_bracelet->connection() != 0; })
                   ? testing::AssertionSuccess()
                   : testing::AssertionFailure() << m_bracelet->status().message;
    }

    /// Error of a file with which nothing can be opened.
    core::Error errorOf(const sound::SoundBraceletFile& file) {
        const auto opened = sound::openSoundBracelet(file, m_stop);
        EXPECT_FALSE(opened);
        return opened ? core::Error{} : opened.error();
    }

    core::WriteOutcome write(const core::Drive& drive) {
        return m_bracelet->write({drive, 100, m_bracelet->connection()}).outcome;
    }

    /// Writes this drive, a frame every 20 ms, until so many followed each other: a busy machine without real
    /// time may miss periods, which ends the connection.
    [[nodiscard]] testing::AssertionResult drive(const core::Drive& drive, int frames) {
        constexpr int kAttempts = 20;
        for (int attempt = 0; attempt < kAttempts; ++attempt) {
            if (!eventually([this] { return m_bracelet->connection() != 0; }))
                break;
            int written = 0;
            while (written < frames && write(drive) == core::WriteOutcome::written) {
                ++written;
                std::this_thread::sleep_for(std::chrono::milliseconds(20));
            }
            if (written == frames && m_bracelet->connection() != 0)
                return testing::AssertionSuccess();
        }
        return testing::AssertionFailure() << m_bracelet->status().message;
    }

    /// Plays at full intensity until the condition holds, again after a missed period.
    template <typename Condition>
    [[nodiscard]] bool playUntil(playback::Player& player, const Condition& condition) {
        return eventually([&] {
            if (player.status().mode == playback::PlayerMode::idle && m_bracelet->connection() != 0)
                player.play({[](double) { return core::Intensities{1, 1, 1, 1, 1, 1}; },
                             std::numeric_limits<double>::infinity()});
            return condition();
        });
    }

    template <typename Condition>
    [[nodiscard]] bool eventually(const Condition& condition) {
        for (int i = 0; i < 2000; ++i) {
            if (condition())
                return true;
            m_wakeup.waitFor(std::chrono::milliseconds(5));
        }
        return condition();
    }

    core::StopSwitch m_stop;
    core::Wakeup m_wakeup;
    std::unique_ptr<core::BraceletLink> m_bracelet;
};

} // namespace teleta::peer
