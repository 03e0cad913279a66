// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/ros/files/ros_wrench_file.h"

#include "devices/ros/files/ros_file_keys.h"

#include <QCoreApplication>

namespace teleta::ros_arm {

namespace {

struct WrenchFileText {
    Q_DECLARE_TR_FUNCTIONS(RosWrenchFile)
};

RosWrenchFile read(core::TomlTable& root) {
    RosWrenchFile file;
    (void)root.choice("kind", {"ros_wrench"});
    file.name = root.text("name");
    file.topic = readTopic(root, "topic");
    file.frame = root.text("frame", "");
    const long long sign = root.integer("wrench_sign", -1, 1, 1);
    if (sign == 0)
        root.fail(
            "wrench_sign", WrenchFileText::tr("a sign of 0 hides every force").toStdString(),
            WrenchFileText::tr("1: it reports what acts on the arm; -1: what the arm exerts").toStdString());
    file.sign = static_cast<double>(sign);
    file.timeout_s = readTimeout_s(root, "timeout_s", file.timeout_s);
    file.domain = readRos(root);
    return file;
}

} // namespace

core::Expected<RosWrenchFile> readRosWrench(const std::string& path) {
    return readDocument(core::TomlDocument::open(path), read);
}

core::Expected<RosWrenchFile> parseRosWrench(std::string_view text, const std::string& file) {
    return readDocument(core::TomlDocument::parse(text, file), read);
}

} // namespace teleta::ros_arm
