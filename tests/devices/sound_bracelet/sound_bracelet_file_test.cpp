// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/described/described_bracelet.h"
#include "devices/sound_bracelet/sound_bracelet_file.h"
#include "tests/backend/core/temporary_folder.h"

#include <gtest/gtest.h>

#include <string>

namespace teleta::sound {
namespace {

constexpr const char* kLeast = "kind = \"sound_bracelet\"\n"
                               "name = \"voice coils\"\n"
                               "device = \"pipewire:tactors\"\n"
                               "channels = [3, 4, 5, 6, 7, 8]\n";

core::Error errorOf(const std::string& text) {
    const auto read = parseSoundBracelet(text, "coils.toml");
    EXPECT_FALSE(read) << text;
    return read ? core::Error{} : read.error();
}

/// Of a file that is right but for its fifth line.
core::Error errorWith(const std::string& line) {
    const core::Error error = errorOf(kLeast + line + '\n');
    EXPECT_EQ(error.kind, core::ErrorKind::badInput) << line;
    EXPECT_EQ(error.where.file, "coils.toml");
    EXPECT_EQ(error.where.line, 5) << line << ": " << error.message;
    EXPECT_GT(error.where.column, 0);
    EXPECT_FALSE(error.expected.empty()) << line;
    return error;
}

SoundBraceletFile read(const std::string& text) {
    const auto read = parseSoundBracelet(text, "coils.toml");
    EXPECT_TRUE(read) << core::describe(read.error());
    return read ? *read : SoundBraceletFile{};
}

} // namespace

TEST(SoundBraceletFile, needsLittle) {
    const SoundBraceletFile file = read(kLeast);
    EXPECT_EQ(file.name, "voice coils");
    EXPECT_EQ(file.address, (SoundAddress{SoundApi::pipeWire, "tactors"}));
    EXPECT_EQ(file.sampleRate_Hz, 48'000U);
    EXPECT_EQ(file.period_frames, 128U);
    EXPECT_EQ(file.channels, (std::array<std::uint32_t, 6>{3, 4, 5, 6, 7, 8}));
    EXPECT_FALSE(file.shared);
    EXPECT_FALSE(file.latency_ms);
    EXPECT_FALSE(file.latencySpread_ms);
    for (const ToneSettings& tone : file.tones)
        EXPECT_EQ(tone, (ToneSettings{.carrier_Hz = 250.0, .fullScale = 0.5, .gain = 1.0, .ramp_s = 0.002}));
    EXPECT_DOUBLE_EQ(file.period_s(), 128.0 / 48'000.0);
}

TEST(SoundBraceletFile, readsEveryKey) {
    const SoundBraceletFile file = read("kind = \"sound_bracelet\"\n"
                                        "name = \"mine\"\n"
                                        "device = \"alsa:hw:CARD=UMC1820\"\n"
                                        "sample_rate_Hz = 96000\n"
                                        "period_frames = 256\n"
                                        "channels = [6, 5, 4, 3, 2, 1]\n"
                                        "carrier_Hz = [200, 210, 220, 230.5, 240, 250]\n"
                                        "waveform = \"sine\"\n"
                                        "full_scale = 0.9\n"
                                        "gain = [1.0, 0.9, 0.8, 0.7, 0.6, 0.0]\n"
                                        "ramp_ms = 5\n"
                                        "latency_ms = 7.5\n"
                                        "latency_spread_ms = 1.25\n"
                                        "shared = true\n");
    EXPECT_EQ(file.latency_ms, 7.5);
    EXPECT_EQ(file.latencySpread_ms, 1.25);
    EXPECT_EQ(file.address, (SoundAddress{SoundApi::alsa, "hw:CARD=UMC1820"})) << "up to the first colon";
    EXPECT_EQ(file.sampleRate_Hz, 96'000U);
    EXPECT_EQ(file.period_frames, 256U);
    EXPECT_EQ(file.channels[0], 6U);
    EXPECT_TRUE(file.shared);
    EXPECT_EQ(file.tones[3],
              (ToneSettings{.carrier_Hz = 230.5, .fullScale = 0.9, .gain = 0.7, .ramp_s = 0.005}));
    EXPECT_EQ(file.tones[5].gain, 0.0);
    EXPECT_EQ(read(std::string(kLeast) + "carrier_Hz = 300\n").tones[5].carrier_Hz, 300.0)
        << "one number is for all";
    const auto levels =
        read(std::string(kLeast) + "level_Hz = [167, 188, 208, 229, 250]\n").tones[2].level_Hz;
    EXPECT_EQ(levels, (LevelFrequencies{167, 188, 208, 229, 250}));
}

TEST(SoundBraceletFile, namesACardByOneOfThreeWays) {
    const auto address = [](const std::string& device) {
        std::string text = kLeast;
        text.replace(text.find("pipewire:tactors"), 16, device);
        return read(text).address;
    };
    EXPECT_EQ(address("pipewire"), (SoundAddress{SoundApi::pipeWire, ""}));
    EXPECT_EQ(address("jack"), (SoundAddress{SoundApi::jack, ""}));
    EXPECT_EQ(address("jack:system"), (SoundAddress{SoundApi::jack, "system"}));
    EXPECT_EQ(address("alsa:plughw:1,0"), (SoundAddress{SoundApi::alsa, "plughw:1,0"}));
    for (const std::string wrong : {"pipewire:", "alsa", "alsa:", "pulse:x", "hw:1", ":", "PipeWire"}) {
        std::string text = kLeast;
        text.replace(text.find("pipewire:tactors"), 16, wrong);
        const core::Error error = errorOf(text);
        EXPECT_EQ(error.where.line, 3) << wrong;
        EXPECT_NE(error.expected.find("alsa:PCM"), std::string::npos);
    }
}

TEST(SoundBraceletFile, saysWhatIsWrongAndWhere) {
    for (const char* line : {"sample_rate_Hz = 22050",
                             "sample_rate_Hz = 45000",
                             "sample_rate_Hz = \"48000\"",
                             "period_frames = 100",
                             "period_frames = 8",
                             "period_frames = 4096",
                             "period_frames = 128.5",
                             "carrier_Hz = 19.9",
                             "carrier_Hz = 1000.1",
                             "carrier_Hz = nan",
                             "carrier_Hz = [250, 250]",
                             "carrier_Hz = [250, 250, 250, 250, 250, 2500]",
                             "carrier_Hz = []",
                             "carrier_Hz = \"low\"",
                             "level_Hz = [167, 188, 208, 229]",
                             "level_Hz = [167, 188, 208, 250, 229]",
                             "level_Hz = [10, 188, 208, 229, 250]",
                             "waveform = \"square\"",
                             "full_scale = 0",
                             "full_scale = 0.91",
                             "full_scale = inf",
                             "gain = [1, 1, 1, 1, 1]",
                             "gain = [1, 1, 1, 1, 1, 1.1]",
                             "gain = [1, 1, 1, 1, 1, -0.1]",
                             "gain = 1",
                             "ramp_ms = 0.9",
                             "ramp_ms = 20.1",
                             "shared = 1",
                             "latency_ms = -1",
                             "latency_ms = 501",
                             "latency_spread_ms = 1",
                             "chanels = 3",
                             "sample_rate = 48000"})
        (void)errorWith(line);
    EXPECT_NE(errorWith("gian = [1, 1, 1, 1, 1, 1]").expected.find("gain"), std::string::npos);
    const core::Error missing = errorOf("kind = \"sound_bracelet\"\nname = \"x\"\ndevice = \"jack\"\n");
    EXPECT_NE(core::describe(missing).find("channels"), std::string::npos);
}

TEST(SoundBraceletFile, givesEachTactorAnOutputOfItsOwn) {
    for (const char* channels :
         {"[1, 2, 3, 4, 5, 5]", "[0, 1, 2, 3, 4, 5]", "[1, 2, 3, 4, 5]", "[1, 2, 3, 4, 5, 6.5]",
          "[1, 2, 3, 4, 5, 6, 7]", "[1, 2, 3, 4, 5, 257]", "1"}) {
        const core::Error error =
            errorOf("kind = \"sound_bracelet\"\nname = \"x\"\ndevice = \"jack\"\nchannels = " +
                    std::string(channels) + '\n');
        EXPECT_EQ(error.where.line, 4) << channels;
    }
}

TEST(SoundBraceletFile, takesEitherOneFrequencyOrLevels) {
    const core::Error error =
        errorOf(std::string(kLeast) + "carrier_Hz = 250\nlevel_Hz = [167, 188, 208, 229, 250]\n");
    EXPECT_EQ(error.where.line, 6);
}

// sqrt(2) / (4 f): 3.54 ms at 100 Hz.
TEST(SoundBraceletFile, refusesARampThatClicks) {
    const core::Error error = errorOf(std::string(kLeast) + "carrier_Hz = 100\nramp_ms = 3.5\n");
    EXPECT_EQ(error.where.line, 6);
    EXPECT_NE(error.expected.find("3.6"), std::string::npos) << error.expected;
    EXPECT_DOUBLE_EQ(read(std::string(kLeast) + "carrier_Hz = 100\nramp_ms = 3.6\n").tones[0].ramp_s, 3.6e-3);
    EXPECT_NE(core::describe(errorOf(std::string(kLeast) + "carrier_Hz = 100\n")).find("3.6"),
              std::string::npos)
        << "the ramp that is not given is too short as well";
}

TEST(SoundBraceletFile, thatComesWithTheProgramIsRight) {
    const auto file = readSoundBracelet(TELETA_SOURCE_DIR "/resources/devices/sound-card.toml");
    ASSERT_TRUE(file) << core::describe(file.error());
    EXPECT_EQ(file->address.api, SoundApi::pipeWire);
    EXPECT_FALSE(file->shared);
}

TEST(SoundBraceletFile, isOpenedByItsKind) {
    const test::TemporaryFolder folder;
    const core::StopSwitch stop;
    const auto opened = [&](const std::string& text) {
        const auto link = described::openBracelet(folder.write("device.toml", text), stop);
        EXPECT_FALSE(link);
        return link ? core::Error{} : link.error();
    };
    std::string text = kLeast;
    text.replace(text.find("pipewire:tactors"), 16, "alsa:no such card");
    const core::Error missing = opened(text);
    EXPECT_EQ(missing.kind, core::ErrorKind::unavailable);
    EXPECT_NE(missing.message.find("no such card"), std::string::npos) << missing.message;
    EXPECT_EQ(opened(std::string(kLeast) + "ramp_ms = 0\n").where.line, 5);
}

} // namespace teleta::sound
