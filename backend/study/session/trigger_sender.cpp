// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/session/trigger_sender.h"

#include "backend/core/threads/urgent_thread.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace teleta::study {

namespace {

constexpr std::int64_t kReopen_ns = 1'000'000'000;
/// How often an onset is looked for.
constexpr std::int64_t kLook_ns = 250'000;

} // namespace

TriggerSender::TriggerSender(Opener opener)
    : m_opener(std::move(opener))
    , m_thread([this](const std::stop_token& stop) { run(stop); }) {
}

TriggerSender::~TriggerSender() {
    m_thread.request_stop();
    m_condition.notify_all();
    m_thread.join();
}

void TriggerSender::post(core::TriggerEvent event) {
    {
        const std::scoped_lock lock(m_mutex);
        m_queue.emplace_back(std::move(event), false);
    }
    m_condition.notify_all();
}

void TriggerSender::await(core::TriggerEvent event, Onset onset) {
    std::optional<Waiting> before;
    {
        const std::scoped_lock lock(m_mutex);
        before = std::exchange(m_waiting, Waiting{std::move(event), std::move(onset)});
        m_isWatching = true;
        m_onsetToWritten_ms.reset();
    }
    m_condition.notify_all();
}

void TriggerSender::forget() {
    std::optional<Waiting> before;
    const std::scoped_lock lock(m_mutex);
    // An onset that was confirmed since the last look is not lost.
    (void)look();
    before = std::exchange(m_waiting, std::nullopt);
    m_isWatching = false;
}

std::optional<double> TriggerSender::onsetToWritten_ms() const {
    const std::scoped_lock lock(m_mutex);
    return m_onsetToWritten_ms;
}

TriggerStatus TriggerSender::status() const {
    const std::scoped_lock lock(m_mutex);
    return m_status;
}

/// Queues the event that waits if its onset is known. Locked.
bool TriggerSender::look() {
    if (!m_isWatching)
        return false;
    const std::int64_t onset_ns = m_waiting->onset();
    if (onset_ns == 0)
        return false;
    m_isWatching = false;
    m_waiting->event.time_ns = onset_ns;
    m_queue.emplace_back(m_waiting->event, true);
    m_condition.notify_all();
    return true;
}

void TriggerSender::run(const std::stop_token& stop) {
    (void)core::makeThreadUrgent();
    std::unique_lock lock(m_mutex);
    openLine(lock);
    // What was posted before the end is still written.
    while (!stop.stop_requested() || !m_queue.empty()) {
        const std::int64_t now_ns = core::steadyNow_ns();
        (void)look();
        if (!m_queue.empty()) {
            write(lock);
            continue;
        }
        if (m_clearAt_ns != 0 && now_ns >= m_clearAt_ns) {
            clear(lock);
            continue;
        }
        if (m_openAt_ns != 0 && now_ns >= m_openAt_ns) {
            openLine(lock);
            continue;
        }
        std::int64_t until_ns = m_isWatching ? now_ns + kLook_ns : 0;
        for (const std::int64_t due_ns : {m_clearAt_ns, m_openAt_ns}) {
            if (due_ns != 0)
                until_ns = until_ns == 0 ? due_ns : std::min(until_ns, due_ns);
        }
        const auto wanted = [&] { return stop.stop_requested() || !m_queue.empty() || m_isWatching; };
        if (m_isWatching)
            (void)m_condition.wait_until(lock, core::toTimePoint(until_ns),
                                         [&] { return stop.stop_requested() || !m_queue.empty(); });
        else if (until_ns != 0)
            (void)m_condition.wait_until(lock, core::toTimePoint(until_ns), wanted);
        else
            m_condition.wait(lock, wanted);
    }
    if (m_clearAt_ns != 0)
        clear(lock);
}

void TriggerSender::openLine(std::unique_lock<std::mutex>& lock) {
    lock.unlock();
    core::Expected<std::unique_ptr<core::TriggerPort>> opened = m_opener();
    lock.lock();
    if (opened) {
        m_port = std::move(*opened);
        m_openAt_ns = 0;
        m_status.state = TriggerStatus::State::open;
        return;
    }
    lose(opened.error());
}

void TriggerSender::lose(const core::Error& error) {
    m_port.reset();
    m_clearAt_ns = 0;
    m_openAt_ns = core::steadyNow_ns() + kReopen_ns;
    m_status.state = TriggerStatus::State::failed;
    m_status.error = error;
}

void TriggerSender::write(std::unique_lock<std::mutex>& lock) {
    const auto [event, awaited] = std::move(m_queue.front());
    m_queue.pop_front();
    if (!m_port) {
        ++m_status.failures;
        return;
    }
    lock.unlock();
    const core::Expected<void> done = m_port->write(event);
    const std::int64_t written_ns = core::steadyNow_ns();
    lock.lock();
    if (!done) {
        ++m_status.failures;
        lose(done.error());
        return;
    }
    ++m_status.written;
    if (awaited)
        m_onsetToWritten_ms = 1e-6 * static_cast<double>(written_ns - event.time_ns);
    m_clearAt_ns = m_port->pulse_ns() > 0 ? written_ns + m_port->pulse_ns() : 0;
}

void TriggerSender::clear(std::unique_lock<std::mutex>& lock) {
    m_clearAt_ns = 0;
    lock.unlock();
    const core::Expected<void> done = m_port->clear();
    lock.lock();
    if (!done)
        lose(done.error());
}

} // namespace teleta::study
