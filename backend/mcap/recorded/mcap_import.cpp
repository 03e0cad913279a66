// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/mcap/recorded/mcap_import.h"

#include "backend/core/data/array_layout.h"
#include "backend/core/data/taxel_layout.h"
#include "backend/core/failure.h"
#include "backend/mcap/mcap_reader.h"
#include "backend/mcap/recorded/imported_recording.h"
#include "backend/mcap/recorded/ros_names.h"
#include "backend/opencv/opencv_parts.h"
#include "backend/pipeline/recorded/recorded_layout.h"
#include "backend/pipeline/recorded/recorded_scene_camera.h"
#include "backend/pipeline/recorded/recorded_streams.h"
#include "backend/recording/new_recording.h"
#include "backend/recording/recording_writer.h"
#include "backend/recording/stream_columns.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace teleta::mcap {

namespace {

using recording::RecordingWriter;
using recording::StreamInfo;
using recording::StreamKind;
using recording::ValueType;

struct McapImportText {
    Q_DECLARE_TR_FUNCTIONS(McapImport)
};

/// Frames that wait for the writer together; from those of a stream that no note describes comes its rate.
constexpr std::size_t kFramesAtOnce = 128;
constexpr std::size_t kBytesAtOnce = std::size_t{1} << 20U;
constexpr std::size_t kCommitBytes = std::size_t{8} << 20U;
constexpr int kMessagesBetweenLooks = 256;
constexpr std::string_view kReferences = "/joint_references";
constexpr std::string_view kStates = "/joint_states";

/// Everything about a topic, from its type to its frames on the way to the writer.
struct TopicState {
    McapImport::Topic report;
    std::optional<TopicRole> role;
    bool isImageOpen = false; ///< its first message says what it is read as
    bool isCloudOpen = false; ///< the fields of its first message say whether it is one of taxels
    std::optional<core::TaxelLayout> layout; ///< of points, once it is known
    bool isReference = false;                ///< of the joints of another topic
    TopicState* references = nullptr;
    std::optional<NotedStream> noted;
    std::size_t columns = 0;
    std::vector<recording::Column> columnNames;
    std::optional<std::size_t> stream; ///< of the writer
    StreamInfo info;                   ///< once there is a frame
    core::TappedFrames waiting;
    /// A joint sample whose references may come yet.
    std::optional<std::int64_t> sample_ns;
    std::vector<double> sample;
    double sampleTime_s = 0.0;
};

/// The kind of stream that a role becomes.
StreamInfo infoOf(TopicRole role, const DecodedMessage& first,
                  const std::vector<recording::Column>& columns) {
    StreamInfo info;
    switch (role) {
    case TopicRole::arrayImage:
    case TopicRole::arrayPicture:
    case TopicRole::tactileArray:
    case TopicRole::multiArray: {
        core::SourceDescription description;
        core::ArrayLayout layout{static_cast<int>(first.shape[0]), static_cast<int>(first.shape[1])};
        if (std::isfinite(first.pitch_m) && first.pitch_m > 1e-9 && first.pitch_m < 1e3)
            layout.setPitch_m(first.pitch_m);
        description.layout = layout;
        description.unit = first.unit;
        const pipeline::ChannelSettings settings;
        return pipeline::arrayStream(std::string(), description, settings);
    }
    case TopicRole::points: {
        core::SourceDescription description;
        description.layout = core::TaxelLayout(std::make_shared<const core::TaxelPlaces>(first.points.places),
                                               first.points.components);
        description.unit = first.points.components == core::TaxelLayout::kVector ? "N" : "";
        return pipeline::arrayStream(std::string(), description, pipeline::ChannelSettings());
    }
    case TopicRole::colourImage:
    case TopicRole::colourPicture:
        return pipeline::sceneCameraStream({}, {});
    case TopicRole::cameraImage:
    case TopicRole::cameraPicture:
        info.kind = StreamKind::camera;
        info.type = ValueType::grey8;
        info.shape = first.shape;
        return info;
    case TopicRole::joints:
        return recording::jointStream(0.0, first.shape[0] / recording::kJointKinds);
    case TopicRole::tactors:
        info.kind = StreamKind::tactors;
        info.type = ValueType::float32;
        info.shape = first.shape;
        return info;
    case TopicRole::wrench:
        info.kind = StreamKind::wrench;
        info.columns = recording::wrenchColumns();
        break;
    case TopicRole::features:
        info.kind = StreamKind::features;
        info.columns = columns;
        break;
    case TopicRole::touch:
        info.kind = StreamKind::touches;
        info.columns = columns;
        break;
    case TopicRole::contacts:
        info.kind = StreamKind::contacts;
        info.columns = columns;
        break;
    case TopicRole::numbers:
        info.kind = StreamKind::numbers;
        for (const std::string& name : first.names)
            info.columns.push_back({name, {}});
        break;
    case TopicRole::event:
        return info;
    }
    info.type = ValueType::float64;
    info.shape = first.shape;
    return info;
}

double rateOf(const std::vector<std::int64_t>& time_ns) {
    if (time_ns.size() < 2 || time_ns.back() <= time_ns.front())
        return 0.0;
    return static_cast<double>(time_ns.size() - 1) * 1e9 /
           static_cast<double>(time_ns.back() - time_ns.front());
}

class Import {
public:
    Import(McapReader& reader, ImportedRecording imported, RecordingWriter& writer)
        : m_reader(reader)
        , m_imported(std::move(imported))
        , m_writer(writer) {}

