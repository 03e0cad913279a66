// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/sound_bracelet/sound_bracelet_file.h"

#include "backend/core/keys/key_lists.h"
#include "backend/core/keys/toml_keys.h"

#include <QCoreApplication>
#include <QString>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <vector>

namespace teleta::sound {

namespace {

using core::Need;
using core::NumberRange;

struct SoundFileText {
    Q_DECLARE_TR_FUNCTIONS(SoundFileText)
};

constexpr std::array<std::uint32_t, 3> kRates_Hz{44'100, 48'000, 96'000};
constexpr long long kLeastFrames = 16;
constexpr long long kMostFrames = 2048;
constexpr double kMostChannels = 256.0;
constexpr double kLongestLatency_ms = 500.0;
constexpr NumberRange kCarriers_Hz = NumberRange::between(20.0, 1000.0);

void refuse(core::Keys& keys, std::string_view key, const QString& message, const QString& expected) {
    keys.refuse(key, message.toStdString(), expected.toStdString());
}

std::optional<SoundAddress> addressOf(const std::string& text) {
    const std::size_t colon = text.find(':');
    const std::string api = text.substr(0, colon);
    const std::string name = colon == std::string::npos ? std::string() : text.substr(colon + 1);
    if (colon != std::string::npos && name.empty())
        return std::nullopt;
    if (api == "pipewire")
        return SoundAddress{SoundApi::pipeWire, name};
    if (api == "jack")
        return SoundAddress{SoundApi::jack, name};
    if (api == "alsa" && !name.empty())
        return SoundAddress{SoundApi::alsa, name};
    return std::nullopt;
}

void describeDevice(core::Keys& keys, SoundBraceletFile& file) {
    keys.text(
        "device", file.device,
        "The card: `pipewire:NODE`, `jack:CLIENT` or `alsa:PCM`; `pipewire` or `jack` alone is the only "
        "card there is");
    if (const auto address = addressOf(file.device))
        file.address = *address;
    else if (!file.device.empty())
        refuse(keys, "device",
               SoundFileText::tr("\"%1\" names no sound card").arg(QString::fromStdString(file.device)),
               SoundFileText::tr("pipewire, pipewire:NODE, jack, jack:CLIENT or alsa:PCM"));
}

void describeTime(core::Keys& keys, SoundBraceletFile& file) {
    keys.whole("sample_rate_Hz", file.sampleRate_Hz, {kRates_Hz.front(), kRates_Hz.back()},
               "Samples a second that the card plays: 44100, 48000 or 96000", Need::optional);
    if (std::ranges::find(kRates_Hz, file.sampleRate_Hz) == kRates_Hz.end())
        refuse(keys, "sample_rate_Hz", SoundFileText::tr("no such sample rate: %1").arg(file.sampleRate_Hz),
               SoundFileText::tr("one of: %1").arg(QStringLiteral("44100, 48000, 96000")));
    keys.whole("period_frames", file.period_frames, {kLeastFrames, kMostFrames},
               "Samples that the card takes at a time, a power of two", Need::optional);
    if ((file.period_frames & (file.period_frames - 1)) != 0)
        refuse(keys, "period_frames", SoundFileText::tr("%1 is no power of two").arg(file.period_frames),
               SoundFileText::tr("16, 32, 64, 128, 256, 512, 1024 or 2048"));
}

void describeChannels(core::Keys& keys, SoundBraceletFile& file) {
    std::vector<double> channels;
    core::describeList(keys, "channels", channels, NumberRange::between(1.0, kMostChannels),
                       {core::kTactors, core::kTactors},
                       "Output of each tactor, whole numbers from 1 on; other outputs stay silent");
    if (channels.size() != core::kTactors)
        return;
    const bool whole = std::ranges::all_of(channels, [](double value) { return value == std::floor(value); });
    if (!whole || std::set(channels.begin(), channels.end()).size() != core::kTactors)
        return refuse(keys, "channels", SoundFileText::tr("each tactor needs an output of its own"),
                      SoundFileText::tr("six different whole numbers"));
    std::ranges::transform(channels, file.channels.begin(),
                           [](double value) { return static_cast<std::uint32_t>(value); });
}

void describeFrequencies(core::Keys& keys, SoundBraceletFile& file) {
    std::vector<double> carriers;
    core::describeList(keys, "carrier_Hz", carriers, kCarriers_Hz, {1, core::kTactors},
                       "Frequency of all tactors, or a list with one for each; otherwise 250 Hz",
                       Need::optional);
    if (carriers.size() != 1 && carriers.size() != core::kTactors && !carriers.empty())
        refuse(keys, "carrier_Hz", SoundFileText::tr("%1 carriers for six tactors").arg(carriers.size()),
               SoundFileText::tr("one number, or a list of six"));
    else if (!carriers.empty())
        for (std::size_t i = 0; i < core::kTactors; ++i)
            file.tones[i].carrier_Hz = carriers[carriers.size() == 1 ? 0 : i];
    std::vector<double> levels;
    core::describeList(keys, "level_Hz", levels, kCarriers_Hz, {5, 5},
                       "Instead of one frequency: those of the five levels of vibration; the frequency then "
                       "follows the intensity as that of a motor does",
                       Need::optional);
    if (levels.size() != std::tuple_size_v<LevelFrequencies>)
        return;
    if (!carriers.empty())
        refuse(keys, "level_Hz", SoundFileText::tr("the frequency is not clear"),
               SoundFileText::tr("either carrier_Hz or level_Hz"));
    if (!std::ranges::is_sorted(levels))
        refuse(keys, "level_Hz", SoundFileText::tr("the levels do not rise"),
               SoundFileText::tr("five frequencies, the lowest first"));
    LevelFrequencies known{};
    std::ranges::copy(levels, known.begin());
    for (ToneSettings& tone : file.tones)
        tone.level_Hz = known;
}

void describeStrength(core::Keys& keys, SoundBraceletFile& file) {
    std::size_t waveform = 0;
    keys.choice("waveform", waveform, {"sine"}, "Form of the vibration", Need::optional);
    double fullScale = file.tones.front().fullScale;
    keys.number("full_scale", fullScale, NumberRange::positiveUpTo(0.9),
                "Sample value at full intensity, as a share of what the card can play", Need::optional);
    std::vector<double> gains(core::kTactors, 1.0);
    core::describeList(keys, "gain", gains, NumberRange::between(0.0, 1.0), {core::kTactors, core::kTactors},
                       "Strength of each tactor as a share of full_scale, from a calibration",
                       Need::optional);
    double ramp_ms = file.tones.front().ramp_s * 1e3;
    keys.number("ramp_ms", ramp_ms, NumberRange::between(1.0, 20.0),
                "How long the strength takes from one value to the next, along a raised cosine",
                Need::optional);
    double shortest_ms = 0.0;
    for (std::size_t i = 0; i < core::kTactors; ++i) {
        ToneSettings& tone = file.tones[i];
        tone.fullScale = fullScale;
        tone.gain = gains.size() == core::kTactors ? gains[i] : 1.0;
        tone.ramp_s = ramp_ms * 1e-3;
        shortest_ms = std::max(shortest_ms, 1e3 * tone.shortestRamp_s());
    }
    // A shorter ramp would move the coil more abruptly than the vibration itself.
    if (ramp_ms < shortest_ms)
        refuse(keys, "ramp_ms", SoundFileText::tr("the ramp is too short for the frequency: it would click"),
               SoundFileText::tr("at least %1 ms").arg(std::ceil(shortest_ms * 10.0) / 10.0));
}

} // namespace

void SoundBraceletFile::describeKeys(core::Keys& keys) {
    keys.word("kind", "sound_bracelet", "Voice coils on a sound card");
    keys.text("name", name, "Name on the screen");
    describeDevice(keys, *this);
    describeTime(keys, *this);
    describeChannels(keys, *this);
    describeFrequencies(keys, *this);
    describeStrength(keys, *this);
    keys.number("latency_ms", latency_ms, NumberRange::between(0.0, kLongestLatency_ms),
                "From a frame to the movement that it causes, as `teleta devices --probe FILE --latency "
                "INPUT` measured it; "
                "the onset of stimuli counts from there");
    keys.number("latency_spread_ms", latencySpread_ms, NumberRange::between(0.0, kLongestLatency_ms),
                "How much it varied in that measurement, from the shortest to the longest");
    if (latencySpread_ms && !latency_ms)
        refuse(keys, "latency_spread_ms", SoundFileText::tr("there is no latency that varies"),
               SoundFileText::tr("latency_ms as well"));
    keys.flag("shared", shared, "Other programs may play on the card at the same time");
}

core::Expected<SoundBraceletFile> readSoundBracelet(const std::string& path) {
    return core::TomlDocument::open(path).and_then(core::readKeys<SoundBraceletFile>);
}

core::Expected<SoundBraceletFile> parseSoundBracelet(std::string_view text, const std::string& file) {
    return core::TomlDocument::parse(text, file).and_then(core::readKeys<SoundBraceletFile>);
}

} // namespace teleta::sound
