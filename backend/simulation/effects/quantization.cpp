// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/base/listed_effects.h"

#include <cmath>

namespace teleta::simulation {

namespace {

/// Rounds each reading to the nearest multiple of a step.
class Quantization : public TaxelEffect {
public:
    explicit Quantization(const Listed<scene::QuantizationSpec>& listed)
        : TaxelEffect(listed.name())
        , m_step_N(listed.spec.step_N) {}

    void apply(std::span<double> load_N) override {
        for (double& value_N : load_N)
            value_N = m_step_N * std::round(value_N / m_step_N);
    }

private:
    double m_step_N;
};

} // namespace

std::unique_ptr<TaxelEffect> makeEffect(const Listed<scene::QuantizationSpec>& listed) {
    return std::make_unique<Quantization>(listed);
}

} // namespace teleta::simulation
