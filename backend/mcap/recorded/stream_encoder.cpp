// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/mcap/recorded/stream_encoder.h"

#include "backend/mcap/cdr_writer.h"
#include "backend/mcap/recorded/png_encoder.h"
#include "backend/mcap/recorded/point_cloud.h"
#include "backend/mcap/ros_schemas.h"
#include "backend/pipeline/recorded/recorded_layout.h"
#include "backend/recording/recording.h"
#include "backend/recording/stream_columns.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace teleta::mcap {

namespace {

using core::TappedFrames;
using recording::Column;
using recording::StreamInfo;
using recording::StreamKind;
using recording::ValueType;

constexpr std::int64_t kSecond_ns = 1'000'000'000;
constexpr std::uint8_t kInformation = 2;
constexpr char kHeaderField[] = "std_msgs/Header header\n";
constexpr char kFrameAxes[] = "x along the columns, y along the rows, z out of the surface";

void writeStamp(CdrWriter& cdr, std::int64_t utc_ns) {
    cdr.number(static_cast<std::int32_t>(utc_ns / kSecond_ns));
    cdr.number(static_cast<std::uint32_t>(utc_ns % kSecond_ns));
}

void writeHeader(CdrWriter& cdr, std::int64_t utc_ns, const std::string& frame) {
    writeStamp(cdr, utc_ns);
    cdr.text(frame);
}

void writeImage(CdrWriter& cdr, std::size_t rows, std::size_t columns, std::span<const float> values) {
    cdr.number(static_cast<std::uint32_t>(rows));
    cdr.number(static_cast<std::uint32_t>(columns));
    cdr.text("32FC1");
    cdr.number(std::uint8_t{0});
    cdr.number(static_cast<std::uint32_t>(columns * sizeof(float)));
    cdr.byteSequence({reinterpret_cast<const char*>(values.data()), values.size_bytes()});
}

void writeWrench(CdrWriter& cdr, const std::array<double, 6>& forceAndTorque) {
    cdr.array(std::span<const double>(forceAndTorque));
}

/// What acts on an array. Nothing is pressed: no torque, wherever the centre of pressure would be.
std::array<double, 6> wrenchOf(double force_N, double copX_m, double copY_m) {
    if (force_N == 0.0)
        return {};
    return {0.0, 0.0, -force_N, -force_N * copY_m, force_N * copX_m, 0.0};
}

void writeJoints(CdrWriter& cdr, const std::vector<std::string>& names, std::span<const double> position,
                 std::span<const double> effort) {
    cdr.number(static_cast<std::uint32_t>(names.size()));
    for (const std::string& name : names)
        cdr.text(name);
    cdr.sequence(position);
    cdr.sequence(std::span<const double>());
    cdr.sequence(effort);
}

void writePicture(CdrWriter& cdr, const core::GreyImage& image, int level, PngPixel pixel) {
    cdr.text("png");
    cdr.byteSequence(encodePng(image, level, pixel));
}

std::string columnFields(std::span<const Column> columns) {
    std::string fields;
    for (const Column& column : columns)
        fields.append("float64 ").append(column.name).append("\n");
    return fields;
}

std::optional<std::size_t> columnOf(const StreamInfo& stream, std::string_view name) {
    const auto found = std::ranges::find(stream.columns, name, &Column::name);
    if (found == stream.columns.end())
        return std::nullopt;
    return static_cast<std::size_t>(found - stream.columns.begin());
}

/// One name for each definition: that of the package teleta_msgs for loads in N; for other units and for
/// vectors "TactileFeaturesUt", "TactileFeaturesShear", "TactileFeaturesUtShear".
std::string featuresTypeOf(const std::vector<Column>& columns) {
    constexpr std::string_view kForce = "force_";
    std::string type = "TactileFeatures";
    const std::string& force = columns.size() > 1 ? columns[1].name : std::string();
    if (force.starts_with(kForce) && force != "force_n") {
        bool begins = true;
        for (const char letter : std::string_view(force).substr(kForce.size())) {
            const auto code = static_cast<unsigned char>(letter);
            if (std::isalnum(code) != 0)
                type += begins ? static_cast<char>(std::toupper(code)) : letter;
            begins = std::isalnum(code) == 0;
        }
    }
    if (std::ranges::find(columns, "friction_ratio", &Column::name) != columns.end())
        type += "Shear";
    return type;
}

double pitchOf(const StreamInfo& stream) {
    const auto details = nlohmann::json::parse(stream.details, nullptr, /*allow_exceptions=*/false);
    if (!details.is_object() || !details.contains("pitch_m") || !details["pitch_m"].is_number())
        return 0.0;
    return details["pitch_m"].get<double>();
}

} // namespace

std::string featuresDefinition(const std::vector<Column>& columns) {
    return std::string(kHeaderField) + "uint8 NONE=0\nuint8 POINT=1\nuint8 EDGE=2\nuint8 contact_type\n" +
           columnFields(std::span(columns).subspan(1));
}

