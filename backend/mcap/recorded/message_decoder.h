// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/camera_source.h"
#include "backend/mcap/mcap_types.h"
#include "backend/mcap/recorded/point_cloud.h"
#include "backend/recording/recording_types.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace teleta::mcap {

/// What a topic is read as.
enum class TopicRole {
    arrayImage,   ///< sensor_msgs/Image
    cameraImage,  ///< the same
    colourImage,  ///< the same, of a scene camera
    arrayPicture, ///< sensor_msgs/CompressedImage
    cameraPicture,
    colourPicture, ///< the same, of a scene camera
    tactileArray,
    multiArray, ///< std_msgs/Float32MultiArray of two dimensions
    points,     ///< sensor_msgs/PointCloud2 of taxels
    joints,     ///< sensor_msgs/JointState
    wrench,     ///< geometry_msgs/WrenchStamped
    features,
    touch,
    contacts,
    tactors,
    numbers,
    event, ///< foxglove_msgs/Log
};

/// The kinds that a person may choose for a topic.
enum class TopicKind { array, camera, joints };
[[nodiscard]] const char* toString(TopicKind kind);
[[nodiscard]] std::optional<TopicKind> topicKindOf(std::string_view word);

/// What a topic of this type is read as; empty: it cannot be read. wanted: as a person chose, if one did;
/// otherwise an Image is an array, and a CompressedImage a camera, until imageRoleOf() tells. schema: null
/// when there is none. Thread: any (pure).
[[nodiscard]] std::optional<TopicRole> roleOf(const Channel& channel, const Schema* schema,
                                              std::optional<TopicKind> wanted);

/// Whether a PointCloud2 has the fields of taxels, see hasTaxelFields(). Nothing: it is damaged. Thread: any
/// (pure).
[[nodiscard]] std::optional<bool> isCloudOfTaxels(std::string_view message);

/// What an Image or a CompressedImage is read as by its first message: pictures in colour are a scene
/// camera's, grey ones of 8 bits a camera's, and values of more bits an array's. role: of its type. Thread:
/// any (pure).
[[nodiscard]] TopicRole imageRoleOf(TopicRole role, std::string_view message);

/// One message, decoded.
struct DecodedMessage {
    std::optional<std::int64_t> stamp_ns; ///< of its header
    std::vector<std::size_t> shape;       ///< of one frame
    std::vector<float> floats;            ///< of an array and of tactors
    std::vector<double> doubles;          ///< of the others; several frames of contacts
    std::size_t frames = 1;
    std::vector<std::string> names; ///< of the values of numbers
    TaxelPoints points;             ///< of a point cloud, whose shape and floats follow from a layout
    core::GreyImage image;
    double pitch_m = 0.0;            ///< 0: not known
    std::string unit;                ///< of an array
    recording::RecordingEvent event; ///< but for its time
};

/// Decodes a message in CDR of either byte order. columns: values of a frame, for features, touches and
/// contacts. False: it is damaged, or not of this role. Never more memory than the message takes, but for
/// pictures, which have at most 2^26 pixels. Thread: any (pure).
[[nodiscard]] bool decodeMessage(TopicRole role, std::string_view message, std::size_t columns,
                                 DecodedMessage& decoded);

/// The columns that the schema of features, touches or contacts names.
[[nodiscard]] std::vector<recording::Column> schemaColumns(TopicRole role, const Schema& schema);

} // namespace teleta::mcap
