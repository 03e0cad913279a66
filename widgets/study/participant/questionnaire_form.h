// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/protocol/questionnaire.h"
#include "widgets/base/compose.h"

#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QWidget>

#include <vector>

namespace teleta::study {

class QuestionnaireItemView;

/// A questionnaire to be filled in: its questions one below the other, and a button that submits the answers.
/// Problems are shown at the question. Thread: GUI.
class QuestionnaireForm : public QWidget {
    Q_OBJECT

public:
    explicit QuestionnaireForm(QWidget* parent = nullptr);

    /// answers: filled in already; may be empty.
    void setQuestionnaire(Questionnaire questionnaire, const std::vector<ItemAnswer>& answers);
    /// Locked while the answers are being saved or come from somebody else.
    void setLocked(bool locked);
    /// Why the answers could not be saved.
    void setProblem(const QString& problem);
    /// Takes the keyboard focus: the first key typed answers the first question unless it has an answer, and
    /// Tab goes there. Keys still held down, and Space, the key of the trials, fill nothing in.
    void takeKeyboard();
    /// One per item, in order.
    [[nodiscard]] std::vector<ItemAnswer> answers() const;
    [[nodiscard]] const std::vector<QuestionnaireItemView*>& items() const { return m_items; }

signals:
    /// The answers are valid.
    void submitted(const std::vector<teleta::study::ItemAnswer>& answers);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    bool focusNextPrevChild(bool next) override;

private:
    void submit();
    void showCount();
    void retranslate();

    Questionnaire m_questionnaire;
    QWidget* m_column = nullptr; ///< all of it, no wider than is readable
    QScrollArea* m_area = new QScrollArea(this);
    QLabel* m_problem = new QLabel(this);
    QLabel* m_count = new QLabel(this);
    QPushButton* m_done = base::named<QPushButton>("questionnaireDone", this);
    std::vector<QuestionnaireItemView*> m_items;
};

} // namespace teleta::study
