// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/bracelet/tactors.h"
#include "backend/core/data/json_document.h"
#include "backend/pattern/files/foreign_formats.h"
#include "backend/pattern/files/hjif_values.h"
#include "backend/pattern/model/bake.h"
#include "backend/pattern/model/track_builder.h"
#include "backend/pattern/motors/motor_model.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::pattern {

namespace {

using nlohmann::ordered_json;

constexpr double kDirectionLength = 127.0;

long long toTicks(double time_s) {
    return std::llround(time_s * kHjifTimescale);
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
        keyframes.push_back({{"relative_position", relative},
                             {"amplitude_modulation", point.intensity},
                             {"frequency_modulation", hjifFrequency_Hz(motor, point.intensity)}});
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

} // namespace

core::Expected<std::string> patternToHjif(const Pattern& pattern, const std::string& date) {
    TELETA_TRY(const Tracks tracks, linearised(pattern));
    const MotorProfile motor = MotorProfile::assumedCoinMotor();
    const auto lowest_Hz = static_cast<long>(std::floor(steadySpeed_Hz(motor, motor.startDrive)));
    const auto highest_Hz = static_cast<long>(std::ceil(steadySpeed_Hz(motor, 1.0)));
    const int forearm = pattern.arm == Arm::left ? kHjifLeftForearm : kHjifRightForearm;
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
        // Readers do not expect a band without effects.
        ordered_json bands = ordered_json::array();
        if (!effects.empty())
            bands.push_back({{"band_type", "VectorialWave"},
                             {"lower_frequency_limit", lowest_Hz},
                             {"upper_frequency_limit", highest_Hz},
                             {"effects", std::move(effects)}});
        channels.push_back({{"id", i},
                            {"description", "tactor " + std::to_string(i + 1)},
                            {"gain", 1.0},
                            {"mixing_coefficient", 1.0},
                            {"body_part_mask", forearm},
                            {"reference_device_id", 0},
                            {"direction", direction(i)},
                            {"bands", std::move(bands)}});
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
                            {"timescale", kHjifTimescale},
                            {"avatars", ordered_json::array()},
                            {"perceptions", ordered_json::array({std::move(perception)})},
                            {"syncs", ordered_json::array()}};
    return core::jsonText(root);
}

} // namespace teleta::pattern
