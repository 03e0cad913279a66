// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/operate/scene_views.h"

#include "app/console/sources/source_provenance.h"
#include "backend/core/steady_time.h"
#include "widgets/camera/scene/scene_panel.h"

#include <algorithm>

namespace teleta::console {

SceneViews::SceneViews(QWidget* parent)
    : QObject(parent)
    , m_panel(new camera::ScenePanel(parent)) {
    connect(m_panel, &camera::ScenePanel::exportFailed, this, &SceneViews::exportFailed);
}

void SceneViews::addTo(OperateDocks& docks) {
    m_docks = &docks;
    docks.add(OperateDocks::scene, m_panel);
}

void SceneViews::setSources(const std::vector<SourceManager::Item>& items) {
    std::vector<std::uint64_t> keys;
    for (const SourceManager::Item& item : items)
        if (item.sceneCamera())
            keys.push_back(item.key);
    m_panel->setCameras(keys);
    for (const SourceManager::Item& item : items) {
        if (camera::SceneTile* tile = m_panel->tile(item.key)) {
            tile->setName(QString::fromStdString(item.channel->summary().name));
            tile->setProvenance(provenanceOf(item));
        }
    }
    std::erase_if(m_latency_s, [this](const auto& kept) { return m_panel->tile(kept.first) == nullptr; });
    m_docks->setHasScene(!keys.empty());
}

bool SceneViews::tick(SourceManager::Item& item, const chrome::DeviceReading& reading, std::int64_t now_ns) {
    const auto camera = item.sceneCamera();
    camera::SceneTile* tile = m_panel->tile(item.key);
    if (!camera || tile == nullptr)
        return false;
    const bool isNew = camera->update();
    const pipeline::SceneCameraSnapshot& shown = camera->snapshot();
    if (isNew) {
        tile->setImage(shown.image);
        ++item.displayed;
        m_latency_s[item.key] = core::elapsed_s(shown.time_ns, now_ns);
    }
    tile->setReading({.state = reading.state,
                      .age_s = shown.image.isEmpty() ? reading.age_s : core::elapsed_s(shown.time_ns, now_ns),
                      .rate_Hz = reading.rate_Hz,
                      .reason = reading.details,
                      .now_ns = now_ns});
    return isNew;
}

std::optional<double> SceneViews::latency_s(pipeline::ChannelKey key) const {
    const auto found = m_latency_s.find(key);
    return found == m_latency_s.end() ? std::nullopt : std::optional(found->second);
}

} // namespace teleta::console
