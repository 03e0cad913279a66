// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/base/listed_effects.h"

#include <numeric>

namespace teleta::simulation {

namespace {

/// Some taxels read one value whatever their load: named ones, or so many drawn from the random stream.
class DeadTaxels : public TaxelEffect {
public:
    explicit DeadTaxels(const Listed<scene::DeadTaxelsSpec>& listed)
        : TaxelEffect(listed.name())
        , m_reading_N(listed.spec.reading_N) {
        const core::ArrayLayout layout = listed.scene.taxels();
        for (const scene::TaxelIndex& taxel : listed.spec.taxels)
            m_dead.push_back(static_cast<std::size_t>(taxel.row) * static_cast<std::size_t>(layout.columns) +
                             static_cast<std::size_t>(taxel.column));
        if (!m_dead.empty())
            return;
        core::RandomStream random = listed.random();
        m_dead.resize(layout.taxels());
        std::iota(m_dead.begin(), m_dead.end(), std::size_t{0});
        for (std::size_t i = 0; i < listed.spec.count; ++i)
            std::swap(m_dead[i], m_dead[i + random.below(m_dead.size() - i)]);
        m_dead.resize(listed.spec.count);
    }

    void apply(std::span<double> load_N) override {
        for (const std::size_t taxel : m_dead)
            load_N[taxel] = m_reading_N;
    }

private:
    std::vector<std::size_t> m_dead;
    double m_reading_N;
};

} // namespace

std::unique_ptr<TaxelEffect> makeEffect(const Listed<scene::DeadTaxelsSpec>& listed) {
    return std::make_unique<DeadTaxels>(listed);
}

} // namespace teleta::simulation
