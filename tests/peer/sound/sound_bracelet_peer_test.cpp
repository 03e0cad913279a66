// SPDX-License-Identifier: GPL-3.0-or-later
// The bracelet on a sound card against PipeWire: a sink of six outputs that nobody hears, whose monitor a
// second client records. Runs in with_sound_session.sh.
#include "backend/core/steady_time.h"
#include "backend/playback/player.h"
#include "tests/backend/core/temporary_folder.h"
#include "tests/peer/sound/monitor_recorder.h"
#include "tests/peer/sound/sound_peer.h"
#include "tests/peer/sound/sound_server.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <csignal>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

namespace teleta::peer {
namespace {

constexpr std::size_t kPeriod = 128;
constexpr double kRate_Hz = 48'000.0;
constexpr std::size_t kRamp = 96;
constexpr std::array<double, 6> kCarriers_Hz{180, 210, 240, 270, 300, 330};
constexpr std::array<double, 6> kGains{1.0, 0.9, 0.8, 0.7, 0.6, 0.5};
/// Tactor i is on this output, from 0.
constexpr std::array<std::size_t, 6> kOutputs{2, 0, 1, 5, 4, 3};

std::array<std::string, 6> monitors() {
    std::array<std::string, 6> ports;
    for (std::size_t i = 0; i < ports.size(); ++i)
        ports[i] = "tactors:monitor_AUX" + std::to_string(i);
    return ports;
}

double share(std::uint16_t drive) {
    return static_cast<double>(drive) / core::kFullDrive;
}

double raisedCosine(double from, double to, std::size_t frame) {
    return frame >= kRamp
               ? to
               : from + (to - from) *
                            (1.0 - std::cos(std::numbers::pi * static_cast<double>(frame) / kRamp)) / 2.0;
}

/// A sample of a tactor so many samples after it was at rest, whose drive changed at `change`.
double sampleOf(std::size_t tactor, std::size_t frame, std::size_t change, const core::Drive& before,
                const core::Drive& after) {
    const double drive = frame < change
                             ? raisedCosine(0.0, share(before[tactor]), frame)
                             : raisedCosine(share(before[tactor]), share(after[tactor]), frame - change);
    return 0.5 * kGains[tactor] * drive *
           std::sin(2.0 * std::numbers::pi * kCarriers_Hz[tactor] * static_cast<double>(frame) / kRate_Hz);
}

constexpr core::Drive kOther{3000, 4095, 100, 500, 4000, 2047};

/// What was recorded of the tactors with what the formula says.
void compare(const std::array<std::vector<float>, 6>& played) {
    // The first sample of a tone is 0, the second one is not.
    std::size_t first = played[0].size();
    for (const std::vector<float>& tactor : played)
        for (std::size_t n = 0; n < first; ++n)
            if (tactor[n] != 0.0F)
                first = n;
    ASSERT_LT(first, played[0].size());
    const std::size_t begin = first - 1;
    EXPECT_EQ(begin % kPeriod, 0U) << "a setpoint begins with a period";
    const std::size_t frames = played[0].size() - begin;
    const auto worst = [&](std::size_t change, std::size_t from, std::size_t until) {
        double most = 0.0;
        for (std::size_t i = 0; i < played.size(); ++i)
            for (std::size_t n = from; n < until; ++n)
                most = std::max(most, std::abs(sampleOf(i, n, change, kSome, kOther) -
                                               static_cast<double>(played[i][begin + n])));
        return most;
    };
    // The second setpoint was taken at a period.
    std::size_t change = kPeriod;
    while (change + kPeriod < frames && worst(change, change, change + kPeriod) > 1e-6)
        change += kPeriod;
    ASSERT_LT(change + kPeriod, frames);
    EXPECT_NEAR(static_cast<double>(change) / kRate_Hz, 0.2, 0.1);
    ASSERT_LT(change + 4800, frames);
    EXPECT_LT(worst(change, 0, change + 4800), 1e-6) << "all six, sample by sample";
}

class SoundBraceletPeer : public SoundPeer {
protected:
    static void SetUpTestSuite() {
        s_server = std::make_unique<SoundServer>();
        ASSERT_TRUE(s_server->start());
    }
    static void TearDownTestSuite() { s_server.reset(); }

