// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/base/listed_effects.h"

#include <algorithm>

namespace teleta::simulation {

namespace {

/// The reading stays behind while the load falls: a play operator whose loading branch is the load itself and
/// whose unloading branch lies a share h above it. Independent of speed, 0 at no load.
///   y_k = min(max(y_(k-1), x_k), (1 + h) x_k)
/// Area of a full loop from 0 to X: X^2 h / (2 (1 + h)).
/// Source: A. Visintin, Differential Models of Hysteresis (1994), generalised play.
class Hysteresis : public TaxelEffect {
public:
    explicit Hysteresis(const Listed<scene::HysteresisSpec>& listed)
        : TaxelEffect(listed.name(), EffectStage::skin)
        , m_share(listed.spec.share)
        , m_held_N(listed.scene.taxels().taxels(), 0.0) {}

    void apply(std::span<double> load_N) override {
        for (std::size_t i = 0; i < load_N.size(); ++i) {
            m_held_N[i] = std::min(std::max(m_held_N[i], load_N[i]), (1.0 + m_share) * load_N[i]);
            load_N[i] = m_held_N[i];
        }
    }

    void restart() override { std::ranges::fill(m_held_N, 0.0); }

private:
    double m_share;
    std::vector<double> m_held_N;
};

} // namespace

std::unique_ptr<TaxelEffect> makeEffect(const Listed<scene::HysteresisSpec>& listed) {
    return std::make_unique<Hysteresis>(listed);
}

} // namespace teleta::simulation
