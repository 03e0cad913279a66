// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/bracelet/limits_keeper.h"

#include "widgets/base/background.h"

#include <string>

namespace teleta::console {

namespace {

constexpr int kSoon_ms = 300;

} // namespace

LimitsKeeper::LimitsKeeper(QObject* parent)
    : QObject(parent) {
    m_thread.setMaxThreadCount(1);
    m_soon.setSingleShot(true);
    m_soon.setInterval(kSoon_ms);
    connect(&m_soon, &QTimer::timeout, this, &LimitsKeeper::keep);
}

LimitsKeeper::~LimitsKeeper() {
    flush();
    m_thread.waitForDone();
}

void LimitsKeeper::keepSoon(const motors::WearerLimits& limits) {
    m_limits = limits;
    m_soon.start();
}

void LimitsKeeper::flush() {
    if (m_soon.isActive())
        keep();
}

void LimitsKeeper::keep() {
    m_soon.stop();
    base::runInBackground(
        m_thread, this,
        [limits = m_limits] {
            const std::string path = motors::limitsPath(limits.bracelet);
            return path.empty() ? core::Expected<void>() : motors::writeLimits(limits, path);
        },
        [this](core::Expected<void> written) {
            if (!written)
                emit failed(written.error());
        });
}

} // namespace teleta::console
