// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/operate/docks/operate_docks.h"
#include "backend/pipeline/camera_channel.h"
#include "widgets/base/controls/badge.h"

#include <QObject>

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>

namespace teleta::camera {
class CameraPanel;
class EventTable;
} // namespace teleta::camera
namespace teleta::view3d {
class Scene3dView;
}

namespace teleta::console {

/// The views of a camera in the soft tube on the Operate page: its picture, what happened, and the tube with
/// what touches it in the reconstruction. Thread: GUI.
class CameraViews : public QObject {
    Q_OBJECT

public:
    CameraViews(view3d::Scene3dView& scene, QWidget* parent);

    void addTo(OperateDocks& docks);
    /// Shows another camera; null: none.
    void setCamera(std::shared_ptr<pipeline::CameraChannel> camera, base::Provenance provenance);
    [[nodiscard]] const std::shared_ptr<pipeline::CameraChannel>& camera() const { return m_camera; }
    /// Keeps the events of one that is not shown until it is shown.
    void keep(const std::shared_ptr<pipeline::CameraChannel>& camera);
    /// Shows what came since the last tick; true when there was a new picture.
    bool tick();
    /// Time from the read of the newest frame to its picture; empty without one.
    [[nodiscard]] std::optional<double> latency_s() const { return m_latency_s; }

    [[nodiscard]] camera::CameraPanel& panel() { return *m_panel; }
    [[nodiscard]] camera::EventTable& events() { return *m_events; }

signals:
    void exportFailed(const QString& message);

private:
    void show(const pipeline::CameraSnapshot& snapshot);

    view3d::Scene3dView& m_scene;
    camera::CameraPanel* m_panel;
    camera::EventTable* m_events;
    std::shared_ptr<pipeline::CameraChannel> m_camera;
    /// Events of the other open cameras, restored when they are shown again.
    std::map<std::weak_ptr<pipeline::CameraChannel>, std::deque<pipeline::CameraEvent>, std::owner_less<>>
        m_kept;
    std::optional<double> m_latency_s;
    std::uint64_t m_shownFrames = 0;
};

} // namespace teleta::console
