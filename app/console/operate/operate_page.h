// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/bracelet/bracelet_service.h"
#include "app/console/operate/arm_views.h"
#include "app/console/operate/camera_views.h"
#include "app/console/operate/docks/operate_docks.h"
#include "app/console/operate/gel_views.h"
#include "app/console/operate/recording/mark_views.h"
#include "app/console/operate/scene_views.h"
#include "app/console/operate/servo_views.h"
#include "app/console/operate/site/site_views.h"
#include "app/console/operate/source_watch.h"
#include "app/console/sources/source_manager.h"
#include "widgets/charts/feature_history.h"
#include "widgets/chrome/device_strip.h"
#include "widgets/chrome/message_bar.h"
#include "widgets/chrome/source_chooser.h"

#include <QWidget>

#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

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

class StartPage;

/// The Operate page: the views of the active source as docks, the source chooser, the playback bar, and
/// notices above them. Every 30 Hz tick it drains what the pipeline made and repaints what changed. Thread:
/// GUI.
class OperatePage : public QWidget {
    Q_OBJECT

public:
    OperatePage(SourceManager& sources, BraceletService& bracelet, core::StopSwitch& stop,
                QWidget* parent = nullptr);

    /// Repaints what changed since the last tick.
    void tick();
    /// Readings of the open sources for the status bar.
    [[nodiscard]] std::vector<chrome::DeviceReading> readings() const;

    /// In a low window the controls are lower, in a small one the pictures lie upon each other, too.
    void setCompact(bool low, bool small);
    [[nodiscard]] chrome::SourceChooser& chooser() { return *m_chooser; }
    /// Demo scenes for the menu, and the cards of the start page: see startCards().
    void setDemos(const std::vector<chrome::SourceChooser::Demo>& demos,
                  const std::vector<chrome::SourceChooser::Demo>& cards);
    /// Shown while nothing is open.
    [[nodiscard]] StartPage& startPage() { return *m_start; }
    [[nodiscard]] view3d::Scene3dView& reconstruction() { return *m_scene; }
    [[nodiscard]] chrome::MessageBar& messages() { return *m_messages; }

    [[nodiscard]] OperateDocks& docks() { return *m_docks; }
    [[nodiscard]] ArmViews& armViews() { return *m_arm; }
    [[nodiscard]] CameraViews& cameraViews() { return *m_camera; }
    [[nodiscard]] GelViews& gelViews() { return *m_gel; }
    [[nodiscard]] SceneViews& sceneViews() { return *m_looking; }
    [[nodiscard]] MarkViews& marks() { return *m_marks; }
    [[nodiscard]] SiteViews& siteViews() { return *m_site; }
    /// The shown source runs a program that can be held and restarted: an arm's program or a
    /// scene.
    [[nodiscard]] bool hasProgram() const;
    void setProgramRunning(bool running);
    void restartProgram();
    /// The scene of an array stays held after STOP. Only servo scenes have a view with *Run*: for others a
    /// notice offers it.
    void onStopReleased();
    void retranslate();

signals:
    /// A source shall be closed, see SourceManager::close().
    void closeRequested(std::uint64_t key);
    void demoRequested();
    /// path: of a scene that the program brings.
    void sceneRequested(const QString& path);
    /// A card of the start page that is no scene: "study:KIND", "pattern:ID".
    void cardRequested(const QString& place);
    void firstStepsRequested();
    void openRecordingRequested();
    void openListRequested();

private:
    void openCard(const QString& place);
    void onActiveChanged();
    /// Keeps the charts of the previous source until it is shown again.
    void changeCharts(pipeline::ChannelKey shown);
    void onSourcesChanged();
    void showOpening();
    void onBraceletFailed(const core::Error& error);
    void connectPlayback();
    /// Null when no array is shown.
    [[nodiscard]] std::shared_ptr<pipeline::TouchChannel> shownArray() const;
    void showArray(pipeline::TouchChannel* array, base::Provenance provenance);
    /// In the heatmap and on the arm, where a contact goes on over the seam of the skin.
    void showFrame(pipeline::TouchSnapshot frame);
    void passOver(SourceManager::Item& item);
    void tickArray(pipeline::TouchChannel& array, SourceManager::Item& item, std::int64_t now_ns);
    void tickSceneCamera(SourceManager::Item& item, std::int64_t now_ns);
    /// Of the streams of a site that are open here; null: none.
    [[nodiscard]] std::vector<site_view::SiteBarState::Count>
    lossesOf(const site_link::SiteClient* site) const;
    /// A live arm whose touches the bracelet does not play since it is not shown; null: none.
    [[nodiscard]] const SourceManager::Item* unfeltArm() const;
    void tellUnfelt();
    core::PlaybackControl* playback();
    /// Applies a playback command to the other sources of the shown recording.
    template <typename Call>
    void withOthers(const Call& call);
    void startPlayback();
    void stepPlayback(int frames);

    SourceManager& m_sources;
    BraceletService& m_bracelet;
    core::StopSwitch& m_stop;
    chrome::MessageBar* m_messages;
    SourceWatch m_watch;
    chrome::SourceChooser* m_chooser;
    chrome::PlaybackBar* m_playback;
    QStackedWidget* m_stack;
    StartPage* m_start;
    chrome::EmptyState* m_opening; ///< while nothing is shown yet
    OperateDocks* m_docks;
    tactile::HeatmapView* m_heatmap;
    charts::StripChartView* m_charts;
    view3d::Scene3dView* m_scene;
    tactile::ChannelSettingsPanel* m_settings;
    ArmViews* m_arm;
    ServoViews* m_servo;
    CameraViews* m_camera;
    GelViews* m_gel;
    SceneViews* m_looking;
    MarkViews* m_marks;
    SiteViews* m_site;
    std::uint64_t m_settingsRevision = 0;
    std::optional<double> m_latency_s;
    pipeline::ChannelKey m_shown = 0; ///< whose samples the charts have
    std::map<pipeline::ChannelKey, charts::FeatureHistory> m_keptCharts;
};

} // namespace teleta::console
