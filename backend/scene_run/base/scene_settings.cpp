// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene_run/base/scene_settings.h"

#include "backend/simulation/servo/servo_loop.h"

#include <algorithm>

namespace teleta::scene_run {

namespace {

constexpr double kLeastSkinThreshold_N = 0.005;
constexpr double kNoiseBorder_sd = 3.0;
constexpr int kLeastSkinTaxels = 4;

double noiseOf_N(const scene::Scene& scene) {
    const auto* noise = scene.listed<scene::NoiseSpec>();
    return noise == nullptr ? 0.0 : noise->sd_N;
}

} // namespace

pipeline::ChannelSettings channelSettings(const scene::Scene& scene) {
    pipeline::ChannelSettings settings;
    double threshold_N = settings.features.threshold_N;
    if (scene.isArm()) {
        threshold_N = std::max(
            {scene.arm().skin.firingThreshold_N, kNoiseBorder_sd * noiseOf_N(scene), kLeastSkinThreshold_N});
        settings.segmentation.minimumTaxels = kLeastSkinTaxels;
        settings.features.range = contact::MomentRange::active;
    } else if (scene.isServo()) {
        settings.features = simulation::servoFeatures(scene);
        threshold_N = settings.features.threshold_N;
    } else if (scene.array().sensor.firingThreshold_N > 0.0) {
        threshold_N = scene.array().sensor.firingThreshold_N;
    }
    settings.features.threshold_N = threshold_N;
    settings.segmentation.threshold_N = threshold_N;
    return settings;
}

} // namespace teleta::scene_run
