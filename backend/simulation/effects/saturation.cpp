// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/base/listed_effects.h"

#include <algorithm>

namespace teleta::simulation {

namespace {

/// Limits each reading to 0 .. full scale.
class Saturation : public TaxelEffect {
public:
    explicit Saturation(const Listed<scene::SaturationSpec>& listed)
        : TaxelEffect(listed.name())
        , m_fullScale_N(listed.scene.fullScale_N()) {}

    void apply(std::span<double> load_N) override {
        for (double& value_N : load_N)
            value_N = std::clamp(value_N, 0.0, m_fullScale_N);
    }

private:
    double m_fullScale_N;
};

} // namespace

std::unique_ptr<TaxelEffect> makeEffect(const Listed<scene::SaturationSpec>& listed) {
    return std::make_unique<Saturation>(listed);
}

} // namespace teleta::simulation
