// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/cost/sweep_running.h"

#include <QWidget>

#include <cstdint>

class QComboBox;
class QLabel;
class QListWidget;
class QProgressBar;
class QPushButton;
class QStackedWidget;
class QTableWidget;

namespace teleta::base {
class SvgView;
}
namespace teleta::chrome {
class EmptyState;
}

namespace teleta::console {

/// The sweeps of the Cost page: those that come with the program, a file or results that were opened, their
/// charts and cells, and one that runs here. Thread: GUI.
class SweepPanel : public QWidget {
    Q_OBJECT

public:
    explicit SweepPanel(SweepRunning::MakeSources makeSources, QWidget* parent = nullptr);

    [[nodiscard]] SweepRunning& running() { return *m_running; }
    /// Shows the progress.
    void tick();
    void retranslate();

signals:
    void failed(const QString& what, const QString& details);

private:
    [[nodiscard]] QWidget* makeListColumn();
    void fillList();
    [[nodiscard]] QWidget* makeMiddle();
    void askToOpen();
    void askToStart();
    [[nodiscard]] QString newFolder() const;
    void showSweep();
    /// What is varied and measured, as a table.
    [[nodiscard]] static QString planText(const sweep::SweepPlan& plan);
    void showMeasure();
    void showRunning();

    SweepRunning* m_running;
    QLabel* m_heading;
    QListWidget* m_list;
    QPushButton* m_open;
    QPushButton* m_openResults;
    QPushButton* m_start;
    QPushButton* m_cancel;
    QProgressBar* m_progress;
    QLabel* m_progressText;
    QLabel* m_title;
    QLabel* m_about;
    QLabel* m_measureLabel;
    QComboBox* m_measure;
    base::SvgView* m_picture;
    QTableWidget* m_table;
    QStackedWidget* m_pages;
    QLabel* m_plan; ///< shown while there are no results
    chrome::EmptyState* m_empty;
    QPushButton* m_startEmpty;
};

} // namespace teleta::console
