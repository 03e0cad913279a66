// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/protocol/questionnaire.h"

#include <QWidget>

#include <vector>

class QLabel;
class QPushButton;
class QScrollArea;

namespace teleta::studyview {

class QuestionnaireItemView;

/// A questionnaire to be filled in: its questions below each other, and a button that hands the answers
/// over. What does not fit is said at its question. Thread: GUI.
class QuestionnaireForm : public QWidget {
    Q_OBJECT

public:
    explicit QuestionnaireForm(QWidget* parent = nullptr);

    /// answers: what is filled in already; empty: nothing.
    void setQuestionnaire(study::Questionnaire questionnaire, const std::vector<study::ItemAnswer>& answers);
    /// The answers are being kept, or somebody else gives them: nothing can be changed.
    void setLocked(bool locked);
    /// Why the answers could not be kept.
    void setProblem(const QString& problem);
    /// Takes the keyboard: the first key that is typed goes to the first question, as long as that has no
    /// answer, and Tab goes there. A key that is held down since before and Space, the key of the trials,
    /// fill nothing in.
    void takeKeyboard();
    /// One an item, in their order.
    [[nodiscard]] std::vector<study::ItemAnswer> answers() const;
    [[nodiscard]] const std::vector<QuestionnaireItemView*>& items() const { return m_items; }
    [[nodiscard]] QPushButton* doneButton() const { return m_done; }

signals:
    /// They fit the questionnaire.
    void submitted(const std::vector<teleta::study::ItemAnswer>& answers);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    bool focusNextPrevChild(bool next) override;
    void changeEvent(QEvent* event) override;

private:
    void submit();
    void showCount();
    void retranslate();

    study::Questionnaire m_questionnaire;
    QWidget* m_column = nullptr; ///< all of it, no wider than can be read
    QScrollArea* m_area;
    QLabel* m_problem;
    QLabel* m_count;
    QPushButton* m_done;
    std::vector<QuestionnaireItemView*> m_items;
};

} // namespace teleta::studyview
