// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/study/running/study_store_thread.h"
#include "backend/study/session/due_questionnaires.h"

#include <QObject>
#include <QString>
#include <QTimer>

#include <cstddef>
#include <functional>
#include <vector>

namespace teleta::console {

/// Goes through the questionnaires that are due: each is shown once the answers to the previous one are safe.
/// Those of simulated participants are filled in, shown for a moment, and stored. Thread: GUI.
class QuestionnaireSequence : public QObject {
    Q_OBJECT

public:
    explicit QuestionnaireSequence(StudyStoreThread& store, QObject* parent = nullptr);

    struct Subject {
        study::StudyHead head;
        study::Participant participant;
        study::PlannedSession plan;
        study::SessionRecord session;
    };

    /// done: called when nothing is due any more, possibly at once.
    void begin(Subject subject, std::vector<study::DueQuestionnaire> due, std::function<void()> done);
    /// Ends the sequence; what was not stored is due again next time.
    void leave();
    /// Answers to the shown questionnaire. What could not be stored stays here for retry(); the form must not
    /// change meanwhile.
    void submit(std::vector<study::ItemAnswer> answers);
    /// Repeats what problem() is about.
    void retry();
    /// Continues without the answers, and stores a note about it. shown: that of the intended questionnaire;
    /// ignored if another one is shown by now.
    void skip(std::size_t shown);
    /// Speed of simulated participants relative to real time.
    void setSpeed(double speed) { m_speed = speed; }

    /// As it is shown. Null: none.
    [[nodiscard]] const study::Questionnaire* current() const;
    /// Number of questionnaires shown so far.
    [[nodiscard]] std::size_t shown() const { return m_shown; }
    /// Answers of a simulated participant.
    [[nodiscard]] const std::vector<study::ItemAnswer>& filledIn() const { return m_filledIn; }
    [[nodiscard]] bool isSimulated() const;
    /// The answers, or the note about skipping, are on their way to the store.
    [[nodiscard]] bool isKeeping() const { return m_keeping; }
    /// isKeeping() and problem() are about the note about skipping.
    [[nodiscard]] bool isSkipping() const { return m_skipping; }
    /// Why the last answers, or the note, could not be stored; empty: no problem.
    [[nodiscard]] const QString& problem() const { return m_problem; }

signals:
    void changed();

private:
    void showNext();
    void keep();
    template <typename Work>
    void askToKeep(Work work);
    void next();

    StudyStoreThread& m_store;
    double m_speed = 1.0;
    Subject m_subject;
    std::vector<study::DueQuestionnaire> m_due; ///< the first is shown
    study::Questionnaire m_current;             ///< as it is shown
    std::function<void()> m_done;
    std::vector<study::ItemAnswer> m_filledIn;
    std::vector<study::ItemAnswer> m_given; ///< being stored, or waiting for retry()
    QTimer m_timer;                         ///< how long a simulated participant takes
    std::size_t m_shown = 0;
    std::size_t m_run = 0; ///< distinguishes callbacks for this questionnaire from earlier ones
    bool m_keeping = false;
    bool m_skipping = false;
    QString m_problem;
};

} // namespace teleta::console
