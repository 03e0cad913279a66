// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/bracelet/bracelet_service.h"
#include "backend/motors/motor_fit.h"
#include "backend/motors/motor_recording.h"
#include "widgets/calibrate/step_list.h"

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

/// Calibrates the motors of the console's bracelet: plays what the view asks for, and measures and handles
/// files on pool threads. STOP or another bracelet ends a measurement. Thread: GUI; nothing blocks but the
/// destructor, which waits for a measurement to end.
class MotorCalibrator : public QObject {
    Q_OBJECT

public:
    MotorCalibrator(BraceletService& station, QWidget* parent);
    ~MotorCalibrator() override;

    [[nodiscard]] calibrate::MotorsView& view() { return *m_view; }
    [[nodiscard]] calibrate::StepReading step() const;
    void tick();

    /// Fits a motor to a recording.
    void openRecording(std::size_t motor, const QString& path);
    /// Reads a profile, which replaces the present one.
    void load(const QString& path);
    /// Saves the profile for the bracelet; with a path, saves a copy there instead. done: called once it is
    /// saved, and not after a failure.
    void save(const QString& copyPath = {}, std::function<void()> done = {});
    /// Whether there is a bracelet to save for.
    [[nodiscard]] bool canSave() const;
    /// Which motors have values that are not saved; empty: none.
    [[nodiscard]] QString unsavedText() const;

signals:
    void trouble(const QString& what, const QString& details);

private:
    using Fitted = std::pair<motors::MotorRecording, core::Expected<motors::MotorFit>>;

    /// A running measurement; shared with its thread.
    struct Run {
        std::stop_source stop;
        std::atomic<double> progress{0.0};
        std::atomic<bool> begun{false}; ///< its thread has started
        std::promise<void> ended;       ///< its thread has released the bracelet
        std::future<void> end = ended.get_future();
    };

    void onSession();
    void measureNext();
    void cancel();
    /// Ends a run that must not drive the bracelet, and says why.
    void refuseRun();
    /// Shows a fit, or why there is none.
    void take(std::size_t motor, const Fitted& fitted);
    void writeExcitation(const QString& path);
    void report(const QString& what, const core::Error& error);

    BraceletService& m_station;
    calibrate::MotorsView* m_view;
    motors::MotorCalibration m_saved;   ///< as in the bracelet's profile
    std::vector<std::size_t> m_waiting; ///< motors still to be measured, the next one last
    std::size_t m_asked = 0;            ///< how many were to be measured
    std::optional<std::size_t> m_measuring;
    bool m_failed = false; ///< the last measurement or recording
    std::shared_ptr<Run> m_run;
    std::vector<std::shared_ptr<Run>> m_runs; ///< runs whose thread may still use the bracelet
};

} // namespace teleta::console
