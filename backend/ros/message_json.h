// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/ros/messages.h"

#include <nlohmann/json_fwd.hpp>

/// Messages in the words of their definitions, for people and other programs: keys are the fields in their
/// order. Pictures stand as their number of bytes ("data_bytes"). Numbers that are not finite stay as they
/// are; nlohmann::json writes null for them. Texts may hold any bytes. Thread: any (pure).
namespace teleta::ros {

[[nodiscard]] nlohmann::ordered_json messageJson(const CameraInfo& message);
[[nodiscard]] nlohmann::ordered_json messageJson(const CompressedImage& message);
[[nodiscard]] nlohmann::ordered_json messageJson(const Float64MultiArray& message);
[[nodiscard]] nlohmann::ordered_json messageJson(const Image& message);
[[nodiscard]] nlohmann::ordered_json messageJson(const JointJog& message);
[[nodiscard]] nlohmann::ordered_json messageJson(const JointState& message);
[[nodiscard]] nlohmann::ordered_json messageJson(const JointTrajectory& message);
[[nodiscard]] nlohmann::ordered_json messageJson(const String& message);
[[nodiscard]] nlohmann::ordered_json messageJson(const TactileState& message);
[[nodiscard]] nlohmann::ordered_json messageJson(const TFMessage& message);
[[nodiscard]] nlohmann::ordered_json messageJson(const TwistStamped& message);
[[nodiscard]] nlohmann::ordered_json messageJson(const WrenchStamped& message);

} // namespace teleta::ros
