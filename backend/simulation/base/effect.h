// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

namespace teleta::simulation {

/// Where in the sensor an effect acts.
enum class EffectStage {
    skin,    ///< on the load, before the firing threshold
    readout, ///< on the reading
};

/// One imperfection of a tactile array, applied to each frame in turn.
/// Thread: one.
class Effect {
public:
    explicit Effect(std::string_view name, EffectStage stage)
        : m_name(name)
        , m_stage(stage) {}
    virtual ~Effect() = default;
    Effect(const Effect&) = delete;
    Effect& operator=(const Effect&) = delete;

    /// load_N: the array's taxels, changed in place. Calls are one sample period apart.
    virtual void apply(std::span<double> load_N) = 0;
    /// Forgets all frames: the same frames then give the same result again.
    virtual void restart() {}

    [[nodiscard]] std::string_view name() const { return m_name; }
    [[nodiscard]] EffectStage stage() const { return m_stage; }

private:
    std::string_view m_name;
    EffectStage m_stage;
};

} // namespace teleta::simulation
