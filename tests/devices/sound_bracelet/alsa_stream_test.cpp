// SPDX-License-Identifier: GPL-3.0-or-later
// ALSA's plugin "file" has no clock, so that it shows formats and the order of the outputs, but nothing about
// time. Only a fixed number of periods is written.
#include "devices/sound_bracelet/alsa_stream.h"
#include "tests/backend/core/temporary_folder.h"

#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <iterator>
#include <vector>

namespace teleta::sound {
namespace {

SoundBraceletFile fileFor(const std::string& pcm) {
    SoundBraceletFile file;
    file.address = {SoundApi::alsa, pcm};
    file.period_frames = 64;
    file.channels = {3, 4, 5, 6, 7, 8};
    return file;
}

std::vector<float> floatsOf(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(in), {}};
    std::vector<float> samples(bytes.size() / sizeof(float));
    std::memcpy(samples.data(), bytes.data(), samples.size() * sizeof(float));
    return samples;
}

} // namespace

TEST(AlsaStream, writesEachTactorToItsOutputAndZerosToTheOthers) {
    const test::TemporaryFolder folder;
    const std::string path = folder.path("played.raw");
    {
        auto stream = AlsaStream::open(fileFor("file:'" + path + "',raw"));
        ASSERT_TRUE(stream) << core::describe(stream.error());
        EXPECT_EQ(stream->channels(), 8U);
        std::vector<float> samples(core::kTactors * 64);
        ToneEngine::Outputs tactors;
        for (std::size_t i = 0; i < core::kTactors; ++i)
            tactors[i] = std::span(samples).subspan(i * 64, 64);
        for (int period = 0; period < 3; ++period) {
            for (std::size_t k = 0; k < samples.size(); ++k)
                samples[k] = static_cast<float>(period) + static_cast<float>(k) / 1024.0F;
            ASSERT_EQ(stream->write(tactors), AlsaStream::Written::period);
        }
    }
    const std::vector<float> played = floatsOf(path);
    ASSERT_EQ(played.size(), 3U * 64U * 8U);
    for (std::size_t frame = 0; frame < 3U * 64U; ++frame)
        for (std::size_t output = 0; output < 8; ++output) {
            const float expected = output < 2
                                       ? 0.0F
                                       : static_cast<float>(frame / 64) +
                                             static_cast<float>((output - 2) * 64 + frame % 64) / 1024.0F;
            ASSERT_EQ(played[frame * 8 + output], expected) << frame << ", output " << output + 1;
        }
}

TEST(AlsaStream, saysThatThereIsNoSuchCard) {
    const auto missing = AlsaStream::open(fileFor("hw:CARD=NoSuchCard"));
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().kind, core::ErrorKind::unavailable);
    EXPECT_NE(missing.error().message.find("NoSuchCard"), std::string::npos);
}

// Largest and smallest samples are those of the formats, and nothing wraps around.
TEST(AlsaStream, scalesSamplesToTheFormatsOfCards) {
    std::vector<std::byte> bytes(3 * sizeof(std::int32_t));
    const auto written = [&]<typename Integer>(snd_pcm_format_t format, float sample, Integer) {
        putSample(format, sample, 1, bytes);
        Integer value{};
        std::memcpy(&value, &bytes[sizeof value], sizeof value);
        return value;
    };
    for (const float large : {1.0F, 1.5F}) {
        EXPECT_EQ(written(SND_PCM_FORMAT_S16, large, std::int16_t{}), 32'767);
        EXPECT_EQ(written(SND_PCM_FORMAT_S32, large, std::int32_t{}), 2'147'483'647);
        EXPECT_EQ(written(SND_PCM_FORMAT_S16, -large, std::int16_t{}), -32'767);
        EXPECT_EQ(written(SND_PCM_FORMAT_S32, -large, std::int32_t{}), -2'147'483'647);
    }
    EXPECT_EQ(written(SND_PCM_FORMAT_S16, 0.5F, std::int16_t{}), 16'384) << "32767 / 2, rounded";
    EXPECT_EQ(written(SND_PCM_FORMAT_S32, 0.25F, std::int32_t{}), 536'870'912);
    EXPECT_EQ(written(SND_PCM_FORMAT_S32, 0.0F, std::int32_t{}), 0);
    EXPECT_EQ(written(SND_PCM_FORMAT_FLOAT, 0.3F, 0.0F), 0.3F);
}

} // namespace teleta::sound
