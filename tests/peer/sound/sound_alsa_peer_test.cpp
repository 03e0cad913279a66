// SPDX-License-Identifier: GPL-3.0-or-later
// The bracelet on a PCM of ALSA with a clock: the plugin that leads to PipeWire. It mixes its channels as it
// likes, so that only the beginning and the end of sound are looked at.
#include "backend/playback/player.h"
#include "tests/peer/sound/monitor_recorder.h"
#include "tests/peer/sound/sound_peer.h"
#include "tests/peer/sound/sound_server.h"

#include <limits>

namespace teleta::peer {
namespace {

class SoundAlsaPeer : public SoundPeer {
protected:
    static constexpr std::uint32_t kPeriod = 256;

    void SetUp() override { ASSERT_TRUE(m_server.start()); }
    void TearDown() override {
        m_bracelet.reset();
        m_recorder.stop();
    }

    [[nodiscard]] bool record() {
        std::array<std::string, MonitorRecorder::kChannels> ports;
        for (std::size_t i = 0; i < ports.size(); ++i)
            ports[i] = "tactors:monitor_AUX" + std::to_string(i);
        return m_recorder.start(sound::pipeWireLibraries().front(), ports, kPeriod);
    }

    SoundServer m_server;
    MonitorRecorder m_recorder{0};
};

const char* const kShared = "shared = true\nperiod_frames = 256\n";

} // namespace

TEST_F(SoundAlsaPeer, isRefusedWhereOthersCanPlayAsWell) {
    const core::Error error = errorOf(fileOf("alsa:pipewire"));
    EXPECT_EQ(error.kind, core::ErrorKind::refused);
    EXPECT_NE(error.expected.find("shared = true"), std::string::npos) << core::describe(error);
}

TEST_F(SoundAlsaPeer, playsAndIsSilentOnStop) {
    ASSERT_TRUE(open(fileOf("alsa:pipewire", kShared)));
    ASSERT_TRUE(record());
    const std::size_t before = m_recorder.silentFor();
    EXPECT_TRUE(eventually([&] { return m_recorder.silentFor() > before + 4800; }))
        << "nothing was asked for";
    playback::Player player(*m_bracelet, m_stop);
    EXPECT_TRUE(
        playUntil(player, [this] { return m_recorder.hears() && m_bracelet->telemetry().board.driving; }));
    m_stop.engage();
    EXPECT_TRUE(eventually([this] { return m_recorder.silentFor() > 9600; }));
    EXPECT_GE(m_bracelet->description().statedLatency_s, 3.0 * kPeriod / 48'000.0);
}

TEST_F(SoundAlsaPeer, isLostWithTheCardAndAsksForItAgain) {
    ASSERT_TRUE(open(fileOf("alsa:pipewire", kShared)));
    const std::uint64_t before = m_bracelet->connection();
    ASSERT_EQ(write(kSome), core::WriteOutcome::written);
    m_server.kill();
    EXPECT_TRUE(eventually([this] { return m_bracelet->connection() == 0; }));
    ASSERT_TRUE(m_server.start());
    EXPECT_TRUE(eventually([this] { return m_bracelet->connection() != 0; }));
    EXPECT_EQ(m_bracelet->write({kSome, 100, before}).outcome, core::WriteOutcome::refused);
}

} // namespace teleta::peer
