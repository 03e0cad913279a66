// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contact/contact_segmenter.h"
#include "backend/contact/frame_conditioner.h"
#include "backend/contact/tactile_features.h"
#include "backend/contact/taxels/taxel_frame.h"

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
    /// Of the array's chips when its tare was taken; empty: they told none, or there is no tare.
    std::vector<float> tareTemperatures_degC{};
};

/// What the pipeline knows of one array after its newest frame. Views get it as a constant and own no truth.
struct TouchSnapshot : contact::TaxelFrame {
    std::string loadUnit;
    std::uint64_t frame = 0;
    std::int64_t time_ns = 0;
    double sourceTime_s = 0.0;
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
