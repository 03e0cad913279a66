// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/camera/effects/sensor_noise.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace teleta::simulation {

namespace {

constexpr std::size_t kNormals = 1U << 18U;
constexpr int kGreyLevels = 256;

} // namespace

SensorNoise::SensorNoise(std::string_view name, const scene::SensorNoiseSpec& spec, RandomStream random)
    : CameraEffect(name)
    , m_random(std::move(random))
    , m_normal(kNormals)
    , m_sd(kGreyLevels) {
    for (std::size_t i = 0; i < m_sd.size(); ++i)
        m_sd[i] = static_cast<float>(std::sqrt(
            spec.read * spec.read + spec.shot * spec.shot * static_cast<double>(i) / (kGreyLevels - 1)));
    std::ranges::generate(m_normal, [this] { return static_cast<float>(m_random.normal()); });
}

void SensorNoise::changeFrame(cv::Mat1f& frame) {
    for (int v = 0; v < frame.rows; ++v) {
        float* row = frame[v];
        std::size_t place = m_random.below(kNormals);
        for (int u = 0; u < frame.cols; ++u) {
            const int level = std::clamp(static_cast<int>(row[u]), 0, kGreyLevels - 1);
            row[u] += m_sd[static_cast<std::size_t>(level)] * m_normal[place];
            place = (place + 1) & (kNormals - 1);
        }
    }
}

} // namespace teleta::simulation
