// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/protocol/protocol.h"

#include <QDialog>
#include <QPointer>
#include <QVariant>

#include <functional>
#include <vector>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QMessageBox;
class QPlainTextEdit;
class QPushButton;
class QSpinBox;
class QVBoxLayout;

namespace teleta::console {

class QuestionnaireEditor;

/// A protocol as a form. What is entered is checked by the reader of protocol files as it is typed. It can be
/// saved as a file, and a study made of it; a study that was made keeps the protocol that it has. What is
/// entered and not saved goes with the form only when that is confirmed. Thread: GUI; it does not block.
class ProtocolDialog : public QDialog {
    Q_OBJECT

public:
    explicit ProtocolDialog(const study::Protocol& protocol, QWidget* parent = nullptr);

    /// What the form says, as the reader understands it. Error: what the reader says.
    [[nodiscard]] core::Expected<study::Protocol> protocol() const;
    /// Something was entered, valid or not, that is in no file.
    [[nodiscard]] bool isChanged() const;
    /// Goes on at once when nothing is changed; else asks whether it may be lost, or is to be saved first,
    /// and does not go on when it may not. The form stays as it is.
    void whenSettled(std::function<void()> goOn);
    /// A study was opened: the form closes when one was asked for, and it is of just what the form says.
    void leaveTo(const study::Protocol& protocol);

    void reject() override;

signals:
    /// A study is to be made of a valid protocol.
    void studyRequested(const teleta::study::Protocol& protocol);
    void openRequested();
    void paperRequested();

private:
    struct PhaseRow {
        QSpinBox* repetitions;
        QCheckBox* feedback;
        QCheckBox* diagram;
    };
    struct TaskRow {
        QWidget* box;
        QLineEdit* id;
        QLineEdit* name;
        QLineEdit* conditions;    ///< with commas between them
        QPlainTextEdit* patterns; ///< one a line: "A circle"
        QPlainTextEdit* files;    ///< one a line: "A static /home/me/mine.json"
        QPushButton* choose;      ///< a file for the next place that needs one
    };
    /// A number that stays as it was read, with all its digits, until somebody changes it.
    struct NumberField {
        QDoubleSpinBox* box;
        double read;
        double shown; ///< by the box, which rounds
        [[nodiscard]] double value() const;
    };

    [[nodiscard]] NumberField makeNumber(double value, double low, double high, int decimals,
                                         const QString& unit);
    [[nodiscard]] PhaseRow makePhase(const study::PhaseSettings& phase);
    void addTask(const study::StudyTask& task);
    void removeTask(QWidget* box);
    void addQuestionnaire(const study::Questionnaire& questionnaire);
    [[nodiscard]] static core::Expected<study::StudyTask> taskOf(const TaskRow& row);
    [[nodiscard]] static QString placeForPattern(const TaskRow& row);
    void askForPattern(const TaskRow& row);
    void check();
    /// The values of all fields, as they are.
    [[nodiscard]] QVariantList fields() const;
    void ask();
    /// goOn: called when all of the form is saved.
    void save(std::function<void()> goOn);

    QWidget* m_content; ///< with all fields
    QLineEdit* m_name;
    QLineEdit* m_description;
    NumberField m_stimulus_s;
    NumberField m_limit_s;
    QComboBox* m_window;
    QSpinBox* m_replays;
    QComboBox* m_order;
    PhaseRow m_practice;
    PhaseRow m_test;
    QSpinBox* m_restEvery;
    NumberField m_rest_s;
    QComboBox* m_noise;
    NumberField m_level_dBA;
    QVBoxLayout* m_taskRows;
    std::vector<TaskRow> m_tasks;
    QVBoxLayout* m_questionnaireRows;
    std::vector<QuestionnaireEditor*> m_questionnaires;
    QLabel* m_verdict;
    QPushButton* m_save;
    QPushButton* m_make;
    bool m_isStudyWanted = false;
    QVariantList m_saved; ///< fields() as they were at first, or are in a file
    QPointer<QMessageBox> m_question;
    std::function<void()> m_goOn; ///< when it is answered
};

} // namespace teleta::console
