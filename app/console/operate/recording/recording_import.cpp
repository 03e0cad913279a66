// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/operate/recording/recording_import.h"

#include "app/console/sources/known_array.h"
#include "app/sources/recording_request.h"
#include "backend/core/failure.h"
#include "backend/frames/recorded/frame_import.h"

#include <QDir>
#include <QFileInfo>
#include <QStringList>

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>

namespace teleta::console {

RecordingImport::RecordingImport(QWidget* window)
    : m_window(window) {
    m_timer.setInterval(kProgressLook_ms);
    connect(&m_timer, &QTimer::timeout, this, &RecordingImport::look);
}

RecordingImport::~RecordingImport() {
    for (const Job& job : m_jobs)
        job.progress->cancelled = true;
    for (const Job& job : m_jobs) {
        job.result.wait();
        delete job.dialog;
    }
}

QString RecordingImport::recordingOf(const QString& file, const QString& otherFolder) {
    const QFileInfo info(file);
    const QString own = info.absolutePath();
    return QDir(QFileInfo(own).isWritable() ? own : otherFolder)
        .filePath(info.completeBaseName() + QStringLiteral(".teleta"));
}

QString RecordingImport::freeName(const QString& recording) {
    const QFileInfo info(recording);
    QString name = recording;
    for (int number = 2; QFileInfo::exists(name); ++number)
        name = info.dir().filePath(
            QStringLiteral("%1-%2.%3").arg(info.completeBaseName()).arg(number).arg(info.suffix()));
    return name;
}

void RecordingImport::start(const QString& file, const QString& recording,
                            const frames::FrameRequest& request) {
    const auto isSame = [&](const Job& job) { return job.recording == recording; };
    if (std::any_of(m_jobs.begin(), m_jobs.end(), isSame)) {
        emit failed(file, core::Error{core::ErrorKind::refused,
                                      tr("a recording of this name is being made").toStdString(),
                                      {},
                                      {recording.toStdString()}});
        return;
    }
    auto progress = std::make_shared<WorkProgress>();
    auto* dialog = progressWindow(tr("Importing %1\u2026", "a file").arg(QFileInfo(file).fileName()),
                                  progress, m_window);
    auto result = std::async(std::launch::async, [file, recording, request, progress] {
        return make(file, recording, request, *progress);
    });
    m_jobs.push_back({file, recording, std::move(progress), std::move(result), dialog});
    m_timer.start();
}

RecordingImport::Result RecordingImport::make(const QString& file, const QString& recording,
                                              const frames::FrameRequest& request, WorkProgress& progress) {
    const QString folder = QFileInfo(recording).absolutePath();
    if (QFileInfo::exists(file) && !QDir().mkpath(folder))
        return core::failed(core::ErrorKind::ioFailed, tr("the folder cannot be made"), {},
                            {folder.toStdString()});
    if (!app::isMcapName(file)) {
        frames::FrameRequest known = request;
        known.path = file.toStdString();
        return makeOfFrames(recording, std::move(known), progress);
    }
    TELETA_TRY(const auto import, mcap::importMcap(file.toStdString(), recording.toStdString(),
                                                   {.goOn = [&progress](double share) {
                                                       progress.share = share;
                                                       return !progress.cancelled;
                                                   }}));
    return missing(import);
}

RecordingImport::Result RecordingImport::makeOfFrames(const QString& recording, frames::FrameRequest request,
                                                      WorkProgress& progress) {
    TELETA_TRY(request, withKnownArray(std::move(request)));
    request.guessesShape = true;
    TELETA_TRY(auto reader, frames::FrameReader::open(request, [&progress] { return !progress.cancelled; }));
    const std::optional<double> threshold =
        request.threshold ? request.threshold : frames::usualThreshold(reader.unit());
    if (!threshold)
        return core::failed(core::ErrorKind::badInput,
                            tr("the loads are in %1, a unit without a usual threshold")
                                .arg(QString::fromStdString(reader.unit())),
                            tr("in \u201cIn contact from\u201d, from how many %1 a taxel is in contact")
                                .arg(QString::fromStdString(reader.unit())),
                            {request.path});
    frames::FrameImportOptions options;
    options.settings.features.threshold_N = options.settings.segmentation.threshold_N = *threshold;
    options.goOn = [&progress](double share) {
        progress.share = share;
        return !progress.cancelled;
    };
    TELETA_CHECK(frames::importFrames(std::move(reader), request.path, recording.toStdString(), options));
    return QString();
}

QString RecordingImport::missing(const mcap::McapImport& import) {
    QStringList parts;
    QStringList left;
    std::uint64_t bad = import.badRecords;
    for (const mcap::McapImport::Topic& topic : import.topics) {
        bad += topic.bad;
        if (!topic.isKept)
            left << QString::fromStdString(topic.name);
    }
    if (!left.isEmpty())
        parts << tr("Topics that cannot be read were left out: %1.").arg(left.join(QStringLiteral(", ")));
    if (!import.isComplete)
        parts << tr("The file was cut off; what could be read is there.");
    if (import.badChunks > 0)
        parts << tr("%n damaged chunk(s) left out.", nullptr, static_cast<int>(import.badChunks));
    if (bad > 0)
        parts << tr("%n damaged message(s) left out.", nullptr, static_cast<int>(bad));
    if (import.isDataSectionDamaged)
        parts << tr("The checksum of the file is wrong: it was damaged somewhere.");
    return parts.join(QLatin1Char(' '));
}

void RecordingImport::look() {
    std::vector<Job> done;
    for (std::size_t i = 0; i < m_jobs.size();) {
        Job& job = m_jobs[i];
        if (job.result.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
            done.push_back(std::move(job));
            m_jobs.erase(m_jobs.begin() + static_cast<std::ptrdiff_t>(i));
            continue;
        }
        showProgress(*job.dialog, *job.progress);
        ++i;
    }
    if (m_jobs.empty())
        m_timer.stop();
    for (Job& job : done)
        finish(std::move(job));
}

void RecordingImport::finish(Job job) {
    job.dialog->deleteLater();
    const Result result = job.result.get();
    if (result)
        emit imported(job.file, job.recording, *result);
    else if (result.error().kind == core::ErrorKind::cancelled)
        emit cancelled(job.file);
    else
        emit failed(job.file, result.error());
}

} // namespace teleta::console
