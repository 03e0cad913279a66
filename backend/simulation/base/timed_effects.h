// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <memory>
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
    explicit TimedEffects(std::vector<std::unique_ptr<Effect>> effects) {
        for (std::unique_ptr<Effect>& effect : effects)
            m_effects.push_back({.effect = std::move(effect)});
    }

    /// Calls act(effect) with each effect for which which(effect) is true.
    template <typename Which, typename Act>
    void apply(const Which& which, const Act& act) {
        using Clock = std::chrono::steady_clock;
        for (Timed& timed : m_effects) {
            if (!which(*timed.effect))
                continue;
            const Clock::time_point start = Clock::now();
            act(*timed.effect);
            timed.time_s += std::chrono::duration<double>(Clock::now() - start).count();
        }
    }
    template <typename Act>
    void apply(const Act& act) {
        apply([](const Effect&) { return true; }, act);
    }

    /// Forgets all that was applied, and all times.
    void restart() {
        for (Timed& timed : m_effects) {
            timed.effect->restart();
            timed.time_s = 0.0;
        }
    }

    /// Adds the times of the effects, in their order.
    void appendTimes(std::vector<EffectTime>& times) const {
        for (const Timed& timed : m_effects)
            times.push_back({.name = timed.effect->name(), .time_s = timed.time_s});
    }

private:
    struct Timed {
        std::unique_ptr<Effect> effect;
        double time_s = 0.0;
    };
    std::vector<Timed> m_effects;
};

} // namespace teleta::simulation
