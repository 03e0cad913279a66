// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/motors/motor_file.h"
#include "backend/playback/player_types.h"
#include "widgets/calibrate/motor_chart.h"

#include <QWidget>

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

class QAction;
class QLabel;
class QProgressBar;
class QPushButton;
class QStackedWidget;
class QUndoStack;

namespace teleta::calibrate {

class FeltPanel;
class MotorTable;

/// What the calibration has to know of the bracelet.
struct BraceletFacts {
    QString name;
    QString serial; ///< empty: there is none, and nothing can be saved
    bool ready = false;
    bool reserved = false; ///< by a study: its motors stay as they are
    bool simulated = false;
    bool hasSensor = false;
    std::optional<core::Intensities> speeds_Hz; ///< by its sensor, now
    /// How strong each motor may be at most: less than 1 weakens what it is measured with.
    core::Intensities strongest{1.0, 1.0, 1.0, 1.0, 1.0, 1.0};

    bool operator==(const BraceletFacts&) const = default;
};

/// The calibration of a bracelet's motors: what is known of the six, the steps that find it, and the
/// evidence. Steps for the selected motor: measure with the bracelet's sensor, open a recording, find the
/// start by feel; for all: balance by feel or by the curves. Every change can be undone, an answer too. It
/// plays nothing and does no file I/O: it asks for both. Thread: GUI.
class MotorsView : public QWidget {
    Q_OBJECT
public:
    explicit MotorsView(QWidget* parent = nullptr);
    ~MotorsView() override;

    void setFacts(const BraceletFacts& facts);
    /// Of another bracelet, as its file has it: nothing is left to undo or to answer.
    void setCalibration(const motors::MotorCalibration& calibration);
    /// A profile of this bracelet from a file, in place of what was known; can be undone.
    void takeProfile(const motors::MotorCalibration& profile);
    [[nodiscard]] const motors::MotorCalibration& calibration() const { return m_calibration; }
    [[nodiscard]] bool isSaved() const;
    void markSaved();

    /// A measurement runs: which motor, and how far it is; empty: none does.
    void setMeasuring(std::optional<std::size_t> motor, double progress = 0.0);
    /// What became of a recording.
    void takeFit(std::size_t motor, const motors::MotorRecording& recording,
                 const core::Expected<motors::MotorFit>& fit);
    void showTrouble(const QString& text);

    [[nodiscard]] MotorTable* table() const { return m_table; }
    [[nodiscard]] FeltPanel* feltPanel() const { return m_felt; }
    [[nodiscard]] QPushButton* button(const char* name) const;
    [[nodiscard]] QString verdict() const;
    void undo();
    void redo();

signals:
    void playRequested(const teleta::playback::Program& program);
    void stopRequested();
    /// With the bracelet's sensor, one after another.
    void measureRequested(const std::vector<std::size_t>& motors);
    void cancelMeasureRequested();
    void recordingRequested(std::size_t motor);
    void excitationFileRequested();
    void saveRequested();
    void copyRequested();
    void loadRequested();
    /// By a person: is to take effect at once.
    void calibrationChanged(const teleta::motors::MotorCalibration& calibration);
    void exportFailed(const QString& message);

protected:
    void changeEvent(QEvent* event) override;

private:
    class Edit;

    QWidget* makeSteps();
    QWidget* makeMeasuring();
    void edit(const motors::MotorCalibration& after, const QString& text);
    void take(const motors::MotorCalibration& calibration);
    void reset();
    void balanceByCurves();
    void refresh();
    void showChart();
    void retranslate();
    QPushButton* addButton(const char* name, QWidget* parent);

    BraceletFacts m_facts;
    motors::MotorCalibration m_calibration;
    std::array<std::shared_ptr<const MotorChart::Evidence>, core::kTactors> m_evidence;
    std::optional<std::size_t> m_measuring;
    QUndoStack* m_undo;
    QLabel* m_title;
    QLabel* m_state;
    MotorTable* m_table;
    QStackedWidget* m_steps;
    QLabel* m_heading;
    QLabel* m_speed;
    QLabel* m_verdict;
    QLabel* m_measureText;
    QProgressBar* m_progress;
    FeltPanel* m_felt;
    MotorChart* m_chart;
};

} // namespace teleta::calibrate
