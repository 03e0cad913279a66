// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/operate/gel_views.h"

#include "backend/core/steady_time.h"
#include "widgets/camera/gel/gel_event_table.h"
#include "widgets/camera/gel/gel_panel.h"

#include <utility>

namespace teleta::console {

GelViews::GelViews(QWidget* parent)
    : QObject(parent)
    , m_panel(new camera::GelPanel(parent))
    , m_events(new camera::GelEventTable(parent)) {
    connect(m_panel, &camera::GelPanel::referenceRequested, this, [this] {
        if (m_gel)
            m_gel->renewReference();
    });
    connect(m_panel, &camera::GelPanel::exportFailed, this, &GelViews::exportFailed);
    connect(m_events, &camera::GelEventTable::exportFailed, this, &GelViews::exportFailed);
}

void GelViews::addTo(OperateDocks& docks) {
    docks.add(OperateDocks::gel, m_panel);
    docks.add(OperateDocks::gelEvents, m_events);
}

void GelViews::setGel(std::shared_ptr<pipeline::GelChannel> gel, base::Provenance provenance) {
    if (m_gel)
        m_kept.insert_or_assign(m_gel, m_events->model().takeEvents());
    m_gel = std::move(gel);
    std::erase_if(m_kept, [](const auto& entry) { return entry.first.expired(); });
    m_latency_s.reset();
    m_panel->setProvenance(provenance);
    m_panel->setSnapshot(nullptr);
    m_events->setProvenance(provenance);
    m_events->clear();
    if (!m_gel)
        return;
    if (auto kept = m_kept.extract(m_gel))
        m_events->model().setEvents(std::move(kept.mapped()));
    if (m_gel->generation() > 0)
        m_panel->setSnapshot(&m_gel->snapshot());
}

bool GelViews::tick() {
    if (!m_gel)
        return false;
    pipeline::GelEvent event;
    while (m_gel->popEvent(event))
        m_events->append(event);
    if (!m_gel->update())
        return false;
    const pipeline::GelSnapshot& snapshot = m_gel->snapshot();
    m_panel->setSnapshot(&snapshot);
    m_latency_s = core::elapsed_s(snapshot.time_ns, core::steadyNow_ns());
    return true;
}

} // namespace teleta::console
