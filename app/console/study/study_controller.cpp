// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/study/study_controller.h"

#include "app/console/study/study_writing.h"
#include "backend/study/protocol/stimulus_set.h"
#include "backend/study/report/exports/participant_deletion.h"
#include "backend/study/report/exports/study_export.h"
#include "widgets/base/background.h"
#include "widgets/base/shown_path.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace teleta::console {

using study::StudyStore;

namespace {

constexpr std::int64_t kLookAround_ns = 2'000'000'000;

/// When a session began on the clock that is now at now_ns, so that the onsets of a resumed one continue.
std::int64_t beganAt_ns(const OpenedSession& session, std::int64_t now_ns, const QDateTime& utcNow) {
    QDateTime began = QDateTime::fromString(QString::fromStdString(session.record.id).left(15),
                                            QStringLiteral("yyyyMMdd'T'HHmmss"));
    began.setTimeSpec(Qt::UTC);
    double elapsed_s = static_cast<double>(began.msecsTo(utcNow)) * 1e-3;
    // Onsets never go back, even when the wall clock was.
    for (const study::TrialResult& result : session.kept)
        elapsed_s =
            std::max(elapsed_s, result.onset_s + result.duration_s + result.responseTime_s.value_or(0.0));
    return now_ns - std::llround(1e9 * std::max(elapsed_s, 0.0));
}

/// A study in a folder that cannot be written to is opened for reading.
core::Expected<StudyStore> openedOrShown(const study::StoreLocation& location) {
    const QFileInfo folder(QString::fromStdString(location.folder));
    return location.server.empty() && folder.isDir() && !folder.isWritable()
               ? StudyStore::openForReading(location)
               : StudyStore::open(location);
}

/// Replaces the store only if all of the other study could be read.
core::Expected<StudyOverview> replaced(StudyStoreThread::Store& store, core::Expected<StudyStore> another) {
    TELETA_CHECK(another);
    core::Expected<StudyOverview> overview = overviewOf(*another);
    if (overview)
        store = std::move(*another);
    return overview;
}

} // namespace

StudyController::StudyController(BraceletService& station, core::StopSwitch& stop, SteadyClock clock,
                                 WallClock utcNow, QObject* parent)
    : QObject(parent)
    , m_station(station)
    , m_stop(stop)
    , m_clock(std::move(clock))
    , m_utcNow(std::move(utcNow))
    , m_bracelet(station, stop)
    , m_questionnaires(m_store)
    , m_runner(
          stop, [this] { return now_ns(); }, [this] { return m_utcNow(); },
          [this](const study::TrialResult& result, const QDateTime& ended, StudyRunner::Kept kept) {
              m_store.ask(
                  [record = m_running->record, result, ended](StudyStoreThread::Store& store) {
                      return store->keepTrial(record, result, ended);
                  },
                  std::move(kept));
          })
    , m_person(
          m_runner, [this] { return now_ns(); }, m_speed) {
    connect(&m_questionnaires, &QuestionnaireSequence::changed, this, &StudyController::changed);
    connect(&m_runner, &StudyRunner::changed, this, &StudyController::followSimulated);
    connect(&m_runner, &StudyRunner::changed, this, &StudyController::changed);
    // During a session nothing else may play on the bracelet. A fast rehearsal plays nothing on it.
    connect(&m_runner, &StudyRunner::changed, this,
            [this] { m_station.reserve(m_runner.isActive() && !isFast()); });
    m_runner.observe(&m_marks);
    connect(&m_runner, &StudyRunner::changed, this,
            [this] { m_marks.setPaused(m_runner.hold() != study::Hold::none, now_ns()); });
    connect(&m_runner, &StudyRunner::blockKept, this, &StudyController::exportSession);
    connect(&m_runner, &StudyRunner::finished, this, &StudyController::conclude);
    connect(&m_runner, &StudyRunner::aborted, this, [this] {
        m_marks.end(true, now_ns());
        stopRehearsal();
        exportSession();
        refresh();
    });
}

StudyController::~StudyController() {
    forgetSession();
    m_station.reserve(false);
}

std::int64_t StudyController::now_ns() const {
    const std::int64_t now_ns = m_clock();
    // In real time it must be the clock by which the bracelet's player stamps its frames.
    return isFast() ? m_anchor_ns + std::llround(m_speed * static_cast<double>(now_ns - m_anchor_ns))
                    : now_ns;
}

