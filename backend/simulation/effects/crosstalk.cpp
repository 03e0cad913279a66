// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/base/listed_effects.h"

#include <algorithm>

namespace teleta::simulation {

namespace {

/// The elastic cover hands a share of each taxel's load to its four neighbours in equal parts.
///   out_i = (1 - n_i s/4) in_i + s/4 sum over the n_i neighbours of in_j
/// The total is conserved: at a border the part without a neighbour stays.
class Crosstalk : public TaxelEffect {
public:
    explicit Crosstalk(const Listed<scene::CrosstalkSpec>& listed)
        : TaxelEffect(listed.name(), EffectStage::skin)
        , m_layout(listed.scene.taxels())
        , m_toEach(0.25 * listed.spec.share)
        , m_change_N(m_layout.taxels()) {}

    void apply(std::span<double> load_N) override {
        std::ranges::fill(m_change_N, 0.0);
        const auto exchange = [&](std::size_t a, std::size_t b) {
            const double flow_N = m_toEach * (load_N[a] - load_N[b]);
            m_change_N[a] -= flow_N;
            m_change_N[b] += flow_N;
        };
        const auto columns = static_cast<std::size_t>(m_layout.columns);
        for (std::size_t i = 0; i < load_N.size(); ++i) {
            if ((i + 1) % columns != 0)
                exchange(i, i + 1);
            if (i + columns < load_N.size())
                exchange(i, i + columns);
        }
        for (std::size_t i = 0; i < load_N.size(); ++i)
            load_N[i] += m_change_N[i];
    }

private:
    core::ArrayLayout m_layout;
    double m_toEach;
    std::vector<double> m_change_N;
};

} // namespace

std::unique_ptr<TaxelEffect> makeEffect(const Listed<scene::CrosstalkSpec>& listed) {
    return std::make_unique<Crosstalk>(listed);
}

} // namespace teleta::simulation
