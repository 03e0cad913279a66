// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/mcap/recorded/ros_names.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>

namespace teleta::mcap {

namespace {

using recording::StreamInfo;
using recording::StreamKind;

bool isDigit(char letter) {
    return letter >= '0' && letter <= '9';
}

bool isLetter(char letter) {
    return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z');
}

/// Whether the camera sees the sensor frame as left-handed.
bool isMirrored(const StreamInfo& camera) {
    const auto details = nlohmann::json::parse(camera.details, nullptr, /*allow_exceptions=*/false);
    if (!details.is_object() || !details.contains("camera") || !details["camera"].is_object())
        return false;
    const auto& model = details["camera"];
    return model.contains("mirrored") && model["mirrored"].is_boolean() && model["mirrored"].get<bool>();
}

/// The link at which a force was measured, if the stream says so.
std::string frameOf(const StreamInfo& wrench) {
    const auto details = nlohmann::json::parse(wrench.details, nullptr, /*allow_exceptions=*/false);
    const bool isNamed = details.is_object() && details.contains("frame") && details["frame"].is_string();
    return isNamed ? details["frame"].get<std::string>() : std::string();
}

} // namespace

std::string topicPart(std::string_view name) {
    std::string part(name);
    for (char& letter : part) {
        if (!isDigit(letter) && !isLetter(letter))
            letter = '_';
    }
    if (part.empty() || isDigit(part.front()))
        part.insert(0, "s_");
    return part;
}

std::vector<RosNames> rosNames(std::span<const StreamInfo> streams) {
    std::vector<RosNames> names;
    std::set<std::string> taken;
    for (const StreamInfo& stream : streams) {
        const std::string wanted = topicPart(stream.name);
        std::string topic = wanted;
        for (int number = 2; !taken.insert(topic).second; ++number)
            topic = wanted + "_" + std::to_string(number);
        names.push_back({topic, {}, false});
    }
    // What was computed of a source is in the frame of its array or camera.
    const auto sourceOf = [&](const StreamInfo& stream, StreamKind kind) -> std::size_t {
        const auto found = std::ranges::find_if(streams, [&](const StreamInfo& other) {
            return other.kind == kind && other.source == stream.source && other.details.size() > 2;
        });
        return static_cast<std::size_t>(found - streams.begin());
    };
    for (std::size_t i = 0; i < streams.size(); ++i) {
        const StreamInfo& stream = streams[i];
        switch (stream.kind) {
        case StreamKind::array:
            names[i].frame = names[i].topic;
            break;
        case StreamKind::numbers:
        case StreamKind::features: {
            const std::size_t array = sourceOf(stream, StreamKind::array);
            names[i].frame = array < streams.size() ? names[array].topic : names[i].topic;
            break;
        }
        case StreamKind::touches:
            names[i].frame = "base_link";
            break;
        case StreamKind::wrench:
            names[i].frame = frameOf(stream);
            break;
        case StreamKind::camera:
            names[i].frame = names[i].topic + "_optical_frame";
            break;
        case StreamKind::contacts: {
            const std::size_t camera = sourceOf(stream, StreamKind::camera);
            names[i].frame = camera < streams.size() ? names[camera].topic : names[i].topic;
            names[i].turnsY = camera < streams.size() && isMirrored(streams[camera]);
            break;
        }
        default:
            break;
        }
    }
    return names;
}

} // namespace teleta::mcap
