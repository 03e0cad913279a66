// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contact/frame_conditioner.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace teleta::contact {

FrameConditioner::FrameConditioner(std::size_t taxels, ConditioningSettings settings)
    : m_settings(std::move(settings)) {
    if (m_settings.tare.size() != taxels)
        m_settings.tare.clear();
    if (m_settings.taxelGain.size() != taxels)
        m_settings.taxelGain.clear();
    if (m_settings.dead.size() != taxels)
        m_settings.dead.clear();
    m_tare = m_settings.tare;
    m_tare.resize(taxels, 0.0F);
    m_gain.assign(m_settings.taxelGain.begin(), m_settings.taxelGain.end());
    m_gain.resize(taxels, 1.0);
    for (double& gain : m_gain)
        gain *= m_settings.inverted ? -m_settings.gain : m_settings.gain;
    m_dead = m_settings.dead;
    m_dead.resize(taxels, 0);
    m_isPlain = std::ranges::all_of(m_tare, [](float tare) { return tare == 0.0F; }) &&
                std::ranges::all_of(m_gain, [](double gain) { return gain == 1.0; });
    m_anyDead = std::ranges::any_of(m_dead, [](std::uint8_t dead) { return dead != 0; });
}

template <bool isPlain>
std::size_t FrameConditioner::applyTo(const float* raw, float* load_N, std::uint8_t* dead,
                                      std::size_t taxels) const {
    constexpr std::uint32_t kMagnitude = 0x7fffffffU;
    constexpr std::uint32_t kInfinity = 0x7f800000U;
    // As members they could be changed by what is written through dead, and were read again for each taxel.
    const float* const tare = m_tare.data();
    const double* const gain = m_gain.data();
    const std::uint8_t* const isDead = m_dead.data();

    std::uint32_t count = 0;
    for (std::size_t i = 0; i < taxels; ++i) {
        const float load =
            isPlain
                ? raw[i]
                : static_cast<float>(gain[i] * (static_cast<double>(raw[i]) - static_cast<double>(tare[i])));
        // A value, tare or gain that is not finite gives a load that is not finite. It is tested by its bits,
        // as is its sign: comparing with NaN raises the floating-point exception "invalid", and several
        // taxels at once are compared before those that are not usable are left out.
        const auto bits = std::bit_cast<std::uint32_t>(load);
        const bool usable = isDead[i] == 0 && (bits & kMagnitude) < kInfinity;
        load_N[i] = std::bit_cast<float>(usable && bits <= kMagnitude ? bits : 0U);
        dead[i] = usable ? 0 : 1;
        count += usable ? 0U : 1U;
    }
    return count;
}

std::size_t FrameConditioner::apply(std::span<const float> raw, std::span<float> load_N,
                                    std::span<std::uint8_t> dead) const {
    const std::size_t taxels = std::min({m_tare.size(), raw.size(), load_N.size(), dead.size()});
    return m_isPlain ? applyTo<true>(raw.data(), load_N.data(), dead.data(), taxels)
                     : applyTo<false>(raw.data(), load_N.data(), dead.data(), taxels);
}

} // namespace teleta::contact
