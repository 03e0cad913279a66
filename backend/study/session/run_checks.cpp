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

RunCheck passed(RunCheckKind kind, const QString& name, const QString& finding) {
    return {kind, true, name.toStdString(), finding.toStdString(), {}};
}

RunCheck failed(RunCheckKind kind, const QString& name, const QString& finding, const QString& remedy) {
    return {kind, false, name.toStdString(), finding.toStdString(), remedy.toStdString()};
}

RunCheck checkProtocol(const RunConditions& now) {
    constexpr auto kKind = RunCheckKind::protocol;
    const QString name = CheckText::tr("Protocol");
    if (!now.protocol)
        return failed(kKind, name, QString::fromStdString(core::describe(now.protocol.error())),
                      CheckText::tr("Mend the protocol at this place and open it again."));
    const Protocol* protocol = *now.protocol;
    if (protocol == nullptr)
        return failed(kKind, name, CheckText::tr("no protocol is open"),
                      CheckText::tr("Open a protocol, or begin with the paper's."));
    if (protocol->testTrials() == 0 && protocol->practice.repetitions == 0)
        return failed(kKind, name, CheckText::tr("the protocol has no trials"),
                      CheckText::tr("Give practice or test at least one repetition."));
    return passed(kKind, name, QString::fromStdString(protocol->name));
}

RunCheck checkStimuli(const RunConditions& now) {
    constexpr auto kKind = RunCheckKind::stimuli;
    const QString name = CheckText::tr("Stimuli");
    if (!now.missingStimuli.empty()) {
        constexpr std::size_t kNamed = 3;
        QStringList some;
        for (std::size_t i = 0; i < std::min(kNamed, now.missingStimuli.size()); ++i)
            some << QString::fromStdString(now.missingStimuli[i]);
        if (now.missingStimuli.size() > kNamed)
            some << QStringLiteral("\u2026");
        return failed(
            kKind, name, CheckText::tr("there are no patterns %1").arg(some.join(QStringLiteral(", "))),
            CheckText::tr("Make a study whose protocol names a file for each pattern that does not come with "
                          "the program."));
    }
    if (now.stimuliChanged.value_or(false))
        return failed(
            kKind, name, CheckText::tr("the patterns are not those with which this study was begun"),
            CheckText::tr("Go on with version %1 of the program, which began it, or begin a new study.")
                .arg(QString::fromStdString(now.madeBy)));
    return passed(kKind, name,
                  now.stimuliChanged
                      ? CheckText::tr("those with which the study was begun")
                      : CheckText::tr("all there; whether the study was begun with others is not known"));
}

RunCheck checkParticipant(const RunConditions& now) {
    constexpr auto kKind = RunCheckKind::participant;
    const QString name = CheckText::tr("Participant");
    if (now.participant.empty())
        return failed(kKind, name, CheckText::tr("no participant is chosen"),
                      CheckText::tr("Choose a participant, or add a new one."));
    const QString id = QString::fromStdString(now.participant);
    if (now.runner)
        return failed(kKind, name,
                      now.runner->empty() ? CheckText::tr("%1 is in a session already").arg(id)
                                          : CheckText::tr("%1 is in a session already, at %2")
                                                .arg(id, QString::fromStdString(*now.runner)),
                      CheckText::tr("Finish or abort the other session, or choose another participant."));
    if (now.finished)
        return failed(kKind, name, CheckText::tr("%1 has finished this session").arg(id),
                      CheckText::tr("Choose the next session or another participant."));
    return passed(kKind, name, id);
}

RunCheck checkBracelet(const RunConditions& now) {
    constexpr auto kKind = RunCheckKind::bracelet;
    const QString name = CheckText::tr("Bracelet");
    const QString device =
        now.braceletName.empty() ? CheckText::tr("the bracelet") : QString::fromStdString(now.braceletName);
    switch (now.bracelet) {
    case BraceletCondition::missing:
        return failed(kKind, name, CheckText::tr("no bracelet is open"),
                      CheckText::tr("Plug the bracelet in and choose it in the menu Bracelet."));
    case BraceletCondition::notLive:
        return failed(kKind, name, CheckText::tr("%1 does not answer").arg(device),
                      CheckText::tr("Check cable and power supply; it goes on by itself when it is back."));
    case BraceletCondition::stopped:
        return failed(kKind, name, CheckText::tr("STOP is engaged"),
                      CheckText::tr("Release STOP when it is safe."));
    case BraceletCondition::live:
        break;
    }
    if (now.braceletIsSimulated && now.mode == Mode::run)
        return failed(kKind, name, CheckText::tr("%1 is simulated: nobody can feel it").arg(device),
                      CheckText::tr("Choose a real bracelet, or a pilot or simulated study."));
    return passed(kKind, name, device);
}

