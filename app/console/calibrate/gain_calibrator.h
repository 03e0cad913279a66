// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/calibrate/press_collector.h"
#include "app/console/sources/source_manager.h"
#include "backend/equilibration/taxel_gains.h"
#include "widgets/calibrate/gains_view.h"

#include <QObject>
#include <QString>
#include <QStringList>

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <utility>

namespace teleta::tactile {
class HeatmapView;
}

namespace teleta::console {

/// Calibrates the taxels of the array shown in the console: collects presses from its channel, computes gains
/// and handles files on pool threads, and applies the gains to the channel. Switching to another array ends
/// what is running; the gains of an array are kept while its source is open. Thread: GUI; nothing blocks.
class GainCalibrator : public QObject {
    Q_OBJECT

public:
    /// sources must outlive this.
    GainCalibrator(SourceManager& sources, QWidget* parent);

    [[nodiscard]] calibrate::GainsView& view() { return *m_view; }
    /// Whether the gains of all open arrays are saved.
    [[nodiscard]] bool isSaved() const;
    /// Whether those of this source are; true when it has none.
    [[nodiscard]] bool isSaved(pipeline::ChannelKey key) const;
    void tick();

    void collect();
    /// Reads presses from files of frames.
    void openPresses(const QStringList& paths);
    void load(const QString& path);
    void save(const QString& path, const std::function<void()>& done = {});
    /// Whether the array shown is that of this source.
    [[nodiscard]] bool isShown(pipeline::ChannelKey key) const { return m_channel && key == m_key; }
    /// Whether the array shown has gains that can be saved.
    [[nodiscard]] bool canSave() const { return m_view->calibration().gains && !m_view->isSaved(); }
    /// Asks for a file for them. done: called once they are saved, not after a failure or a refusal.
    void askToSave(std::function<void()> done = {});

signals:
    void demoRequested();
    void trouble(const QString& what, const QString& details);

private:
    using Found = core::Expected<calibrate::GainCalibration>;
    /// The calibration of an open array that is not shown.
    struct Left {
        calibrate::GainCalibration calibration;
        bool isSaved;
    };

    void onActiveChanged();
    void retranslate();
    void showFrame(const pipeline::TouchSnapshot* snapshot);
    void endCollecting();
    /// Computes a calibration on a pool thread; the view shows it if the array is still the same.
    void find(std::function<Found()> work);

    SourceManager& m_sources;
    calibrate::GainsView* m_view;
    pipeline::ChannelKey m_key = 0;
    std::shared_ptr<pipeline::TouchChannel> m_channel; ///< of the array shown; null: none
    std::map<pipeline::ChannelKey, Left> m_left;
    std::unique_ptr<PressCollector> m_collector;
    tactile::HeatmapView* m_live;
    std::pair<pipeline::ChannelKey, std::uint64_t> m_shown; ///< the frame in it
    std::uint64_t m_round = 0; ///< counts changes of the array, to detect late results
};

} // namespace teleta::console
