// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/stream_tap.h"
#include "backend/pipeline/camera_snapshot.h"

#include <cstdint>
#include <functional>
#include <memory>

namespace teleta::pipeline {

/// Where the channels leave copies of what passes for a recording. All members are set. Each tap has one
/// channel only.

struct TouchTaps {
    std::shared_ptr<core::StreamTap> frames;   ///< raw, float32
    std::shared_ptr<core::StreamTap> features; ///< as featureValues()
};

struct ArmTaps {
    std::shared_ptr<core::StreamTap> joints;  ///< as recording::jointValues()
    std::shared_ptr<core::StreamTap> touches; ///< as touchValues()
};

struct CameraTaps {
    std::shared_ptr<core::StreamTap> pictures;  ///< all that the camera gives
    std::shared_ptr<core::StreamTap> reference; ///< the one in use, and each that follows
    std::shared_ptr<core::StreamTap> contacts;  ///< as contactValues()
    /// Called on the vision thread; returns at once.
    std::function<void(const CameraEvent& event, std::int64_t time_ns)> event;
};

} // namespace teleta::pipeline
