// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/servo/servo_verdict.h"

#include "backend/simulation/servo/servo_loop.h"

#include <algorithm>
#include <array>

namespace teleta::simulation {

namespace {

constexpr double kEnd_s = 2.0;
constexpr double kLostFor_s = 0.5;
constexpr double kSlow = 0.1;

servo::TaskKind lastingTask(scene::ServoTaskKind kind) {
    switch (kind) {
    case scene::ServoTaskKind::exploreEdge:
        break;
    case scene::ServoTaskKind::point:
        return servo::TaskKind::pointFollowing;
    case scene::ServoTaskKind::roll:
        return servo::TaskKind::roll;
    case scene::ServoTaskKind::comanipulate:
        return servo::TaskKind::comanipulation;
    }
    return servo::TaskKind::explore;
}

} // namespace

ServoVerdict::ServoVerdict(const scene::Scene& scene)
    : m_task(scene.servo().task)
    , m_alignment(m_task)
    , m_lasting(lastingTask(m_task.kind)) {
}

void ServoVerdict::add(const ServoLoop& loop) {
    m_now_s = loop.world().time_s();
    m_alignment.add(loop);
    if (loop.world().truth().touching)
        m_touched_s = m_now_s;
    if (!loop.servoed())
        return;
    const servo::ServoOutput& output = loop.output();
    if (!m_phase || output.phaseBegan) {
        m_phase = output.kind;
        m_phaseBegan_s = m_now_s;
    }
    m_kind = output.kind;
    m_searchEnded = output.contact == servo::ContactState::lost;
    m_last.push_back({m_now_s, loop.world().arm().X_Base_Sensor().translation(), output.limits});
    while (m_now_s - m_last.front().time_s > kEnd_s)
        m_last.pop_front();
}

double ServoVerdict::way_m() const {
    double way_m = 0.0;
    for (std::size_t i = 1; i < m_last.size(); ++i)
        way_m += (m_last[i].p_Base_Sensor_m - m_last[i - 1].p_Base_Sensor_m).norm();
    return way_m;
}

bool ServoVerdict::tooSlow(double speed_mPerS) const {
    // A phase that has just begun has had no time to move.
    if (m_last.empty() || m_now_s - m_phaseBegan_s < kEnd_s)
        return false;
    return way_m() < kSlow * speed_mPerS * (m_now_s - m_last.front().time_s);
}

std::optional<servo::Limit> ServoVerdict::limit() const {
    std::array<std::size_t, servo::kLimits> cycles{};
    for (const Cycle& cycle : m_last)
        for (std::size_t i = 0; i < servo::kLimits; ++i)
            cycles[i] += cycle.limits.has(static_cast<servo::Limit>(i)) ? 1 : 0;
    const auto most = std::ranges::max_element(cycles);
    if (2 * *most <= m_last.size())
        return std::nullopt;
    return static_cast<servo::Limit>(most - cycles.begin());
}

servo::TaskVerdict ServoVerdict::verdict() const {
    using servo::NotCompleted;
    const servo::TaskKind phase = m_phase.value_or(servo::TaskKind::freeMotion);
    const auto notCompleted = [phase](NotCompleted reason, std::optional<servo::Limit> limit = {}) {
        return servo::TaskVerdict{.completed = false, .phase = phase, .reason = reason, .limit = limit};
    };
    const std::optional<servo::Limit> acting = limit();
    if (m_touched_s < 0.0)
        return acting && tooSlow(m_task.approach_mPerS) ? notCompleted(NotCompleted::stalled, acting)
                                                        : notCompleted(NotCompleted::neverInContact);
    if (m_searchEnded || m_now_s - m_touched_s > kLostFor_s)
        return notCompleted(NotCompleted::lost);
    if (m_kind != m_lasting)
        return acting && tooSlow(m_task.approach_mPerS) ? notCompleted(NotCompleted::stalled, acting)
                                                        : notCompleted(NotCompleted::notAligned);
    const bool isPoint = m_lasting == servo::TaskKind::pointFollowing || m_lasting == servo::TaskKind::roll;
    if (isPoint && !m_alignment.since_s())
        return notCompleted(NotCompleted::notAligned);
    if (m_lasting == servo::TaskKind::explore && tooSlow(m_task.slide_mPerS))
        return notCompleted(NotCompleted::stalled, acting);
    return {.completed = true, .phase = phase, .reason = {}, .limit = {}};
}

} // namespace teleta::simulation
