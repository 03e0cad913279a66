// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/playback/player.h"

#include <utility>

namespace teleta::playback {

Player::Player(core::BraceletSource& bracelet, const core::StopSwitch& stopSwitch, PlayerConfig config)
    : m_clock(config.clock)
    , m_cycle(bracelet, stopSwitch, std::move(config))
    , m_thread([this](const std::stop_token& stop) { run(stop); }) {
}

Player::~Player() {
    m_thread.request_stop();
    command([](PlayerCommands&) {});
    m_thread.join();
}

std::uint64_t Player::play(Program program, bool loop, double from_s) {
    std::uint64_t number = 0;
    command([&](PlayerCommands& commands) {
        number = commands.newest = ++m_programs;
        commands.start = ProgramRequest{std::move(program), loop, from_s, number};
        commands.dropChanges();
    });
    return number;
}

void Player::change(std::uint64_t number, Program program, double shift_s) {
    command([&](PlayerCommands& commands) {
        if (commands.seek_s)
            *commands.seek_s += shift_s;
        auto* request = commands.start ? std::get_if<ProgramRequest>(&*commands.start) : nullptr;
        if (request != nullptr && request->number == number) {
            request->program = std::move(program);
            request->from_s += shift_s;
            return;
        }
        const double before_s =
            commands.change && commands.change->number == number ? commands.change->shift_s : 0.0;
        commands.change = ProgramChange{std::move(program), before_s + shift_s, number};
    });
}

void Player::startLive() {
    command([this](PlayerCommands& commands) {
        commands.start = LiveRequest{};
        commands.dropChanges();
        // What was posted before is not what is asked for now.
        [[maybe_unused]] const auto old = m_cycle.setpoints().take();
    });
}

void Player::stop() {
    command([](PlayerCommands& commands) {
        commands.stop = true;
        commands.start.reset();
        commands.dropChanges();
    });
}

void Player::stop(std::uint64_t number) {
    command([number](PlayerCommands& commands) {
        const auto* request = commands.start ? std::get_if<ProgramRequest>(&*commands.start) : nullptr;
        if (request != nullptr && request->number == number) {
            // What came after it was for it.
            commands.start.reset();
            commands.dropChanges();
        }
        commands.stopProgram = number;
    });
}

void Player::seek(double time_s) {
    command([time_s](PlayerCommands& commands) { commands.seek_s = time_s; });
}

void Player::setLoop(bool loop) {
    command([loop](PlayerCommands& commands) { commands.loop = loop; });
}

void Player::setLimits(const SafetyLimits& limits) {
    command([&limits](PlayerCommands& commands) { commands.limits = limits; });
}

void Player::setRanges(const DriveRanges& ranges) {
    command([&ranges](PlayerCommands& commands) { commands.ranges = ranges; });
}

void Player::post(const core::Intensities& intensities, std::int64_t made_ns) {
    m_cycle.setpoints().post({intensities, made_ns});
    const std::scoped_lock lock(m_mutex);
    if (std::exchange(m_takesSetpoint, false)) {
        m_commanded = true;
        m_condition.notify_all();
    }
}

template <typename Change>
void Player::command(const Change& change) {
    const std::scoped_lock lock(m_mutex);
    change(m_commands);
    m_commanded = true;
    m_condition.notify_all();
}

void Player::run(const std::stop_token& stop) {
    m_urgency = core::makeThreadUrgent();
    std::unique_lock lock(m_mutex);
    while (!stop.stop_requested()) {
        PlayerCommands commands = std::exchange(m_commands, {});
        m_commanded = false;
        m_takesSetpoint = true;
        lock.unlock();
        const std::int64_t deadline_ns = m_cycle.run(std::move(commands));
        lock.lock();
        if (m_commanded || stop.stop_requested())
            continue;
        m_takesSetpoint = m_cycle.takesSetpointAtOnce();
        m_clock->waitUntil(m_condition, lock, deadline_ns);
    }
    lock.unlock();
    m_cycle.close();
}

} // namespace teleta::playback
