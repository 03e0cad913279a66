// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/bracelet/tactors.h"
#include "backend/core/data/json_document.h"
#include "backend/pattern/files/foreign_formats.h"
#include "backend/pattern/model/bake.h"
#include "backend/pattern/model/track_builder.h"
#include "backend/pattern/motors/motor_model.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::pattern {

namespace {

using core::JsonDocument;
using core::JsonReader;
using nlohmann::ordered_json;

struct HjifText {
    Q_DECLARE_TR_FUNCTIONS(PatternFile)
};

constexpr int kTimescale = 1000;
constexpr int kRightForearm = 0x1000;
constexpr int kLeftForearm = 0x2000;
constexpr int kLeftWrist = 0x8000;
constexpr double kDirectionLength = 127.0;
constexpr long long kMostTicks = 1'000'000'000'000;

long long toTicks(double time_s) {
    return std::llround(time_s * kTimescale);
}

ordered_json direction(std::size_t tactor) {
    const double angle_rad = core::kTactorAngle_rad * static_cast<double>(tactor);
    // 63.5 is computed slightly too large or too small; it must round to 64 on both sides of the ring.
    const auto whole = [](double value) { return std::lround(std::round(1e6 * value) / 1e6); };
    return {{"X", whole(kDirectionLength * std::cos(angle_rad))},
            {"Y", whole(kDirectionLength * std::sin(angle_rad))},
            {"Z", 0}};
}

/// Keyframes at rising whole milliseconds.
ordered_json effect(int id, const Track& stretch, const MotorProfile& motor) {
    const long long position = toTicks(stretch.front().time_s);
    ordered_json keyframes = ordered_json::array();
    for (const Breakpoint& point : stretch) {
        const long long relative = toTicks(point.time_s) - position;
        while (!keyframes.empty()) {
            ordered_json& before = keyframes.back();
            const auto ticks = before["relative_position"].get<long long>();
            const bool roomAhead =
                ticks > 0 &&
                (keyframes.size() < 2 ||
                 keyframes[keyframes.size() - 2]["relative_position"].get<long long>() < ticks - 1);
            if (ticks < relative)
                break;
            if (roomAhead) {
                before["relative_position"] = relative - 1;
                break;
            }
            keyframes.erase(keyframes.size() - 1); // of two within a millisecond the later one counts
        }
        const double speed_Hz = steadySpeed_Hz(motor, driveOf(motor, std::max(point.intensity, 1e-9)));
        keyframes.push_back({{"relative_position", relative},
                             {"amplitude_modulation", point.intensity},
                             {"frequency_modulation", std::lround(speed_Hz)}});
    }
    return {{"id", id},     {"effect_type", "Basis"}, {"position", position},
            {"phase", 0.0}, {"base_signal", "Sine"},  {"keyframes", std::move(keyframes)}};
}

/// Time at which the last tactor turns off.
double lastOn_s(const Tracks& tracks) {
    double end_s = 0.0;
    for (const Track& track : tracks)
        for (const Track& stretch : stretches(track))
            end_s = std::max(end_s, stretch.back().time_s);
    return end_s;
}

/// Tactor of a channel.
std::size_t tactorOf(JsonReader& reader, const ordered_json& channel, std::size_t order) {
    const ordered_json* const found = reader.find(channel, "direction");
    if (found == nullptr)
        return order;
    const double x = reader.number(reader.member(*found, "X"), -128.0, 127.0);
    const double y = reader.number(reader.member(*found, "Y"), -128.0, 127.0);
    if (x == 0.0 && y == 0.0)
        return order;
    const long nearest = std::lround(std::atan2(y, x) / core::kTactorAngle_rad);
    return core::wrappedTactor(nearest);
}

void expectText(JsonReader& reader, const ordered_json& object, const char* key, const char* expected) {
    const ordered_json& value = reader.member(object, key);
    if (reader.text(value) != expected)
        reader.fail(value, HjifText::tr("a pattern cannot represent this"), expected);
}

Track stretchOf(JsonReader& reader, const ordered_json& effect, double timescale, double gain) {
    expectText(reader, effect, "effect_type", "Basis");
    const auto ticks = [&](const ordered_json& value) {
        return static_cast<double>(reader.integer(value, 0, kMostTicks));
    };
    const double position = ticks(reader.member(effect, "position"));
    Track lines;
    for (const ordered_json& keyframe :
         reader.array(reader.member(effect, "keyframes"), 0, Pattern::kMostBreakpoints)) {
        const ordered_json* const amplitude = reader.find(keyframe, "amplitude_modulation");
        if (amplitude == nullptr)
            continue; // a keyframe for the frequency only
        const ordered_json& relative = reader.member(keyframe, "relative_position");
        const double time_s = (position + ticks(relative)) / timescale;
        if (time_s > Pattern::kLongest_s || (!lines.empty() && time_s < lines.back().time_s)) {
            reader.fail(relative, HjifText::tr("the times decrease or exceed the longest pattern"),
                        HjifText::tr("a time that is not before the previous one"));
            break;
        }
        lines.push_back({time_s, std::min(1.0, gain * reader.number(*amplitude, 0.0, 1.0))});
    }
    return lines;
}

/// The arm of a channel; the right one when it does not say.
Arm armOf(JsonReader& reader, const ordered_json& channel) {
    const ordered_json* const mask = reader.find(channel, "body_part_mask");
    const long long bits = mask == nullptr ? 0 : reader.integer(*mask, 0, 0xFFFF'FFFFLL);
    return (bits & (kLeftForearm | kLeftWrist)) != 0 ? Arm::left : Arm::right;
}

void readChannel(JsonReader& reader, const ordered_json& channel, std::size_t tactor, double timescale,
                 TrackBuilder& tracks) {
    const double gain = reader.number(channel, "gain", 0.0, 1e6, 1.0);
    for (const ordered_json& band : reader.array(reader.member(channel, "bands"), 0, Pattern::kMostObjects)) {
        expectText(reader, band, "band_type", "VectorialWave");
        for (const ordered_json& effect :
             reader.array(reader.member(band, "effects"), 0, Pattern::kMostBreakpoints)) {
            if (reader.error())
                return;
            tracks.add(tactor, stretchOf(reader, effect, timescale, gain));
        }
    }
}

} // namespace

core::Expected<std::string> patternToHjif(const Pattern& pattern, const std::string& date) {
    TELETA_TRY(const Tracks tracks, linearised(pattern));
    const MotorProfile motor = MotorProfile::assumedCoinMotor();
    const auto lowest_Hz = static_cast<long>(std::floor(steadySpeed_Hz(motor, motor.startDrive)));
    const auto highest_Hz = static_cast<long>(std::ceil(steadySpeed_Hz(motor, 1.0)));
    const int forearm = pattern.arm == Arm::left ? kLeftForearm : kRightForearm;
    const double end_s = lastOn_s(tracks);
    ordered_json channels = ordered_json::array();
    for (std::size_t i = 0; i < core::kTactors; ++i) {
        ordered_json effects = ordered_json::array();
        for (const Track& stretch : stretches(tracks[i]))
            effects.push_back(effect(static_cast<int>(effects.size()), stretch, motor));
        // The format has no duration: silence at the end is written as an effect that does nothing.
        if (i == 0 && toTicks(pattern.duration_s) > toTicks(end_s))
            effects.push_back(
                effect(static_cast<int>(effects.size()), {{end_s, 0.0}, {pattern.duration_s, 0.0}}, motor));
        ordered_json band{{"band_type", "VectorialWave"},
                          {"lower_frequency_limit", lowest_Hz},
                          {"upper_frequency_limit", highest_Hz},
                          {"effects", std::move(effects)}};
        channels.push_back({{"id", i},
                            {"description", "tactor " + std::to_string(i + 1)},
                            {"gain", 1.0},
                            {"mixing_coefficient", 1.0},
                            {"body_part_mask", forearm},
                            {"reference_device_id", 0},
                            {"direction", direction(i)},
                            {"bands", ordered_json::array({std::move(band)})}});
    }
    ordered_json device{{"id", 0},
                        {"name", "Bracelet of six vibration motors"},
                        {"body_part_mask", forearm},
                        {"minimum_frequency", lowest_Hz},
                        {"maximum_frequency", highest_Hz},
                        {"type", "ERM"}};
    ordered_json perception{{"id", 0},
                            {"avatar_id", 0},
                            {"description", pattern.notes},
                            {"perception_modality", "Vibrotactile"},
                            {"unit_exponent", -3},
                            {"perception_unit_exponent", 0},
                            {"reference_devices", ordered_json::array({std::move(device)})},
                            {"effect_library", ordered_json::array()},
                            {"channels", std::move(channels)}};
    const ordered_json root{{"version", "2023"},
                            {"profile", "Simple Parametric"},
                            {"level", 1},
                            {"date", date},
                            {"description", pattern.name},
                            {"timescale", kTimescale},
                            {"avatars", ordered_json::array()},
                            {"perceptions", ordered_json::array({std::move(perception)})},
                            {"syncs", ordered_json::array()}};
    return core::jsonText(root);
}

core::Expected<Pattern> patternFromHjif(std::string text, const std::string& file) {
    TELETA_TRY(const JsonDocument document, JsonDocument::parse(std::move(text), file));
    JsonReader reader(document);
    const ordered_json& root = reader.root();
    (void)reader.text(reader.member(root, "version"));
    Pattern pattern;
    pattern.name = reader.text(root, "description", {});
    const double timescale = reader.number(root, "timescale", 1.0, 1e9, kTimescale);
    TrackBuilder tracks;
    std::array<bool, core::kTactors> taken{};
    std::size_t order = 0;
    for (const ordered_json& perception : reader.array(reader.member(root, "perceptions"), 0, 64)) {
        const std::string notes = reader.text(perception, "description", {});
        if (pattern.notes.empty())
            pattern.notes = notes;
        for (const ordered_json& channel : reader.array(reader.member(perception, "channels"), 0, 1024)) {
            const std::size_t tactor = tactorOf(reader, channel, order++);
            if (tactor >= core::kTactors || taken[tactor]) {
                reader.fail(channel, HjifText::tr("there is no tactor left for this channel"),
                            HjifText::tr("six channels with directions 60 degrees apart"));
                break;
            }
            taken[tactor] = true;
            if (const Arm arm = armOf(reader, channel); arm == Arm::left)
                pattern.arm = arm;
            readChannel(reader, channel, tactor, timescale, tracks);
        }
    }
    if (reader.error())
        return core::Unexpected(*reader.error());
    tracks.build(pattern);
    return pattern;
}

} // namespace teleta::pattern
