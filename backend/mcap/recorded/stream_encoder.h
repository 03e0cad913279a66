// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/taxel_layout.h"
#include "backend/core/device/stream_tap.h"
#include "backend/mcap/recorded/ros_names.h"
#include "backend/recording/recording_types.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace teleta::mcap {

/// One topic, as a channel of a file or of a live view announces it.
struct TopicType {
    std::string topic;      ///< "/skin/image"
    std::string schemaName; ///< "sensor_msgs/msg/Image"
    std::string schemaText; ///< ros2msg
};

/// What becomes of a stream in ROS: its topics, and the messages of its frames in CDR.
///   array          /NAME/image        sensor_msgs/msg/Image, 32FC1, raw values, row 0 first
///                  /NAME/array        teleta_msgs/msg/TactileArray
///                  /NAME/points       sensor_msgs/msg/PointCloud2 instead of both, where TactileArray has no
///                                     room: vectors, taxels off a grid, two pitches; see writePoints()
///   features       /NAME/features     teleta_msgs/msg/TactileFeatures; NaN where a feature is not defined.
///                                     Other units and vectors have other fields, and other names:
///                                     TactileFeaturesUtShear
///                  /NAME/wrench       geometry_msgs/msg/WrenchStamped, what acts on the array
///   contacts       /NAME/contacts     teleta_msgs/msg/Contacts, all of one time
///   touches        /NAME/touches      teleta_msgs/msg/Touch
///   joints         /NAME/joint_states, /NAME/joint_references    sensor_msgs/msg/JointState
///   camera         /NAME/image/compressed    sensor_msgs/msg/CompressedImage, png, 8 bits, grey or colour
///   tactors        /NAME/tactors      teleta_msgs/msg/Tactors
///   wrench         /NAME/wrench       geometry_msgs/msg/WrenchStamped
///   numbers        /NAME/numbers      teleta_msgs/msg/Numbers, with the names of the columns
/// Thread: one.
class StreamEncoder {
public:
    /// pictureLevel: how hard pictures are compressed, 0 (not at all) to 9.
    StreamEncoder(recording::StreamInfo stream, RosNames names, int pictureLevel);

    /// Empty when the frames of the stream are of no kind that has messages.
    [[nodiscard]] const std::vector<TopicType>& topics() const { return m_topics; }
    [[nodiscard]] const recording::StreamInfo& stream() const { return m_stream; }

    /// How many frames of a block, from one on, go into one message: contacts of the same time go together.
    [[nodiscard]] std::size_t framesOfMessage(const core::TappedFrames& block, std::size_t frame) const;
    /// Appends the message of these frames for a topic. utc_ns: time of the frames.
    void encode(std::size_t topic, const core::TappedFrames& block, std::size_t frame, std::size_t frames,
                std::int64_t utc_ns, std::string& bytes) const;

private:
    enum class Message {
        image,
        array,
        points,
        features,
        featureWrench,
        contacts,
        touch,
        jointStates,
        jointReferences,
        picture,
        tactors,
        wrench,
        numbers,
    };

    void add(Message message, const char* topic, std::string_view type, std::string text = {});
    void describe();

    recording::StreamInfo m_stream;
    RosNames m_names;
    int m_pictureLevel;
    double m_pitch_m = 0.0;
    core::TaxelLayout m_layout; ///< of an array
    std::vector<TopicType> m_topics;
    std::vector<Message> m_messages;       ///< of the topics
    std::vector<std::string> m_jointNames; ///< q1, q2, ...
    std::size_t m_force = 0;               ///< columns of a stream of features
    std::size_t m_copX = 0;
    std::size_t m_copY = 0;
    std::optional<std::size_t> m_shearX; ///< with the moment two columns on; of vectors
    std::vector<double> m_signs;         ///< of the columns of contacts
};

/// A topic of the events of a recording: foxglove_msgs/msg/Log.
[[nodiscard]] TopicType eventTopic();
/// Appends the message of an event: its kind is the name, its text the message, and its value the line, where
/// it is a whole number that fits.
void encodeEvent(const recording::RecordingEvent& event, std::int64_t utc_ns, std::string& bytes);

/// Definitions of the types whose fields are columns.
[[nodiscard]] std::string featuresDefinition(const std::vector<recording::Column>& columns);
[[nodiscard]] std::string touchDefinition(const std::vector<recording::Column>& columns);
[[nodiscard]] std::string contactDefinition(const std::vector<recording::Column>& columns);
[[nodiscard]] std::string contactsDefinition();

} // namespace teleta::mcap
