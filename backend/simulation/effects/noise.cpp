// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/base/listed_effects.h"

namespace teleta::simulation {

namespace {

/// Adds Gaussian noise of a given standard deviation, independent in every taxel and frame. Readings may be
/// negative.
class Noise : public TaxelEffect {
public:
    explicit Noise(const Listed<scene::NoiseSpec>& listed)
        : TaxelEffect(listed.name())
        , m_sd_N(listed.spec.sd_N)
        , m_random(listed.random()) {}

    void apply(std::span<double> load_N) override {
        for (double& value_N : load_N)
            value_N += m_sd_N * m_random.normal();
    }

    void restart() override { m_random.restart(); }

private:
    double m_sd_N;
    core::RandomStream m_random;
};

} // namespace

std::unique_ptr<TaxelEffect> makeEffect(const Listed<scene::NoiseSpec>& listed) {
    return std::make_unique<Noise>(listed);
}

} // namespace teleta::simulation
