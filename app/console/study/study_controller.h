// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/study/running/bracelet_stimulus.h"
#include "app/console/study/running/questionnaire_sequence.h"
#include "app/console/study/running/session_marks.h"
#include "app/console/study/running/simulated_person.h"
#include "app/console/study/running/study_runner.h"
#include "app/console/study/running/study_store_thread.h"
#include "app/console/study/study_overview.h"
#include "backend/core/steady_time.h"
#include "backend/study/methods/felt/felt_task.h"
#include "backend/study/session/run_checks.h"
#include "backend/study/session/study_scene.h"

#include <QDateTime>
#include <QObject>
#include <QString>
#include <QStringList>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace teleta::console {

/// The open study and the session that runs in it: what the Study page does, without the page. Thread: GUI;
/// no call waits for a disk or a device.
class StudyController : public QObject {
    Q_OBJECT

public:
    using SteadyClock = std::function<std::int64_t()>;
    using WallClock = std::function<QDateTime()>; ///< UTC

    /// station and stop must outlive it. clock, utcNow: those of the system, or of a test.
    StudyController(BraceletService& station, core::StopSwitch& stop, SteadyClock clock = core::steadyNow_ns,
                    WallClock utcNow = QDateTime::currentDateTimeUtc, QObject* parent = nullptr);
    ~StudyController() override;

    /// The outcome of these comes as a signal.
    void open(const study::StoreLocation& location);
    void create(const study::StoreLocation& location, const study::StudyHead& head);
    /// Opens the study of the folder, or creates it where there is none.
    void openOrCreate(const study::StoreLocation& location, const study::StudyHead& head);
    /// The same for the study of a scene, which has the scene's participants as long as it is open.
    void openScene(const QString& folder, const study::StudyScene& scene, std::uint64_t seed);
    /// Both change nothing while a session is under way or the store is busy.
    void enrol(const QString& id);
    void choose(int participant, int session);
    /// Deletes a participant with everything that was kept and exported; deleted() follows.
    void deleteParticipant(const QString& id, const QString& reason);

    /// Starts or resumes the chosen session if all checks pass.
    void begin();
    void goOn() { m_runner.goOn(); }
    void abort();
    /// Leaves a session that is over and chooses the participant's next one.
    void leaveSession();
    void keepNote(const QString& text);
    /// Writes the files of the whole study, see writeStudy(); written() follows.
    void write(const QString& format);
    void setNoiseConfirmed(bool confirmed);

    /// A simulated study: runs all sessions of all participants that are still open, one after another.
    void startRehearsal();
    void stopRehearsal();
    [[nodiscard]] bool isRehearsing() const { return m_rehearsing; }
    /// How much faster than real time simulated participants are; over 1 nothing is played on the bracelet.
    void setSpeed(double speed);
    [[nodiscard]] double speed() const { return m_speed; }

    /// Waits until all that was answered is kept; for the end of the program.
    void waitUntilKept() { m_store.waitForAll(); }

    /// Checks device, STOP and time limits; to be called 30 times a second.
    void tick();
    /// The clock of participants' presses.
    [[nodiscard]] std::int64_t now_ns() const;

