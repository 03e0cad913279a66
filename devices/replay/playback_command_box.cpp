// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/replay/playback_command_box.h"

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

PlaybackCommandBox::PlaybackCommandBox(std::shared_ptr<core::PacingClock> clock, bool playing, bool loop,
                                       double speed)
    : m_clock(std::move(clock)) {
    m_commands.playing = playing;
    m_commands.loop = loop;
    if (!std::isnan(speed))
        m_commands.speed = allowedSpeed(speed);
}

/// Changes the commands and wakes the worker.
template <typename Change>
void PlaybackCommandBox::command(const Change& change) {
    const std::scoped_lock lock(m_mutex);
    change(m_commands);
    m_commands.at_ns = m_clock->now_ns();
    m_commanded = true;
    m_condition.notify_all();
}

void PlaybackCommandBox::setPlaying(bool playing) {
    command([playing](PlaybackCommands& commands) { commands.playing = playing; });
}

void PlaybackCommandBox::step(int frames) {
    command([frames](PlaybackCommands& commands) {
        commands.playing = false;
        commands.steps += frames;
    });
}

void PlaybackCommandBox::setSpeed(double factor) {
    if (!std::isnan(factor))
        command([factor](PlaybackCommands& commands) { commands.speed = allowedSpeed(factor); });
}

void PlaybackCommandBox::seek(double time_s) {
    if (std::isnan(time_s))
        return;
    command([this, time_s](PlaybackCommands& commands) {
        commands.seek_s = std::max(time_s, 0.0);
        commands.steps = 0;
        m_seekWaiting.store(true, std::memory_order_relaxed);
    });
}

void PlaybackCommandBox::setLoop(bool loop) {
    command([loop](PlaybackCommands& commands) { commands.loop = loop; });
}

void PlaybackCommandBox::wake() {
    const std::scoped_lock lock(m_mutex);
    m_condition.notify_all();
}

void PlaybackCommandBox::begin(bool playing) {
    const std::scoped_lock lock(m_mutex);
    m_commands.playing = playing;
    m_commands.seek_s = 0.0;
}

void PlaybackCommandBox::end() {
    const std::scoped_lock lock(m_mutex);
    m_commands.playing = false;
}

PlaybackCommands PlaybackCommandBox::take() {
    const std::scoped_lock lock(m_mutex);
    PlaybackCommands commands = m_commands;
    m_seeking_s = commands.steps == 0 ? commands.seek_s : std::nullopt;
    m_commands.seek_s.reset();
    m_commands.steps = 0;
    m_commanded = false;
    m_seekWaiting.store(false, std::memory_order_relaxed);
    return commands;
}

void PlaybackCommandBox::waitUntil(std::int64_t deadline_ns, const std::stop_token& stop) {
    std::unique_lock lock(m_mutex);
    if (!m_commanded && !stop.stop_requested())
        m_clock->waitUntil(m_condition, lock, deadline_ns);
}

bool PlaybackCommandBox::waitForRoom(const std::stop_token& stop) {
    std::unique_lock lock(m_mutex);
    if (stop.stop_requested())
        return false;
    m_clock->waitUntil(m_condition, lock, m_clock->now_ns() + kRoomRetry_ns);
    return true;
}

std::optional<double> PlaybackCommandBox::describe(core::PlaybackPosition& position) const {
    const std::scoped_lock lock(m_mutex);
    position.paused = !m_commands.playing;
    position.speed = m_commands.speed;
    position.loop = m_commands.loop;
    return m_commands.seek_s ? m_commands.seek_s : m_seeking_s;
}

} // namespace teleta::replay
