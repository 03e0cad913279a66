// SPDX-License-Identifier: GPL-3.0-or-later
// The bracelet on JACK's own server, whose driver "dummy" misses periods as soon as it is held.
#include "tests/peer/sound/sound_peer.h"
#include "tests/peer/sound/sound_server.h"

namespace teleta::peer {
namespace {

class SoundJackPeer : public SoundPeer {
protected:
    void SetUp() override { ASSERT_TRUE(m_server.start()); }
    JackServer m_server;
};

} // namespace

TEST_F(SoundJackPeer, playsOnTheSystemsOutputs) {
    ASSERT_TRUE(open(fileOf("jack:system")));
    EXPECT_EQ(m_bracelet->description().model.find("system") != std::string::npos, true);
    ASSERT_EQ(write(kSome), core::WriteOutcome::written);
    EXPECT_TRUE(eventually([this] { return m_bracelet->telemetry().framesEchoed > 1; }));
}

TEST_F(SoundJackPeer, endsWhatIsDrivenWhenPeriodsAreMissed) {
    ASSERT_TRUE(open(fileOf("jack")));
    const std::uint64_t before = m_bracelet->connection();
    ASSERT_EQ(write(kSome), core::WriteOutcome::written);
    ASSERT_TRUE(eventually(
        [&] { return m_bracelet->telemetry().board.driving || m_bracelet->connection() != before; }));
    // Shorter than the time-out of the frame, so that it is still driven afterwards.
    m_server.hold(50);
    // A new connection, for which nobody asked for anything yet.
    EXPECT_TRUE(
        eventually([&] { return m_bracelet->connection() != 0 && m_bracelet->connection() != before; }));
    EXPECT_EQ(m_bracelet->write({kSome, 100, before}).outcome, core::WriteOutcome::refused);
    EXPECT_TRUE(core::isOff(m_bracelet->telemetry().written));
}

TEST_F(SoundJackPeer, isLostWithTheServer) {
    ASSERT_TRUE(open(fileOf("jack:system")));
    m_server.kill();
    EXPECT_TRUE(eventually([this] { return m_bracelet->connection() == 0; }));
    EXPECT_TRUE(eventually([this] { return m_bracelet->status().state == core::DeviceState::reconnecting; }));
}

} // namespace teleta::peer
