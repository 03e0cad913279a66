// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/motors/motor_file.h"
#include "backend/playback/player_types.h"
#include "widgets/calibrate/calibration_view.h"
#include "widgets/calibrate/felt_panel.h"
#include "widgets/calibrate/motor_chart.h"
#include "widgets/calibrate/motor_table.h"

#include <QLabel>
#include <QProgressBar>
#include <QSplitter>
#include <QStackedWidget>
#include <QTabWidget>

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace teleta::calibrate {

class FeltTask;

/// State of the bracelet.
struct BraceletFacts {
    QString name;
    QString serial; ///< empty: no bracelet, nothing can be saved
    bool ready = false;
    bool reserved = false; ///< by a study: the motors cannot be changed
    bool simulated = false;
    bool hasSensor = false;
    std::optional<core::Intensities> speeds_Hz; ///< measured by its sensor
    /// Limit of each motor's intensity; it also applies to measurements.
    core::Intensities strongest{1.0, 1.0, 1.0, 1.0, 1.0, 1.0};

    bool operator==(const BraceletFacts&) const = default;
};

/// Calibrates a bracelet's motors: a table of their known values, the steps that determine them, and charts
/// of the measurements. Steps for the selected motor: measure it with the bracelet's sensor, open a
/// recording, find its start by feel. For all motors: balance them by feel or by their curves. Every change
/// and every answer can be undone. The view plays nothing itself: it emits requests. Thread: GUI.
class MotorsView : public CalibrationView {
    Q_OBJECT
public:
    explicit MotorsView(QWidget* parent = nullptr);

    void setFacts(const BraceletFacts& facts);
    /// Shows another bracelet, as described by its file; clears the undo history and all questions.
    void setCalibration(const motors::MotorCalibration& calibration);
    /// Replaces the present calibration with a profile of the same bracelet; can be undone.
    void takeProfile(const motors::MotorCalibration& profile);
    [[nodiscard]] const motors::MotorCalibration& calibration() const { return m_calibration; }

    /// The motor being measured; empty: none. progress: 0 .. 1.
    /// of: how many are measured one after the other, and number: which of them it is, from 1.
    void setMeasuring(std::optional<std::size_t> motor, double progress = 0.0, std::size_t number = 1,
                      std::size_t of = 1);
    /// Applies the fit of a recording, or shows why there is none.
    void takeFit(std::size_t motor, const motors::MotorRecording& recording,
                 const core::Expected<motors::MotorFit>& fit);

signals:
    void playRequested(const teleta::playback::Program& program);
    void stopRequested();
    /// Measure these motors with the bracelet's sensor, one after another.
    void measureRequested(const std::vector<std::size_t>& motors);
    void cancelMeasureRequested();
    void recordingRequested(std::size_t motor);
    void excitationFileRequested();
    void copyRequested();
    /// The calibration has changed and takes effect at once.
    void calibrationChanged(const teleta::motors::MotorCalibration& calibration);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    QWidget* makeSteps();
    QWidget* makeMeasuring();
    void edit(const motors::MotorCalibration& after);
    void take(const motors::MotorCalibration& calibration);
    void ask(FeltTask task);
    void reset();
    void balanceByCurves();
    void undo() override;
    void redo() override;
    void refresh() override;
    /// How many motors are calibrated, and whether that is saved.
    [[nodiscard]] QString calibratedText() const;
    void showChart();
    void retranslate();

    BraceletFacts m_facts;
    motors::MotorCalibration m_calibration;
    std::array<std::shared_ptr<const MotorChart::Evidence>, core::kTactors> m_evidence;
    std::optional<std::size_t> m_measuring;
    MotorTable* m_table = new MotorTable(this);
    QStackedWidget* m_steps = new QStackedWidget(this);
    std::vector<QLabel*> m_groups; ///< of buttons
    QLabel* m_heading = new QLabel(this);
    QLabel* m_speed = new QLabel(this);
    QLabel* m_measureText = new QLabel(this);
    QProgressBar* m_progress = new QProgressBar(this);
    FeltPanel* m_felt = new FeltPanel(this);
    MotorChart* m_chart = new MotorChart(this);
    QTabWidget* m_views = new QTabWidget(this); ///< the table, and the chart where there is little room
    QSplitter* m_parts = new QSplitter(Qt::Vertical, this);
};

} // namespace teleta::calibrate
