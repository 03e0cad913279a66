// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/operate/camera_views.h"

#include "app/console/operate/taken_events.h"
#include "backend/core/steady_time.h"
#include "widgets/camera/camera_panel.h"
#include "widgets/camera/event_model.h"
#include "widgets/camera/event_table.h"
#include "widgets/view3d/scene3d_view.h"

#include <utility>

namespace teleta::console {

CameraViews::CameraViews(view3d::Scene3dView& scene, QWidget* parent)
    : QObject(parent)
    , m_scene(scene)
    , m_panel(new camera::CameraPanel(parent))
    , m_events(new camera::EventTable(parent)) {
    connect(m_panel, &camera::CameraPanel::rungChosen, this, [this](const QString& name) {
        if (m_camera)
            m_camera->chooseRung(name.toStdString());
    });
    connect(m_panel, &camera::CameraPanel::referenceRequested, this, [this] {
        if (m_camera)
            m_camera->renewReference();
    });
    connect(m_panel, &camera::CameraPanel::mayReactChanged, this, [this](bool mayReact) {
        if (m_camera)
            m_camera->setMayReact(mayReact);
    });
    connect(m_panel, &camera::CameraPanel::exportFailed, this, &CameraViews::exportFailed);
    connect(m_events, &camera::EventTable::exportFailed, this, &CameraViews::exportFailed);
}

void CameraViews::addTo(OperateDocks& docks) {
    docks.add(OperateDocks::camera, m_panel);
    docks.add(OperateDocks::events, m_events);
}

void CameraViews::setCamera(std::shared_ptr<pipeline::CameraChannel> camera, base::Provenance provenance) {
    const bool had = m_camera != nullptr;
    if (had)
        m_kept.insert_or_assign(m_camera, m_events->model().takeEvents());
    m_camera = std::move(camera);
    std::erase_if(m_kept, [](const auto& entry) { return entry.first.expired(); });
    m_latency_s.reset();
    m_shownFrames = 0;
    m_panel->setProvenance(provenance);
    m_panel->setSnapshot(nullptr);
    m_events->setProvenance(provenance);
    m_events->clear();
    if (had)
        m_scene.setTube(nullptr);
    if (!m_camera)
        return;
    m_scene.setProvenance(provenance);
    if (auto kept = m_kept.extract(m_camera))
        m_events->model().setEvents(std::move(kept.mapped()));
    if (m_camera->generation() > 0)
        show(m_camera->snapshot());
}

void CameraViews::keep(const std::shared_ptr<pipeline::CameraChannel>& camera) {
    if (camera)
        takeEvents(*camera, m_kept[camera], camera::EventModel::kCapacity);
}

bool CameraViews::tick() {
    if (!m_camera)
        return false;
    pipeline::CameraEvent event;
    while (m_camera->popEvent(event))
        m_events->append(event);
    if (!m_camera->update())
        return false;
    const pipeline::CameraSnapshot& snapshot = m_camera->snapshot();
    show(snapshot);
    // One without a new frame says what the arm does.
    if (snapshot.processed != m_shownFrames)
        m_latency_s = core::elapsed_s(snapshot.time_ns, core::steadyNow_ns());
    m_shownFrames = snapshot.processed;
    return true;
}

void CameraViews::show(const pipeline::CameraSnapshot& snapshot) {
    m_panel->setSnapshot(&snapshot, m_camera->description().nominalRate_Hz);
    m_scene.setTube(&snapshot);
}

} // namespace teleta::console
