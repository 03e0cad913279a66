// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/session/run_checks.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QStorageInfo>
#include <QString>
#include <QStringList>
#include <QTemporaryFile>

#include <algorithm>
#include <unistd.h>

namespace teleta::study {

namespace {

struct CheckText {
    Q_DECLARE_TR_FUNCTIONS(StudyChecks)
};

QString megabytes(std::int64_t bytes) {
    return QString::number(bytes / 1'000'000);
}

struct Verdict {
    bool passed = false;
    QString finding;
    QString remedy = {};
};

Verdict passed(const QString& finding) {
    return {true, finding};
}

Verdict failed(const QString& finding, const QString& remedy) {
    return {false, finding, remedy};
}

Verdict checkProtocol(const RunConditions& now) {
    if (!now.protocol)
        return failed(QString::fromStdString(core::describe(now.protocol.error())),
                      CheckText::tr("Correct the protocol at this place and open it again."));
    const Protocol* protocol = *now.protocol;
    if (protocol == nullptr)
        return failed(CheckText::tr("no protocol is open"),
                      CheckText::tr("Open a protocol, or start with the paper's."));
    if (protocol->testTrials() == 0 && protocol->practice.repetitions == 0)
        return failed(CheckText::tr("the protocol has no trials"),
                      CheckText::tr("Give practice or test at least one repetition."));
    return passed(QString::fromStdString(protocol->name));
}

Verdict checkStimuli(const RunConditions& now) {
    if (!now.missingStimuli.empty()) {
        constexpr std::size_t kNamed = 3;
        QStringList some;
        for (std::size_t i = 0; i < std::min(kNamed, now.missingStimuli.size()); ++i)
            some << QString::fromStdString(now.missingStimuli[i]);
        if (now.missingStimuli.size() > kNamed)
            some << QStringLiteral("\u2026");
        return failed(
            CheckText::tr("there are no tactile patterns for %1").arg(some.join(QStringLiteral(", "))),
            CheckText::tr(
                "Create a study whose protocol names a file for each pattern that is not built in."));
    }
    if (now.stimuliChanged.value_or(false))
        return failed(CheckText::tr("the patterns have changed since this study was created"),
                      CheckText::tr("Use version %1 of the program, which created it, or create a new study.")
                          .arg(QString::fromStdString(now.madeBy)));
    // A motor that still turns would be felt in the next interval.
    const Protocol* protocol = now.protocol ? *now.protocol : nullptr;
    for (std::size_t i = 0; protocol != nullptr && now.slowestFall_s && i < protocol->tasks.size(); ++i) {
        const StudyTask& task = protocol->tasks[i];
        if (intervalsOf(task.design, task.levels) > 1 && task.levels.gap_s < *now.slowestFall_s)
            return failed(CheckText::tr("a motor takes %1 s to stop, and the gap between the intervals of "
                                        "%2 is %3 s")
                              .arg(*now.slowestFall_s)
                              .arg(QString::fromStdString(task.name))
                              .arg(task.levels.gap_s),
                          CheckText::tr("Create a study with a longer gap (gap_s)."));
    }
    return passed(
        now.stimuliChanged
            ? CheckText::tr("unchanged since the study was created")
            : CheckText::tr("all there; whether they have changed since the study was created is unknown"));
}

Verdict checkParticipant(const RunConditions& now) {
    if (now.participant.empty())
        return failed(CheckText::tr("no participant is selected"),
                      CheckText::tr("Choose a participant, or add a new one."));
    const QString id = QString::fromStdString(now.participant);
    if (now.runner)
        return failed(now.runner->empty() ? CheckText::tr("%1 is already in a session").arg(id)
                                          : CheckText::tr("%1 is already in a session at %2")
                                                .arg(id, QString::fromStdString(*now.runner)),
                      CheckText::tr("Finish or abort the other session, or choose another participant."));
    if (now.finished)
        return failed(CheckText::tr("%1 has finished this session").arg(id),
                      CheckText::tr("Choose the next session or another participant."));
    return passed(id);
}

Verdict checkBracelet(const RunConditions& now) {
    const QString device =
        now.braceletName.empty() ? CheckText::tr("the bracelet") : QString::fromStdString(now.braceletName);
    switch (now.bracelet) {
    case BraceletCondition::missing:
        return failed(CheckText::tr("no bracelet is open"),
                      CheckText::tr("Plug the bracelet in and choose it in the menu Bracelet."));
    case BraceletCondition::notLive:
        return failed(CheckText::tr("%1 does not answer").arg(device),
                      CheckText::tr("Check cable and power supply; it reconnects by itself."));
    case BraceletCondition::stopped:
        return failed(CheckText::tr("STOP is engaged"), CheckText::tr("Release STOP when it is safe."));
    case BraceletCondition::live:
        break;
    }
    if (now.braceletIsSimulated && now.mode == Mode::run)
        return failed(CheckText::tr("%1 is simulated: nobody can feel it").arg(device),
                      CheckText::tr("Choose a real bracelet, or a pilot or simulated study."));
    return passed(device);
}

Verdict checkFolder(const RunConditions& now) {
    const QString path = QString::fromStdString(now.folder.path);
    if (!now.folder.exists)
        return failed(CheckText::tr("%1 was not found").arg(path),
                      CheckText::tr("Connect the drive of the study, or choose another folder."));
    if (!now.folder.writable)
        return failed(
            CheckText::tr("cannot write to %1: %2").arg(path, QString::fromStdString(now.folder.reason)),
            CheckText::tr("Allow writing to the folder, or choose another one."));
    return passed(path);
}

Verdict checkSpace(const RunConditions& now) {
    const QString finding = CheckText::tr("%1 MB are free").arg(megabytes(now.folder.free_B));
    if (now.folder.free_B < kNeededSpace_B)
        return failed(finding, CheckText::tr("Free up space to at least %1 MB, or choose another folder.")
                                   .arg(megabytes(kNeededSpace_B)));
    return passed(finding);
}

Verdict checkStore(const RunConditions& now) {
    if (!now.store)
        return passed(CheckText::tr("ready"));
    return failed(QString::fromStdString(core::describe(*now.store)),
                  now.store->kind == core::ErrorKind::unavailable
                      ? CheckText::tr("Start the server or repair the network connection, then try again.")
                      : CheckText::tr("Make a copy of the study's folder and open the study again."));
}

Verdict checkNoise(const RunConditions& now) {
    if (now.mode == Mode::simulated)
        return passed(CheckText::tr("not needed: simulated participants hear nothing"));
    const Protocol* protocol = now.protocol ? *now.protocol : nullptr;
    if (protocol != nullptr && protocol->noiseColour == "none")
        return passed(CheckText::tr("the protocol has none"));
    if (!now.noiseConfirmed)
        return failed(
            CheckText::tr("the noise is not confirmed"),
            protocol == nullptr
                ? CheckText::tr("Play the noise, measure its level at the ear, and confirm.")
                : CheckText::tr("Play the noise, measure %1 dBA at the participant's ear, and confirm.")
                      .arg(protocol->noise_dBA));
    return passed(CheckText::tr("confirmed"));
}

Verdict checkTrigger(const TriggerStatus& trigger) {
    switch (trigger.state) {
    case TriggerStatus::State::open:
        return passed(CheckText::tr("ready"));
    case TriggerStatus::State::opening:
        return failed(CheckText::tr("the line is being opened"), CheckText::tr("Wait a moment."));
    case TriggerStatus::State::failed:
        break;
    }
    return failed(trigger.error ? QString::fromStdString(core::describe(*trigger.error))
                                : CheckText::tr("the line cannot be used"),
                  CheckText::tr("Plug the device in and switch it on; it is tried again every second."));
}

/// Passed in any case: a screen saver is a nuisance, and somebody is there.
Verdict checkScreen(const RunConditions& now) {
    if (*now.screenHeld)
        return passed(CheckText::tr("the desktop keeps it on"));
    return {true, CheckText::tr("the desktop may turn it off during the session"),
            CheckText::tr("Turn off the screen saver and energy saving of the desktop for the session.")};
}

} // namespace

FolderCondition lookAtFolder(const std::string& path) {
    FolderCondition folder{path, false, false, {}, 0};
    const QString name = QString::fromStdString(path);
    folder.exists = QFileInfo(name).isDir();
    if (!folder.exists)
        return folder;
    const QStorageInfo storage(name);
    folder.free_B = std::max<qint64>(0, storage.bytesAvailable());
    QTemporaryFile probe(QDir(name).filePath(QStringLiteral(".teleta-probe-XXXXXX")));
    // Some file systems report that they are full only when the data are flushed.
    folder.writable =
        probe.open() && probe.write("probe") == 5 && probe.flush() && fsync(probe.handle()) == 0;
    if (!folder.writable)
        folder.reason = probe.errorString().toStdString();
    return folder;
}

std::vector<RunCheck> preRunChecks(const RunConditions& now) {
    const auto check = [](RunCheckKind kind, const QString& name, const Verdict& verdict) {
        return RunCheck{kind, verdict.passed, name.toStdString(), verdict.finding.toStdString(),
                        verdict.remedy.toStdString()};
    };
    std::vector<RunCheck> checks{
        check(RunCheckKind::protocol, CheckText::tr("Protocol"), checkProtocol(now)),
        check(RunCheckKind::stimuli, CheckText::tr("Stimuli"), checkStimuli(now)),
        check(RunCheckKind::participant, CheckText::tr("Participant"), checkParticipant(now)),
        check(RunCheckKind::bracelet, CheckText::tr("Bracelet"), checkBracelet(now)),
        check(RunCheckKind::folder, CheckText::tr("Folder"), checkFolder(now)),
        check(RunCheckKind::space, CheckText::tr("Disk space"), checkSpace(now)),
        check(RunCheckKind::store, CheckText::tr("Data store"), checkStore(now)),
        check(RunCheckKind::noise, CheckText::tr("Masking noise"), checkNoise(now)),
    };
    if (now.trigger)
        checks.push_back(check(RunCheckKind::trigger, CheckText::tr("Trigger"), checkTrigger(*now.trigger)));
    if (now.screenHeld)
        checks.push_back(check(RunCheckKind::screen, CheckText::tr("Screen"), checkScreen(now)));
    return checks;
}

bool allPassed(const std::vector<RunCheck>& checks) {
    return std::ranges::all_of(checks, &RunCheck::passed);
}

} // namespace teleta::study
