// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

namespace teleta::simulation {

/// One imperfection of a simulated device. Thread: one.
class Effect {
public:
    explicit Effect(std::string_view name)
        : m_name(name) {}
    virtual ~Effect() = default;
    Effect(const Effect&) = delete;
    Effect& operator=(const Effect&) = delete;

    /// Forgets what it was applied to: the same inputs then give the same result again.
    virtual void restart() {}
    [[nodiscard]] std::string_view name() const { return m_name; }

private:
    std::string_view m_name;
};

/// Where in the sensor an effect acts.
enum class EffectStage {
    skin,    ///< on the load, before the firing threshold
    readout, ///< on the reading
};

/// One of a tactile array, applied to each frame in turn.
class TaxelEffect : public Effect {
public:
    explicit TaxelEffect(std::string_view name, EffectStage stage = EffectStage::readout)
        : Effect(name)
        , m_stage(stage) {}

    /// load_N: the array's taxels, changed in place. Calls are one sample period apart.
    virtual void apply(std::span<double> load_N) = 0;
    [[nodiscard]] EffectStage stage() const { return m_stage; }

private:
    EffectStage m_stage;
};

} // namespace teleta::simulation
