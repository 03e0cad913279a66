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

class ExclusionEditor;
class LevelTaskForm;
class QuestionnaireEditor;
class TriggerEditor;

/// A protocol as a form. Input is checked by the reader of protocol files while it is typed. The protocol can
/// be saved as a file and used for a new study; existing studies keep theirs. Unsaved changes are discarded
/// only after confirmation. Thread: GUI; it does not block.
class ProtocolDialog : public QDialog {
    Q_OBJECT

public:
    explicit ProtocolDialog(const study::Protocol& protocol, QWidget* parent = nullptr);

    /// The protocol in the form. Error: what the reader reports.
    [[nodiscard]] core::Expected<study::Protocol> protocol() const;
    /// There are unsaved changes, valid or not.
    [[nodiscard]] bool isChanged() const;
    /// Calls goOn at once if nothing is changed; otherwise asks whether to discard or save the changes, and
    /// does not call it on cancel. The form stays unchanged.
    void whenSettled(std::function<void()> goOn);
    /// A study was opened: the form closes if it had requested one and the study has this very protocol.
    void leaveTo(const study::Protocol& protocol);

    void reject() override;

signals:
    /// A study with this valid protocol is requested.
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
        LevelTaskForm* levels = nullptr; ///< of a task with levels, which has nothing of the others
        QLineEdit* id = nullptr;
        QLineEdit* name = nullptr;
        QLineEdit* conditions = nullptr;    ///< with commas between them
        QPlainTextEdit* patterns = nullptr; ///< one per line: "A circle"
        QPlainTextEdit* files = nullptr;    ///< one per line: "A static /home/me/mine.json"
        QPushButton* choose = nullptr;      ///< a file for the next stimulus that needs one
    };
    /// A number that keeps all its digits until somebody edits it.
    struct NumberField {
        QDoubleSpinBox* box;
        double read;
        double shown; ///< as rounded by the box
        [[nodiscard]] double value() const;
    };

    [[nodiscard]] NumberField makeNumber(double value, double low, double high, int decimals,
                                         const QString& unit);
    [[nodiscard]] PhaseRow makePhase(const study::PhaseSettings& phase);
    void addTask(const study::StudyTask& task);
    void addLevelTask(const study::StudyTask& task);
    void removeTask(QWidget* box);
    void addQuestionnaire(const study::Questionnaire& questionnaire);
    [[nodiscard]] static core::Expected<study::StudyTask> taskOf(const TaskRow& row);
    [[nodiscard]] static QString placeForPattern(const TaskRow& row);
    void askForPattern(const TaskRow& row);
    void check();
    /// The current values of all fields.
    [[nodiscard]] QVariantList fields() const;
    void ask();
    /// goOn: called once everything is saved.
    void save(std::function<void()> goOn);

    QWidget* m_content; ///< holds all fields
    QLineEdit* m_name;
    QLineEdit* m_description;
    QLineEdit* m_authors; ///< with semicolons between them
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
    TriggerEditor* m_trigger;
    QCheckBox* m_record;
    QVBoxLayout* m_taskRows;
    std::vector<TaskRow> m_tasks;
    QVBoxLayout* m_questionnaireRows;
    std::vector<QuestionnaireEditor*> m_questionnaires;
    ExclusionEditor* m_exclusions;
    QLabel* m_verdict;
    QPushButton* m_save;
    QPushButton* m_make;
    bool m_isStudyWanted = false;
    QVariantList m_saved; ///< fields() at first, or as last saved
    QPointer<QMessageBox> m_question;
    std::function<void()> m_goOn; ///< once the question is answered
};

} // namespace teleta::console
