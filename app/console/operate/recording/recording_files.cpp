// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/operate/recording/recording_files.h"

#include "app/console/sources/recording_dialog.h"
#include "widgets/base/background.h"

#include <QFileInfo>

#include <vector>

namespace teleta::console {

RecordingFiles::RecordingFiles(SourceManager& sources, ConsoleSettings& settings, QWidget* window)
    : QObject(window)
    , m_sources(sources)
    , m_settings(settings)
    , m_window(window) {
}

void RecordingFiles::open(const QString& path) {
    if (isRecordingName(path)) {
        play(path);
        return;
    }
    base::runInBackground(
        this, [path] { return guessCsv(path.toStdString()); },
        [this, path](core::Expected<CsvRequest> guess) {
            if (guess)
                askHow(*guess);
            else
                emit failed(QFileInfo(path).fileName(), guess.error());
        });
}

QString RecordingFiles::folder(const QString& otherwise) const {
    QString folder = otherwise;
    for (const QString& path : m_settings.recentFiles()) {
        if (isRecordingName(path) || path.endsWith(QLatin1String(".csv"), Qt::CaseInsensitive)) {
            folder = QFileInfo(path).absolutePath();
            break;
        }
    }
    // A dialog would show the working directory in place of a folder that is missing.
    while (!QFileInfo(folder).isDir() && folder != QFileInfo(folder).absolutePath())
        folder = QFileInfo(folder).absolutePath();
    return folder;
}

void RecordingFiles::openAs(const RecordingArguments& recording) {
    if (isRecordingName(recording.path)) {
        play(recording.path);
        return;
    }
    base::runInBackground(
        this, [recording] { return completeRecording(recording); },
        [this, name = QFileInfo(recording.path).fileName()](core::Expected<CsvRequest> request) {
            if (request)
                m_sources.open(*request);
            else
                emit failed(name, request.error());
        });
}

void RecordingFiles::play(const QString& path) {
    base::runInBackground(
        this, [path] { return recordingRequestsOf(path.toStdString()); },
        [this, path](core::Expected<std::vector<RecordingRequest>> requests) {
            if (!requests) {
                emit failed(QFileInfo(path).fileName(), requests.error());
                return;
            }
            for (const RecordingRequest& request : *requests)
                m_sources.open(request);
            emit opened(path);
        });
}

void RecordingFiles::askHow(const CsvRequest& guess) {
    const QString path = QString::fromStdString(guess.path);
    const auto known = m_settings.recording(path);
    const bool fits = known && known->layout.taxels() == guess.layout.taxels();
    auto* dialog = new RecordingDialog(fits ? *known : guess, m_window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog, path] {
        const CsvRequest request = dialog->request();
        m_settings.setRecording(request);
        m_sources.open(request);
        emit opened(path);
    });
    dialog->open();
}

} // namespace teleta::console