const StimulusOutput& StudyController::output() const {
    if (isFast())
        return m_unplayed;
    return m_bracelet;
}

StimulusOutput& StudyController::output() {
    if (isFast())
        return m_unplayed;
    return m_bracelet;
}

const ParticipantOverview* StudyController::chosenParticipant() const {
    if (!m_overview || !m_chosen)
        return nullptr;
    return &m_overview->participants[static_cast<std::size_t>(m_chosen->first)];
}

const SessionOverview* StudyController::chosenSession() const {
    const ParticipantOverview* participant = chosenParticipant();
    return participant == nullptr ? nullptr
                                  : &participant->sessions[static_cast<std::size_t>(m_chosen->second)];
}

const study::PlannedSession* StudyController::plan() const {
    if (m_running)
        return &m_running->plan;
    const SessionOverview* session = chosenSession();
    return session == nullptr ? nullptr : &session->plan;
}

const study::StudyTask* StudyController::task() const {
    const study::PlannedSession* planned = plan();
    return planned == nullptr ? nullptr : &m_overview->head.protocol.tasks[planned->task];
}

std::optional<study::MotorStrength> StudyController::strengthOf(const study::PlannedTrial& trial) const {
    if (!m_running || !m_running->felt || !trial.level || !m_station.session() ||
        m_running->felt->vary != study::Vary::intensity)
        return std::nullopt;
    const study::FeltTask& felt = *m_running->felt;
    const auto track = felt.tracks.find(trial.track);
    if (track == felt.tracks.end())
        return std::nullopt;
    return study::motorStrength(m_station.calibration().profiles(), track->second.tactors,
                                *trial.level * felt.strongest);
}

template <typename Work>
void StudyController::askForOverview(const QString& what, Work work, std::function<void()> done) {
    ++m_busy;
    m_store.ask(std::move(work),
                [this, what, done = std::move(done)](core::Expected<StudyOverview> overview) {
                    --m_busy;
                    if (overview) {
                        if (done)
                            done();
                        take(std::move(*overview));
                    } else {
                        stopRehearsal();
                        emit failed(what, overview.error());
                    }
                    emit changed();
                });
    emit changed();
}

bool StudyController::mayChange(const QString& what) {
    // A session that is about to start would write into the other study.
    if (!isActive() && !isBusy()) {
        stopRehearsal();
        return true;
    }
    const bool runs = isActive();
    emit failed(
        what,
        {core::ErrorKind::refused,
         (runs ? tr("a session of the open study is running") : tr("the open study is being read or written"))
             .toStdString(),
         (runs ? tr("to leave the session first") : tr("to try again in a moment")).toStdString(),
         {}});
    return false;
}

void StudyController::open(const study::StoreLocation& location) {
    const QString folder = QString::fromStdString(location.folder);
    const QString name = location.server.empty()
                             ? QDir(folder).dirName()
                             : QString::fromStdString(study::shownServer(location.server));
    const QString what = tr("%1 could not be opened.", "a folder").arg(name);
    if (mayChange(what))
        askForOverview(what, [location](StudyStoreThread::Store& store) {
            return replaced(store, openedOrShown(location));
        });
}

void StudyController::create(const study::StoreLocation& location, const study::StudyHead& head) {
    const QString what = tr("The study could not be created.");
    if (mayChange(what))
        askForOverview(what, [location, head](StudyStoreThread::Store& store) {
            return replaced(store, StudyStore::create(location, head));
        });
}

void StudyController::openOrCreate(const study::StoreLocation& location, const study::StudyHead& head) {
    const QString what = tr("The rehearsal could not be opened.");
    if (mayChange(what))
        askForOverview(what, [location, head](StudyStoreThread::Store& store) {
            const QDir folder(QString::fromStdString(location.folder));
            return replaced(store, folder.exists(QStringLiteral("study.sqlite"))
                                       ? StudyStore::open(location)
                                       : StudyStore::create(location, head));
        });
}

void StudyController::enrol(const QString& id) {
    if (!m_overview || isActive() || isBusy())
        return;
    askForOverview(
        tr("%1 could not be enrolled.", "a participant").arg(id),
        [id = id.toStdString()](StudyStoreThread::Store& store) {
            return store->enrol(id).and_then([&](const study::Participant&) { return overviewOf(*store); });
        },
        [this, id] {
            // The new participant is chosen next, and has not heard the noise.
            m_chosen.reset();
            m_noiseConfirmed = false;
            emit enrolled(id);
        });
}

