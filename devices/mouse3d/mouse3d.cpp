// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/mouse3d/mouse3d.h"

#include <utility>

namespace teleta::mouse3d {

Mouse3d::Mouse3d(Mouse3dConfig config, HidInputOpener opener)
    : m_worker(std::move(opener), std::move(config)) {
}

Mouse3d::~Mouse3d() {
    stop();
}

void Mouse3d::start(core::Wakeup& consumer) {
    if (m_thread.joinable())
        return;
    m_worker.open(consumer);
    m_thread = std::jthread([this](const std::stop_token& stop) { m_worker.run(stop); });
}

void Mouse3d::stop() {
    if (!m_thread.joinable())
        return;
    m_thread.request_stop();
    m_worker.wake();
    m_thread.join();
}

} // namespace teleta::mouse3d