    [[nodiscard]] const std::optional<StudyOverview>& overview() const { return m_overview; }
    [[nodiscard]] std::optional<std::pair<int, int>> chosen() const { return m_chosen; }
    [[nodiscard]] const ParticipantOverview* chosenParticipant() const;
    [[nodiscard]] const SessionOverview* chosenSession() const;
    /// Of the running session, otherwise of the chosen one; null: none.
    [[nodiscard]] const study::PlannedSession* plan() const;
    /// Its task.
    [[nodiscard]] const study::StudyTask* task() const;
    /// What the motors do at a level of the running trial; empty: levels are no intensities, or the motors
    /// were not measured.
    [[nodiscard]] std::optional<study::MotorStrength> strengthOf(const study::PlannedTrial& trial) const;
    [[nodiscard]] std::vector<study::RunCheck> checks() const;
    /// Whether the desktop keeps the screen on, for the checks; empty: nobody asked it.
    void setScreenHeld(std::optional<bool> held);
    /// Why the store cannot be used now, the server being away for example; empty: it can.
    [[nodiscard]] const std::optional<core::Error>& storeError() const { return m_storeError; }
    [[nodiscard]] bool noiseConfirmed() const { return m_noiseConfirmed; }
    [[nodiscard]] bool isBusy() const { return m_busy > 0; }
    /// STOP is engaged: nothing goes on.
    [[nodiscard]] bool isStopped() const { return m_stop.engaged(); }
    /// A session is under way, or a questionnaire before or after it.
    [[nodiscard]] bool isActive() const {
        return m_runner.isActive() || m_questionnaires.current() != nullptr;
    }
    [[nodiscard]] QuestionnaireSequence& questionnaires() { return m_questionnaires; }
    [[nodiscard]] const QuestionnaireSequence& questionnaires() const { return m_questionnaires; }
    [[nodiscard]] StudyRunner& runner() { return m_runner; }
    [[nodiscard]] const StudyRunner& runner() const { return m_runner; }
    /// Where sessions are recorded when the protocol asks for it; null: nowhere. Must outlive it.
    void setRecording(SessionRecording* recording) { m_marks.setRecording(recording); }
    /// Empty: the study has no triggers, or is a rehearsal.
    [[nodiscard]] std::optional<study::TriggerStatus> trigger() const { return m_marks.trigger(); }
    [[nodiscard]] const StimulusOutput& output() const;
    [[nodiscard]] StimulusOutput& output();
    /// Says where the last block was written, once it was read back and compared.
    [[nodiscard]] const QString& savedText() const { return m_saved; }
    /// The study had an interrupted session when it was opened.
    [[nodiscard]] bool foundInterrupted() const { return m_foundInterrupted; }

signals:
    void changed();
    /// A study was opened or created.
    void opened();
    /// Trials were kept; shown results are out of date.
    void resultsOutdated();
    void rehearsed();
    void enrolled(const QString& id);
    /// stale: results in the study's folder that still count the participant.
    void deleted(const QString& id, const QStringList& stale);
    void noteNotKept(const QString& text);
    void written(const QString& folder);
    void failed(const QString& what, const teleta::core::Error& error);

private:
    /// What is known of the session under way, from its first questionnaire to its last.
    struct Running {
        study::SessionRecord record;
        study::Participant participant;
        study::PlannedSession plan;
        std::vector<study::DueQuestionnaire> after;     ///< questionnaires after the last trial
        std::shared_ptr<study::ParticipantClaim> claim; ///< keeps others from running the participant
        std::optional<study::FeltTask> felt = {};       ///< of a task with levels
    };

    /// done: called before take(), on success.
    template <typename Work>
    void askForOverview(const QString& what, Work work, std::function<void()> done = {});
    [[nodiscard]] bool mayChange(const QString& what);
    void take(StudyOverview overview);
    void refresh();
    void lookAround(bool thenBegin = false);
    /// How the running session's simulated participant answers.
    [[nodiscard]] SimulatedPerson::Answers simulatedAnswers(const study::StudyTask& task,
                                                            const std::string& condition) const;
    void beginTrials(const OpenedSession& opened);
    void conclude();
    void closeSession(bool answered);
    void forgetSession();
    void exportSession();
    /// Of the running session.
    [[nodiscard]] QString recordingPath() const;
    void goOnRehearsing();
    void followSimulated();
    [[nodiscard]] bool isFast() const { return isSimulated() && m_speed > 1.0; }
    [[nodiscard]] bool isSimulated() const {
        return m_overview && m_overview->head.mode == study::Mode::simulated;
    }

    BraceletService& m_station;
    core::StopSwitch& m_stop;
    SteadyClock m_clock;
    WallClock m_utcNow;
    double m_speed = 1.0;
    std::int64_t m_anchor_ns = 0; ///< start of a fast rehearsal's clock

    BraceletStimulus m_bracelet;
    UnplayedStimulus m_unplayed;
    StudyStoreThread m_store;
    QuestionnaireSequence m_questionnaires;
    SessionMarks m_marks;
    StudyRunner m_runner;
    SimulatedPerson m_person;

    std::optional<study::StudyScene> m_scene; ///< of the study in m_sceneFolder
    std::string m_sceneFolder;
    std::optional<StudyOverview> m_overview;
    std::optional<std::pair<int, int>> m_chosen;
    std::optional<Running> m_running;
    study::FolderCondition m_folder;
    std::optional<std::string> m_otherRunner;
    std::optional<core::Error> m_storeError;
    std::int64_t m_lookedAround_ns = 0;
    bool m_lookingAround = false; ///< on the store's thread; a server may take long to answer
    bool m_noiseConfirmed = false;
    std::optional<bool> m_screenHeld;
    bool m_foundInterrupted = false;
    bool m_rehearsing = false;
    int m_busy = 0; ///< pending requests that change the study
    QString m_saved;
};

} // namespace teleta::console