void StudyController::deleteParticipant(const QString& id, const QString& reason) {
    if (!m_overview || isActive() || isBusy())
        return;
    auto stale = std::make_shared<QStringList>();
    askForOverview(
        tr("%1 could not be deleted.", "a participant").arg(id),
        [id = id.toStdString(), reason = reason.toStdString(), now = m_utcNow(),
         stale](StudyStoreThread::Store& store) {
            return study::deleteFromStudy(*store, id, reason, now)
                .and_then([&](const study::DeletedParticipant& gone) {
                    for (const std::string& path : gone.stale)
                        stale->append(QString::fromStdString(path));
                    return overviewOf(*store);
                });
        },
        [this, id, stale] {
            m_chosen.reset();
            m_noiseConfirmed = false;
            emit deleted(id, *stale);
        });
}

void StudyController::refresh() {
    askForOverview(tr("The study could not be read."),
                   [](StudyStoreThread::Store& store) { return overviewOf(*store); });
}

void StudyController::take(StudyOverview overview) {
    const bool another = !m_overview || m_overview->store != overview.store;
    m_overview = std::move(overview);
    m_marks.setTrigger(isSimulated() ? core::TriggerSettings() : m_overview->head.protocol.trigger);
    if (another) {
        m_chosen.reset();
        m_saved.clear();
        m_noiseConfirmed = false;
        m_foundInterrupted = false;
        if (m_overview->location.folder != m_sceneFolder)
            m_scene.reset();
    }
    const std::vector<ParticipantOverview>& people = m_overview->participants;
    if (m_chosen && static_cast<std::size_t>(m_chosen->first) >= people.size())
        m_chosen.reset();
    if (!m_chosen && !people.empty()) {
        // An interrupted session comes first, otherwise the participant who was enrolled last.
        std::size_t person = people.size() - 1;
        std::size_t session = people.back().nextSession().value_or(0);
        for (std::size_t p = 0; p < people.size() && another; ++p) {
            for (std::size_t s = 0; s < people[p].sessions.size() && !m_foundInterrupted; ++s) {
                if (people[p].sessions[s].isInterrupted()) {
                    m_foundInterrupted = true;
                    person = p;
                    session = s;
                }
            }
        }
        m_chosen = {static_cast<int>(person), static_cast<int>(session)};
    }
    lookAround();
    if (another)
        emit opened();
    emit resultsOutdated();
    goOnRehearsing();
}

void StudyController::choose(int participant, int session) {
    // A session that is about to start is the chosen one.
    if (!m_overview || isActive() || isBusy() || participant < 0 || session < 0)
        return;
    const auto p = static_cast<std::size_t>(participant);
    if (p >= m_overview->participants.size() ||
        static_cast<std::size_t>(session) >= m_overview->participants[p].sessions.size())
        return;
    if (m_chosen && m_chosen->first != participant)
        m_noiseConfirmed = false;
    m_chosen = {participant, session};
    m_foundInterrupted = false;
    m_saved.clear();
    lookAround();
    emit changed();
}

/// Looks at the folder, and at whether somebody else runs the participant: both may take long.
void StudyController::lookAround(bool thenBegin) {
    m_lookedAround_ns = m_clock();
    const ParticipantOverview* participant = chosenParticipant();
    if (!m_overview || participant == nullptr)
        return;
    struct Findings {
        study::FolderCondition folder;
        core::Expected<std::optional<std::string>> runner;
    };
    m_lookingAround = true;
    m_store.ask(
        [who = participant->participant](StudyStoreThread::Store& store) {
            return Findings{study::lookAtFolder(store->folder()), store->runner(who)};
        },
        [this, thenBegin, isOwn = m_running.has_value()](Findings findings) {
            m_lookingAround = false;
            m_folder = std::move(findings.folder);
            m_otherRunner = findings.runner && !isOwn ? *findings.runner : std::nullopt;
            m_storeError = findings.runner ? std::nullopt : std::optional(findings.runner.error());
            if (isActive())
                return;
            if (thenBegin && m_rehearsing) {
                begin();
                // Whatever prevents it is among the checks that are shown.
                m_rehearsing = isBusy();
            }
            emit changed();
        });
}