    /// Decides what each topic is read as. Error: refused.
    [[nodiscard]] core::Expected<void> choose(const McapImportOptions& options, const std::string& path) {
        QStringList all;
        for (const auto& [id, channel] : m_reader.map().channels) {
            const Schema* schema = m_reader.schemaOf(channel);
            TopicState& topic = m_topics[id];
            topic.report.name = channel.topic;
            topic.report.type = schema == nullptr ? std::string() : schema->name;
            const auto wanted = options.topics.find(channel.topic);
            const bool isWanted = wanted != options.topics.end();
            topic.role = roleOf(channel, schema, isWanted ? std::optional(wanted->second) : std::nullopt);
            topic.isImageOpen =
                !isWanted && (topic.role == TopicRole::arrayImage || topic.role == TopicRole::cameraPicture);
            topic.isCloudOpen = topic.role == TopicRole::points;
            if (isWanted && !topic.role)
                return core::failed(core::ErrorKind::refused,
                                    McapImportText::tr("%1 is of the type %2 and cannot be read as %3")
                                        .arg(QString::fromStdString(channel.topic),
                                             QString::fromStdString(topic.report.type),
                                             QLatin1String(toString(wanted->second))),
                                    {}, {path});
            if (topic.role && schema != nullptr) {
                topic.columnNames = schemaColumns(*topic.role, *schema);
                topic.columns = topic.columnNames.size();
            }
            all << QStringLiteral("%1 (%2, %3)")
                       .arg(QString::fromStdString(channel.topic), QString::fromStdString(channel.encoding),
                            QString::fromStdString(topic.report.type));
        }
        for (const auto& [name, kind] : options.topics) {
            if (std::ranges::none_of(m_topics,
                                     [&](const auto& topic) { return topic.second.report.name == name; }))
                return core::failed(
                    core::ErrorKind::refused,
                    McapImportText::tr("there is no topic %1").arg(QString::fromStdString(name)),
                    McapImportText::tr("one of %1").arg(all.join(QStringLiteral(", "))), {path});
        }
        settleExport(options);
        joinReferences();
        if (std::ranges::none_of(m_topics, [](const auto& topic) { return topic.second.role.has_value(); }))
            return core::failed(
                core::ErrorKind::refused,
                McapImportText::tr("no topic of this file can be read: %1")
                    .arg(all.isEmpty() ? McapImportText::tr("it has none") : all.join(QStringLiteral(", "))),
                McapImportText::tr("messages of ROS 2 in CDR"), {path});
        if (std::ranges::any_of(m_topics, [](const auto& topic) {
                return topic.second.role == TopicRole::arrayPicture ||
                       topic.second.role == TopicRole::cameraPicture ||
                       topic.second.role == TopicRole::colourPicture;
            }))
            TELETA_CHECK(opencv::pictures());
        return {};
    }

