// SPDX-License-Identifier: GPL-3.0-or-later
// The bracelet on a card of the kernel, "snd-aloop", whose other end gives back what is played. Runs in the
// virtual machine of tests/peer/vm, beside play_sound_until_killed.
#include "tests/peer/sound/sound_peer.h"

#include <alsa/asoundlib.h>
#include <array>
#include <atomic>
#include <cmath>
#include <csignal>
#include <fstream>
#include <mutex>
#include <numbers>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace teleta::peer {
namespace {

constexpr unsigned kRate_Hz = 48'000;
/// The card's clock ticks 250 times a second: 192 samples.
constexpr snd_pcm_uframes_t kPeriod = 2048;
constexpr std::size_t kRamp = 96;
constexpr const char* kCard = "alsa:hw:CARD=Loopback,DEV=0";
constexpr const char* kMore = "period_frames = 2048\n";
constexpr const char* kDriver = "/sys/bus/platform/drivers/snd_aloop/";

/// The other end of the card: all its outputs, until it is destroyed.
class OtherEnd {
public:
    explicit OtherEnd(unsigned channels)
        : m_channels(channels)
        , m_thread([this](const std::stop_token& stop) { run(stop); }) {}

    [[nodiscard]] std::vector<float> samples() const {
        const std::scoped_lock lock(m_mutex);
        return m_samples;
    }
    /// Periods in a row in which nothing was played.
    [[nodiscard]] int silentPeriods() const { return m_silent.load(); }
    [[nodiscard]] bool hears() const { return silentPeriods() == 0 && !samples().empty(); }

private:
    void run(const std::stop_token& stop) {
        snd_pcm_t* pcm = nullptr;
        while (!stop.stop_requested()) {
            if (pcm == nullptr && !open(pcm)) {
                std::this_thread::sleep_for(std::chrono::milliseconds(20));
                continue;
            }
            std::vector<float> period(kPeriod * m_channels);
            const snd_pcm_sframes_t read = snd_pcm_readi(pcm, period.data(), kPeriod);
            if (read < 0) {
                // Nobody plays, or what is played has another format.
                snd_pcm_close(std::exchange(pcm, nullptr));
                continue;
            }
            period.resize(static_cast<std::size_t>(read) * m_channels);
            const bool silent = std::ranges::all_of(period, [](float sample) { return sample == 0.0F; });
            m_silent.store(silent ? m_silent.load() + 1 : 0);
            const std::scoped_lock lock(m_mutex);
            m_samples.insert(m_samples.end(), period.begin(), period.end());
        }
        if (pcm != nullptr)
            snd_pcm_close(pcm);
    }
    bool open(snd_pcm_t*& pcm) const {
        if (snd_pcm_open(&pcm, "hw:CARD=Loopback,DEV=1", SND_PCM_STREAM_CAPTURE, 0) < 0) {
            pcm = nullptr;
            return false;
        }
        if (snd_pcm_set_params(pcm, SND_PCM_FORMAT_FLOAT, SND_PCM_ACCESS_RW_INTERLEAVED, m_channels, kRate_Hz,
                               0, 500'000) < 0 ||
            snd_pcm_start(pcm) < 0) {
            snd_pcm_close(std::exchange(pcm, nullptr));
            return false;
        }
        return true;
    }

    unsigned m_channels;
    mutable std::mutex m_mutex;
    std::vector<float> m_samples; ///< guarded by m_mutex
    std::atomic<int> m_silent{0};
    std::jthread m_thread;
};

void tellDriver(const char* what) {
    std::ofstream(std::string(kDriver) + what) << "snd_aloop.0" << std::flush;
}

class AlsaCardPeer : public SoundPeer {
protected:
    /// Sets the drive for so long; false: the connection was lost, as when a busy machine missed a period.
    bool hold(const core::Drive& drive, int times) {
        for (int i = 0; i < times; ++i) {
            if (m_bracelet->write({drive, 1000, m_bracelet->connection()}).outcome !=
                core::WriteOutcome::written)
                return false;
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
        }
        return true;
    }
};

} // namespace

TEST_F(AlsaCardPeer, playsEachTactorOnItsOutputSampleBySample) {
    sound::SoundBraceletFile file = fileOf(kCard, kMore);
    constexpr std::array<std::size_t, 6> kOutputs{7, 2, 3, 6, 5, 4}; // of 8, from 0
    for (std::size_t i = 0; i < kOutputs.size(); ++i)
        file.channels[i] = static_cast<std::uint32_t>(kOutputs[i] + 1);
    for (int attempt = 0; attempt < 10; ++attempt) {
        ASSERT_TRUE(open(file));
        OtherEnd other(8);
        std::this_thread::sleep_for(std::chrono::milliseconds(500));
        const bool held = hold(kSome, 20);
        m_bracelet.reset();
        if (!held)
            continue;
        const std::vector<float> played = other.samples();
        const auto heard = std::ranges::find_if(played, [](float sample) { return sample != 0.0F; });
        ASSERT_NE(heard, played.end());
        // The first sample of a tone is 0.
        const std::size_t begin = static_cast<std::size_t>(heard - played.begin()) / 8 - 1;
        ASSERT_GT(played.size() / 8, begin + 9600);
        for (std::size_t n = 0; n < 9600; ++n) {
            const double ramp =
                n < kRamp ? 0.5 * (1.0 - std::cos(std::numbers::pi * static_cast<double>(n) / kRamp)) : 1.0;
            const double tone = std::sin(2.0 * std::numbers::pi * 250.0 * static_cast<double>(n) / kRate_Hz);
            std::array<double, 8> expected{};
            for (std::size_t i = 0; i < kOutputs.size(); ++i)
                expected[kOutputs[i]] = 0.5 * ramp * tone * kSome[i] / core::kFullDrive;
            for (std::size_t output = 0; output < 8; ++output)
                ASSERT_NEAR(played[(begin + n) * 8 + output], expected[output], 1e-6)
                    << "sample " << n << ", output " << output + 1;
        }
        return;
    }
    FAIL() << "the machine missed periods each time";
}

TEST_F(AlsaCardPeer, isTakenByOneProgram) {
    ASSERT_TRUE(open(fileOf(kCard, kMore)));
    const core::Error error = errorOf(fileOf(kCard, kMore));
    EXPECT_EQ(error.kind, core::ErrorKind::refused) << core::describe(error);
    EXPECT_FALSE(error.expected.empty());
}

TEST_F(AlsaCardPeer, refusesWhatTheCardCannotPlay) {
    sound::SoundBraceletFile file = fileOf(kCard, kMore);
    file.channels[5] = 200;
    const core::Error error = errorOf(file);
    EXPECT_EQ(error.kind, core::ErrorKind::refused);
    EXPECT_NE(error.message.find("32"), std::string::npos) << "its outputs: " << error.message;
}

TEST_F(AlsaCardPeer, isSilentWhenTheProgramIsKilled) {
    std::ofstream("/tmp/coils.toml") << "kind = 'sound_bracelet'\nname = 'x'\ndevice = '" << kCard
                                     << "'\nchannels = [1, 2, 3, 4, 5, 6]\n"
                                     << kMore;
    const pid_t child = fork();
    if (child == 0) {
        execl("/test/play_sound_until_killed", "play_sound_until_killed", "/tmp/coils.toml", nullptr);
        _exit(1);
    }
    OtherEnd other(6);
    EXPECT_TRUE(eventually([&] { return other.hears(); }));
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    // The card stops: what its other end still reads is silence, and the next program has it at once.
    ASSERT_TRUE(open(fileOf(kCard, kMore)));
    EXPECT_TRUE(eventually([&] { return other.silentPeriods() > 5; }));
}

TEST_F(AlsaCardPeer, isLostWhenTheCardIsUnpluggedAndComesBackSilent) {
    ASSERT_TRUE(open(fileOf(kCard, kMore)));
    const std::uint64_t before = m_bracelet->connection();
    (void)hold(kSome, 4);
    std::jthread unplug([] { tellDriver("unbind"); });
    EXPECT_TRUE(eventually([this] { return m_bracelet->connection() == 0; }));
    unplug.join();
    EXPECT_FALSE(m_bracelet->status().message.empty());
    tellDriver("bind");
    EXPECT_TRUE(eventually([this] { return m_bracelet->connection() != 0; }));
    EXPECT_EQ(m_bracelet->write({kSome, 1000, before}).outcome, core::WriteOutcome::refused);
    EXPECT_TRUE(core::isOff(m_bracelet->telemetry().written));
}

} // namespace teleta::peer
