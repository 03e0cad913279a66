// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/protocol/protocol.h"

#include <QGroupBox>
#include <QString>

#include <vector>

class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QPushButton;
class QSpinBox;

namespace teleta::console {

/// A task with levels as a form: what is asked, of which stimulus, at which levels, and how they are chosen.
/// Rows that the chosen design or procedure does not have are hidden. Numbers are written with a point; the
/// reader of protocol files checks them. Thread: GUI.
class LevelTaskForm : public QGroupBox {
    Q_OBJECT

public:
    /// task: of any design but identification.
    explicit LevelTaskForm(const study::StudyTask& task, QWidget* parent = nullptr);

    /// A task with which a form may begin: detection of a vibration in one of two intervals.
    [[nodiscard]] static study::StudyTask beginning();

    /// Error: refused for what is not a number, naming its row.
    [[nodiscard]] core::Expected<study::StudyTask> task() const;

signals:
    void changed();
    void removeRequested();

private:
    /// A line of the form, for some designs or procedures.
    struct Row {
        QWidget* field;
        std::vector<study::Design> designs;       ///< empty: all
        std::vector<std::size_t> procedures = {}; ///< indices of study::Procedure; empty: all
    };

    QLineEdit* line(const char* name, const QString& text);
    void addRow(const QString& label, QWidget* field, std::vector<study::Design> designs = {},
                std::vector<std::size_t> procedures = {});
    void addStaircase(const study::StaircaseSettings& settings);
    void addBayes(const study::BayesSettings& settings);
    void showRows();
    /// The unit of levels, and where the staircase stays.
    void showConsequences();
    void askForFile();
    [[nodiscard]] core::Expected<double> number(const QLineEdit* edit) const;
    [[nodiscard]] core::Expected<std::optional<double>> wish(const QLineEdit* edit) const;
    [[nodiscard]] core::Expected<std::vector<double>> numbers(const QLineEdit* edit) const;
    [[nodiscard]] core::Expected<std::size_t> count(const QLineEdit* edit) const;
    [[nodiscard]] core::Expected<void> readTracks(study::StudyTask& task) const;
    [[nodiscard]] core::Expected<void> readConditions(study::StudyTask& task) const;
    [[nodiscard]] core::Expected<study::Procedure> procedure() const;

    QFormLayout* m_form;
    std::vector<Row> m_rows;
    QLineEdit* m_id;
    QLineEdit* m_name;
    QComboBox* m_design;
    QLineEdit* m_question;
    QLineEdit* m_conditions; ///< "rest" or "weak 0.3, strong 0.7"
    QSpinBox* m_intervals;
    QLineEdit* m_gap_s;
    QLineEdit* m_catchShare;
    QPlainTextEdit* m_tracks; ///< one per line: "t2 2", with a reference "t2 2 / 1"
    QLineEdit* m_file;
    QPushButton* m_choose;
    QComboBox* m_vary;
    QLabel* m_unit;
    QComboBox* m_scale;
    QLineEdit* m_lowest;
    QLineEdit* m_highest;
    QLineEdit* m_reference;
    QLineEdit* m_practice;
    QComboBox* m_procedure;
    QLineEdit* m_values;
    QLabel* m_target; ///< of the staircase
    struct {
        QLineEdit *first, *down, *stepUp, *stepDown, *fastReversals, *fastFactor, *reversals, *skip, *most;
    } m_staircase;
    struct {
        QComboBox* function;
        QLineEdit *slope, *lapse, *guess, *grid, *priorMean, *priorSd, *most, *least, *sd;
    } m_bayes;
};

} // namespace teleta::console
