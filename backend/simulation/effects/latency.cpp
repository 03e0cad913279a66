// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/base/listed_effects.h"

#include <algorithm>
#include <cmath>

namespace teleta::simulation {

namespace {

/// Readings come late by whole frames, the number nearest to the delay.
///   y_k = x_(k-n),  n = round(delay / step),  0 before the first frame
class Latency : public TaxelEffect {
public:
    explicit Latency(const Listed<scene::LatencySpec>& listed)
        : TaxelEffect(listed.name())
        , m_taxels(listed.scene.taxels().taxels())
        , m_waiting_N(static_cast<std::size_t>(std::llround(listed.spec.delay_s / listed.step_s)) * m_taxels,
                      0.0) {}

    void apply(std::span<double> load_N) override {
        if (m_waiting_N.empty())
            return;
        std::swap_ranges(load_N.begin(), load_N.end(),
                         m_waiting_N.begin() + static_cast<std::ptrdiff_t>(m_next));
        m_next = (m_next + m_taxels) % m_waiting_N.size();
    }

    void restart() override {
        std::ranges::fill(m_waiting_N, 0.0);
        m_next = 0;
    }

private:
    std::size_t m_taxels;
    std::vector<double> m_waiting_N; ///< n frames, one after another, around
    std::size_t m_next = 0;          ///< where the oldest one begins
};

} // namespace

std::unique_ptr<TaxelEffect> makeEffect(const Listed<scene::LatencySpec>& listed) {
    return std::make_unique<Latency>(listed);
}

} // namespace teleta::simulation
