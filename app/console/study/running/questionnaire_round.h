// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/study/running/study_desk.h"
#include "backend/study/session/due_questionnaires.h"

#include <QObject>
#include <QString>
#include <QTimer>

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace teleta::console {

/// Lets a participant fill in the questionnaires that are due, one after another: the next one is shown when
/// the answers to the last one are safe. A simulated participant's are filled in, shown for a moment, and
/// kept. Thread: GUI.
class QuestionnaireRound : public QObject {
    Q_OBJECT

public:
    explicit QuestionnaireRound(StudyDesk& desk, QObject* parent = nullptr);

    struct Subject {
        study::StudyHead head;
        study::Participant participant;
        study::PlannedSession plan;
        study::SessionRecord session;
    };

    /// done: when nothing is due any more, which may be at once.
    void begin(Subject subject, std::vector<study::DueQuestionnaire> due, std::function<void()> done);
    /// Ends the round; what was not kept is due again the next time.
    void leave();
    /// Answers of the one that is shown. Those that do not fit are refused, and what could not be kept stays
    /// here for retry(); whoever shows the form keeps it as it is meanwhile.
    void submit(std::vector<study::ItemAnswer> answers);
    /// Does once more what problem() is about.
    void retry();
    /// Goes on without the answers, and notes that. shown: the one that is meant, as shown() counts; nothing
    /// happens to another one.
    void skip(std::size_t shown);
    /// How much faster than real time simulated participants are.
    void setSpeed(double speed) { m_speed = speed; }

    /// Null when nothing is to be filled in.
    [[nodiscard]] const study::Questionnaire* current() const;
    /// Counts up with each that is shown.
    [[nodiscard]] std::size_t shown() const { return m_shown; }
    /// What is filled in already: a simulated participant's.
    [[nodiscard]] const std::vector<study::ItemAnswer>& filledIn() const { return m_filledIn; }
    [[nodiscard]] bool isSimulated() const;
    /// The answers, or the note that there are none, are on their way to the store.
    [[nodiscard]] bool isKeeping() const { return m_keeping; }
    /// isKeeping() and problem() are about the note that it is left out.
    [[nodiscard]] bool isSkipping() const { return m_skipping; }
    /// Why the last answers, or the note, could not be kept; empty when they could.
    [[nodiscard]] const QString& problem() const { return m_problem; }

signals:
    void changed();

private:
    void showNext();
    void keep();
    template <typename Work>
    void askToKeep(Work work);
    void next();

    StudyDesk& m_desk;
    double m_speed = 1.0;
    Subject m_subject;
    std::vector<study::DueQuestionnaire> m_due; ///< the first one is shown
    std::function<void()> m_done;
    std::vector<study::ItemAnswer> m_filledIn;
    std::vector<study::ItemAnswer> m_given; ///< being kept, or waiting for retry()
    QTimer m_timer;                         ///< how long a simulated participant takes
    std::size_t m_shown = 0;
    std::size_t m_run = 0; ///< tells the answers of the desk to this round from those to an earlier one
    bool m_keeping = false;
    bool m_skipping = false;
    QString m_problem;
};

} // namespace teleta::console
