// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/base/listed_effects.h"
#include "backend/simulation/camera/effects/camera_effect.h"

#include <algorithm>
#include <cmath>

namespace teleta::simulation {

namespace {

constexpr std::size_t kNormals = 1U << 18U;
constexpr float kBrightest = 255.0F;

/// See scene::SensorNoiseSpec. Normal numbers are drawn once; each row of a frame reads them from a place
/// that is drawn anew.
class SensorNoise {
public:
    explicit SensorNoise(const Listed<scene::SensorNoiseSpec>& listed)
        : m_random(listed.random())
        , m_normal(kNormals)
        , m_read2(static_cast<float>(listed.spec.read * listed.spec.read))
        , m_shot2PerLevel(static_cast<float>(listed.spec.shot * listed.spec.shot) / kBrightest) {
        std::ranges::generate(m_normal, [this] { return static_cast<float>(m_random.normal()); });
    }

    void operator()(cv::Mat1f& rows) {
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

private:
    core::RandomStream m_random;
    std::vector<float> m_normal;
    float m_read2;
    float m_shot2PerLevel;
};

} // namespace

CameraEffect makeEffect(const Listed<scene::SensorNoiseSpec>& listed) {
    return {.name = listed.name(), .changeRows = SensorNoise(listed)};
}

} // namespace teleta::simulation
