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

namespace teleta::console {

/// Calibrates the taxels of the array that the console shows: collects presses from its channel for the view,
/// finds the gains and reads and writes files on pool threads, hands gains to the channel. Another array ends
/// what runs; what was found of an array stays as long as its source is open. Thread: GUI; no call waits.
class GainCalibrator : public QObject {
    Q_OBJECT

public:
    /// sources outlives this.
    GainCalibrator(SourceManager& sources, QWidget* parent);

    [[nodiscard]] calibrate::GainsView& view() { return *m_view; }
    /// Of all arrays that are open.
    [[nodiscard]] bool isSaved() const;
    void tick();

    void collect();
    /// Adds presses from files of frames.
    void openPresses(const QStringList& paths);
    void load(const QString& path);
    void save(const QString& path);

signals:
    void demoRequested();
    void trouble(const QString& what, const QString& details);

private:
    using Found = core::Expected<calibrate::GainCalibration>;
    /// Of an array that is open and not shown.
    struct Left {
        calibrate::GainCalibration calibration;
        bool isSaved;
    };

    void onActiveChanged();
    void endCollecting();
    /// Makes a calibration on a pool thread; the view takes it when the array is still the same.
    void find(const QString& text, std::function<Found()> work);
    void askForFiles(const QString& title, const QString& filter, bool several,
                     std::function<void(const QStringList&)> done);
    void askForNewFile(const QString& title, std::function<void(const QString&)> done);
    void report(const QString& what, const core::Error& error);

    SourceManager& m_sources;
    calibrate::GainsView* m_view;
    pipeline::ChannelKey m_key = 0;
    std::shared_ptr<pipeline::TouchChannel> m_channel; ///< of the array that is shown; null: none is
    std::map<pipeline::ChannelKey, Left> m_left;
    std::unique_ptr<PressCollector> m_collector;
    std::uint64_t m_round = 0; ///< grows with each array, so that late results are told apart
};

} // namespace teleta::console
