// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/calibrate/camera/probing_thread.h"

namespace teleta::console {

ProbingThread::ProbingThread(QObject* parent)
    : QObject(parent) {
    m_pool.setMaxThreadCount(1);
}

ProbingThread::~ProbingThread() {
    m_stop.request_stop();
    m_pool.waitForDone();
}

void ProbingThread::start(std::function<void(const Run&)> work) {
    m_stop.request_stop();
    m_stop = {};
    setRunning(true);
    m_pool.start([work = std::move(work), run = Run{++m_number, m_stop.get_token()}] { work(run); });
}

void ProbingThread::cancel() {
    m_stop.request_stop();
    ++m_number; // drops its pending calls
    setRunning(false);
}

void ProbingThread::setRunning(bool running) {
    if (running == m_running)
        return;
    m_running = running;
    emit runningChanged(running);
}

} // namespace teleta::console