    void SetUp() override { ASSERT_TRUE(s_server); }

    [[nodiscard]] bool record() {
        return m_recorder.start(sound::pipeWireLibraries().front(), monitors(), kPeriod);
    }

    /// The same without a second attempt.
    bool hold(const core::Drive& drive, int frames) {
        for (int i = 0; i < frames; ++i) {
            if (write(drive) != core::WriteOutcome::written)
                return false;
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
        }
        return true;
    }

    static std::unique_ptr<SoundServer> s_server;
    MonitorRecorder m_recorder{20 * 48'000};
};
std::unique_ptr<SoundServer> SoundBraceletPeer::s_server;

} // namespace

TEST_F(SoundBraceletPeer, playsEachTactorOnItsOutputSampleBySample) {
    sound::SoundBraceletFile file = fileOf("pipewire:tactors", "carrier_Hz = [180, 210, 240, 270, 300, 330]\n"
                                                               "gain = [1.0, 0.9, 0.8, 0.7, 0.6, 0.5]\n");
    for (std::size_t i = 0; i < kOutputs.size(); ++i)
        file.channels[i] = static_cast<std::uint32_t>(kOutputs[i] + 1);
    // A busy machine may miss periods, as client or as recorder: then there is nothing to compare.
    using Clock = std::chrono::steady_clock;
    for (const auto end = Clock::now() + std::chrono::seconds(60); Clock::now() < end;
         std::this_thread::sleep_for(std::chrono::milliseconds(200))) {
        ASSERT_TRUE(open(file));
        MonitorRecorder recorder(5 * 48'000);
        ASSERT_TRUE(recorder.start(sound::pipeWireLibraries().front(), monitors(), kPeriod));
        const bool driven = hold(kSome, 10) && hold(kOther, 10) && write({}) == core::WriteOutcome::written &&
                            eventually([&] { return recorder.silentFor() > 4800; });
        const std::uint64_t missed =
            m_bracelet->telemetry().board.sound->missedPeriods + recorder.missedPeriods();
        recorder.stop();
        m_bracelet.reset();
        if (missed > 0 || !driven)
            continue;
        std::array<std::vector<float>, 6> played;
        for (std::size_t i = 0; i < played.size(); ++i)
            played[i] = recorder.samples(kOutputs[i]);
        return compare(played);
    }
    FAIL() << "the machine missed periods each time";
}

TEST_F(SoundBraceletPeer, statesItsLatencyAndWhatItsCallbackCosts) {
    ASSERT_TRUE(open(fileOf("pipewire:tactors")));
    const double stated_s = m_bracelet->description().statedLatency_s;
    EXPECT_GE(stated_s, 2.0 * kPeriod / kRate_Hz);
    EXPECT_LT(stated_s, 0.1);
    ASSERT_TRUE(drive(kSome, 10));
    const core::BraceletTelemetry telemetry = m_bracelet->telemetry();
    ASSERT_TRUE(telemetry.board.sound);
    EXPECT_TRUE(telemetry.board.driving);
    EXPECT_GT(telemetry.board.sound->meanShare, 0.0);
    EXPECT_LT(telemetry.board.sound->meanShare, 1.0);
    EXPECT_GT(telemetry.board.sound->played_ns, 0);
    EXPECT_GT(telemetry.framesEchoed, 8U);
    EXPECT_EQ(telemetry.strayEchoes, 0U);
}

TEST_F(SoundBraceletPeer, playsPatternsUnderTheSafetyLimits) {
    ASSERT_TRUE(open(fileOf("pipewire:tactors")));
    ASSERT_TRUE(record());
    playback::Player player(*m_bracelet, m_stop);
    ASSERT_TRUE(eventually([&] {
        if (player.status().mode == playback::PlayerMode::idle && m_bracelet->connection() != 0 &&
            player.status().ending != playback::PlayerEnding::finished)
            player.play({[](double) { return core::Intensities{1, 1, 1, 1, 1, 1}; }, 0.5});
        return player.status().ending == playback::PlayerEnding::finished;
    }));
    EXPECT_TRUE(player.counters().confirmed);
    ASSERT_TRUE(eventually([this] { return m_recorder.silentFor() > 4800; }));
    const std::vector<float> played = m_recorder.samples(0);
    EXPECT_NEAR(*std::ranges::max_element(played), 0.5F, 1e-3F);
}

TEST_F(SoundBraceletPeer, isSilentOnStopAndGoesOnOnlyWhenAsked) {
    ASSERT_TRUE(open(fileOf("pipewire:tactors")));
    ASSERT_TRUE(record());
    playback::Player player(*m_bracelet, m_stop);
    ASSERT_TRUE(playUntil(player, [this] { return m_recorder.hears(); }));
    m_stop.engage();
    EXPECT_TRUE(eventually([this] { return m_recorder.silentFor() > 9600; }));
    EXPECT_EQ(player.status().ending, playback::PlayerEnding::stopSwitch);
    m_recorder.arm();
    m_stop.release();
    const std::size_t before = m_recorder.silentFor();
    EXPECT_TRUE(eventually([&] { return m_recorder.silentFor() > before + 9600; }));
    EXPECT_EQ(m_recorder.heard_ns(), 0) << "not even for a moment";
    EXPECT_TRUE(playUntil(player, [this] { return m_recorder.hears(); }));
}

TEST_F(SoundBraceletPeer, leavesSilenceWhenTheProgramIsKilled) {
    const test::TemporaryFolder folder;
    const std::string path = folder.write(
        "coils.toml",
        "kind = 'sound_bracelet'\nname = 'x'\ndevice = 'pipewire:tactors'\nchannels = [1, 2, 3, 4, 5, 6]\n");
    ASSERT_TRUE(record());
    test::PeerProcess player;
    player.start(QStringLiteral(TELETA_PLAY_UNTIL_KILLED), {QString::fromStdString(path)});
    ASSERT_TRUE(eventually([this] { return m_recorder.hears(); })) << player.errors();
    player.kill();
    EXPECT_TRUE(eventually([this] { return m_recorder.silentFor() > 24'000; }));
    // The card is free at once.
    ASSERT_TRUE(open(fileOf("pipewire:tactors")));
    ASSERT_TRUE(drive(kSome, 10));
    EXPECT_TRUE(m_recorder.hears());
}

TEST_F(SoundBraceletPeer, isSilentWhileTheProgramIsSuspendedAndAfterwards) {
    const test::TemporaryFolder folder;
    const std::string path = folder.write(
        "coils.toml",
        "kind = 'sound_bracelet'\nname = 'x'\ndevice = 'pipewire:tactors'\nchannels = [1, 2, 3, 4, 5, 6]\n");
    ASSERT_TRUE(record());
    test::PeerProcess player;
    player.start(QStringLiteral(TELETA_PLAY_UNTIL_KILLED), {QString::fromStdString(path)});
    ASSERT_TRUE(eventually([this] { return m_recorder.hears(); })) << player.errors();
    const auto process = static_cast<pid_t>(player.processId());
    ::kill(process, SIGSTOP);
    EXPECT_TRUE(eventually([this] { return m_recorder.silentFor() > 24'000; }));
    m_recorder.arm();
    ::kill(process, SIGCONT);
    const std::size_t before = m_recorder.silentFor();
    EXPECT_TRUE(eventually([&] { return m_recorder.silentFor() > before + 24'000; })) << "nothing resumes";
    EXPECT_EQ(m_recorder.heard_ns(), 0) << "not even for a moment";
}

TEST_F(SoundBraceletPeer, isLostWithTheServerAndComesBackSilent) {
    ASSERT_TRUE(open(fileOf("pipewire:tactors")));
    const std::uint64_t before = m_bracelet->connection();
    playback::Player player(*m_bracelet, m_stop);
    ASSERT_TRUE(playUntil(player, [this] { return m_bracelet->telemetry().board.driving; }));
    s_server->kill();
    EXPECT_TRUE(eventually([this] { return m_bracelet->connection() == 0; }));
    EXPECT_TRUE(eventually([&] { return player.status().ending == playback::PlayerEnding::deviceLost; }));
    EXPECT_FALSE(m_bracelet->status().message.empty());
    EXPECT_EQ(m_bracelet->write({kSome, 100, before}).outcome, core::WriteOutcome::lost);
    ASSERT_TRUE(s_server->start());
    EXPECT_TRUE(eventually([this] { return m_bracelet->connection() != 0; }));
    ASSERT_TRUE(record());
    EXPECT_TRUE(eventually([this] { return m_recorder.silentFor() > 24'000; })) << "nothing plays by itself";
    EXPECT_EQ(m_recorder.heard_ns(), 0);
    EXPECT_EQ(m_bracelet->write({kSome, 100, before}).outcome, core::WriteOutcome::refused);
    ASSERT_TRUE(drive(kSome, 10));
    EXPECT_TRUE(m_recorder.hears());
}

TEST_F(SoundBraceletPeer, isLostWhenTheCardIsUnpluggedAndComesBackSilent) {
    ASSERT_TRUE(open(fileOf("pipewire:tactors")));
    ASSERT_TRUE(drive(kSome, 5));
    const std::uint64_t before = m_bracelet->connection();
    ASSERT_TRUE(s_server->destroySink());
    EXPECT_TRUE(eventually([&] { return m_bracelet->connection() != before; }));
    EXPECT_EQ(write(kSome), core::WriteOutcome::lost);
    ASSERT_TRUE(s_server->createSink());
    EXPECT_TRUE(eventually([this] { return m_bracelet->connection() != 0; }));
    ASSERT_TRUE(record());
    EXPECT_TRUE(eventually([this] { return m_recorder.silentFor() > 24'000; }));
    EXPECT_EQ(m_recorder.heard_ns(), 0);
    EXPECT_EQ(m_bracelet->write({kSome, 100, before}).outcome, core::WriteOutcome::refused);
    ASSERT_TRUE(drive(kSome, 10));
    EXPECT_TRUE(m_recorder.hears());
}

TEST_F(SoundBraceletPeer, sharesTheCardOnlyWhereTheFileSaysSo) {
    const auto jack = sound::loadJack(sound::pipeWireLibraries().front());
    ASSERT_TRUE(jack);
    sound::JackClient* other = jack->clientOpen("music", sound::kJackNoStartServer, nullptr);
    ASSERT_NE(other, nullptr);
    ASSERT_NE(jack->portRegister(other, "out", sound::kJackAudio, sound::kJackPortIsOutput, 0), nullptr);
    jack->setProcess(
        other, [](std::uint32_t, void*) { return 0; }, nullptr);
    ASSERT_EQ(jack->activate(other), 0);

    ASSERT_TRUE(open(fileOf("pipewire:tactors")));
    ASSERT_TRUE(drive(kSome, 3));
    const std::uint64_t before = m_bracelet->connection();
    ASSERT_EQ(jack->connect(other, "music:out", "tactors:playback_AUX5"), 0);
    EXPECT_TRUE(eventually([&] { return m_bracelet->connection() != before; }));
    m_bracelet.reset();

    const core::Error shared = errorOf(fileOf("pipewire:tactors"));
    EXPECT_EQ(shared.kind, core::ErrorKind::refused);
    EXPECT_NE(shared.expected.find("shared = true"), std::string::npos) << core::describe(shared);
    ASSERT_TRUE(open(fileOf("pipewire:tactors", "shared = true\n")));
    ASSERT_TRUE(drive(kSome, 3));
    jack->clientClose(other);
}

TEST_F(SoundBraceletPeer, refusesACardThatIsNotAsTheFileSays) {
    const core::Error rate = errorOf(fileOf("pipewire:tactors", "sample_rate_Hz = 44100\n"));
    EXPECT_EQ(rate.kind, core::ErrorKind::refused);
    EXPECT_NE(rate.expected.find("sample_rate_Hz = 48000"), std::string::npos) << core::describe(rate);
    sound::SoundBraceletFile file = fileOf("pipewire:tactors");
    file.channels[5] = 7;
    const core::Error channel = errorOf(file);
    EXPECT_EQ(channel.kind, core::ErrorKind::refused);
    EXPECT_NE(core::describe(channel).find('7'), std::string::npos) << core::describe(channel);
    const core::Error missing = errorOf(fileOf("pipewire:no such card"));
    EXPECT_EQ(missing.kind, core::ErrorKind::unavailable);
    EXPECT_NE(missing.expected.find("tactors"), std::string::npos) << core::describe(missing);
    ASSERT_TRUE(open(fileOf("pipewire"))) << "the only card there is";
    m_bracelet.reset();
    ASSERT_TRUE(s_server->createSink(QStringLiteral("second")));
    const core::Error several = errorOf(fileOf("pipewire"));
    EXPECT_TRUE(s_server->destroySink(QStringLiteral("second")));
    EXPECT_EQ(several.kind, core::ErrorKind::refused);
    EXPECT_NE(several.message.find("second"), std::string::npos) << core::describe(several);
}

TEST_F(SoundBraceletPeer, takesThePeriodOfTheFile) {
    for (const std::uint32_t frames : {64U, 256U}) {
        sound::SoundBraceletFile file = fileOf("pipewire:tactors");
        file.period_frames = frames;
        ASSERT_TRUE(open(file));
        ASSERT_TRUE(drive(kSome, 3));
        EXPECT_NEAR(m_bracelet->description().statedLatency_s, 2.0 * frames / kRate_Hz,
                    2.0 * frames / kRate_Hz);
        m_bracelet.reset();
    }
}

TEST_F(SoundBraceletPeer, isProbedAndPlayedAtTheCommandLine) {
    const test::TemporaryFolder folder;
    const std::string path =
        folder.write("coils.toml", "kind = 'sound_bracelet'\nname = 'voice coils'\ndevice = "
                                   "'pipewire:tactors'\nchannels = [1, 2, 3, 4, 5, 6]\n");
    // A busy machine may miss a period, which ends the playing.
    const auto json = [](const QStringList& arguments) {
        using Clock = std::chrono::steady_clock;
        std::string errors;
        for (const auto end = Clock::now() + std::chrono::seconds(60); Clock::now() < end;
             std::this_thread::sleep_for(std::chrono::milliseconds(200))) {
            QProcess teleta;
            teleta.start(QStringLiteral(TELETA_PROGRAM), arguments);
            if (teleta.waitForFinished() && teleta.exitCode() == 0)
                return nlohmann::json::parse(teleta.readAllStandardOutput().toStdString(), nullptr, false);
            errors += teleta.readAllStandardError().toStdString();
        }
        ADD_FAILURE() << errors;
        return nlohmann::json();
    };
    const nlohmann::json probed = json({QStringLiteral("devices"), QStringLiteral("--probe"),
                                        QString::fromStdString(path), QStringLiteral("--json")});
    ASSERT_TRUE(probed.contains("devices"));
    const nlohmann::json& device = probed["devices"][0];
    EXPECT_EQ(device["kind"], "sound_bracelet");
    EXPECT_EQ(device["name"], "voice coils");
    EXPECT_TRUE(device["connected"]);
    EXPECT_EQ(device["frame_rate_hz"], 200.0);
    ASSERT_TRUE(record());
    const nlohmann::json played =
        json({QStringLiteral("pattern"), QStringLiteral("play"), QStringLiteral("shape.A.static"),
              QStringLiteral("--device"), QString::fromStdString(path), QStringLiteral("--json")});
    EXPECT_EQ(played["bracelet"], "voice coils");
    EXPECT_EQ(played["simulated"], false);
    ASSERT_TRUE(played.contains("sound"));
    EXPECT_TRUE(played["sound"].contains("missed_periods"));
    EXPECT_GT(played["sound"]["stated_latency_s"], 0.0);
    EXPECT_TRUE(played["sound"]["measured_latency_s"].is_null());
    EXPECT_TRUE(played["sound"]["measured_latency_spread_s"].is_null());
    const std::vector<float> samples = m_recorder.samples(0);
    EXPECT_GT(*std::ranges::max_element(samples), 0.1F);
}

} // namespace teleta::peer
