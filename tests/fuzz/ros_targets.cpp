// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/ros/joint_state_joiner.h"
#include "backend/ros/node_list.h"
#include "devices/ros/array/array_message.h"
#include "devices/ros/camera/camera_message.h"
#include "devices/ros/camera/ros_camera_file.h"
#include "devices/ros/files/ros_wrench_file.h"
#include "devices/ros/frame_tree.h"
#include "tests/fuzz/byte_source.h"
#include "tests/fuzz/fuzz_check.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/support/floating_point_traps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace teleta::fuzz {

namespace {

/// All that is told of a pose is finite, and it turns without changing lengths.
bool isPose(const Eigen::Isometry3d& pose) {
    return pose.matrix().allFinite() && pose.linear().isUnitary(1e-6);
}

template <typename Message>
bool tellsNodes(ByteSource& source) {
    using Info = std::remove_pointer_t<decltype(Message{}.node_entities_info_seq._buffer)>;
    using Gid = std::remove_pointer_t<decltype(Info{}.reader_gid_seq._buffer)>;
    std::vector<Info> infos(source.next<std::uint8_t>() % 4U);
    std::vector<std::vector<Gid>> gids(2 * infos.size());
    for (std::size_t i = 0; i < infos.size(); ++i) {
        const auto text = [&source](char* name) {
            const std::size_t length = source.next<std::uint8_t>() % 8U;
            for (std::size_t at = 0; at < length; ++at)
                name[at] = source.next<char>();
        };
        text(infos[i].node_namespace);
        text(infos[i].node_name);
        gids[2 * i].resize(source.next<std::uint8_t>() % 5U);
        gids[2 * i + 1].resize(source.next<std::uint8_t>() % 5U);
        ros::lend(infos[i].reader_gid_seq, std::span(gids[2 * i]));
        ros::lend(infos[i].writer_gid_seq, std::span(gids[2 * i + 1]));
    }
    Message message{};
    ros::lend(message.node_entities_info_seq, std::span(infos));
    const std::optional<std::vector<ros::Node>> nodes = ros::nodesOf(message);
    if (!nodes)
        return false;
    require(!nodes->empty() && nodes->size() == infos.size(), "all nodes are told, or none");
    for (std::size_t i = 0; i < infos.size(); ++i) {
        const ros::Node& node = (*nodes)[i];
        require(node.name.starts_with('/') && !node.name.ends_with('/'), "a node has a name");
        require(node.subscribers == gids[2 * i].size() && node.publishers == gids[2 * i + 1].size(),
                "its ends are counted");
    }
    return true;
}

} // namespace

bool rosFrames(Bytes bytes) {
    const test::FloatingPointTraps traps;
    const std::array<std::string, 6> names{"", "a", "/a", "b", "c", "d"};
    ros_arm::FrameTree tree;
    ByteSource source(bytes);
    std::int64_t now_ns = 0;
    bool any = false;
    while (!source.atEnd()) {
        now_ns += std::int64_t{source.next<std::uint8_t>()} * 1'000'000;
        const bool moves = source.next<std::uint8_t>() % 2U == 1;
        std::vector<std::remove_pointer_t<decltype(ros::TFMessage{}.transforms._buffer)>> transforms(
            source.next<std::uint8_t>() % 4U);
        std::vector<std::string> texts;
        for (std::size_t i = 0; i < 2 * transforms.size(); ++i)
            texts.push_back(names[source.next<std::uint8_t>() % names.size()]);
        for (std::size_t i = 0; i < transforms.size(); ++i) {
            auto& one = transforms[i];
            one.header.frame_id = texts[2 * i].empty() ? nullptr : texts[2 * i].data();
            one.child_frame_id = texts[2 * i + 1].empty() ? nullptr : texts[2 * i + 1].data();
            one.header.stamp = {source.next<std::int32_t>(), source.next<std::uint32_t>()};
            const std::vector<double> numbers = source.numbers(7);
            one.transform.translation = {numbers[0], numbers[1], numbers[2]};
            one.transform.rotation = {numbers[3], numbers[4], numbers[5], numbers[6]};
        }
        ros::TFMessage message{};
        ros::lend(message.transforms, std::span(transforms));
        if (moves)
            tree.takeMoving(message, now_ns);
        else
            tree.takeFixed(message);
        for (const char* from : {"a", "b", "c", "d"}) {
            for (const char* to : {"a", "b", "c", "d"}) {
                const std::optional<ros_arm::FrameTree::Pose> pose = tree.between(from, to);
                require(pose.has_value() || std::string_view(from) != to, "a frame hangs on itself");
                if (!pose)
                    continue;
                require(isPose(pose->X_From_To), "a pose turns and shifts");
                require(std::isfinite(pose->stamp_s) && pose->oldestBy_s >= 0.0, "times are times");
                any = any || std::string_view(from) != to;
            }
        }
    }
    return any;
}

