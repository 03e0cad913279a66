// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/recording/recording_types.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace teleta::mcap {

/// A name as a part of a topic: what is not a letter, a digit or "_" becomes "_", a leading digit gets "s_".
/// Thread: any (pure), as the others.
[[nodiscard]] std::string topicPart(std::string_view name);

/// How a stream is called where ROS reads it.
struct RosNames {
    std::string topic; ///< "skin": topics begin with "/skin/"
    std::string frame; ///< of its headers; empty: none
    /// The values are in a left-handed frame, which ROS does not have: y changes its sign.
    bool turnsY = false;
};

/// Of all streams of a recording, in their order; names that are equal get "_2", "_3"...
[[nodiscard]] std::vector<RosNames> rosNames(std::span<const recording::StreamInfo> streams);

} // namespace teleta::mcap