    [[nodiscard]] core::Expected<void> read(const McapImportOptions& options) {
        for (auto& [topic, noted] : m_imported.streams) {
            TELETA_CHECK(m_writer.addStream(noted.info));
            m_names.insert(noted.info.name);
            ++m_streams;
        }
        Message message;
        int left = kMessagesBetweenLooks;
        while (m_reader.next(message)) {
            take(message);
            if (m_failure)
                return core::Unexpected(*m_failure);
            if (--left > 0)
                continue;
            left = kMessagesBetweenLooks;
            if (options.goOn && !options.goOn(m_reader.share()))
                return core::failed(core::ErrorKind::cancelled, McapImportText::tr("interrupted"));
        }
        for (auto& [id, topic] : m_topics) {
            completeSample(topic);
            flush(topic);
        }
        if (m_failure)
            return core::Unexpected(*m_failure);
        if (!m_imported.isExport && m_reader.map().isComplete)
            m_writer.take({.time_ns = m_writer.newest_ns(), .kind = recording::kStopped, .text = {}});
        return m_writer.commit();
    }

    [[nodiscard]] McapImport report() const {
        McapImport report;
        for (const auto& [id, topic] : m_topics)
            report.topics.push_back(topic.report);
        report.frames = m_writer.frames();
        return report;
    }

private:
    /// In an export, the first topic of a stream has its values; others repeat them.
    void settleExport(const McapImportOptions& options) {
        for (auto& [id, topic] : m_topics) {
            if (!m_imported.isExport) {
                if (topic.role == TopicRole::event)
                    topic.role.reset();
                continue;
            }
            if (options.topics.contains(topic.report.name))
                continue;
            topic.report.isKept = topic.role == TopicRole::event;
            for (std::size_t i = 0; i < m_imported.streams.size(); ++i) {
                const auto& [part, noted] = m_imported.streams[i];
                if (!topic.report.name.starts_with("/" + part + "/"))
                    continue;
                const StreamKind kind = noted.info.kind;
                const bool isRepeat = (kind == StreamKind::array && topic.role == TopicRole::arrayImage) ||
                                      (kind == StreamKind::features && topic.role == TopicRole::wrench);
                topic.report.isKept = topic.role.has_value();
                if (isRepeat)
                    topic.role.reset();
                topic.isImageOpen = false;
                topic.isCloudOpen = false;
                if (topic.role == TopicRole::cameraPicture && recording::isColour(noted.info))
                    topic.role = TopicRole::colourPicture;
                topic.noted = noted;
                topic.stream = i;
                topic.info = noted.info;
                topic.columns = noted.info.channels();
                topic.layout = pipeline::layoutOf(noted.info);
                if (topic.role)
                    topic.report.stream = noted.info.name;
            }
        }
    }

    /// The references of joints have a topic beside that of the joints.
    void joinReferences() {
        for (auto& [id, topic] : m_topics) {
            if (topic.role != TopicRole::joints || !topic.report.name.ends_with(kStates))
                continue;
            const std::string name =
                topic.report.name.substr(0, topic.report.name.size() - kStates.size()).append(kReferences);
            for (auto& [otherId, other] : m_topics) {
                if (other.report.name != name || other.role != TopicRole::joints)
                    continue;
                topic.references = &other;
                other.isReference = true;
                other.report.stream = topic.report.stream;
                other.report.isKept = topic.report.isKept;
                m_jointsOf[otherId] = &topic;
            }
        }
    }

    void take(const Message& message) {
        const auto found = m_topics.find(message.channel);
        if (found == m_topics.end())
            return;
        TopicState& topic = found->second;
        constexpr auto kLast_ns = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max() / 2);
        if (!topic.role)
            return;
        if (std::exchange(topic.isImageOpen, false))
            topic.role = imageRoleOf(*topic.role, message.data);
        if (topic.isCloudOpen) {
            const std::optional<bool> isOfTaxels = isCloudOfTaxels(message.data);
            topic.isCloudOpen = !isOfTaxels;
            if (isOfTaxels == false) {
                topic.role.reset(); // as of a depth camera
                return;
            }
        }
        if (message.log_ns > kLast_ns ||
            !decodeMessage(*topic.role, message.data, topic.columns, m_decoded) ||
            (topic.role == TopicRole::points && !placePoints(topic)) ||
            (topic.role == TopicRole::numbers && !hasNamesOf(topic))) {
            ++topic.report.bad;
            return;
        }
        const std::int64_t time_ns = static_cast<std::int64_t>(message.log_ns) - m_imported.utcOffset_ns;
        const std::int64_t stamp_ns =
            m_decoded.stamp_ns.value_or(static_cast<std::int64_t>(message.log_ns)) - m_imported.utcOffset_ns;
        const double sourceTime_s = static_cast<double>(stamp_ns - m_imported.head.start_ns) * 1e-9;
        if (topic.role == TopicRole::event) {
            m_decoded.event.time_ns = time_ns;
            m_writer.take(m_decoded.event);
            ++topic.report.messages;
        } else if (topic.isReference) {
            takeReferences(*m_jointsOf[message.channel], time_ns, topic);
        } else if (topic.role == TopicRole::joints) {
            takeSample(topic, time_ns, sourceTime_s);
        } else {
            takeFrames(topic, time_ns, sourceTime_s);
        }
    }

