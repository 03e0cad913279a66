// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <string_view>
#include <utility>
#include <vector>

namespace teleta::simulation {

/// Time that an effect took since the start, in s.
struct EffectTime {
    std::string_view name;
    double time_s = 0.0;
};

/// Effects on the same thing in the order in which they act, and the time that each takes. Thread: one.
template <typename Effect>
class TimedEffects {
public:
    explicit TimedEffects(std::vector<Effect> effects)
        : m_fresh(std::move(effects)) {
        restart();
    }

    /// Calls act(effect) with each effect for which which(effect) is true.
    template <typename Which, typename Act>
    void apply(const Which& which, const Act& act) {
        using Clock = std::chrono::steady_clock;
        for (std::size_t i = 0; i < m_effects.size(); ++i) {
            if (!which(m_effects[i]))
                continue;
            const Clock::time_point start = Clock::now();
            act(m_effects[i]);
            m_times[i].time_s += std::chrono::duration<double>(Clock::now() - start).count();
        }
    }
    template <typename Act>
    void apply(const Act& act) {
        apply([](const Effect&) { return true; }, act);
    }

    /// Forgets all that was applied, and all times: the same inputs then give the same results again.
    void restart() {
        m_effects = m_fresh;
        m_times.clear();
        for (const Effect& effect : m_fresh)
            m_times.push_back({.name = effect.name});
    }

    /// Of the effects, in their order.
    [[nodiscard]] const std::vector<EffectTime>& times() const { return m_times; }

private:
    std::vector<Effect> m_fresh; ///< as before the first call
    std::vector<Effect> m_effects;
    std::vector<EffectTime> m_times;
};

} // namespace teleta::simulation
