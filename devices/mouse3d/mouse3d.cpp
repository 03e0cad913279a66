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
    m_thread.start(m_worker, consumer);
}

void Mouse3d::stop() {
    m_thread.stop(m_worker);
}

} // namespace teleta::mouse3d