    /// Brings points into the order of their layout, which the first ones make where no note has it.
    bool placePoints(TopicState& topic) {
        const std::vector<core::TaxelPlace>& places = m_decoded.points.places;
        if (!topic.layout) {
            if (places.size() > core::TaxelPlaces::kMost || core::TaxelPlaces::sameOf(places))
                return false;
            topic.layout = core::TaxelLayout(std::make_shared<const core::TaxelPlaces>(places),
                                             m_decoded.points.components);
        }
        m_decoded.floats = valuesOn(*topic.layout, m_decoded.points);
        m_decoded.shape = pipeline::shapeOf(*topic.layout);
        return !m_decoded.floats.empty();
    }

    /// Numbers with other names are of other columns.
    [[nodiscard]] bool hasNamesOf(const TopicState& topic) const {
        const bool isFirst = !topic.stream && topic.waiting.frames() == 0;
        return isFirst ||
               std::ranges::equal(m_decoded.names, topic.info.columns, {}, {}, &recording::Column::name);
    }

    void takeSample(TopicState& topic, std::int64_t time_ns, double sourceTime_s) {
        completeSample(topic);
        topic.sample_ns = time_ns;
        topic.sample = std::move(m_decoded.doubles);
        topic.sampleTime_s = sourceTime_s;
        if (topic.references == nullptr)
            completeSample(topic);
    }

    void takeReferences(TopicState& joints, std::int64_t time_ns, TopicState& topic) {
        const std::size_t count = joints.sample.size() / recording::kJointKinds;
        if (joints.sample_ns != time_ns || m_decoded.doubles.size() < count) {
            ++topic.report.bad;
            return;
        }
        // Positions come first.
        std::copy_n(m_decoded.doubles.begin(), count,
                    joints.sample.end() - static_cast<std::ptrdiff_t>(count));
        ++topic.report.messages;
        completeSample(joints);
    }

    void completeSample(TopicState& topic) {
        if (!topic.sample_ns)
            return;
        m_decoded = {};
        m_decoded.shape = {topic.sample.size()};
        m_decoded.doubles = topic.sample;
        const std::int64_t time_ns = *std::exchange(topic.sample_ns, std::nullopt);
        takeFrames(topic, time_ns, topic.sampleTime_s);
    }

    /// Adds the frames of m_decoded to those that wait.
    void takeFrames(TopicState& topic, std::int64_t time_ns, double sourceTime_s) {
        const bool isFirst = !topic.stream && topic.waiting.frames() == 0;
        if (isFirst)
            topic.info = infoOf(*topic.role, m_decoded, topic.columnNames);
        const bool isPicture = !m_decoded.image.isEmpty();
        const std::size_t size = isPicture ? 0 : topic.info.channels() * topic.info.bytesPerValue();
        const std::string_view bytes =
            topic.info.type == ValueType::float32
                ? std::string_view(reinterpret_cast<const char*>(m_decoded.floats.data()),
                                   m_decoded.floats.size() * sizeof(float))
                : std::string_view(reinterpret_cast<const char*>(m_decoded.doubles.data()),
                                   m_decoded.doubles.size() * sizeof(double));
        const bool hasShape =
            isPicture ? topic.info.type == ValueType::grey8
                      : topic.info.type != ValueType::grey8 &&
                            (topic.info.kind != StreamKind::array || m_decoded.shape == topic.info.shape) &&
                            bytes.size() == m_decoded.frames * size;
        if (!hasShape) {
            ++topic.report.bad;
            return;
        }
        ++topic.report.messages;
        turn(topic);
        core::TappedFrames& waiting = topic.waiting;
        const bool goesBack = !waiting.time_ns.empty() && time_ns < waiting.time_ns.back();
        if (goesBack)
            flush(topic);
        for (std::size_t i = 0; i < m_decoded.frames; ++i) {
            waiting.time_ns.push_back(time_ns);
            waiting.sourceTime_s.push_back(sourceTime_s);
        }
        const auto* first = reinterpret_cast<const std::byte*>(bytes.data());
        waiting.values.insert(waiting.values.end(), first, first + bytes.size());
        waiting.image = m_decoded.image;
        if (isPicture || waiting.frames() >= kFramesAtOnce || waiting.values.size() >= kBytesAtOnce)
            flush(topic);
    }