bool rosNodes(Bytes bytes) {
    ByteSource source(bytes);
    bool any = false;
    while (!source.atEnd()) {
        const bool told = source.next<std::uint8_t>() % 2U == 0 ? tellsNodes<ros::HumbleNodes>(source)
                                                                : tellsNodes<ros::JazzyNodes>(source);
        any = any || told;
    }
    return any;
}

bool rosJointStates(Bytes bytes) {
    const test::FloatingPointTraps traps;
    ros::JointStateJoiner joiner({"a", "b", "c"}, 0.1);
    ByteSource source(bytes);
    bool joined = false;
    std::uint64_t messages = 0;
    std::size_t unknownNames = 0;
    std::int64_t now_ns = 0;
    while (!source.atEnd()) {
        now_ns += std::int64_t{source.next<std::uint8_t>()} * 1'000'000;
        ros::JointState message{};
        message.header.stamp = {source.next<std::int32_t>(), source.next<std::uint32_t>()};
        // Names of one character, the third joint's among them; an empty one is a null pointer.
        std::vector<std::array<char, 2>> names(source.next<std::uint8_t>() % 8U);
        std::vector<char*> pointers;
        for (std::array<char, 2>& name : names) {
            name = {source.next<char>(), '\0'};
            pointers.push_back(name[0] == '\0' ? nullptr : name.data());
        }
        // 0: as many as names, 1: none, 2: one too many.
        const auto sizes = source.next<std::uint8_t>();
        const auto count = [&](unsigned shift) -> std::size_t {
            const unsigned kind = (unsigned{sizes} >> shift) & 3U;
            return kind == 0 ? names.size() : kind == 1 ? 0 : names.size() + 1;
        };
        std::vector<double> position = source.numbers(count(0));
        std::vector<double> velocity = source.numbers(count(2));
        std::vector<double> effort = source.numbers(count(4));
        ros::lend(message.name, std::span(pointers));
        ros::lend(message.position, std::span(position));
        ros::lend(message.velocity, std::span(velocity));
        ros::lend(message.effort, std::span(effort));

        const std::optional<ros::JoinedJoints> sample = joiner.take(message, now_ns);
        ++messages;
        unknownNames += joiner.takeUnknownNames().size();
        require(sample.has_value() <= joiner.missing(now_ns).empty(), "a sample misses no joint");
        if (!sample)
            continue;
        joined = true;
        require(sample->position.size() == 3, "a sample has all joints");
        for (const core::JointVector* values : {&sample->position, &sample->velocity, &sample->effort}) {
            require(values->empty() || values->size() == 3, "values are told for all joints or for none");
            require(std::ranges::all_of(*values, [](double value) { return std::isfinite(value); }),
                    "a sample is finite");
        }
    }
    require(joiner.counters().messages == messages, "every message is counted");
    require(joiner.counters().malformed <= messages, "a message is malformed once");
    require(unknownNames <= ros::JointStateJoiner::kMostUnknownNames, "few unknown names are remembered");
    return joined;
}

bool rosSensorFile(Bytes bytes) {
    const std::string text = textOf(bytes);
    const auto wrench = ros_arm::parseRosWrench(text, kInput);
    const auto array = ros_array::parseRosArray(text, kInput);
    const auto camera = ros_camera::parseRosCamera(text, kInput);
    require((wrench ? 1 : 0) + (array ? 1 : 0) + (camera ? 1 : 0) <= 1, "a file has one kind");
    if (wrench)
        require(!wrench->topic.empty() && std::abs(wrench->sign) == 1.0 && wrench->timeout_s > 0.0,
                "a force sensor has a topic, a sign and a time");
    else
        requireExplained(wrench.error());
    if (array)
        require(array->layout.rows > 0 && array->layout.columns > 0 && array->layout.pitchX_m > 0.0 &&
                    array->scale != 0.0 && array->threshold > 0.0,
                "an array has taxels");
    else
        requireExplained(array.error());
    if (camera)
        require(!camera->topic.empty() && camera->rate_Hz >= 0.0, "a camera has a topic and a rate");
    else
        requireExplained(camera.error());
    return wrench || array || camera;
}

