// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/cost/cost_measuring.h"
#include "app/console/cost/sweep_running.h"
#include "backend/pipeline/camera_channel.h"
#include "widgets/chrome/message_bar.h"

#include <QWidget>

#include <memory>
#include <optional>

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QListWidget;
class QProgressBar;
class QPushButton;
class QStackedWidget;
class QTabWidget;
class QTableWidget;

namespace teleta::camera {
class StageBar;
}
namespace teleta::chrome {
class EmptyState;
}
namespace teleta::cost {
class CostChart;
}

namespace teleta::console {

class SweepPanel;

/// The Cost page: sweeps on a tab of their own; the ladders, what their rungs cost on this machine, in a
/// chart and in words, and for the camera that is shown the rung in use, its live stage times, and a time
/// budget that picks a rung. On the screen a ladder is a job, and a rung a setting of it. Thread: GUI.
class CostPage : public QWidget {
    Q_OBJECT

public:
    /// makeLadders, file: see CostMeasuring.
    CostPage(const CostMeasuring::MakeLadders& makeLadders, const QString& file,
             const cost::MeasureSettings& settings = {}, QWidget* parent = nullptr);

    [[nodiscard]] CostMeasuring& measuring() { return *m_measuring; }
    [[nodiscard]] SweepPanel& sweeps() { return *m_sweeps; }
    [[nodiscard]] chrome::MessageBar& messages() { return *m_messages; }
    /// Shows the progress and what the camera does; null: there is none.
    void tick(const std::shared_ptr<pipeline::CameraChannel>& camera);

signals:
    void demoCameraRequested();

private:
    [[nodiscard]] QWidget* makeLadderColumn();
    [[nodiscard]] QWidget* makeMiddle();
    [[nodiscard]] QWidget* makeCameraColumn();
    [[nodiscard]] QWidget* makeTable();
    [[nodiscard]] std::string ladderShown() const;
    void retranslate();
    void showLadders();
    /// The shortest and the longest time of its settings, or that they are not known.
    [[nodiscard]] static QString timesOf(const cost::LadderCost* costs);
    void showCosts();
    void showWords();
    /// The title of the camera's job.
    [[nodiscard]] QString cameraJob() const;
    void showRunning();
    void showBudget();
    void chooseRung(const QString& name);

    CostMeasuring* m_measuring;
    chrome::MessageBar* m_messages;
    QTabWidget* m_tabs;
    SweepPanel* m_sweeps;
    QLabel* m_ladderHeading;
    QListWidget* m_list;
    chrome::EmptyState* m_empty;
    QPushButton* m_measureEmpty;
    QPushButton* m_measure;
    QPushButton* m_measureAll;
    QPushButton* m_cancel;
    QProgressBar* m_progress;
    QLabel* m_progressText;
    QLabel* m_title;
    QLabel* m_truth;
    cost::CostChart* m_chart;
    QLabel* m_words;
    QTableWidget* m_table;
    QWidget* m_below; ///< with the table, once there are numbers
    QStackedWidget* m_results;
    QLabel* m_cameraHeading;
    QLabel* m_rungLabel;
    QComboBox* m_rungs;
    QLabel* m_stagesLabel;
    camera::StageBar* m_stages;
    QLabel* m_budgetLabel;
    QDoubleSpinBox* m_budget_ms;
    QLabel* m_budgetText;
    QPushButton* m_useBest;
    QLabel* m_noCamera;
    QPushButton* m_openCamera;

    std::shared_ptr<pipeline::CameraChannel> m_camera;
    std::optional<bool> m_cameraShown; ///< empty: before the first tick
    QString m_best;                    ///< rung within the budget; empty: none
    QString m_wish;                    ///< rung that was asked for and is not yet in use
    QString m_inUse;
};

} // namespace teleta::console
