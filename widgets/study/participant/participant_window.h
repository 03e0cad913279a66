// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/protocol/protocol.h"
#include "backend/study/protocol/questionnaire.h"
#include "backend/study/session/session.h"
#include "widgets/study/participant/answer_keys.h"
#include "widgets/study/participant/event_clock.h"
#include "widgets/study/participant/participant_scene.h"
#include "widgets/study/participant/questionnaire_form.h"

#include <QGridLayout>
#include <QLabel>
#include <QWidget>

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <vector>

class QInputEvent;

namespace teleta::study {

class AnswerButton;

/// The participant's window: the answers as large buttons. Input by the digits of keyboard and keypad, mouse
/// and touch; Space asks for the next trial, R for a replay where that is allowed. Questionnaires replace the
/// answers. Y and N, S and D answer where the answers are yes and no, same and different; the interval that
/// is felt lights up. The window decides nothing: each press is signalled with the time at which it was made,
/// even if a busy program handles it later. Thread: GUI.
class ParticipantWindow : public QWidget {
    Q_OBJECT

public:
    static constexpr std::size_t kMostAnswers = kMostPatterns; ///< one digit each

    using Clock = std::function<std::int64_t()>;

    /// clock: steady clock for the times of presses.
    explicit ParticipantWindow(Clock clock, QWidget* parent = nullptr);

    void setChoices(std::vector<AnswerChoice> choices);
    /// For ParticipantScene::State::questionnaire. answers: given already.
    void setQuestionnaire(const Questionnaire& questionnaire, const std::vector<ItemAnswer>& answers = {});
    void setScene(const ParticipantScene& scene);
    /// Repaints changes at once, before anything else that waits to be painted.
    void paintNow();
    [[nodiscard]] const ParticipantScene& scene() const { return m_scene; }
    /// The instruction.
    [[nodiscard]] QString instruction() const;
    [[nodiscard]] const std::vector<AnswerButton*>& buttons() const { return m_buttons; }
    [[nodiscard]] QuestionnaireForm& questionnaire() const { return *m_questionnaire; }

signals:
    void nextRequested(std::int64_t time_ns);
    void replayRequested(std::int64_t time_ns);
    void pressed(const teleta::study::KeyPress& press);
    void released(const QString& device, const QString& key);
    /// A questionnaire was filled in.
    void questionnaireAnswered(const std::vector<teleta::study::ItemAnswer>& answers);
    /// The window was closed.
    void left();

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void closeEvent(QCloseEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void arrange();
    void refresh();
    [[nodiscard]] std::int64_t timeOf(const QInputEvent& event);
    /// The answer that a key means; empty: none.
    [[nodiscard]] std::optional<std::size_t> answerOf(const PhysicalKey& key) const;
    void pressAt(const QPointF& at, const QString& device, std::int64_t time_ns);
    void releasePointer();
    void releaseAll();

    Clock m_clock;
    EventClock m_eventClock;
    std::vector<AnswerChoice> m_choices;
    ParticipantScene m_scene;
    QLabel* m_title = new QLabel(this);
    QLabel* m_instruction = new QLabel(this);
    QGridLayout* m_grid = new QGridLayout;
    QuestionnaireForm* m_questionnaire = new QuestionnaireForm(this);
    QString m_questionnaireTitle;
    std::vector<AnswerButton*> m_buttons;
    std::set<std::pair<QString, QString>> m_down; ///< keys and buttons that were signalled, by device
};

} // namespace teleta::study