bool rosCameraMessages(Bytes bytes) {
    ByteSource source(bytes);
    bool any = false;
    while (!source.atEnd()) {
        core::Expected<core::ColourImage> picture = core::ColourImage();
        const bool isCoded = source.next<std::uint8_t>() % 2U == 1;
        std::string name(1, source.next<char>());
        const std::uint32_t height = source.next<std::uint8_t>() % 5U;
        const std::uint32_t width = source.next<std::uint8_t>() % 5U;
        std::vector<std::uint8_t> data(source.next<std::uint8_t>());
        if (isCoded) {
            for (std::uint8_t& byte : data)
                byte = source.next<std::uint8_t>();
            ros::CompressedImage message{};
            message.format = name.data();
            ros::lend(message.data, std::span(data));
            picture = ros_camera::pictureOf(message);
        } else {
            const std::array<std::string, 9> encodings{"rgb8", "bgr8",   "rgba8",  "bgra8",      "mono8",
                                                       "8UC3", "mono16", "yuv422", "yuv422_yuy2"};
            const std::size_t number = source.next<std::uint8_t>() % (encodings.size() + 1);
            std::string encoding = number < encodings.size() ? encodings[number] : name;
            for (std::uint8_t& byte : data)
                byte = source.next<std::uint8_t>();
            ros::Image message{};
            message.encoding = encoding.data();
            message.height = height;
            message.width = source.next<std::uint8_t>() == 255 ? source.next<std::uint32_t>() : width;
            message.step = source.next<std::uint8_t>() % 2U == 0 ? source.next<std::uint8_t>() % 32U
                                                                 : source.next<std::uint32_t>();
            message.is_bigendian = source.next<std::uint8_t>();
            ros::lend(message.data, std::span(data));
            picture = ros_camera::pictureOf(message);
            if (picture)
                require(std::uint32_t(picture->width_px) == message.width &&
                            std::uint32_t(picture->height_px) == message.height,
                        "a picture has the size of its message");
        }
        if (!picture)
            require(!picture.error().message.empty(), "an error has a message");
        else
            require(!picture->isEmpty(), "a picture has pixels");
        any = any || picture.has_value();
    }
    return any;
}

bool rosArrayMessages(Bytes bytes) {
    ByteSource source(bytes);
    ros_array::RosArrayFile file;
    file.layout = {1 + source.next<std::uint8_t>() % 4, 1 + source.next<std::uint8_t>() % 4, 1e-3};
    file.scale = 1.0 + source.next<std::int8_t>() * 2.0;
    bool any = false;
    while (!source.atEnd()) {
        std::vector<float> loads(file.layout.taxels(), -1.0F);
        core::Expected<bool> isFrame = false;
        const auto kind = source.next<std::uint8_t>() % 3U;
        std::string name(1, source.next<char>());
        if (kind == 0) {
            ros::Image message{};
            const std::array<std::string, 6> encodings{"32FC1", "16UC1", "mono16", "8UC1", "mono8", name};
            std::string encoding = encodings[source.next<std::uint8_t>() % encodings.size()];
            std::vector<std::uint8_t> data(source.next<std::uint8_t>());
            for (std::uint8_t& byte : data)
                byte = source.next<std::uint8_t>();
            message.encoding = encoding.data();
            message.height = source.next<std::uint8_t>() % 5U;
            message.width = source.next<std::uint8_t>() % 5U;
            message.step = source.next<std::uint32_t>();
            message.is_bigendian = source.next<std::uint8_t>();
            ros::lend(message.data, std::span(data));
            isFrame = ros_array::loadsOf(message, file, loads);
        } else if (kind == 1) {
            ros::Float64MultiArray message{};
            std::vector<std::remove_pointer_t<decltype(message.layout.dim._buffer)>> dimensions(
                source.next<std::uint8_t>() % 4U);
            for (auto& dimension : dimensions)
                dimension.size = source.next<std::uint32_t>();
            std::vector<double> data = source.numbers(source.next<std::uint8_t>() % 20U);
            message.layout.data_offset = source.next<std::uint32_t>() % 8U;
            ros::lend(message.layout.dim, std::span(dimensions));
            ros::lend(message.data, std::span(data));
            isFrame = ros_array::loadsOf(message, file, loads);
        } else {
            ros::TactileState message{};
            file.sensor = source.next<std::uint8_t>() % 2U == 0 ? std::string() : name;
            std::vector<std::remove_pointer_t<decltype(message.sensors._buffer)>> sensors(
                source.next<std::uint8_t>() % 3U);
            std::vector<std::vector<float>> values(sensors.size());
            for (std::size_t i = 0; i < sensors.size(); ++i) {
                sensors[i].name = source.next<std::uint8_t>() % 2U == 0 ? nullptr : name.data();
                values[i].resize(source.next<std::uint8_t>() % 20U);
                for (float& value : values[i])
                    value = source.next<float>();
                ros::lend(sensors[i].values, std::span(values[i]));
            }
            ros::lend(message.sensors, std::span(sensors));
            isFrame = ros_array::loadsOf(message, file, loads);
        }
        if (!isFrame)
            require(!isFrame.error().message.empty(), "an error has a message");
        if (!isFrame.value_or(false))
            require(std::ranges::all_of(loads, [](float load) { return load == -1.0F; }),
                    "what is no frame changes nothing");
        require(std::ranges::none_of(loads, [](float load) { return std::isinf(load); }),
                "no load is infinite");
        any = any || isFrame.value_or(false);
    }
    return any;
}

} // namespace teleta::fuzz
