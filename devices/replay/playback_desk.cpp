// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/replay/playback_desk.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::replay {

namespace {

constexpr double kSlowest = 0.01;
constexpr double kFastest = 100.0;
constexpr std::int64_t kRoomRetry_ns = 1'000'000;

double allowedSpeed(double factor) {
    return std::isinf(factor) && factor > 0.0 ? factor : std::clamp(factor, kSlowest, kFastest);
}

} // namespace

PlaybackDesk::PlaybackDesk(std::shared_ptr<core::PacingClock> clock, bool playing, bool loop, double speed)
    : m_clock(std::move(clock)) {
    m_commands.playing = playing;
    m_commands.loop = loop;
    if (!std::isnan(speed))
        m_commands.speed = allowedSpeed(speed);
}

void PlaybackDesk::setPlaying(bool playing) {
    command([playing](PlaybackCommands& commands) { commands.playing = playing; });
}

void PlaybackDesk::setSpeed(double factor) {
    if (!std::isnan(factor))
        command([factor](PlaybackCommands& commands) { commands.speed = allowedSpeed(factor); });
}

void PlaybackDesk::setLoop(bool loop) {
    command([loop](PlaybackCommands& commands) { commands.loop = loop; });
}

void PlaybackDesk::wake() {
    const std::scoped_lock lock(m_mutex);
    m_condition.notify_all();
}

void PlaybackDesk::waitUntil(std::int64_t deadline_ns, const std::stop_token& stop) {
    std::unique_lock lock(m_mutex);
    if (!m_commanded && !stop.stop_requested())
        m_clock->waitUntil(m_condition, lock, deadline_ns);
}

bool PlaybackDesk::waitForRoom(const std::stop_token& stop) {
    std::unique_lock lock(m_mutex);
    if (stop.stop_requested())
        return false;
    m_clock->waitUntil(m_condition, lock, m_clock->now_ns() + kRoomRetry_ns);
    return true;
}

std::optional<double> PlaybackDesk::describe(core::PlaybackPosition& position) const {
    const std::scoped_lock lock(m_mutex);
    position.paused = !m_commands.playing;
    position.speed = m_commands.speed;
    position.loop = m_commands.loop;
    return m_commands.seek_s ? m_commands.seek_s : m_seeking_s;
}

} // namespace teleta::replay
