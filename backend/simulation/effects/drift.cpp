// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/base/listed_effects.h"

#include <algorithm>
#include <cmath>

namespace teleta::simulation {

namespace {

/// Rest values that wander from 0: in each taxel an Ornstein-Uhlenbeck process, exact for any step.
///   b_(k+1) = a b_k + sd sqrt(1 - a^2) n,  a = exp(-dt/tau),  b_0 = 0,  variance sd^2 (1 - exp(-2 t/tau))
class Drift : public TaxelEffect {
public:
    explicit Drift(const Listed<scene::DriftSpec>& listed)
        : TaxelEffect(listed.name())
        , m_keep(std::exp(-listed.step_s / listed.spec.timeConstant_s))
        // 1 - a^2 would cancel when the time constant is long.
        , m_kick_N(listed.spec.sd_N *
                   std::sqrt(-std::expm1(-2.0 * listed.step_s / listed.spec.timeConstant_s)))
        , m_rest_N(listed.scene.taxels().taxels(), 0.0)
        , m_random(listed.random()) {}

    void apply(std::span<double> load_N) override {
        for (std::size_t i = 0; i < load_N.size(); ++i) {
            m_rest_N[i] = m_keep * m_rest_N[i] + m_kick_N * m_random.normal();
            load_N[i] += m_rest_N[i];
        }
    }

    void restart() override {
        std::ranges::fill(m_rest_N, 0.0);
        m_random.restart();
    }

private:
    double m_keep;   ///< a
    double m_kick_N; ///< sd sqrt(1 - a^2)
    std::vector<double> m_rest_N;
    core::RandomStream m_random;
};

} // namespace

std::unique_ptr<TaxelEffect> makeEffect(const Listed<scene::DriftSpec>& listed) {
    return std::make_unique<Drift>(listed);
}

} // namespace teleta::simulation