std::vector<study::RunCheck> StudyController::checks() const {
    study::RunConditions now;
    if (m_overview) {
        now.mode = m_overview->head.mode;
        now.protocol = &m_overview->head.protocol;
        now.missingStimuli = m_overview->head.stimuli.missing();
        now.stimuliChanged = m_overview->head.stimuliChanged();
        now.madeBy = m_overview->head.appVersion;
    }
    const ParticipantOverview* participant = chosenParticipant();
    const SessionOverview* session = chosenSession();
    if (participant != nullptr && session != nullptr) {
        now.participant = participant->participant.id;
        now.finished = session->isFinished();
    }
    now.trigger = m_marks.trigger();
    now.runner = m_otherRunner;
    now.folder = m_folder;
    now.store = m_storeError;
    now.noiseConfirmed = m_noiseConfirmed;
    now.screenHeld = m_screenHeld;
    if (&output() == &m_unplayed) {
        now.bracelet = study::BraceletCondition::live;
        now.braceletName = m_unplayed.description().toStdString();
        now.braceletIsSimulated = true;
    } else if (const auto& open = m_station.session()) {
        now.braceletName = open->source().description().name;
        now.braceletIsSimulated = m_station.isSimulated();
        for (const auto& motor : open->calibration().profiles()) {
            if (!motor.assumed)
                now.slowestFall_s = std::max(now.slowestFall_s.value_or(0.0), motor.fallTime_s);
        }
        now.bracelet = m_stop.engaged()          ? study::BraceletCondition::stopped
                       : m_station.isAnswering() ? study::BraceletCondition::live
                                                 : study::BraceletCondition::notLive;
    }
    return study::preRunChecks(now);
}

void StudyController::setScreenHeld(std::optional<bool> held) {
    if (std::exchange(m_screenHeld, held) != held)
        emit changed();
}

void StudyController::setNoiseConfirmed(bool confirmed) {
    m_noiseConfirmed = confirmed;
    emit changed();
}

void StudyController::begin() {
    const ParticipantOverview* participant = chosenParticipant();
    const SessionOverview* session = chosenSession();
    if (participant == nullptr || session == nullptr || isActive() || isBusy() || !study::allPassed(checks()))
        return;
    ++m_busy;
    m_saved.clear();
    m_foundInterrupted = false;
    const auto planIndex = static_cast<std::size_t>(m_chosen->second);
    m_store.ask(
        [who = participant->participant, planIndex, plan = session->plan, now = m_utcNow()](
            StudyStoreThread::Store& store) { return openSession(*store, who, planIndex, plan, now); },
        [this, who = participant->participant, plan = session->plan](core::Expected<OpenedSession> opened) {
            --m_busy;
            if (!opened) {
                stopRehearsal();
                emit failed(tr("The session could not start."), opened.error());
                emit changed();
                return;
            }
            m_running = {opened->record, who, plan, opened->after, opened->claim};
            m_questionnaires.begin({m_overview->head, who, plan, opened->record}, opened->before,
                                   [this, session = *opened] { beginTrials(session); });
            emit changed();
        });
    emit changed();
}

void StudyController::beginTrials(const OpenedSession& opened) {
    const study::PlannedSession plan = m_running->plan;
    const core::Expected<void> begun =
        m_runner.begin(output(), m_overview->head.protocol, m_overview->head.stimuli, plan, opened.kept,
                       beganAt_ns(opened, now_ns(), m_utcNow()));
    if (!begun) {
        forgetSession();
        stopRehearsal();
        emit failed(tr("The session could not start."), begun.error());
        return;
    }
    const study::StudyTask& task = m_overview->head.protocol.tasks[plan.task];
    const pattern::Pattern* stimulus = task.design == study::Design::identification
                                           ? nullptr
                                           : m_overview->head.stimuli.find(study::levelStimulusId(task));
    if (stimulus != nullptr)
        m_running->felt = study::feltTask(task, *stimulus);
    if (!isSimulated()) {
        const study::Protocol& protocol = m_overview->head.protocol;
        const QString folder = QString::fromStdString(m_overview->location.folder);
        m_marks.begin(m_running->record.id, folder, protocol.recordSessions ? recordingPath() : QString(),
                      now_ns());
        return;
    }
    const std::string& condition = task.conditions[plan.condition];
    m_person.begin(simulatedAnswers(task, condition), plan.seed);
    // The rehearsal was halted during a questionnaire.
    if (!m_rehearsing)
        m_runner.pause();
}

