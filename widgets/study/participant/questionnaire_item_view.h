// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/protocol/questionnaire.h"

#include <QWidget>

#include <optional>
#include <string>
#include <vector>

class QAbstractButton;
class QHBoxLayout;
class QLabel;
class QPlainTextEdit;
class QVBoxLayout;

namespace teleta::study {

/// One question with its input: a text field, large numbers or marks for a scale, choices one below the
/// other, or two side by side. By mouse, touch and keyboard: Tab goes from question to question, arrows and
/// digits choose; on a scale of 0 to 100 a digit is a tenth of the value. Thread: GUI.
class QuestionnaireItemView : public QWidget {
    Q_OBJECT

public:
    explicit QuestionnaireItemView(QuestionnaireItem item, QWidget* parent = nullptr);

    [[nodiscard]] const QuestionnaireItem& item() const { return m_item; }
    /// Empty: left out.
    [[nodiscard]] std::optional<std::string> value() const;
    void setValue(const std::optional<std::string>& value);
    /// Why the answer is not accepted; empty: no problem.
    void setProblem(const QString& problem);
    void focusAnswer();
    /// Answers with a key that was typed before the item had the focus: a digit, or the first letter of a
    /// text. False: not an answer.
    bool takeFirstKey(QKeyEvent& key);
    /// The points of a scale, or the choices; the last one of an optional item is "No answer".
    [[nodiscard]] const std::vector<QAbstractButton*>& buttons() const { return m_buttons; }

signals:
    void changed();

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    bool choose(const QKeyEvent& event);
    void buildPoints(QVBoxLayout* column);
    void buildScale(QVBoxLayout* column);
    void buildPair(QVBoxLayout* column);
    void addNoAnswer(QHBoxLayout* row);
    void addEnds(QVBoxLayout* column);
    void buildChoices(QVBoxLayout* column);
    void addButton(QAbstractButton* button, std::string value);
    void retranslate();
    void colour();

    QuestionnaireItem m_item;
    QLabel* m_question;
    QLabel* m_problem;
    QPlainTextEdit* m_text = nullptr;
    std::vector<QAbstractButton*> m_buttons;
    std::vector<std::string> m_values; ///< one per button; empty: left out
};

} // namespace teleta::study
