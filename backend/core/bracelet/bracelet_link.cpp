// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/bracelet/bracelet_link.h"

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
    m_thread.start(m_worker, consumer);
}

void BraceletLink::stop() {
    m_thread.stop(m_worker);
}

} // namespace teleta::core
