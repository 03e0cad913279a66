// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/bracelet_link.h"

#include <utility>

namespace teleta::core {

BraceletLink::BraceletLink(OpenedBracelet opened, BraceletOpener opener, const StopSwitch& stopSwitch,
                           BraceletLinkConfig config)
    : m_worker(std::move(opened), std::move(opener), stopSwitch, std::move(config)) {
}

BraceletLink::~BraceletLink() {
    stop();
}

void BraceletLink::start(Wakeup& consumer) {
    if (m_thread.joinable())
        return;
    m_worker.open(consumer);
    m_thread = std::jthread([this](const std::stop_token& stop) { m_worker.run(stop); });
}

void BraceletLink::stop() {
    if (!m_thread.joinable())
        return;
    m_thread.request_stop();
    m_worker.wake();
    m_thread.join();
}

} // namespace teleta::core