RunCheck checkFolder(const RunConditions& now) {
    constexpr auto kKind = RunCheckKind::folder;
    const QString name = CheckText::tr("Folder");
    const QString path = QString::fromStdString(now.folder.path);
    if (!now.folder.exists)
        return failed(kKind, name, CheckText::tr("%1 is not there").arg(path),
                      CheckText::tr("Connect the drive of the study, or choose another folder."));
    if (!now.folder.writable)
        return failed(
            kKind, name,
            CheckText::tr("%1 cannot be written: %2").arg(path, QString::fromStdString(now.folder.reason)),
            CheckText::tr("Allow writing to the folder, or choose another one."));
    return passed(kKind, name, path);
}

RunCheck checkSpace(const RunConditions& now) {
    constexpr auto kKind = RunCheckKind::space;
    const QString name = CheckText::tr("Disk space");
    const QString finding = CheckText::tr("%1 MB are free").arg(megabytes(now.folder.free_B));
    if (now.folder.free_B < kNeededSpace_B)
        return failed(kKind, name, finding,
                      CheckText::tr("Free space until there are %1 MB, or choose another folder.")
                          .arg(megabytes(kNeededSpace_B)));
    return passed(kKind, name, finding);
}

RunCheck checkStore(const RunConditions& now) {
    constexpr auto kKind = RunCheckKind::store;
    const QString name = CheckText::tr("Data store");
    if (!now.store)
        return passed(kKind, name, CheckText::tr("ready"));
    return failed(kKind, name, QString::fromStdString(core::describe(*now.store)),
                  now.store->kind == core::ErrorKind::unavailable
                      ? CheckText::tr("Start the server or mend the network; then try again.")
                      : CheckText::tr("Make a copy of the study's folder and open the study again."));
}

RunCheck checkNoise(const RunConditions& now) {
    constexpr auto kKind = RunCheckKind::noise;
    const QString name = CheckText::tr("Masking noise");
    if (now.mode == Mode::simulated)
        return passed(kKind, name, CheckText::tr("not needed: simulated participants hear nothing"));
    const Protocol* protocol = now.protocol ? *now.protocol : nullptr;
    if (protocol != nullptr && protocol->noiseColour == "none")
        return passed(kKind, name, CheckText::tr("the protocol has none"));
    if (!now.noiseConfirmed)
        return failed(
            kKind, name, CheckText::tr("the noise is not confirmed"),
            protocol == nullptr
                ? CheckText::tr("Play the noise, measure its level at the ear, and confirm.")
                : CheckText::tr("Play the noise, measure %1 dBA at the participant's ear, and confirm.")
                      .arg(protocol->noise_dBA));
    return passed(kKind, name, CheckText::tr("confirmed"));
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
    // Some file systems notice that they are full only when the data have to come to the disk.
    folder.writable =
        probe.open() && probe.write("probe") == 5 && probe.flush() && fsync(probe.handle()) == 0;
    if (!folder.writable)
        folder.reason = probe.errorString().toStdString();
    return folder;
}

std::vector<RunCheck> preRunChecks(const RunConditions& conditions) {
    return {checkProtocol(conditions), checkStimuli(conditions), checkParticipant(conditions),
            checkBracelet(conditions), checkFolder(conditions),  checkSpace(conditions),
            checkStore(conditions),    checkNoise(conditions)};
}

bool allPassed(const std::vector<RunCheck>& checks) {
    return std::all_of(checks.begin(), checks.end(), [](const RunCheck& check) { return check.passed; });
}

} // namespace teleta::study
