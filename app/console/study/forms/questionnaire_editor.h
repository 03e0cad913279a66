// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/protocol/questionnaire.h"

#include <QGroupBox>

#include <vector>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLineEdit;
class QPlainTextEdit;
class QPushButton;
class QSpinBox;
class QVBoxLayout;

namespace teleta::console {

/// A questionnaire of a protocol as a form: its time, and its own questions or a published one. The reader of
/// protocol files checks it. Thread: GUI.
class QuestionnaireEditor : public QGroupBox {
    Q_OBJECT

public:
    explicit QuestionnaireEditor(const study::Questionnaire& questionnaire, QWidget* parent = nullptr);

    [[nodiscard]] study::Questionnaire questionnaire() const;

signals:
    void changed();
    void removeRequested();

private:
    /// A question. Fields that do not belong to its kind are hidden, and kept until the form is closed.
    struct ItemRow {
        QWidget* box;
        QLineEdit* id;
        QComboBox* kind;
        QCheckBox* required;
        QLineEdit* question;
        QWidget* scale;
        QSpinBox* points;
        QLineEdit* low;
        QLineEdit* high;
        QPlainTextEdit* choices; ///< one per line: "yes I felt it"
    };

    void showUse();
    void addItem(const study::QuestionnaireItem& item);
    void removeItem(const QWidget* box);

    QLineEdit* m_id;
    QLineEdit* m_title;
    QComboBox* m_when;
    QComboBox* m_use;      ///< in the order of study::StandardQuestionnaire
    QCheckBox* m_required; ///< of all questions of a published one
    QPushButton* m_add;
    QFormLayout* m_form;
    QVBoxLayout* m_rows;
    std::vector<ItemRow> m_items;
};

} // namespace teleta::console
