// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/bracelet/bracelet_station.h"
#include "backend/motors/motor_fit.h"
#include "backend/motors/motor_recording.h"

#include <QObject>
#include <QString>

#include <atomic>
#include <cstddef>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

namespace teleta::calibrate {
class MotorsView;
}

namespace teleta::console {

/// Calibrates the motors of the console's bracelet: drives it through its player for the view, measures on a
/// pool thread, reads and writes files there. STOP and another bracelet end a measurement. Thread: GUI; no
/// call waits but the destructor, for a measurement that is ended.
class MotorCalibrator : public QObject {
    Q_OBJECT

public:
    MotorCalibrator(BraceletStation& station, QWidget* parent);
    ~MotorCalibrator() override;

    [[nodiscard]] calibrate::MotorsView& view() { return *m_view; }
    void tick();

    /// Fits a recording to a motor.
    void openRecording(std::size_t motor, const QString& path);
    /// Reads a profile in place of the present one.
    void load(const QString& path);
    /// Keeps the profile for the bracelet; with a path, a copy there.
    void save(const QString& copyPath = {});

signals:
    void trouble(const QString& what, const QString& details);

private:
    using Fitted = std::pair<motors::MotorRecording, core::Expected<motors::MotorFit>>;

    /// A measurement that runs; shared with its thread.
    struct Run {
        std::stop_source stop;
        std::atomic<double> progress{0.0};
        std::atomic<bool> begun{false}; ///< it has got a thread, which plays
        std::promise<void> ended;       ///< its thread has let go of the bracelet
        std::future<void> end = ended.get_future();
    };

    void onSession();
    void measureNext();
    void cancel();
    /// Ends a run that may not drive the bracelet (any more), and says why.
    void refuseRun();
    void writeExcitation(const QString& path);
    void askForFile(const QString& title, const QString& filter, const QString& suffix,
                    std::function<void(const QString&)> done);
    void report(const QString& what, const core::Error& error);

    BraceletStation& m_station;
    calibrate::MotorsView* m_view;
    std::vector<std::size_t> m_waiting; ///< motors that are to be measured, the next one last
    std::optional<std::size_t> m_measuring;
    std::shared_ptr<Run> m_run;
    std::vector<std::shared_ptr<Run>> m_runs; ///< those whose thread may still hold the bracelet
};

} // namespace teleta::console
