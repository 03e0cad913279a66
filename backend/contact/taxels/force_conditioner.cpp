// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contact/taxels/force_conditioner.h"

#include <algorithm>
#include <cmath>

namespace teleta::contact {

namespace {

constexpr std::size_t kVector = core::TaxelLayout::kVector;
constexpr std::array<double, 3> kUp{0.0, 0.0, 1.0};

template <typename T>
std::vector<T> orEach(const std::vector<T>& values, std::size_t size, T otherwise) {
    return values.size() == size ? values : std::vector<T>(size, otherwise);
}

} // namespace

ForceConditioner::ForceConditioner(const core::TaxelLayout& layout, const ConditioningSettings& settings)
    : m_tare(orEach(settings.tare, layout.values(), 0.0F))
    , m_dead(orEach(settings.dead, layout.taxels(), std::uint8_t{0})) {
    for (const float gain : orEach(settings.taxelGain, layout.taxels(), 1.0F))
        m_gain.push_back((settings.inverted ? -settings.gain : settings.gain) * static_cast<double>(gain));
    if (layout.isGrid())
        return;
    for (const core::TaxelPlace& place : layout.places()->all())
        m_normal.push_back(place.normal);
    if (std::ranges::all_of(m_normal, [](const auto& normal) { return normal == kUp; }))
        m_normal.clear();
}

std::size_t ForceConditioner::apply(std::span<const float> raw, std::span<float> load_N,
                                    std::span<float> shearX_N, std::span<float> shearY_N,
                                    std::span<std::uint8_t> dead) const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < m_gain.size(); ++i) {
        std::array<double, kVector> f{};
        bool usable = m_dead[i] == 0;
        for (std::size_t k = 0; k < kVector; ++k) {
            const std::size_t at = kVector * i + k;
            f[k] = m_gain[i] * (static_cast<double>(raw[at]) - static_cast<double>(m_tare[at]));
            usable = usable && std::isfinite(static_cast<float>(f[k]));
        }
        dead[i] = usable ? 0 : 1;
        if (!usable) {
            load_N[i] = shearX_N[i] = shearY_N[i] = 0.0F;
            ++count;
            continue;
        }
        const std::array<double, kVector>& n = m_normal.empty() ? kUp : m_normal[i];
        const double outward = f[0] * n[0] + f[1] * n[1] + f[2] * n[2];
        load_N[i] = outward < 0.0 ? static_cast<float>(-outward) : 0.0F;
        shearX_N[i] = static_cast<float>(f[0] - outward * n[0]);
        shearY_N[i] = static_cast<float>(f[1] - outward * n[1]);
    }
    return count;
}

} // namespace teleta::contact
