// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/operate/docks/operate_docks.h"
#include "app/console/sources/source_manager.h"
#include "widgets/chrome/device_strip.h"

#include <QObject>

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace teleta::camera {
class ScenePanel;
}

namespace teleta::console {

/// The dock Scene of the Operate page: what all open scene cameras see, whichever source is the active one.
/// Thread: GUI.
class SceneViews : public QObject {
    Q_OBJECT

public:
    explicit SceneViews(QWidget* parent);

    void addTo(OperateDocks& docks);
    /// Shows the scene cameras among the open sources; the dock is there while there is one.
    void setSources(const std::vector<SourceManager::Item>& items);
    /// Shows what came of one of them since the last tick; true when there was a new picture.
    bool tick(SourceManager::Item& item, const chrome::DeviceReading& reading, std::int64_t now_ns);
    /// Time from the read of a camera's newest picture until it was shown; empty without one.
    [[nodiscard]] std::optional<double> latency_s(pipeline::ChannelKey key) const;

    [[nodiscard]] camera::ScenePanel& panel() { return *m_panel; }

signals:
    void exportFailed(const QString& message);

private:
    OperateDocks* m_docks = nullptr;
    camera::ScenePanel* m_panel;
    std::map<pipeline::ChannelKey, double> m_latency_s;
};

} // namespace teleta::console
