// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/bracelet/bracelet_service.h"
#include "backend/core/threads/latest_copy.h"
#include "devices/sound_bracelet/latency/sound_latency.h"

#include <QDialog>
#include <QString>
#include <QTimer>

#include <future>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace teleta::calibrate {
class LatencyChart;
}

namespace teleta::console {

/// Measures how late the bracelet on a sound card is, and keeps it in its device file: clicks on tactor 1
/// that come back at an input. Not modal, so that STOP stays in reach. STOP, a study, another bracelet or
/// anything else that is played ends a measurement. Thread: GUI; nothing blocks but the destructor, which
/// waits for a measurement to end.
class LatencyDialog : public QDialog {
    Q_OBJECT

public:
    /// station: its bracelet is on a sound card.
    LatencyDialog(BraceletService& station, QWidget* parent);
    ~LatencyDialog() override;

    void reject() override;

private:
    /// A measurement; shared with its thread.
    struct Run {
        std::stop_source stop;
        core::LatestCopy<std::vector<double>> clicks_s; ///< that were heard so far
        std::promise<void> ended;                       ///< its thread has released the bracelet
        std::future<void> end = ended.get_future();
    };

    void setTexts();
    void findInputs();
    void measureOrStop();
    void measure();
    void takeResult(const core::Expected<sound::SoundLatency>& latency);
    void save();
    void onSession();
    void tick();
    void showTrouble(const QString& text);
    void restyle();
    [[nodiscard]] QString resultText() const;

    BraceletService& m_station;
    QString m_deviceFile;
    QLabel* m_what;
    QLabel* m_inputName;
    QComboBox* m_input;
    QPushButton* m_again; ///< looks for inputs
    calibrate::LatencyChart* m_chart;
    QProgressBar* m_progress;
    QLabel* m_result;
    QLabel* m_trouble;
    QPushButton* m_measure;
    QPushButton* m_save;
    QTimer m_clock; ///< runs until it is closed
    std::optional<sound::SoundLatency> m_latency;
    bool m_saved = false;       ///< m_latency is in the file
    bool m_busy = false;        ///< inputs are being looked for, or the file is being written
    std::shared_ptr<Run> m_run; ///< null: nothing is measured
};

} // namespace teleta::console
