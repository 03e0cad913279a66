// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/operate/recording/recording_files.h"

#include "app/console/sources/frame_dialog.h"
#include "app/console/sources/recording_dialog.h"
#include "widgets/base/background.h"

#include <QDir>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <QStandardPaths>

#include <string>
#include <utility>
#include <vector>

namespace teleta::console {

namespace {

/// Without the folder, which makes the sentence long.
QString reasonOf(core::Error error) {
    error.where.file = QFileInfo(QString::fromStdString(error.where.file)).fileName().toStdString();
    return QString::fromStdString(core::describe(error));
}

} // namespace

RecordingFiles::RecordingFiles(SourceManager& sources, ConsoleSettings& settings, QWidget* window)
    : QObject(window)
    , m_sources(sources)
    , m_settings(settings)
    , m_window(window)
    , m_import(window) {
    connect(&m_import, &RecordingImport::imported, this,
            [this](const QString& file, const QString& recording, const QString& missing) {
                emit imported(file, recording, missing);
                play(recording);
            });
    connect(&m_import, &RecordingImport::cancelled, this, &RecordingFiles::cancelled);
    connect(&m_import, &RecordingImport::failed, this, &RecordingFiles::onNotImported);
}

void RecordingFiles::open(const QString& path) {
    if (app::isRecordingName(path)) {
        play(path);
        return;
    }
    if (app::isImported(path)) {
        import(path);
        return;
    }
    base::runInBackground(
        this,
        [path] { return std::pair(app::guessCsv(path.toStdString()), frames::familyOf(path.toStdString())); },
        [this, path](const std::pair<core::Expected<app::CsvRequest>, std::string>& found) {
            const auto& [guess, family] = found;
            if (guess)
                askHow(*guess);
            else if (guess.error().kind == core::ErrorKind::badInput)
                // a table of another program
                import(path, m_settings.frameRequest(family).value_or(frames::FrameRequest()));
            else
                emit failed(QFileInfo(path).fileName(), guess.error());
        });
}

void RecordingFiles::reopen(const QString& path) {
    if (const auto known = m_settings.recording(path))
        m_sources.open(*known);
    else
        open(path);
}

QString RecordingFiles::folder(const QString& otherwise) const {
    QString folder = otherwise;
    for (const QString& path : m_settings.recentFiles()) {
        if (app::isPlayable(path)) {
            folder = QFileInfo(path).absolutePath();
            break;
        }
    }
    // A dialog would show the working directory in place of a folder that is missing.
    while (!QFileInfo(folder).isDir() && folder != QFileInfo(folder).absolutePath())
        folder = QFileInfo(folder).absolutePath();
    return folder;
}

QString RecordingFiles::usualFolder() {
    return QDir(QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation))
        .filePath(QStringLiteral("TeleTA"));
}

void RecordingFiles::openAs(const RecordingArguments& recording) {
    if (app::isRecordingName(recording.path) || app::isImported(recording.path)) {
        open(recording.path);
        return;
    }
    base::runInBackground(
        this, [recording] { return completeRecording(recording); },
        [this, name = QFileInfo(recording.path).fileName()](core::Expected<app::CsvRequest> request) {
            if (request)
                m_sources.open(*request);
            else
                emit failed(name, request.error());
        });
}

void RecordingFiles::play(const QString& path) {
    base::runInBackground(
        this, [path] { return app::recordingRequestsOf(path.toStdString()); },
        [this, path](core::Expected<std::vector<app::RecordingRequest>> requests) {
            if (!requests) {
                emit failed(QFileInfo(path).fileName(), requests.error());
                return;
            }
            for (const app::RecordingRequest& request : *requests)
                m_sources.open(request);
            emit opened(path);
        });
}

void RecordingFiles::onNotImported(const QString& file, const core::Error& error) {
    if (!app::isMcapName(file) && error.kind == core::ErrorKind::badInput)
        askFrames(file, reasonOf(error));
    else
        emit failed(QFileInfo(file).fileName(), error);
}

void RecordingFiles::askFrames(const QString& file, const QString& why) {
    base::runInBackground(
        this, [file] { return frames::familyOf(file.toStdString()); },
        [this, file, why](const std::string& family) { askFrames(file, why, family); });
}

void RecordingFiles::askFrames(const QString& file, const QString& why, const std::string& family) {
    frames::FrameRequest known = m_settings.frameRequest(family).value_or(frames::FrameRequest());
    known.path = file.toStdString();
    auto* dialog = new FrameDialog(known, why, m_window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog, file, family, isChange = why.isEmpty()] {
        m_settings.setFrameRequest(family, dialog->request());
        if (isChange)
            m_import.start(file, RecordingImport::freeName(recordingOf(file)), dialog->request());
        else
            import(file, dialog->request());
    });
    connect(dialog, &QDialog::rejected, this, [this, file] { emit cancelled(file); });
    dialog->open();
}

QString RecordingFiles::recordingOf(const QString& file) const {
    const QString chosen = m_settings.recordingFolder();
    return RecordingImport::recordingOf(file, chosen.isEmpty() ? usualFolder() : chosen);
}

void RecordingFiles::import(const QString& file, const frames::FrameRequest& request) {
    const QString recording = recordingOf(file);
    if (QFileInfo::exists(file) && QFileInfo::exists(recording))
        askWhether(file, recording, request);
    else
        m_import.start(file, recording, request);
}

void RecordingFiles::askWhether(const QString& file, const QString& recording,
                                const frames::FrameRequest& request) {
    const QString another = RecordingImport::freeName(recording);
    auto* box = new QMessageBox(QMessageBox::Question, tr("Open file"),
                                tr("%1 is there already.", "a file").arg(QFileInfo(recording).fileName()),
                                QMessageBox::Cancel, m_window);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setInformativeText(
        tr("It may have been made from %1 before. Importing the file again makes %2.", "two files")
            .arg(QFileInfo(file).fileName(), QFileInfo(another).fileName()));
    auto* open = box->addButton(tr("&Open the recording"), QMessageBox::AcceptRole);
    auto* again = box->addButton(tr("&Import again"), QMessageBox::ActionRole);
    auto* change = app::isMcapName(file)
                       ? nullptr
                       : box->addButton(tr("Import with other &choices\u2026"), QMessageBox::ActionRole);
    if (change != nullptr)
        change->setObjectName(QStringLiteral("importOtherwise"));
    open->setObjectName(QStringLiteral("openRecording"));
    again->setObjectName(QStringLiteral("importAgain"));
    box->setDefaultButton(open);
    connect(box, &QDialog::finished, this,
            [this, box, open, again, change, file, recording, another, request] {
                if (box->clickedButton() == again) {
                    m_import.start(file, another, request);
                } else if (change != nullptr && box->clickedButton() == change) {
                    askFrames(file, {});
                } else {
                    emit cancelled(file);
                    if (box->clickedButton() == open)
                        play(recording);
                }
            });
    box->open();
}

void RecordingFiles::askHow(const app::CsvRequest& guess) {
    const QString path = QString::fromStdString(guess.path);
    const auto known = m_settings.recording(path);
    const bool fits = known && known->layout.taxels() == guess.layout.taxels();
    auto* dialog = new RecordingDialog(fits ? *known : guess, m_window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog, path] {
        const app::CsvRequest request = dialog->request();
        m_settings.setRecording(request);
        m_sources.open(request);
        emit opened(path);
    });
    dialog->open();
}

} // namespace teleta::console
