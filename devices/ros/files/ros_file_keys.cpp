// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/ros/files/ros_file_keys.h"

#include "backend/ros/topic_names.h"

#include <QCoreApplication>

#include <algorithm>
#include <vector>

namespace teleta::ros_arm {

namespace {

struct FileKeysText {
    Q_DECLARE_TR_FUNCTIONS(FileKeysText)
};

constexpr double kShortestTimeout_s = 0.02;
constexpr double kLongestTimeout_s = 1.0;

} // namespace

std::string readTopic(core::TomlTable& table, std::string_view key,
                      const std::optional<std::string>& fallback) {
    std::string name = table.text(key, fallback);
    if (!name.empty() && !ros::isTopicName(name))
        table.fail(
            key,
            FileKeysText::tr("\"%1\" is not a topic name").arg(QString::fromStdString(name)).toStdString(),
            FileKeysText::tr("parts of letters, digits and _ after slashes, for example /joint_states")
                .toStdString());
    return name;
}

std::optional<dds::DomainConfig> readRos(core::TomlTable& root) {
    if (!root.has("ros"))
        return std::nullopt;
    core::TomlTable table = root.table("ros");
    dds::DomainConfig config = readDomain(table);
    table.finish();
    return config;
}

dds::DomainConfig readDomain(core::TomlTable& ros) {
    dds::DomainConfig config;
    config.domain = static_cast<int>(ros.integer("domain", 0, dds::kHighestDomain, 0));
    config.interface = ros.text("interface", "");
    config.peers = ros.textList("peers");
    return config;
}

double readTimeout_s(core::TomlTable& table, std::string_view key, double fallback_s) {
    return table.number(key, core::NumberRange::between(kShortestTimeout_s, kLongestTimeout_s), fallback_s);
}

void readPose(core::TomlTable& table, core::PadPlacement& pad) {
    constexpr double kFarthest = 100.0;
    if (!table.has("pose"))
        return;
    const std::vector<double> pose =
        table.numberList("pose", core::NumberRange::between(-kFarthest, kFarthest), {6, 6});
    if (pose.size() != 6)
        return;
    std::copy_n(pose.begin(), 3, pad.position_m.begin());
    std::copy_n(pose.begin() + 3, 3, pad.rollPitchYaw_rad.begin());
}

} // namespace teleta::ros_arm
