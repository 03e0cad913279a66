// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/operate/gel_views.h"

#include "app/console/operate/taken_events.h"
#include "backend/core/steady_time.h"
#include "widgets/camera/gel/gel_event_table.h"
#include "widgets/camera/gel/gel_panel.h"
#include "widgets/camera/gel/gel_view.h"
#include "widgets/view3d/scene/gel_words.h"
#include "widgets/view3d/scene3d_view.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace teleta::console {

namespace {

/// Contacts as the picture tells them.
std::vector<view3d::GelWords> wordsOf(const pipeline::GelSnapshot& snapshot) {
    using camera::GelPicture;
    std::vector<view3d::GelWords> words;
    for (std::size_t i = 0; i < snapshot.contacts.size(); ++i) {
        const vision::GelContactState& contact = snapshot.contacts[i];
        words.push_back({GelPicture::slipText(contact),
                         GelPicture::wordsFor(snapshot, i),
                         {GelPicture::slipColour(contact, false), GelPicture::slipColour(contact, true)}});
    }
    return words;
}

} // namespace

GelViews::GelViews(view3d::Scene3dView& scene, QWidget* parent)
    : QObject(parent)
    , m_scene(scene)
    , m_panel(new camera::GelPanel(parent))
    , m_events(new camera::GelEventTable(parent)) {
    connect(m_panel, &camera::GelPanel::referenceRequested, this, [this] {
        if (m_gel)
            m_gel->renewReference();
    });
    connect(m_panel, &camera::GelPanel::mayReactChanged, this, [this](bool mayReact) {
        if (m_gel)
            m_gel->setMayReact(mayReact);
    });
    connect(m_panel, &camera::GelPanel::exportFailed, this, &GelViews::exportFailed);
    connect(m_events, &camera::GelEventTable::exportFailed, this, &GelViews::exportFailed);
}

void GelViews::addTo(OperateDocks& docks) {
    docks.add(OperateDocks::gel, m_panel);
    docks.add(OperateDocks::gelEvents, m_events);
}

void GelViews::setGel(std::shared_ptr<pipeline::GelChannel> gel, base::Provenance provenance) {
    const bool had = m_gel != nullptr;
    if (had)
        m_kept.insert_or_assign(m_gel, m_events->model().takeEvents());
    m_gel = std::move(gel);
    std::erase_if(m_kept, [](const auto& entry) { return entry.first.expired(); });
    m_latency_s.reset();
    m_panel->setProvenance(provenance);
    m_panel->setSnapshot(nullptr);
    m_events->setProvenance(provenance);
    m_events->clear();
    if (had)
        m_scene.setGel(nullptr, 1.0, {});
    m_enlargement = 0.0;
    if (!m_gel)
        return;
    m_scene.setProvenance(provenance);
    if (auto kept = m_kept.extract(m_gel))
        m_events->model().setEvents(std::move(kept.mapped()));
    if (m_gel->generation() > 0)
        show(m_gel->snapshot());
}

void GelViews::keep(const std::shared_ptr<pipeline::GelChannel>& gel) {
    if (gel)
        takeEvents(*gel, m_kept[gel], camera::GelEventModel::kCapacity);
}

bool GelViews::tick() {
    if (!m_gel)
        return false;
    pipeline::GelEvent event;
    while (m_gel->popEvent(event))
        m_events->append(event);
    if (!m_gel->update()) {
        if (m_enlargement > 0.0 && m_panel->view().picture().enlargement != m_enlargement)
            showInSpace(m_panel->view().picture().shown);
        return false;
    }
    const pipeline::GelSnapshot& snapshot = m_gel->snapshot();
    show(snapshot);
    m_latency_s = core::elapsed_s(snapshot.time_ns, core::steadyNow_ns());
    return true;
}

void GelViews::show(const pipeline::GelSnapshot& snapshot) {
    m_panel->setSnapshot(&snapshot);
    if (!m_panel->isPaused())
        showInSpace(snapshot);
}

void GelViews::showInSpace(const pipeline::GelSnapshot& snapshot) {
    m_enlargement = m_panel->view().picture().enlargement;
    m_scene.setGel(&snapshot, m_enlargement, wordsOf(snapshot));
}

} // namespace teleta::console
