// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/mcap/recorded/message_decoder.h"

#include "backend/core/words.h"
#include "backend/mcap/cdr_reader.h"
#include "backend/mcap/ros_schemas.h"
#include "backend/opencv/coded_picture.h"
#include "backend/picture/raw_picture.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <limits>
#include <memory>
#include <span>
#include <utility>

namespace teleta::mcap {

namespace {

constexpr core::Words<TopicKind, 3> kTopicKinds{{"array", "camera", "joints"}};

constexpr std::size_t kMostSide = 1024; ///< of an array, as core::ArrayLayout has it
constexpr std::size_t kMostJoints = 16; ///< as core::JointVector has it
constexpr std::int64_t kStampSecond_ns = 1'000'000'000;
constexpr char kContactType[] = "MSG: teleta_msgs/Contact\n";

bool readStamp(CdrReader& cdr, DecodedMessage& decoded) {
    const auto seconds = cdr.number<std::int32_t>();
    const auto nanoseconds = cdr.number<std::uint32_t>();
    decoded.stamp_ns = seconds * kStampSecond_ns + nanoseconds;
    return !cdr.failed();
}

bool readHeader(CdrReader& cdr, DecodedMessage& decoded) {
    (void)readStamp(cdr, decoded);
    (void)cdr.text(); // frame_id
    return !cdr.failed();
}

bool isShapeOfArray(std::size_t rows, std::size_t columns) {
    return rows >= 1 && columns >= 1 && rows <= kMostSide && columns <= kMostSide;
}

/// The pixels of an image, row by row, whatever its rows are padded with.
template <typename Pixel, typename Take>
void forEachPixel(std::string_view data, std::size_t rows, std::size_t columns, std::size_t step, bool swaps,
                  const Take& take) {
    for (std::size_t row = 0; row < rows; ++row) {
        const char* bytes = data.data() + row * step;
        for (std::size_t column = 0; column < columns; ++column) {
            std::array<char, sizeof(Pixel)> copy{};
            std::copy_n(bytes + column * sizeof(Pixel), sizeof(Pixel), copy.begin());
            if (swaps)
                std::ranges::reverse(copy);
            take(std::bit_cast<Pixel>(copy));
        }
    }
}

std::size_t bytesOfPixel(std::string_view encoding) {
    if (encoding == "32FC1")
        return sizeof(float);
    if (encoding == "16UC1" || encoding == "mono16")
        return sizeof(std::uint16_t);
    return encoding == "mono8" || encoding == "8UC1" ? sizeof(std::uint8_t) : 0;
}

bool takePicture(core::Expected<core::GreyImage> image, DecodedMessage& decoded) {
    if (!image)
        return false;
    decoded.image = std::move(*image);
    decoded.shape = {static_cast<std::size_t>(decoded.image.height_px),
                     static_cast<std::size_t>(decoded.image.width_px)};
    return true;
}

core::Expected<core::GreyImage> bytesOf(const core::Expected<core::ColourImage>& image) {
    TELETA_CHECK(image);
    return core::bytesOf(*image);
}

bool decodeImage(TopicRole role, CdrReader& cdr, DecodedMessage& decoded) {
    if (!readHeader(cdr, decoded))
        return false;
    const std::size_t rows = cdr.number<std::uint32_t>();
    const std::size_t columns = cdr.number<std::uint32_t>();
    const std::string_view encoding = cdr.text();
    const bool swaps = cdr.number<std::uint8_t>() != 0;
    const std::size_t step = cdr.number<std::uint32_t>();
    const std::string_view data = cdr.byteSequence();
    if (cdr.failed())
        return false;
    if (role != TopicRole::arrayImage) {
        const picture::RawPicture raw{
            .encoding = encoding == "16UC1" ? "mono16" : encoding,
            .width_px = columns,
            .height_px = rows,
            .rowBytes = step,
            .isBigEndian = swaps,
            .data = {reinterpret_cast<const std::uint8_t*>(data.data()), data.size()}};
        return takePicture(
            role == TopicRole::colourImage ? bytesOf(picture::colourOf(raw)) : picture::greyOf(raw), decoded);
    }
    const std::size_t size = bytesOfPixel(encoding);
    if (size == 0 || !isShapeOfArray(rows, columns) || columns > step / size || rows > data.size() / step)
        return false;
    decoded.shape = {rows, columns};
    decoded.floats.reserve(rows * columns);
    const auto take = [&](auto pixel) { decoded.floats.push_back(static_cast<float>(pixel)); };
    if (size == sizeof(float))
        forEachPixel<float>(data, rows, columns, step, swaps, take);
    else if (size == sizeof(std::uint16_t))
        forEachPixel<std::uint16_t>(data, rows, columns, step, swaps, take);
    else
        forEachPixel<std::uint8_t>(data, rows, columns, step, swaps, take);
    return true;
}

bool decodeCompressed(TopicRole role, CdrReader& cdr, DecodedMessage& decoded) {
    if (!readHeader(cdr, decoded))
        return false;
    (void)cdr.text(); // the bytes say better what they are
    const std::string_view bytes = cdr.byteSequence();
    if (cdr.failed() || !takePicture(role == TopicRole::colourPicture ? bytesOf(picture::colourOfCoded(bytes))
                                                                      : picture::greyOfCoded(bytes),
                                     decoded))
        return false;
    if (role != TopicRole::arrayPicture)
        return true;
    const core::GreyImage image = std::exchange(decoded.image, {});
    if (!isShapeOfArray(decoded.shape[0], decoded.shape[1]))
        return false;
    decoded.floats.assign(image.pixels.get(), image.pixels.get() + decoded.shape[0] * decoded.shape[1]);
    return true;
}

bool decodeTactileArray(CdrReader& cdr, DecodedMessage& decoded) {
    if (!readHeader(cdr, decoded))
        return false;
    const std::size_t rows = cdr.number<std::uint32_t>();
    const std::size_t columns = cdr.number<std::uint32_t>();
    decoded.pitch_m = cdr.number<double>();
    decoded.unit = cdr.text();
    (void)cdr.text(); // frame_axes
    cdr.sequence(decoded.floats);
    decoded.shape = {rows, columns};
    return !cdr.failed() && isShapeOfArray(rows, columns) && decoded.floats.size() == rows * columns;
}

bool decodeMultiArray(CdrReader& cdr, DecodedMessage& decoded) {
    constexpr std::size_t kDimensionBytes = 12;
    if (cdr.count(kDimensionBytes) != 2)
        return false;
    std::array<std::size_t, 2> sizes{};
    std::array<std::size_t, 2> strides{};
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        (void)cdr.text();
        sizes[i] = cdr.number<std::uint32_t>();
        strides[i] = cdr.number<std::uint32_t>();
    }
    const std::size_t offset = cdr.number<std::uint32_t>();
    std::vector<float> data;
    cdr.sequence(data);
    const auto [rows, columns] = sizes;
    if (cdr.failed() || !isShapeOfArray(rows, columns))
        return false;
    // The stride of the last dimension is the length of a row; many writers leave it out.
    const std::size_t step = std::max(strides[1], columns);
    if (offset > data.size() || (rows - 1) * step + columns > data.size() - offset)
        return false;
    decoded.shape = {rows, columns};
    for (std::size_t row = 0; row < rows; ++row) {
        const float* first = data.data() + offset + row * step;
        decoded.floats.insert(decoded.floats.end(), first, first + columns);
    }
    return true;
}

/// Angles, torques and references, which it does not have.
bool decodeJoints(CdrReader& cdr, DecodedMessage& decoded) {
    if (!readHeader(cdr, decoded))
        return false;
    constexpr std::size_t kNameBytes = 4;
    const std::size_t names = cdr.count(kNameBytes);
    for (std::size_t i = 0; i < names && !cdr.failed(); ++i)
        (void)cdr.text();
    std::vector<double> positions;
    std::vector<double> velocities;
    std::vector<double> efforts;
    cdr.sequence(positions);
    cdr.sequence(velocities);
    cdr.sequence(efforts);
    const std::size_t joints = std::max({names, positions.size(), efforts.size()});
    if (cdr.failed() || joints == 0 || joints > kMostJoints)
        return false;
    const auto fill = [&](std::vector<double> values) {
        values.resize(joints, std::numeric_limits<double>::quiet_NaN());
        decoded.doubles.insert(decoded.doubles.end(), values.begin(), values.end());
    };
    fill(std::move(positions));
    fill(std::move(efforts));
    fill({});
    decoded.shape = {3 * joints};
    return true;
}

bool decodeColumns(TopicRole role, CdrReader& cdr, std::size_t columns, DecodedMessage& decoded) {
    if (!readHeader(cdr, decoded) || columns == 0)
        return false;
    decoded.shape = {columns};
    if (role == TopicRole::contacts) {
        decoded.frames = cdr.count(columns * sizeof(double));
        cdr.array(decoded.frames * columns, decoded.doubles);
        return !cdr.failed();
    }
    if (role == TopicRole::features) {
        const auto type = static_cast<double>(cdr.number<std::uint8_t>());
        cdr.array(columns - 1, decoded.doubles);
        decoded.doubles.insert(decoded.doubles.begin(), type);
        return !cdr.failed();
    }
    cdr.array(columns, decoded.doubles);
    return !cdr.failed();
}

bool decodeTactors(CdrReader& cdr, DecodedMessage& decoded) {
    constexpr std::size_t kTactors = 6;
    if (!readHeader(cdr, decoded))
        return false;
    cdr.array(kTactors, decoded.floats);
    decoded.shape = {kTactors};
    return !cdr.failed();
}

bool decodeNumbers(CdrReader& cdr, DecodedMessage& decoded) {
    if (!readHeader(cdr, decoded))
        return false;
    constexpr std::size_t kNameBytes = 4;
    const std::size_t names = cdr.count(kNameBytes);
    for (std::size_t i = 0; i < names && !cdr.failed(); ++i)
        decoded.names.emplace_back(cdr.text());
    cdr.sequence(decoded.doubles);
    decoded.shape = {decoded.doubles.size()};
    return !cdr.failed() && names > 0 && decoded.doubles.size() == names;
}

bool decodeEvent(CdrReader& cdr, DecodedMessage& decoded) {
    if (!readStamp(cdr, decoded))
        return false;
    (void)cdr.number<std::uint8_t>(); // level
    decoded.event.text = cdr.text();
    decoded.event.kind = cdr.text();
    (void)cdr.text(); // file
    decoded.event.value = static_cast<double>(cdr.number<std::uint32_t>());
    return !cdr.failed();
}

} // namespace

