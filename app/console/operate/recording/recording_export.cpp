// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/operate/recording/recording_export.h"

#include "backend/mcap/recorded/mcap_export.h"
#include "backend/recording/recording.h"
#include "widgets/base/file_dialog.h"

#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QProgressDialog>

#include <chrono>
#include <utility>

namespace teleta::console {

RecordingExport::RecordingExport(QWidget* window)
    : m_window(window) {
    m_timer.setInterval(kProgressLook_ms);
    connect(&m_timer, &QTimer::timeout, this, &RecordingExport::look);
}

RecordingExport::~RecordingExport() {
    if (m_progress)
        m_progress->cancelled = true;
    if (m_result.valid())
        m_result.wait();
}

void RecordingExport::ask(const QString& suggested) {
    QFileDialog* dialog = base::askToOpen(m_window,
                                          {.title = tr("Export recording as CSV"),
                                           .filters = {tr("Recordings (*.teleta)")},
                                           .folder = QFileInfo(suggested).path()},
                                          [this](const QString& path) { askForFolder(path); });
    dialog->setLabelText(QFileDialog::Accept, tr("Export…"));
    dialog->selectFile(suggested);
}

void RecordingExport::askForFolder(const QString& path) {
    const base::FileQuestion question{.title = tr("Folder for the CSV files"),
                                      .folder = QFileInfo(path).absolutePath()};
    QFileDialog* dialog = base::askForFolder(m_window, question, [this, path](const QString& chosen) {
        // A folder of its own: several recordings have streams of the same names.
        start(path, chosen + QLatin1Char('/') + QFileInfo(path).completeBaseName());
    });
    dialog->setLabelText(QFileDialog::Accept, tr("Export here"));
}

void RecordingExport::askMcap(const QString& suggested) {
    QFileDialog* dialog =
        base::askToOpen(m_window,
                        {.title = tr("Export recording as MCAP"),
                         .filters = {tr("Recordings (*.teleta)")},
                         .folder = QFileInfo(suggested).path()},
                        [this](const QString& path) {
                            const QFileInfo recording(path);
                            base::askToSave(m_window,
                                            {.title = tr("MCAP file"),
                                             .filters = {tr("MCAP files (*.mcap)")},
                                             .folder = recording.absolutePath(),
                                             .suffix = QStringLiteral("mcap"),
                                             .name = recording.completeBaseName() + QStringLiteral(".mcap")},
                                            [this, path](const QString& file) { startMcap(path, file); });
                        });
    dialog->setLabelText(QFileDialog::Accept, tr("Export…"));
    dialog->selectFile(suggested);
}

void RecordingExport::start(const QString& path, const QString& folder) {
    begin(path, folder, &RecordingExport::write);
}

void RecordingExport::startMcap(const QString& path, const QString& file) {
    begin(path, file, &RecordingExport::writeMcap);
}

void RecordingExport::begin(const QString& path, const QString& target, Work work) {
    if (isBusy()) {
        emit failed(QFileInfo(path).fileName(), core::Error{core::ErrorKind::refused,
                                                            tr("another export is running").toStdString(),
                                                            {},
                                                            {path.toStdString()}});
        return;
    }
    m_path = path;
    m_folder = target;
    m_isMcap = work == &RecordingExport::writeMcap;
    m_progress = std::make_shared<Progress>();
    m_progress->utc = m_utc;
    m_result = std::async(std::launch::async,
                          [work, progress = m_progress, path = path.toStdString(),
                           target = target.toStdString()] { return work(path, target, *progress); });
    m_dialog = progressWindow(tr("Exporting %1\u2026", "a file").arg(QFileInfo(path).fileName()), m_progress,
                              m_window);
    m_timer.start();
    emit busyChanged(true);
}

RecordingExport::Result RecordingExport::write(const std::string& path, const std::string& folder,
                                               Progress& progress) {
    const auto recording = recording::Recording::open(path);
    TELETA_CHECK(recording);
    progress.isComplete = recording->isComplete();
    progress.isNewFolder = !QFileInfo::exists(QString::fromStdString(folder));
    recording::ExportOptions options;
    options.utc = progress.utc;
    options.goOn = [&](double frames, double all) {
        progress.share = all > 0.0 ? frames / all : 0.0;
        return !progress.cancelled;
    };
    Result files = recording::exportCsv(*recording, folder, options);
    // What was cancelled in time has left nothing.
    const bool isStopped = !files && files.error().kind == core::ErrorKind::cancelled;
    return isStopped ? Result() : files;
}

RecordingExport::Result RecordingExport::writeMcap(const std::string& path, const std::string& file,
                                                   Progress& progress) {
    const auto recording = recording::Recording::open(path);
    TELETA_CHECK(recording);
    progress.isComplete = recording->isComplete();
    mcap::McapExportOptions options;
    options.overwrite = true; // the dialog has asked
    options.goOn = [&](double frames, double all) {
        progress.share = all > 0.0 ? frames / all : 0.0;
        return !progress.cancelled;
    };
    const auto written = mcap::exportMcap(*recording, file, options);
    if (!written && written.error().kind == core::ErrorKind::cancelled)
        return Result();
    TELETA_CHECK(written);
    return std::vector<recording::ExportedFile>{{file, 0, written->damagedBlocks}};
}

void RecordingExport::discard(const std::vector<recording::ExportedFile>& files, const std::string& folder,
                              bool isNewFolder) {
    for (const recording::ExportedFile& file : files)
        QFile::remove(QString::fromStdString(file.path));
    if (isNewFolder)
        QDir().rmdir(QString::fromStdString(folder));
}

void RecordingExport::look() {
    if (m_result.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
        showProgress(*m_dialog, *m_progress);
        return;
    }
    const Result result = m_result.get();
    if (m_progress->cancelled && result && !result->empty()) {
        // It was whole before that was seen.
        m_result = std::async(std::launch::async, [files = *result, folder = m_folder.toStdString(),
                                                   isNewFolder = m_progress->isNewFolder] {
            discard(files, folder, isNewFolder);
            return Result();
        });
        return;
    }
    m_timer.stop();
    std::exchange(m_dialog, nullptr)->deleteLater();
    emit busyChanged(false);
    if (!result) {
        emit failed(QFileInfo(m_path).fileName(), result.error());
        return;
    }
    if (result->empty())
        return;
    std::uint64_t damaged = 0;
    for (const recording::ExportedFile& file : *result)
        damaged += file.damagedBlocks;
    if (m_isMcap) {
        emit finishedMcap(m_folder, static_cast<int>(damaged), m_progress->isComplete);
        return;
    }
    emit finished(m_folder, static_cast<int>(result->size()), static_cast<int>(damaged),
                  m_progress->isComplete);
}

} // namespace teleta::console
