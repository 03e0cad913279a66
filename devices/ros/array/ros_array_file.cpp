// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/ros/array/ros_array_file.h"

#include "devices/ros/files/ros_file_keys.h"

#include <QCoreApplication>

namespace teleta::ros_array {

namespace {

using core::NumberRange;
using core::TomlTable;

struct ArrayFileText {
    Q_DECLARE_TR_FUNCTIONS(RosArrayFile)
};

constexpr const char* kKind = "ros_tactile";
constexpr double kLargestPitch_mm = 1000.0;

RosArrayFile read(core::TomlTable& root) {
    RosArrayFile file;
    (void)root.choice("kind", {kKind});
    file.name = root.text("name");
    file.topic = ros_arm::readTopic(root, "topic");
    file.format =
        static_cast<ArrayFormat>(root.choice("format", {"TactileState", "Float64MultiArray", "Image"}));
    file.sensor = root.text("sensor", "");
    if (!file.sensor.empty() && file.format != ArrayFormat::tactileState)
        root.fail("sensor", ArrayFileText::tr("only a TactileState has sensors with names").toStdString(),
                  "format = \"TactileState\"");
    const long long side = core::ArrayLayout::kMaximumSide;
    file.layout.rows = static_cast<int>(root.integer("rows", 1, side));
    file.layout.columns = static_cast<int>(root.integer("cols", 1, side));
    file.layout.setPitch_m(1e-3 * root.number("pitch_mm", NumberRange::positiveUpTo(kLargestPitch_mm)));
    file.unit = root.text("unit", file.unit);
    file.scale = root.number("scale", NumberRange::any(), file.scale);
    if (file.scale == 0.0)
        root.fail("scale", ArrayFileText::tr("with a factor of 0 every value is the same").toStdString(),
                  ArrayFileText::tr("another number").toStdString());
    if (file.unit != "N" && !root.has("threshold"))
        root.fail(
            "threshold",
            ArrayFileText::tr("without a threshold it is not known which taxels are touched").toStdString(),
            ArrayFileText::tr("threshold = a number in the unit of the values, above the first table")
                .toStdString());
    file.threshold = root.number("threshold", NumberRange::positive(), file.threshold);
    file.rate_Hz = root.number("rate_Hz", NumberRange::between(0.0, 1e5), file.rate_Hz);
    file.domain = ros_arm::readRos(root).value_or(dds::DomainConfig());
    return file;
}

} // namespace

bool isRosArrayKind(std::string_view kind) {
    return kind == kKind;
}

core::Expected<RosArrayFile> readRosArray(const std::string& path) {
    return ros_arm::readDocument(core::TomlDocument::open(path), read);
}

core::Expected<RosArrayFile> parseRosArray(std::string_view text, const std::string& file) {
    return ros_arm::readDocument(core::TomlDocument::parse(text, file), read);
}

} // namespace teleta::ros_array