std::string touchDefinition(const std::vector<Column>& columns) {
    return kHeaderField + columnFields(columns);
}

std::string contactDefinition(const std::vector<Column>& columns) {
    return columnFields(columns);
}

std::string contactsDefinition() {
    return std::string(kHeaderField) + "Contact[] contacts\n";
}

StreamEncoder::StreamEncoder(StreamInfo stream, RosNames names, int pictureLevel)
    : m_stream(std::move(stream))
    , m_names(std::move(names))
    , m_pictureLevel(pictureLevel) {
    describe();
}

void StreamEncoder::add(Message message, const char* topic, std::string_view type, std::string text) {
    const std::size_t slash = type.find('/');
    const std::string package(type.substr(0, slash));
    if (text.empty())
        text = schemaText(rosDefinition(type), package);
    m_topics.push_back({"/" + m_names.topic + "/" + topic,
                        package + "/msg/" + std::string(type.substr(slash + 1)), std::move(text)});
    m_messages.push_back(message);
}

void StreamEncoder::describe() {
    const bool isDouble = m_stream.type == ValueType::float64;
    const bool isFloat = m_stream.type == ValueType::float32;
    switch (m_stream.kind) {
    case StreamKind::array:
        if (!isFloat)
            return;
        // TactileArray has loads on a grid with one pitch.
        if (auto layout = pipeline::layoutOf(m_stream);
            layout &&
            (layout->isVector() || !layout->isGrid() || layout->grid().pitchX_m != layout->grid().pitchY_m)) {
            m_layout = std::move(*layout);
            add(Message::points, "points", "sensor_msgs/PointCloud2");
            return;
        }
        if (m_stream.shape.size() != 2)
            return;
        m_pitch_m = pitchOf(m_stream);
        add(Message::image, "image", "sensor_msgs/Image");
        add(Message::array, "array", "teleta_msgs/TactileArray");
        return;
    case StreamKind::features: {
        if (!isDouble || m_stream.columns.empty() || m_stream.columns.front().name != "contact_type")
            return;
        add(Message::features, "features", "teleta_msgs/" + featuresTypeOf(m_stream.columns),
            schemaText(featuresDefinition(m_stream.columns), "teleta_msgs"));
        const auto force = columnOf(m_stream, "force_n");
        const auto copX = columnOf(m_stream, "cop_x_m");
        const auto copY = columnOf(m_stream, "cop_y_m");
        if (!force || !copX || !copY)
            return;
        m_force = *force;
        m_copX = *copX;
        m_copY = *copY;
        m_shearX = columnOf(m_stream, "shear_x_n");
        if (m_shearX && *m_shearX + 2 >= m_stream.columns.size())
            m_shearX.reset();
        add(Message::featureWrench, "wrench", "geometry_msgs/WrenchStamped");
        return;
    }
    case StreamKind::contacts: {
        if (!isDouble || m_stream.columns.empty())
            return;
        for (const Column& column : m_stream.columns)
            m_signs.push_back(m_names.turnsY && (column.name == "y_m" || column.name == "dy_m") ? -1.0 : 1.0);
        std::string text = schemaText(contactsDefinition(), "teleta_msgs");
        appendType(text, "teleta_msgs/Contact", contactDefinition(m_stream.columns));
        add(Message::contacts, "contacts", "teleta_msgs/Contacts", std::move(text));
        return;
    }
    case StreamKind::touches:
        if (!isDouble || m_stream.columns.empty())
            return;
        add(Message::touch, "touches", "teleta_msgs/Touch",
            schemaText(touchDefinition(m_stream.columns), "teleta_msgs"));
        return;
    case StreamKind::joints:
        if (!recording::jointsOf(m_stream))
            return;
        for (std::size_t i = 1; i <= *recording::jointsOf(m_stream); ++i)
            m_jointNames.push_back("q" + std::to_string(i));
        add(Message::jointStates, "joint_states", "sensor_msgs/JointState");
        add(Message::jointReferences, "joint_references", "sensor_msgs/JointState");
        return;
    case StreamKind::camera:
        if (m_stream.type == ValueType::grey8)
            add(Message::picture, "image/compressed", "sensor_msgs/CompressedImage");
        return;
    case StreamKind::tactors:
        if (isFloat && m_stream.channels() == 6)
            add(Message::tactors, "tactors", "teleta_msgs/Tactors");
        return;
    case StreamKind::wrench:
        if (isDouble && m_stream.channels() == recording::wrenchColumns().size())
            add(Message::wrench, "wrench", "geometry_msgs/WrenchStamped");
        return;
    case StreamKind::numbers:
        if (isDouble && !m_stream.columns.empty() && m_stream.columns.size() == m_stream.channels())
            add(Message::numbers, "numbers", "teleta_msgs/Numbers");
        return;
    }
}

