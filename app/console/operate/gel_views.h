// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/operate/docks/operate_docks.h"
#include "backend/pipeline/gel_channel.h"
#include "widgets/base/controls/badge.h"

#include <QObject>

#include <deque>
#include <map>
#include <memory>
#include <optional>

namespace teleta::camera {
class GelEventTable;
class GelPanel;
} // namespace teleta::camera

namespace teleta::view3d {
class Scene3dView;
}

namespace teleta::console {

/// The views of a flat gel on the Operate page: its picture, what happened, and its plane with its markers in
/// the reconstruction. Thread: GUI.
class GelViews : public QObject {
    Q_OBJECT

public:
    GelViews(view3d::Scene3dView& scene, QWidget* parent);

    void addTo(OperateDocks& docks);
    /// Shows another gel; null: none.
    void setGel(std::shared_ptr<pipeline::GelChannel> gel, base::Provenance provenance);
    [[nodiscard]] const std::shared_ptr<pipeline::GelChannel>& gel() const { return m_gel; }
    /// Keeps the events of one that is not shown until it is shown.
    void keep(const std::shared_ptr<pipeline::GelChannel>& gel);
    /// Shows what came since the last tick; true when there was a new picture.
    bool tick();
    /// Time from the read of the newest picture until it was shown; empty without one.
    [[nodiscard]] std::optional<double> latency_s() const { return m_latency_s; }

    [[nodiscard]] camera::GelPanel& panel() { return *m_panel; }
    [[nodiscard]] camera::GelEventTable& events() { return *m_events; }

signals:
    void exportFailed(const QString& message);

private:
    void show(const pipeline::GelSnapshot& snapshot);
    /// In the reconstruction, enlarged as in the picture.
    void showInSpace(const pipeline::GelSnapshot& snapshot);

    view3d::Scene3dView& m_scene;
    camera::GelPanel* m_panel;
    camera::GelEventTable* m_events;
    std::shared_ptr<pipeline::GelChannel> m_gel;
    /// Events of the other open gels, restored when they are shown again.
    std::map<std::weak_ptr<pipeline::GelChannel>, std::deque<pipeline::GelEvent>, std::owner_less<>> m_kept;
    std::optional<double> m_latency_s;
    double m_enlargement = 0.0; ///< in the reconstruction; 0: nothing is shown
};

} // namespace teleta::console
