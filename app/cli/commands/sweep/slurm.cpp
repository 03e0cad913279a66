// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/sweep/slurm.h"

#include "backend/core/data/output_file.h"
#include "backend/core/failure.h"

#include <QCoreApplication>
#include <QProcess>
#include <QStandardPaths>
#include <QString>
#include <QStringList>

#include <algorithm>

namespace teleta::cli {

namespace {

constexpr int kSlurmPatience_ms = 60'000;

struct SlurmText {
    Q_DECLARE_TR_FUNCTIONS(Slurm)
};

/// A word of a shell.
QString quotedWord(const std::string& word) {
    QString text = QString::fromStdString(word);
    text.replace(QLatin1Char('\''), QStringLiteral("'\\''"));
    return QLatin1Char('\'') + text + QLatin1Char('\'');
}

/// What a program of Slurm prints on standard output.
core::Expected<QString> outputOf(const QString& program, const QStringList& arguments) {
    const QString path = QStandardPaths::findExecutable(program);
    if (path.isEmpty())
        return core::failed(core::ErrorKind::notFound,
                            SlurmText::tr("the program %1 of Slurm is not there").arg(program),
                            SlurmText::tr("the package slurm-client, or a login node of the cluster"));
    QProcess process;
    process.start(path, arguments, QIODevice::ReadOnly);
    if (!process.waitForFinished(kSlurmPatience_ms)) {
        process.kill();
        process.waitForFinished();
        return core::failed(core::ErrorKind::refused, SlurmText::tr("%1 does not answer").arg(program));
    }
    const QString said = QString::fromLocal8Bit(process.readAllStandardError()).trimmed();
    if (process.exitStatus() != QProcess::NormalExit || process.exitCode() != 0)
        return core::failed(core::ErrorKind::refused, SlurmText::tr("%1 refuses: %2").arg(program, said));
    return QString::fromLocal8Bit(process.readAllStandardOutput());
}

/// "ID" or "ID;CLUSTER".
std::string jobId(const QString& parsable) {
    return parsable.trimmed().section(QLatin1Char(';'), 0, 0).toStdString();
}

QString commandOf(const SlurmJob& job) {
    return quotedWord(job.program) + QStringLiteral(" sweep ") + quotedWord(job.sweepFile) +
           QStringLiteral(" --out ") + quotedWord(job.folder) +
           (job.frames ? QStringLiteral(" --frames npz") : QString());
}

} // namespace

std::string slurmScript(const SlurmJob& job) {
    QString text = QStringLiteral("#!/bin/sh\n"
                                  "#SBATCH --job-name=teleta-sweep\n"
                                  "#SBATCH --array=0-%1\n"
                                  "#SBATCH --cpus-per-task=1\n"
                                  "#SBATCH --requeue\n"
                                  "#SBATCH --open-mode=append\n")
                       .arg(job.tasks - 1);
    for (const std::string& option : job.options)
        text += QStringLiteral("#SBATCH %1\n").arg(QString::fromStdString(option));
    text += QStringLiteral("exec ") + commandOf(job) +
            QStringLiteral(" --workers 1 --task \"$SLURM_ARRAY_TASK_ID\" --tasks %1\n").arg(job.tasks);
    return text.toStdString();
}

core::Expected<SubmittedJob> submitToSlurm(const SlurmJob& job) {
    const QString folder = QString::fromStdString(job.folder);
    const QString script = folder + QStringLiteral("/job.sh");
    TELETA_CHECK(core::writeFile(script.toStdString(), slurmScript(job)));
    TELETA_CHECK(core::makeFolder(job.folder + "/log"));
    SubmittedJob submitted;
    TELETA_TRY(const QString array,
               outputOf(QStringLiteral("sbatch"),
                        {QStringLiteral("--parsable"), QStringLiteral("--chdir"), folder,
                         QStringLiteral("--output"), folder + QStringLiteral("/log/task-%a.txt"), script}));
    submitted.array = jobId(array);
    QStringList merge{QStringLiteral("--parsable"),
                      QStringLiteral("--job-name=teleta-merge"),
                      QStringLiteral("--requeue"),
                      QStringLiteral("--dependency=afterany:%1").arg(QString::fromStdString(submitted.array)),
                      QStringLiteral("--chdir"),
                      folder,
                      QStringLiteral("--output"),
                      folder + QStringLiteral("/log/merge.txt")};
    for (const std::string& option : job.options)
        merge << QString::fromStdString(option);
    merge << QStringLiteral("--wrap")
          << commandOf(job) + QStringLiteral(" --merge --allow-failed %1").arg(job.allowFailed);
    TELETA_TRY(const QString merged, outputOf(QStringLiteral("sbatch"), merge));
    submitted.merge = jobId(merged);
    return submitted;
}

core::Expected<std::uint64_t> tasksInSlurm(const std::vector<std::string>& jobs) {
    // All jobs of this user: Slurm refuses to speak of a job that it has forgotten.
    TELETA_TRY(const QString text, outputOf(QStringLiteral("squeue"),
                                            {QStringLiteral("--noheader"), QStringLiteral("--array"),
                                             QStringLiteral("--me"), QStringLiteral("--format=%A %F")}));
    std::uint64_t tasks = 0;
    for (const QString& line : text.split(QLatin1Char('\n'), Qt::SkipEmptyParts)) {
        const QStringList ids = line.split(QLatin1Char(' '), Qt::SkipEmptyParts);
        tasks += std::ranges::any_of(ids,
                                     [&](const QString& id) {
                                         return std::ranges::find(jobs, id.toStdString()) != jobs.end();
                                     })
                     ? 1
                     : 0;
    }
    return tasks;
}

} // namespace teleta::cli
