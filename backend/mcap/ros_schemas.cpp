// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/mcap/ros_schemas.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace teleta::mcap {

namespace {

struct RosType {
    std::string_view name;
    std::string_view definition;
};

/// Those of teleta_msgs that have a field a column are made of the columns.
constexpr std::array<RosType, 17> kTypes{{
    {"builtin_interfaces/Time", "int32 sec\nuint32 nanosec\n"},
    {"foxglove_msgs/Log", "uint8 UNKNOWN=0\n"
                          "uint8 DEBUG=1\n"
                          "uint8 INFO=2\n"
                          "uint8 WARNING=3\n"
                          "uint8 ERROR=4\n"
                          "uint8 FATAL=5\n"
                          "builtin_interfaces/Time timestamp\n"
                          "uint8 level\n"
                          "string message\n"
                          "string name\n"
                          "string file\n"
                          "uint32 line\n"},
    {"geometry_msgs/Vector3", "float64 x\nfloat64 y\nfloat64 z\n"},
    {"geometry_msgs/Wrench", "Vector3 force\nVector3 torque\n"},
    {"geometry_msgs/WrenchStamped", "std_msgs/Header header\nWrench wrench\n"},
    {"sensor_msgs/CompressedImage", "std_msgs/Header header\nstring format\nuint8[] data\n"},
    {"sensor_msgs/Image", "std_msgs/Header header\n"
                          "uint32 height\n"
                          "uint32 width\n"
                          "string encoding\n"
                          "uint8 is_bigendian\n"
                          "uint32 step\n"
                          "uint8[] data\n"},
    {"sensor_msgs/JointState", "std_msgs/Header header\n"
                               "string[] name\n"
                               "float64[] position\n"
                               "float64[] velocity\n"
                               "float64[] effort\n"},
    {"sensor_msgs/PointCloud2", "std_msgs/Header header\n"
                                "uint32 height\n"
                                "uint32 width\n"
                                "PointField[] fields\n"
                                "bool is_bigendian\n"
                                "uint32 point_step\n"
                                "uint32 row_step\n"
                                "uint8[] data\n"
                                "bool is_dense\n"},
    {"sensor_msgs/PointField", "uint8 INT8=1\n"
                               "uint8 UINT8=2\n"
                               "uint8 INT16=3\n"
                               "uint8 UINT16=4\n"
                               "uint8 INT32=5\n"
                               "uint8 UINT32=6\n"
                               "uint8 FLOAT32=7\n"
                               "uint8 FLOAT64=8\n"
                               "string name\n"
                               "uint32 offset\n"
                               "uint8 datatype\n"
                               "uint32 count\n"},
    {"std_msgs/Float32MultiArray", "MultiArrayLayout layout\nfloat32[] data\n"},
    {"std_msgs/Header", "builtin_interfaces/Time stamp\nstring frame_id\n"},
    {"std_msgs/MultiArrayDimension", "string label\nuint32 size\nuint32 stride\n"},
    {"std_msgs/MultiArrayLayout", "MultiArrayDimension[] dim\nuint32 data_offset\n"},
    {"teleta_msgs/Numbers", "std_msgs/Header header\nstring[] name\nfloat64[] value\n"},
    {"teleta_msgs/TactileArray", "std_msgs/Header header\n"
                                 "uint32 rows\n"
                                 "uint32 columns\n"
                                 "float64 pitch_m\n"
                                 "string unit\n"
                                 "string frame_axes\n"
                                 "float32[] value\n"},
    {"teleta_msgs/Tactors", "std_msgs/Header header\nfloat32[6] intensity\n"},
}};

constexpr std::string_view kMsg = "/msg/";
constexpr std::size_t kRule = 80;

std::string_view lineOf(std::string_view& text) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return line;
}

/// Of a line "type[] name"; a constant and a remark have none.
std::pair<std::string_view, std::string_view> fieldOf(std::string_view line) {
    line = line.substr(0, std::min(line.find('#'), line.size()));
    const auto word = [&line] {
        const std::size_t start = std::min(line.find_first_not_of(" \t\r"), line.size());
        const std::size_t end = std::min(line.find_first_of(" \t\r", start), line.size());
        const std::string_view found = line.substr(start, end - start);
        line.remove_prefix(end);
        return found;
    };
    const std::string_view type = word();
    const std::string_view name = word();
    if (name.empty() || name.find('=') != std::string_view::npos || line.find('=') != std::string_view::npos)
        return {};
    return {type, name};
}

/// The types that a definition names, with their packages. package: of the definition.
std::vector<std::string> namedTypes(std::string_view definition, std::string_view package) {
    std::vector<std::string> names;
    while (!definition.empty()) {
        const std::string_view type = fieldOf(lineOf(definition)).first;
        const std::string_view bare = type.substr(0, std::min(type.find('['), type.size()));
        for (const std::string& name : {std::string(bare), std::string(package) + '/' + std::string(bare)}) {
            if (!rosDefinition(name).empty())
                names.push_back(name);
        }
    }
    return names;
}

void appendTypes(std::string& text, std::vector<std::string>& done, std::string_view definition,
                 std::string_view package) {
    for (const std::string& name : namedTypes(definition, package)) {
        if (std::ranges::find(done, name) != done.end())
            continue;
        done.push_back(name);
        const std::string_view own = rosDefinition(name);
        appendType(text, name, own);
        appendTypes(text, done, own, std::string_view(name).substr(0, name.find('/')));
    }
}

} // namespace

std::string_view rosDefinition(std::string_view name) {
    const std::size_t msg = name.find(kMsg);
    const std::string_view package = name.substr(0, std::min(msg, name.size()));
    const std::string_view type =
        msg == std::string_view::npos ? std::string_view() : name.substr(msg + kMsg.size());
    for (const RosType& each : kTypes) {
        const bool isIt = msg == std::string_view::npos
                              ? each.name == name
                              : each.name.size() == package.size() + 1 + type.size() &&
                                    each.name.starts_with(package) && each.name.ends_with(type);
        if (isIt)
            return each.definition;
    }
    return {};
}

std::string schemaText(std::string_view definition, std::string_view package) {
    std::string text(definition);
    std::vector<std::string> done;
    appendTypes(text, done, definition, package);
    return text;
}

void appendType(std::string& text, std::string_view name, std::string_view definition) {
    text.append(kRule, '=').append("\nMSG: ").append(name).append("\n").append(definition);
}

std::vector<std::pair<std::string, std::string>> schemaFields(std::string_view text) {
    std::vector<std::pair<std::string, std::string>> fields;
    while (!text.empty()) {
        const std::string_view line = lineOf(text);
        if (line.starts_with("==="))
            break;
        const auto [type, name] = fieldOf(line);
        if (!name.empty())
            fields.emplace_back(type, name);
    }
    return fields;
}

} // namespace teleta::mcap
