// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/study/study_scenes.h"

#include "app/console/study/trial_lines.h"
#include "backend/study/protocol/stimulus_set.h"
#include "widgets/study/study_names.h"

#include <QLocale>

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::console {

using study::displayCondition;
using study::displayName;
using study::Hold;
using study::Phase;
using study::Stage;
using study::Tone;

namespace {

QString text(const std::string& value) {
    return QString::fromStdString(value);
}

Phase phaseNow(const study::SessionFlow& flow) {
    if (const study::PlannedTrial* current = flow.session().current())
        return current->phase;
    return flow.results().empty() ? Phase::test : flow.results().back().planned.phase;
}

std::size_t completed(const study::SessionFlow& flow, Phase phase) {
    const auto& results = flow.results();
    return static_cast<std::size_t>(std::count_if(results.begin(), results.end(), [&](const auto& result) {
        return result.planned.phase == phase && result.isComplete();
    }));
}

std::size_t planned(const study::PlannedSession& plan, Phase phase) {
    return phase == Phase::practice ? plan.practiceTrials : plan.testTrials;
}

} // namespace

QString StudyScenes::sessionName(const study::Protocol& protocol, const study::PlannedSession& plan) {
    const study::StudyTask& task = protocol.tasks[plan.task];
    return tr("%1, %2", "task, condition")
        .arg(displayName(task), displayCondition(task, task.conditions[plan.condition]));
}

QString StudyScenes::protocolText(const study::StudyHead& head) {
    const study::Protocol& protocol = head.protocol;
    QStringList lines;
    for (const study::StudyTask& task : protocol.tasks) {
        QStringList conditions;
        for (const std::string& condition : task.conditions)
            conditions << displayCondition(task, condition);
        lines << (task.design == study::Design::identification
                      ? tr("%1: %n pattern(s); %2", "task; conditions",
                           static_cast<int>(task.patterns.size()))
                      : tr("%1: %n track(s); %2", "task; conditions",
                           static_cast<int>(task.levels.tracks.size())))
                     .arg(displayName(task), conditions.join(QStringLiteral(", ")));
    }
    const QLocale locale;
    const bool hasPatterns = std::ranges::any_of(protocol.tasks, [](const study::StudyTask& task) {
        return task.design == study::Design::identification;
    });
    if (hasPatterns)
        lines << tr("Repetitions of each pattern: %1 in practice, %2 in the test; %3 test trials per "
                    "participant")
                     .arg(protocol.practice.repetitions)
                     .arg(protocol.test.repetitions)
                     .arg(protocol.testTrials());
    else
        lines << tr("%1 practice trials of each track; up to %2 test trials per participant")
                     .arg(protocol.practice.repetitions)
                     .arg(protocol.testTrials());
    lines << tr("Stimulus %1 s, answer within %2 s %3", "numbers; of what")
                 .arg(locale.toString(protocol.stimulus_s), locale.toString(protocol.responseLimit_s),
                      protocol.window == study::ResponseWindow::fromOnset ? tr("of its onset")
                                                                          : tr("of its end"));
    if (protocol.noiseColour != "none")
        lines << tr("Pink noise, %1 dBA").arg(locale.toString(protocol.noise_dBA));
    lines << tr("Seed %1").arg(QString::number(head.seed));
    return lines.join(QLatin1Char('\n'));
}

study::PanelScene StudyScenes::study(const StudyController& controller) {
    study::PanelScene scene;
    if (!controller.overview())
        return scene;
    const StudyOverview& overview = *controller.overview();
    const study::Session* last = controller.runner().session();
    const bool runs = controller.isActive() && (last == nullptr || last->stage() != Stage::aborted);
    scene = study(overview, runs ? controller.chosen() : std::nullopt);
    if (!overview.location.server.empty()) {
        scene.store = text(overview.store);
        if (const auto& error = controller.storeError()) {
            scene.storeProblem = text(core::describe(*error));
            scene.storeAway = error->kind == core::ErrorKind::unavailable;
        }
    }
    scene.chosen = controller.chosen();
    scene.locked = controller.isActive() || controller.isBusy() || controller.isRehearsing();
    return scene;
}

study::PanelScene StudyScenes::study(const StudyOverview& overview,
                                     const std::optional<std::pair<int, int>>& running) {
    study::PanelScene scene;
    const study::Protocol& protocol = overview.head.protocol;
    scene.name = text(protocol.name);
    scene.folder = text(overview.location.folder);
    scene.mode = overview.head.mode;
    scene.protocol = protocolText(overview.head);
    for (const ParticipantOverview& person : overview.participants) {
        study::ParticipantLine line{text(person.participant.id), {}, {}};
        QStringList order;
        for (const SessionOverview& session : person.sessions) {
            const study::StudyTask& task = protocol.tasks[session.plan.task];
            if (session.plan.task == 0)
                order << displayCondition(task, task.conditions[session.plan.condition]);
            study::SessionLine one;
            one.name = sessionName(protocol, session.plan);
            one.kept = session.kept;
            one.planned = session.planned();
            one.finished = session.isFinished();
            one.interrupted = session.isInterrupted();
            const std::pair at(static_cast<int>(scene.participants.size()),
                               static_cast<int>(line.sessions.size()));
            one.state = running == at && !one.finished ? tr("running")
                        : one.finished                 ? tr("\u2713 finished")
                        : one.interrupted ? tr("%1 of %2", "trials kept").arg(one.kept).arg(one.planned)
                                          : tr("to do");
            line.sessions.push_back(std::move(one));
        }
        line.order = order.size() > 1 ? order.join(QStringLiteral(" \u2192 ")) : QString();
        scene.participants.push_back(std::move(line));
    }
    return scene;
}

NextStep StudyScenes::nextStep(const StudyController& controller) {
    if (!controller.overview())
        return NextStep::none;
    const bool simulated = controller.overview()->head.mode == study::Mode::simulated;
    if (controller.questionnaires().current() != nullptr) {
        if (!controller.questionnaires().problem().isEmpty())
            return NextStep::retry;
        return controller.isRehearsing() ? NextStep::stopRehearsal : NextStep::fillIn;
    }
    if (const study::SessionFlow* flow = controller.runner().flow()) {
        if (flow->hold() == Hold::notKept)
            return NextStep::retry;
        if (flow->isOver())
            return simulated && controller.isRehearsing() ? NextStep::stopRehearsal : NextStep::leaveSession;
        if (flow->waitsForExperimenter() || (flow->hold() == Hold::rest && !controller.isRehearsing()))
            return NextStep::goOn;
        return controller.isRehearsing() ? NextStep::stopRehearsal : NextStep::none;
    }
    if (controller.isRehearsing())
        return NextStep::stopRehearsal;
    const auto& people = controller.overview()->participants;
    const bool allDone =
        std::all_of(people.begin(), people.end(), [](const auto& person) { return !person.nextSession(); });
    if (simulated) {
        const std::size_t wanted = std::max<std::size_t>(controller.overview()->head.plannedParticipants, 1);
        return allDone && people.size() >= wanted ? NextStep::showResults : NextStep::rehearse;
    }
    const SessionOverview* session = controller.chosenSession();
    if (session == nullptr)
        return NextStep::enrol;
    if (session->isFinished())
        return allDone                                         ? NextStep::showResults
               : controller.chosenParticipant()->nextSession() ? NextStep::leaveSession
                                                               : NextStep::none;
    return NextStep::begin;
}

study::SessionScene StudyScenes::session(const StudyController& controller) {
    study::SessionScene scene;
    if (!controller.overview())
        return scene;
    const StudyOverview& overview = *controller.overview();
    scene.mode = overview.head.mode;
    scene.saved = controller.savedText();
    scene.noiseConfirmed = controller.noiseConfirmed();
    scene.device = controller.output().description();
    const QString obstacle = controller.output().obstacle();
    scene.deviceTone = !obstacle.isEmpty() ? Tone::alarm : Tone::calm;
    if (const auto trigger = controller.trigger(); trigger && trigger->failures > 0) {
        scene.device = tr("%1. %n trigger(s) could not be written: %2", "device; why",
                          static_cast<int>(trigger->failures))
                           .arg(scene.device, trigger->error ? text(core::describe(*trigger->error))
                                                             : tr("the line was not open"));
        scene.deviceTone = Tone::alarm;
    }
    if (const SessionOverview* session = controller.chosenSession()) {
        const ParticipantOverview& person = *controller.chosenParticipant();
        scene.title =
            tr("%1 \u2014 %2", "participant, session")
                .arg(text(person.participant.id), sessionName(overview.head.protocol, session->plan));
        const std::size_t conditions = overview.head.protocol.tasks[session->plan.task].conditions.size();
        scene.subtitle =
            (conditions > 1
                 ? tr("Session %1 of %2, row %3 of the Williams square")
                       .arg(controller.chosen()->second + 1)
                       .arg(person.sessions.size())
                       .arg(session->plan.sequenceRow + 1)
                 : tr("Session %1 of %2").arg(controller.chosen()->second + 1).arg(person.sessions.size()));
    }
    if (controller.runner().isActive())
        describeRunning(controller, scene);
    if (controller.questionnaires().current() != nullptr)
        describeQuestionnaire(controller, scene);
    else if (!controller.runner().isActive())
        describeIdle(controller, scene);
    return scene;
}

void StudyScenes::describeIdle(const StudyController& controller, study::SessionScene& scene) {
    const StudyOverview& overview = *controller.overview();
    const SessionOverview* session = controller.chosenSession();
    bool passed = true;
    const bool open = session != nullptr && !session->isFinished();
    if (session != nullptr)
        scene.outcomes = outcomeLines(session->results, *controller.task());
    if (open) {
        for (const study::RunCheck& check : controller.checks()) {
            scene.checks.push_back({text(check.name), check.passed, text(check.finding), text(check.remedy)});
            passed = passed && check.passed;
        }
        scene.needsNoise =
            overview.head.mode != study::Mode::simulated && overview.head.protocol.noiseColour != "none";
    }
    scene.nextEnabled = !controller.isBusy();
    switch (nextStep(controller)) {
    case NextStep::begin:
        scene.next = session->isInterrupted() ? tr("Resume this session") : tr("Start this session");
        scene.nextEnabled = scene.nextEnabled && passed;
        if (session->isInterrupted()) {
            scene.state = tr("This session was interrupted after %1 of %2 trials. All answers are saved; it "
                             "resumes in the same order.")
                              .arg(session->kept)
                              .arg(session->planned());
            scene.tone = Tone::attention;
        } else if (!passed) {
            scene.state = tr("The session can start when all checks have passed.");
        }
        return;
    case NextStep::rehearse:
        scene.next = overview.participants.empty() ? tr("Start the rehearsal") : tr("Resume the rehearsal");
        scene.nextEnabled = scene.nextEnabled && (passed || !open);
        scene.state = tr("Simulated participants go through all sessions, by the same rules as people.");
        return;
    case NextStep::stopRehearsal:
        scene.next = tr("Halt the rehearsal");
        return;
    case NextStep::leaveSession:
        scene.next = tr("Next session");
        scene.state = tr("This session is finished.");
        scene.tone = Tone::good;
        return;
    case NextStep::showResults:
        scene.next = tr("Show the results");
        scene.state = tr("All sessions of all participants are finished.");
        scene.tone = Tone::good;
        return;
    case NextStep::enrol:
        scene.next = tr("Add a participant");
        scene.state = tr("Enrol the first participant on the left: the order of enrolment determines the "
                         "order of the conditions.");
        return;
    case NextStep::none:
    case NextStep::goOn:
    case NextStep::retry:
    case NextStep::fillIn:
        break;
    }
    scene.nextEnabled = false;
    scene.next = tr("Choose another participant");
    scene.state = tr("This participant has finished all sessions.");
    scene.tone = Tone::good;
}

QString StudyScenes::skipConsequence(study::QuestionnaireTime when) {
    switch (when) {
    case study::QuestionnaireTime::beforeStudy:
        return tr("It is asked again when a session of this participant starts or resumes.");
    case study::QuestionnaireTime::beforeSession:
        return tr("It is asked again only if this session is interrupted and resumed.");
    case study::QuestionnaireTime::afterSession:
    case study::QuestionnaireTime::afterStudy:
        break;
    }
    return tr("The session finishes without it, and it is not asked again.");
}

void StudyScenes::describeQuestionnaire(const StudyController& controller, study::SessionScene& scene) {
    const QuestionnaireSequence& questionnaires = controller.questionnaires();
    const QString title = text(questionnaires.current()->title);
    scene.canAbort = true;
    scene.canNote = true;
    scene.canPause = false;
    scene.canSkip = !questionnaires.isKeeping() && !questionnaires.isSimulated();
    scene.questionnaire = questionnaires.shown();
    scene.skipConsequence = skipConsequence(questionnaires.current()->when);
    scene.nextEnabled = !questionnaires.isKeeping();
    scene.tone = Tone::calm;
    scene.state = questionnaires.isSimulated()
                      ? tr("The simulated participant fills in \u201c%1\u201d.").arg(title)
                  : questionnaires.isSkipping() && questionnaires.isKeeping()
                      ? tr("Recording that \u201c%1\u201d is skipped \u2026").arg(title)
                  : questionnaires.isKeeping() ? tr("Saving the answers \u2026")
                                               : tr("The participant fills in \u201c%1\u201d.").arg(title);
    switch (nextStep(controller)) {
    case NextStep::retry:
        scene.tone = Tone::alarm;
        if (questionnaires.isSkipping()) {
            scene.next = tr("Try again to skip it");
            scene.state =
                tr("\u201c%1\u201d could not be skipped, because the note about it could not be saved. %2")
                    .arg(title, questionnaires.problem());
            return;
        }
        scene.next = tr("Try again to save the answers");
        scene.state = tr("The answers to \u201c%1\u201d could not be saved; they are still in the "
                         "participant's window. %2")
                          .arg(title, questionnaires.problem());
        return;
    case NextStep::stopRehearsal:
        scene.next = tr("Halt the rehearsal");
        return;
    default:
        scene.next = tr("Show the questionnaire");
        return;
    }
}

void StudyScenes::describeRunning(const StudyController& controller, study::SessionScene& scene) {
    const StudyRunner& runner = controller.runner();
    const study::SessionFlow* running = runner.flow();
    if (running == nullptr)
        return;
    const study::SessionFlow& flow = *running;
    const study::Session& session = flow.session();
    const study::StudyTask& task = *controller.task();
    const bool simulated = controller.overview()->head.mode == study::Mode::simulated;
    const Phase phase = phaseNow(flow);
    scene.phase = phase == Phase::practice ? tr("Practice") : tr("Test");
    scene.done = completed(flow, phase);
    scene.total = planned(*controller.plan(), phase);
    const bool over = flow.isOver();
    scene.canAbort = !over;
    scene.canPause = !over && !flow.waitsForExperimenter() && !flow.pauseWanted();
    scene.canNote = true;

    scene.outcomes = outcomeLines(flow.results(), task);
    if (const study::PlannedTrial* trial = session.current(); trial != nullptr && trial->level) {
        scene.subtitle +=
            QLatin1Char('\n') + tr("Track %1, level %2 %3", "name, number, unit")
                                    .arg(text(trial->track), QLocale().toString(*trial->level, 'g', 3),
                                         study::displayUnit(task.levels.vary));
        if (const auto strength = controller.strengthOf(*trial))
            scene.subtitle += tr(" (%1 Hz, force %2 %)", "behind a level; force as a share of full")
                                  .arg(QLocale().toString(strength->speed_Hz, 'f', 0),
                                       QLocale().toString(100.0 * strength->force, 'f', 0));
    }

    const NextStep step = nextStep(controller);
    scene.nextEnabled = step != NextStep::none && !controller.isBusy();
    const bool stopped = flow.hold() == Hold::stopped;
    switch (flow.hold()) {
    case Hold::paused:
        scene.next = tr("Go on");
        scene.state = tr("Paused.");
        scene.tone = Tone::attention;
        break;
    case Hold::rest: {
        const int left_s = static_cast<int>(std::ceil(runner.restLeft_s()));
        scene.next = tr("End the rest");
        scene.state = left_s > 0 ? tr("Rest. The participant may continue in %1 s.").arg(left_s)
                                 : tr("Rest. The participant continues with Space.");
        scene.tone = Tone::calm;
        break;
    }
    case Hold::blockEnd:
        scene.next = tr("Start the test");
        scene.state = tr("Practice is over. In the test there is no feedback unless the protocol says so.");
        scene.tone = Tone::good;
        break;
    case Hold::stopped:
    case Hold::deviceLost: {
        const QString obstacle = controller.output().obstacle();
        scene.next = stopped ? tr("Go on after STOP") : tr("Go on");
        scene.nextEnabled = scene.nextEnabled && obstacle.isEmpty();
        scene.state =
            stopped
                ? controller.isStopped()
                      ? tr("STOPPED. The bracelet is off. An interrupted trial will be shown again.")
                      : tr("STOP is released. The session waits, and an interrupted trial will be shown "
                           "again.")
                : tr("The stimulus was interrupted: %1. The trial will be shown again.").arg(runner.reason());
        if (!obstacle.isEmpty())
            scene.state += QLatin1Char('\n') + obstacle;
        scene.tone = stopped && !controller.isStopped() && obstacle.isEmpty() ? Tone::attention : Tone::alarm;
        break;
    }
    case Hold::notKept:
        scene.next = tr("Try again to save the last trial");
        scene.state =
            (flow.waitsForServer() ? tr("The last trial is waiting for the server. %1")
                                   : tr("The last trial could not be saved; it is still in memory. %1"))
                .arg(runner.reason());
        scene.tone = Tone::alarm;
        break;
    case Hold::none:
        if (over) {
            const bool aborted = session.stage() == Stage::aborted;
            scene.next = aborted ? tr("Leave this session") : tr("Next session");
            scene.state = aborted ? tr("The session was aborted. All answers are saved.")
                                  : tr("This session is finished. Thank the participant.");
            scene.tone = aborted ? Tone::attention : Tone::good;
            break;
        }
        scene.state = flow.isKeeping()                     ? tr("Saving the trial \u2026")
                      : session.stage() == Stage::ready    ? tr("Ready for the next trial.")
                      : session.stage() == Stage::starting ? tr("The stimulus is starting \u2026")
                      : session.stage() == Stage::stimulus ? tr("The stimulus is playing.")
                      : session.stage() == Stage::feedback ? tr("The right answer is shown.")
                                                           : tr("Waiting for the answer.");
        scene.next = simulated ? tr("The simulated participant is working")
                               : tr("The participant continues with Space");
        break;
    }
    // Also without a bracelet, whose obstacle would say so.
    if (step == NextStep::goOn && controller.isStopped()) {
        scene.nextEnabled = false;
        scene.state += QLatin1Char(' ') + tr("Hold the STOP button for a second to release it.");
    }
    if (step == NextStep::stopRehearsal)
        scene.next = tr("Halt the rehearsal");
    if (flow.pauseWanted())
        scene.state += QLatin1Char(' ') + tr("A pause follows.");
}

study::ParticipantScene StudyScenes::participant(const StudyController& controller) {
    using State = study::ParticipantScene::State;
    study::ParticipantScene scene;
    if (!controller.overview())
        return scene;
    if (const QuestionnaireSequence& questionnaires = controller.questionnaires();
        questionnaires.current() != nullptr) {
        scene.state = State::questionnaire;
        scene.mode = controller.overview()->head.mode;
        scene.title = text(controller.overview()->head.protocol.name);
        const bool areNotKept = !questionnaires.problem().isEmpty() && !questionnaires.isSkipping();
        // retry() stores the submitted answers: the form must stay unchanged.
        scene.questionnaireLocked = questionnaires.isKeeping() || questionnaires.isSimulated() || areNotKept;
        if (areNotKept)
            scene.questionnaireProblem =
                tr("Your answers could not be saved yet. Please tell the experimenter.");
        return scene;
    }
    const StudyRunner& runner = controller.runner();
    if (!runner.isActive())
        return scene;
    const study::SessionFlow& flow = *runner.flow();
    const study::Session& session = flow.session();
    const bool isFeedback = session.stage() == Stage::feedback;
    const study::TrialResult* last = flow.results().empty() ? nullptr : &flow.results().back();
    scene.title = displayName(*controller.task());
    scene.mode = controller.overview()->head.mode;
    scene.phase = isFeedback ? last->planned.phase : phaseNow(flow);
    scene.trials = planned(*controller.plan(), scene.phase);
    scene.diagrams = session.settings(scene.phase).diagram;
    scene.answersOpen = session.deadline_ns().has_value();
    // Nothing of track, level and target: nobody can learn the right answer here.
    scene.question = study::displayQuestion(*controller.task());
    scene.interval = runner.interval();
    scene.canReplay = session.stage() == Stage::answering && session.replaysLeft() > 0;
    scene.trial = std::min(completed(flow, scene.phase) + (isFeedback ? 0 : 1), scene.trials);
    if (last != nullptr && last->planned.phase == scene.phase)
        scene.answered = last->response;
    if (isFeedback)
        scene.presented = last->planned.stimulus;
    switch (flow.hold()) {
    case Hold::stopped:
        scene.state = controller.isStopped() ? State::stopped : State::paused;
        return scene;
    case Hold::deviceLost:
        scene.state = State::stopped;
        return scene;
    case Hold::paused:
    case Hold::blockEnd:
    case Hold::notKept:
        scene.state = State::paused;
        return scene;
    case Hold::rest:
        scene.state = State::resting;
        scene.restLeft_s = static_cast<int>(std::ceil(runner.restLeft_s()));
        return scene;
    case Hold::none:
        break;
    }
    switch (session.stage()) {
    case Stage::ready:
    case Stage::paused:
        scene.state = State::ready;
        break;
    case Stage::starting:
        scene.state = State::starting;
        break;
    case Stage::stimulus:
        scene.state = State::stimulus;
        break;
    case Stage::answering:
        scene.state = State::answering;
        break;
    case Stage::feedback:
        scene.state = State::feedback;
        break;
    case Stage::finished:
        scene.state = State::finished;
        break;
    case Stage::aborted:
        scene.state = State::ended;
        break;
    }
    return scene;
}

study::ConfusionContent StudyScenes::matrix(const StudyController& controller) {
    study::ConfusionContent content;
    const study::StudyTask* task = controller.task();
    if (task == nullptr) {
        content.title = tr("No session is selected");
        return content;
    }
    for (const study::StudyPattern& pattern : task->patterns)
        content.letters << text(pattern.letter);
    content.mode = controller.overview()->head.mode;
    content.matrix = study::ConfusionMatrix(task->patterns.size());
    const QString name = sessionName(controller.overview()->head.protocol, *controller.plan());
    const study::SessionFlow* flow = controller.runner().flow();
    if (flow == nullptr) {
        const SessionOverview* chosen = controller.chosenSession();
        content.title = name;
        if (chosen != nullptr && !chosen->results.empty()) {
            content.matrix = confusionOf(chosen->results, Phase::test, task->patterns.size());
            content.title = tr("%1, test").arg(name);
        }
        return content;
    }
    const Phase phase = phaseNow(*flow);
    content.matrix = confusionOf(flow->results(), phase, task->patterns.size());
    content.title = (phase == Phase::practice ? tr("%1, practice") : tr("%1, test")).arg(name);
    const auto& results = flow->results();
    if (!results.empty() && results.back().planned.phase == phase && results.back().isComplete()) {
        const study::TrialResult& last = results.back();
        content.last = {last.planned.stimulus, last.response.value_or(content.matrix.noneColumn())};
    }
    return content;
}

std::vector<study::AnswerChoice> StudyScenes::choices(const StudyController& controller) {
    std::vector<study::AnswerChoice> choices;
    const study::StudyTask* task = controller.task();
    if (task == nullptr)
        return choices;
    const std::string& condition = task->conditions[controller.plan()->condition];
    const bool hasLevels = task->design != study::Design::identification;
    for (const study::StudyPattern& pattern : task->patterns) {
        study::AnswerChoice choice{text(pattern.letter), displayName(*task, pattern)};
        if (hasLevels) {
            choice.isPattern = false;
            if (task->design == study::Design::yesNo || task->design == study::Design::sameDifferent)
                choice.key = choice.letter.left(1).toUpper();
            choices.push_back(std::move(choice));
            continue;
        }
        const std::string id = study::stimulusId(*task, pattern, condition);
        if (const pattern::Pattern* stimulus = controller.overview()->head.stimuli.find(id))
            choice.diagram = study::diagramOf(*stimulus, controller.overview()->head.protocol.stimulus_s);
        choices.push_back(std::move(choice));
    }
    return choices;
}

} // namespace teleta::console
