// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/camera/effects/sensor_noise.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace teleta::simulation {

namespace {

constexpr std::size_t kNormals = 1U << 18U;
constexpr float kBrightest = 255.0F;

} // namespace

SensorNoise::SensorNoise(std::string_view name, const scene::SensorNoiseSpec& spec, RandomStream random)
    : CameraEffect(name)
    , m_random(std::move(random))
    , m_normal(kNormals)
    , m_read2(static_cast<float>(spec.read * spec.read))
    , m_shot2PerLevel(static_cast<float>(spec.shot * spec.shot) / kBrightest) {
    std::ranges::generate(m_normal, [this] { return static_cast<float>(m_random.normal()); });
}

void SensorNoise::changeRows(cv::Mat1f& rows) {
    for (int v = 0; v < rows.rows; ++v) {
        float* pixel = rows[v];
        int left = rows.cols;
        std::size_t place = m_random.below(kNormals);
        while (left > 0) {
            // Without a branch in the loop, so that the compiler takes several pixels at a time.
            const int run = std::min(left, static_cast<int>(kNormals - place));
            const float* normal = m_normal.data() + place;
            for (int i = 0; i < run; ++i) {
                const float above = pixel[i] > 0.0F ? pixel[i] : 0.0F;
                const auto level =
                    static_cast<float>(static_cast<int>(above < kBrightest ? above : kBrightest));
                pixel[i] += std::sqrt(m_read2 + m_shot2PerLevel * level) * normal[i];
            }
            pixel += run;
            left -= run;
            place = 0;
        }
    }
}

} // namespace teleta::simulation