QString StudyController::recordingPath() const {
    std::vector<study::Participant> people;
    for (const ParticipantOverview& person : m_overview->participants)
        people.push_back(person.participant);
    const std::vector<std::string> labels = study::fileLabels(people);
    std::string label;
    for (std::size_t i = 0; i < people.size(); ++i) {
        if (people[i].key == m_running->participant.key)
            label = labels[i];
    }
    return QStringLiteral("%1/recordings/%2_%3.teleta")
        .arg(QString::fromStdString(m_overview->location.folder), QString::fromStdString(label),
             QString::fromStdString(m_running->record.id));
}

void StudyController::exportSession() {
    if (!m_running)
        return;
    m_store.ask([who = m_running->participant, record = m_running->record](
                    StudyStoreThread::Store& store) { return study::exportSession(*store, who, record); },
                [this](const core::Expected<void>& written) {
                    const std::string data = m_overview->location.folder + "/data";
                    if (written)
                        m_saved =
                            tr("Saved and verified: %1").arg(base::fromHome(QString::fromStdString(data)));
                    else
                        emit failed(tr("The trials are safe in the study, but could not be exported."),
                                    written.error());
                    emit changed();
                });
}

void StudyController::conclude() {
    m_marks.end(false, now_ns());
    m_person.leave();
    m_questionnaires.begin({m_overview->head, m_running->participant, m_running->plan, m_running->record},
                           m_running->after,
                           [this, answered = !m_running->after.empty()] { closeSession(answered); });
}

void StudyController::closeSession(bool answered) {
    if (answered)
        exportSession();
    askForOverview(tr("The session could not be closed."),
                   [record = m_running->record](StudyStoreThread::Store& store) {
                       return store->finishSession(record).and_then([&] { return overviewOf(*store); });
                   });
}

void StudyController::abort() {
    if (m_questionnaires.current() == nullptr) {
        m_runner.abort();
        return;
    }
    // Given answers are kept; the session stays open until the others are.
    stopRehearsal();
    forgetSession();
    refresh();
}

void StudyController::forgetSession() {
    m_questionnaires.leave();
    m_person.leave();
    m_runner.clear();
    m_marks.end(false, now_ns());
    if (!m_running)
        return;
    // A claim may hold the server's connection, which belongs to the store's thread.
    m_store.ask(
        [claim = std::move(m_running->claim)](StudyStoreThread::Store&) mutable {
            claim.reset();
            return true;
        },
        [](bool) {});
    m_running.reset();
}

void StudyController::leaveSession() {
    if (isBusy() || m_questionnaires.current() != nullptr)
        return;
    forgetSession();
    m_saved.clear();
    if (const ParticipantOverview* participant = chosenParticipant())
        m_chosen->second =
            static_cast<int>(participant->nextSession().value_or(static_cast<std::size_t>(m_chosen->second)));
    lookAround();
    emit changed();
}

void StudyController::keepNote(const QString& text) {
    if (!m_running)
        return;
    struct Written {
        core::Expected<void> kept;
        core::Expected<void> exported;
    };
    m_store.ask(
        [who = m_running->participant, record = m_running->record, text = text.toStdString(),
         now = m_utcNow()](StudyStoreThread::Store& store) {
            Written written{store->keepNote(record, text, now), {}};
            if (written.kept)
                written.exported = study::exportNotes(*store, who);
            return written;
        },
        [this, text](const Written& written) {
            if (!written.kept) {
                emit noteNotKept(text);
                emit failed(tr("The note could not be saved."), written.kept.error());
            } else if (!written.exported) {
                emit failed(tr("The note is safe in the study, but could not be exported."),
                            written.exported.error());
            }
        });
}

void StudyController::write(const QString& format) {
    if (!m_overview)
        return;
    const auto done = [this](const core::Expected<QString>& folder) {
        if (folder)
            emit written(*folder);
        else
            emit failed(tr("The export failed."), folder.error());
    };
    // Figures take long; a running session must not wait for them.
    if (format == QLatin1String("psychds"))
        m_store.ask([format](StudyStoreThread::Store& store) { return writeStudy(*store, format); }, done);
    else
        base::runInBackground(
            this, [location = m_overview->location, format] { return writeStudy(location, format); }, done);
}

void StudyController::tick() {
    m_runner.poll();
    if (!isActive() && !m_lookingAround && m_overview && m_clock() - m_lookedAround_ns > kLookAround_ns)
        lookAround();
}

} // namespace teleta::console
