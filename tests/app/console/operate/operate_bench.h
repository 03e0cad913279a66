// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/bracelet/bracelet_service.h"
#include "app/console/operate/operate_page.h"
#include "app/console/sources/source_manager.h"
#include "backend/core/threads/stop_switch.h"

#include <QObject>
#include <QTest>

#include <memory>

namespace teleta::test {

/// The Operate page with sources of its own, made anew for each test function.
class OperateBench : public QObject {
protected:
    static constexpr int kPatience_ms = 60'000;

    void makePage() {
        m_stop.release();
        m_sources = std::make_unique<console::SourceManager>(m_stop);
        m_page = std::make_unique<console::OperatePage>(*m_sources, m_bracelet, m_stop);
        m_page->resize(1200, 800);
    }
    void closePage() {
        m_page.reset();
        m_sources.reset();
    }
    void poll() {
        m_sources->poll();
        m_page->tick();
    }
    /// Whether the condition comes true in time.
    template <typename Condition>
    bool comes(const Condition& condition) {
        return QTest::qWaitFor(
            [&] {
                poll();
                return condition();
            },
            kPatience_ms);
    }

    core::StopSwitch m_stop;
    console::BraceletService m_bracelet{m_stop};
    std::unique_ptr<console::SourceManager> m_sources;
    std::unique_ptr<console::OperatePage> m_page;
};

} // namespace teleta::test
