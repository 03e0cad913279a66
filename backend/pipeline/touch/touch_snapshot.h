// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contact/contact_segmenter.h"
#include "backend/contact/frame_conditioner.h"
#include "backend/contact/tactile_features.h"
#include "backend/core/device/device.h"

#include <cstdint>
#include <string>
#include <vector>

namespace teleta::pipeline {

/// How one channel's frames are turned into contacts and features; changed while it runs.
struct ChannelSettings {
    contact::ConditioningSettings conditioning;
    contact::FeatureSettings features;
    contact::SegmentationSettings segmentation;
    std::string loadUnit = "N"; ///< unit of the loads, shown with every force
};

/// What the pipeline knows of one array after its newest frame. Views get it as a constant and own no truth.
struct TouchSnapshot {
    core::ArrayLayout layout;
    std::string loadUnit;
    std::uint64_t frame = 0;
    std::int64_t time_ns = 0;
    double sourceTime_s = 0.0;
    std::vector<float> load_N;
    std::vector<std::uint8_t> dead;
    std::vector<std::int32_t> labels; ///< region of each taxel; 0 none
    std::vector<contact::Contact> contacts;
    contact::TactileFeatures features;
    double threshold_N = 0.0;
    std::uint64_t framesProcessed = 0;
};

/// One point of the strip charts.
struct FeatureSample {
    std::int64_t time_ns = 0;
    double sourceTime_s = 0.0;
    bool discontinuity = false;
    contact::TactileFeatures features;
};

} // namespace teleta::pipeline
