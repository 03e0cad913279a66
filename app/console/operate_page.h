// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/source_manager.h"
#include "widgets/chrome/device_strip.h"
#include "widgets/chrome/message_bar.h"
#include "widgets/chrome/source_chooser.h"

#include <QList>
#include <QMainWindow>
#include <QWidget>

#include <optional>
#include <vector>

class QAction;
class QDockWidget;
class QStackedWidget;

namespace teleta::tactile {
class HeatmapView;
class ChannelSettingsPanel;
} // namespace teleta::tactile
namespace teleta::charts {
class StripChartView;
}
namespace teleta::chrome {
class EmptyState;
class PlaybackBar;
} // namespace teleta::chrome
namespace teleta::view3d {
class Scene3dView;
}

namespace teleta::console {

/// The Operate page: the views of the active source as docks, the source chooser, the playback bar, and
/// notices above them. Every 30 Hz tick it drains what the pipeline made and repaints what changed. Thread:
/// GUI.
class OperatePage : public QWidget {
    Q_OBJECT

public:
    explicit OperatePage(SourceManager& sources, QWidget* parent = nullptr);

    /// Repaints what changed since the last tick.
    void tick();
    /// What the status bar says of the open sources.
    [[nodiscard]] std::vector<chrome::DeviceReading> readings() const;

    [[nodiscard]] chrome::SourceChooser& chooser() { return *m_chooser; }
    [[nodiscard]] chrome::MessageBar& messages() { return *m_messages; }

    /// Actions that show and hide the docks.
    [[nodiscard]] QList<QAction*> dockActions() const;
    [[nodiscard]] QByteArray saveLayout() const;
    /// False when the layout is of another version or damaged; the default layout is then in place.
    bool restoreLayout(const QByteArray& layout);
    void resetLayout();
    void retranslate();

signals:
    void demoRequested();
    void openRecordingRequested();
    void openListRequested();

protected:
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void shareSpace();
    QDockWidget* addDock(const QString& name, QWidget* view);
    void onActiveChanged();
    void onSourcesChanged();
    void showState();
    void connectPlayback();
    void watchFailures(const SourceManager::Item& item);
    core::PlaybackControl* playback();

    SourceManager& m_sources;
    chrome::MessageBar* m_messages;
    chrome::SourceChooser* m_chooser;
    chrome::PlaybackBar* m_playback;
    QStackedWidget* m_stack;
    chrome::EmptyState* m_empty;
    QMainWindow* m_docks;
    tactile::HeatmapView* m_heatmap;
    charts::StripChartView* m_charts;
    view3d::Scene3dView* m_scene;
    tactile::ChannelSettingsPanel* m_settings;
    QDockWidget* m_heatmapDock = nullptr;
    QDockWidget* m_sceneDock = nullptr;
    QDockWidget* m_chartsDock = nullptr;
    QDockWidget* m_settingsDock = nullptr;
    bool m_defaultLayout = true;
    std::uint64_t m_settingsRevision = 0;
    std::optional<double> m_latency_s;
    std::vector<pipeline::ChannelKey> m_reportedLost;
};

} // namespace teleta::console