std::size_t StreamEncoder::framesOfMessage(const TappedFrames& block, std::size_t frame) const {
    std::size_t frames = 1;
    if (m_stream.kind == StreamKind::contacts) {
        while (frame + frames < block.frames() && block.time_ns[frame + frames] == block.time_ns[frame])
            ++frames;
    }
    return frames;
}

void StreamEncoder::encode(std::size_t topic, const TappedFrames& block, std::size_t frame,
                           std::size_t frames, std::int64_t utc_ns, std::string& bytes) const {
    CdrWriter cdr(bytes);
    writeHeader(cdr, utc_ns, m_names.frame);
    const std::size_t channels = m_stream.channels();
    const auto doubles = [&](std::size_t number) {
        return recording::valuesOf<double>(block, number, channels);
    };
    switch (m_messages[topic]) {
    case Message::image:
        writeImage(cdr, m_stream.shape[0], m_stream.shape[1],
                   recording::valuesOf<float>(block, frame, channels));
        break;
    case Message::array:
        cdr.number(static_cast<std::uint32_t>(m_stream.shape[0]));
        cdr.number(static_cast<std::uint32_t>(m_stream.shape[1]));
        cdr.number(m_pitch_m);
        cdr.text(m_stream.unit);
        cdr.text(kFrameAxes);
        cdr.sequence(recording::valuesOf<float>(block, frame, channels));
        break;
    case Message::points:
        writePoints(cdr, m_layout, recording::valuesOf<float>(block, frame, channels));
        break;
    case Message::features: {
        const std::span<const double> values = doubles(frame);
        const double type = values.front();
        const bool isKnown = type >= 0.0 && type <= std::numeric_limits<std::uint8_t>::max();
        cdr.number(isKnown ? static_cast<std::uint8_t>(type) : std::uint8_t{0});
        cdr.array(values.subspan(1));
        break;
    }
    case Message::featureWrench: {
        const std::span<const double> values = doubles(frame);
        std::array<double, 6> wrench = wrenchOf(values[m_force], values[m_copX], values[m_copY]);
        if (m_shearX && std::isfinite(values[*m_shearX])) {
            wrench[0] = values[*m_shearX];
            wrench[1] = values[*m_shearX + 1];
            // The columns have the moment at the centre of pressure, a wrench that at the origin.
            wrench[5] = values[*m_shearX + 2] + values[m_copX] * wrench[1] - values[m_copY] * wrench[0];
        }
        writeWrench(cdr, wrench);
        break;
    }
    case Message::contacts:
        cdr.number(static_cast<std::uint32_t>(frames));
        for (std::size_t i = 0; i < frames; ++i) {
            const std::span<const double> values = doubles(frame + i);
            for (std::size_t column = 0; column < channels; ++column)
                cdr.number(m_signs[column] * values[column]);
        }
        break;
    case Message::touch:
        cdr.array(doubles(frame));
        break;
    case Message::jointStates: {
        const std::size_t joints = m_jointNames.size();
        const std::span<const double> values = doubles(frame);
        writeJoints(cdr, m_jointNames, values.first(joints), values.subspan(joints, joints));
        break;
    }
    case Message::jointReferences: {
        const std::size_t joints = m_jointNames.size();
        writeJoints(cdr, m_jointNames, doubles(frame).subspan(2 * joints, joints), {});
        break;
    }
    case Message::picture:
        writePicture(cdr, block.image, m_pictureLevel,
                     recording::isColour(m_stream) ? PngPixel::colour : PngPixel::grey);
        break;
    case Message::tactors:
        cdr.array(recording::valuesOf<float>(block, frame, channels));
        break;
    case Message::wrench:
        cdr.array(doubles(frame));
        break;
    case Message::numbers:
        cdr.number(static_cast<std::uint32_t>(m_stream.columns.size()));
        for (const Column& column : m_stream.columns)
            cdr.text(column.name);
        cdr.sequence(doubles(frame));
        break;
    }
}

TopicType eventTopic() {
    return {"/events", "foxglove_msgs/msg/Log",
            schemaText(rosDefinition("foxglove_msgs/Log"), "foxglove_msgs")};
}

void encodeEvent(const recording::RecordingEvent& event, std::int64_t utc_ns, std::string& bytes) {
    const bool isCount = event.value >= 0.0 &&
                         event.value <= double{std::numeric_limits<std::uint32_t>::max()} &&
                         event.value == std::floor(event.value);
    CdrWriter cdr(bytes);
    writeStamp(cdr, utc_ns);
    cdr.number(kInformation);
    cdr.text(event.text);
    cdr.text(event.kind);
    cdr.text({});
    cdr.number(isCount ? static_cast<std::uint32_t>(event.value) : std::uint32_t{0});
}

} // namespace teleta::mcap