const char* toString(TopicKind kind) {
    return kTopicKinds.of(kind);
}

std::optional<TopicKind> topicKindOf(std::string_view word) {
    return kTopicKinds.find(word);
}

std::optional<TopicRole> roleOf(const Channel& channel, const Schema* schema,
                                std::optional<TopicKind> wanted) {
    if (schema == nullptr || channel.encoding != "cdr" ||
        (schema->encoding != "ros2msg" && schema->encoding != "ros2idl"))
        return std::nullopt;
    const auto ifFits = [&](TopicRole role, TopicKind kind) {
        return !wanted || *wanted == kind ? std::optional(role) : std::nullopt;
    };
    const auto unlessWanted = [&](TopicRole role) { return wanted ? std::nullopt : std::optional(role); };
    const std::string& type = schema->name;
    if (type == "sensor_msgs/msg/Image") {
        if (wanted == TopicKind::joints)
            return std::nullopt;
        return wanted == TopicKind::camera ? TopicRole::cameraImage : TopicRole::arrayImage;
    }
    if (type == "sensor_msgs/msg/CompressedImage") {
        if (wanted == TopicKind::joints)
            return std::nullopt;
        return wanted == TopicKind::array ? TopicRole::arrayPicture : TopicRole::cameraPicture;
    }
    if (type == "sensor_msgs/msg/JointState")
        return ifFits(TopicRole::joints, TopicKind::joints);
    if (type == "teleta_msgs/msg/TactileArray")
        return ifFits(TopicRole::tactileArray, TopicKind::array);
    if (type == "std_msgs/msg/Float32MultiArray")
        return ifFits(TopicRole::multiArray, TopicKind::array);
    if (type == "sensor_msgs/msg/PointCloud2")
        return ifFits(TopicRole::points, TopicKind::array);
    if (type == "geometry_msgs/msg/WrenchStamped")
        return unlessWanted(TopicRole::wrench);
    if (type.starts_with("teleta_msgs/msg/TactileFeatures")) // of other units and with shear, too
        return unlessWanted(TopicRole::features);
    if (type == "teleta_msgs/msg/Touch")
        return unlessWanted(TopicRole::touch);
    if (type == "teleta_msgs/msg/Contacts")
        return unlessWanted(TopicRole::contacts);
    if (type == "teleta_msgs/msg/Tactors")
        return unlessWanted(TopicRole::tactors);
    if (type == "teleta_msgs/msg/Numbers")
        return unlessWanted(TopicRole::numbers);
    if (type == "foxglove_msgs/msg/Log")
        return unlessWanted(TopicRole::event);
    return std::nullopt;
}