    /// Back into the recording's own frame.
    void turn(const TopicState& topic) {
        if (!topic.noted || !topic.noted->turnsY)
            return;
        const std::size_t columns = topic.info.columns.size();
        for (std::size_t i = 0; columns > 0 && i < m_decoded.doubles.size(); ++i) {
            const std::string& name = topic.info.columns[i % columns].name;
            if (name == "y_m" || name == "dy_m")
                m_decoded.doubles[i] = -m_decoded.doubles[i];
        }
    }

    void flush(TopicState& topic) {
        if (topic.waiting.frames() == 0 || m_failure)
            return;
        if (!topic.stream) {
            topic.info.name = streamName(topic.report.name);
            topic.info.source = topic.report.name;
            topic.info.nominalRate_Hz = rateOf(topic.waiting.time_ns);
            if (const auto added = m_writer.addStream(topic.info); !added) {
                m_failure = added.error();
                return;
            }
            topic.report.stream = topic.info.name;
            topic.report.isKept = true;
            topic.stream = m_streams++;
        }
        m_writer.take(*topic.stream, std::exchange(topic.waiting, {}));
        if (m_writer.waitingBytes() < kCommitBytes)
            return;
        if (const auto done = m_writer.commit(); !done)
            m_failure = done.error();
    }

    std::string streamName(const std::string& topic) {
        const std::string wanted = topicPart(topic.substr(topic.starts_with('/') ? 1 : 0));
        std::string name = wanted;
        for (int number = 2; !m_names.insert(name).second; ++number)
            name = wanted + "_" + std::to_string(number);
        return name;
    }

    McapReader& m_reader;
    ImportedRecording m_imported;
    RecordingWriter& m_writer;
    std::map<std::uint16_t, TopicState> m_topics;
    std::map<std::uint16_t, TopicState*> m_jointsOf; ///< by the channel of their references
    std::set<std::string> m_names;
    std::size_t m_streams = 0;
    DecodedMessage m_decoded;
    std::optional<core::Error> m_failure;
};

core::Expected<McapImport> importInto(const std::string& path, const std::string& recordingPath,
                                      const McapImportOptions& options) {
    TELETA_TRY(auto source, openFile(path));
    TELETA_TRY(auto reader, McapReader::open(std::move(source), path));
    const ImportedRecording imported = importedRecording(reader, path);
    RecordingWriter writer(recordingPath, imported.anchors);
    Import work(reader, imported, writer);
    TELETA_CHECK(work.choose(options, path));
    TELETA_CHECK(writer.begin(imported.head));
    TELETA_CHECK(work.read(options));
    McapImport report = work.report();
    bool isCancelled = false;
    report.isDataSectionDamaged = !reader
                                       .checkDataSection([&] {
                                           isCancelled = options.goOn && !options.goOn(1.0);
                                           return !isCancelled;
                                       })
                                       .value_or(true);
    if (isCancelled)
        return core::failed(core::ErrorKind::cancelled, McapImportText::tr("interrupted"));
    TELETA_CHECK(writer.finish());
    report.badChunks = reader.badChunks();
    report.badRecords = reader.badRecords();
    report.isComplete = reader.map().isComplete;
    report.bytes = reader.map().bytes;
    report.wholeBytes = reader.map().wholeBytes;
    return report;
}

} // namespace

core::Expected<McapImport> importMcap(const std::string& path, const std::string& recordingPath,
                                      const McapImportOptions& options) {
    McapImport report;
    TELETA_CHECK(
        recording::makeRecording(recordingPath, [&](const std::string& part) -> core::Expected<void> {
            TELETA_TRY(report, importInto(path, part, options));
            return {};
        }));
    report.path = recordingPath;
    return report;
}

bool looksLikeMcap(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::string begin(kMagic.size(), '\0');
    return file.read(begin.data(), static_cast<std::streamsize>(begin.size())) && begin == kMagic;
}

} // namespace teleta::mcap
