// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/ros/files/ros_wrench_file.h"

#include "devices/ros/files/ros_file_keys.h"

#include <QCoreApplication>

namespace teleta::ros_arm {

namespace {

struct WrenchFileText {
    Q_DECLARE_TR_FUNCTIONS(RosWrenchFile)
};

core::Expected<RosWrenchFile> read(const core::TomlDocument& document) {
    RosWrenchFile file;
    core::TomlTable root = document.root();
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
    if (root.has("ros")) {
        core::TomlTable table = root.table("ros");
        file.domain = readDomain(table);
        table.finish();
    }
    root.finish();
    if (document.firstError())
        return core::Unexpected(*document.firstError());
    return file;
}

} // namespace

core::Expected<RosWrenchFile> readRosWrench(const std::string& path) {
    TELETA_TRY(const core::TomlDocument document, core::TomlDocument::open(path));
    return read(document);
}

core::Expected<RosWrenchFile> parseRosWrench(std::string_view text, const std::string& file) {
    TELETA_TRY(const core::TomlDocument document, core::TomlDocument::parse(text, file));
    return read(document);
}

} // namespace teleta::ros_arm