std::optional<bool> isCloudOfTaxels(std::string_view message) {
    CdrReader cdr(message);
    DecodedMessage decoded;
    return readHeader(cdr, decoded) ? hasTaxelFields(cdr) : std::nullopt;
}

TopicRole imageRoleOf(TopicRole role, std::string_view message) {
    CdrReader cdr(message);
    DecodedMessage head;
    (void)readHeader(cdr, head);
    if (role == TopicRole::cameraPicture) {
        (void)cdr.text();
        return opencv::isColourPicture(cdr.byteSequence()) ? TopicRole::colourPicture : role;
    }
    (void)cdr.number<std::uint32_t>();
    (void)cdr.number<std::uint32_t>();
    const std::string_view encoding = cdr.text();
    if (picture::hasColours(encoding))
        return TopicRole::colourImage;
    return bytesOfPixel(encoding) == 1 ? TopicRole::cameraImage : TopicRole::arrayImage;
}

bool decodeMessage(TopicRole role, std::string_view message, std::size_t columns, DecodedMessage& decoded) {
    decoded = {};
    CdrReader cdr(message);
    switch (role) {
    case TopicRole::arrayImage:
    case TopicRole::cameraImage:
    case TopicRole::colourImage:
        return decodeImage(role, cdr, decoded);
    case TopicRole::arrayPicture:
    case TopicRole::cameraPicture:
    case TopicRole::colourPicture:
        return decodeCompressed(role, cdr, decoded);
    case TopicRole::tactileArray:
        return decodeTactileArray(cdr, decoded);
    case TopicRole::multiArray:
        return decodeMultiArray(cdr, decoded);
    case TopicRole::points:
        return readHeader(cdr, decoded) && readPoints(cdr, decoded.points);
    case TopicRole::joints:
        return decodeJoints(cdr, decoded);
    case TopicRole::wrench:
        return decodeColumns(role, cdr, 6, decoded);
    case TopicRole::features:
    case TopicRole::touch:
    case TopicRole::contacts:
        return decodeColumns(role, cdr, columns, decoded);
    case TopicRole::tactors:
        return decodeTactors(cdr, decoded);
    case TopicRole::numbers:
        return decodeNumbers(cdr, decoded);
    case TopicRole::event:
        return decodeEvent(cdr, decoded);
    }
    return false;
}

std::vector<recording::Column> schemaColumns(TopicRole role, const Schema& schema) {
    std::string_view text = schema.text;
    if (role == TopicRole::contacts) {
        const std::size_t contact = text.find(kContactType);
        text = contact == std::string_view::npos ? std::string_view()
                                                 : text.substr(contact + std::strlen(kContactType));
    }
    std::vector<recording::Column> columns;
    for (auto& [type, name] : schemaFields(text)) {
        if (type == "float64" || name == "contact_type")
            columns.push_back({std::move(name), {}});
    }
    return columns;
}

} // namespace teleta::mcap
