// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/operate/recording_controls.h"

#include "app/console/operate/operate_page.h"
#include "app/console/operate/recording/mark_views.h"
#include "app/console/operate/recording/recording_files.h"
#include "app/console/operate/site/site_views.h"
#include "backend/core/steady_time.h"
#include "widgets/base/file_dialog.h"
#include "widgets/base/redo_keys.h"
#include "widgets/base/shown_path.h"
#include "widgets/chrome/recording_indicator.h"

#include <QAction>
#include <QDesktopServices>
#include <QDir>
#include <QFileInfo>
#include <QMenu>
#include <QStringList>
#include <QUrl>

#include <variant>

namespace teleta::console {

RecordingControls::RecordingControls(RecordingService& service, SourceManager& sources, OperatePage& page,
                                     ConsoleSettings& settings, QWidget* window)
    : QObject(window)
    , m_service(service)
    , m_sources(sources)
    , m_page(page)
    , m_settings(settings)
    , m_window(window)
    , m_export(window)
    , m_indicator(new chrome::RecordingIndicator(window))
    , m_record(new QAction(this))
    , m_mark(new QAction(this))
    , m_playLast(new QAction(this))
    , m_folder(new QAction(this))
    , m_csv(new QAction(this))
    , m_mcap(new QAction(this))
    , m_undo(new QAction(this))
    , m_redo(new QAction(this)) {
    m_record->setShortcut(Qt::CTRL | Qt::Key_R);
    m_mark->setShortcut(Qt::Key_M);
    m_undo->setShortcut(QKeySequence::Undo);
    m_redo->setShortcuts(base::redoKeys());
    // Other pages have an undo of their own.
    for (QAction* action : {m_undo, m_redo}) {
        action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
        m_page.addAction(action);
    }
    connect(&m_page.siteViews(), &SiteViews::happened, this,
            [this](std::int64_t time_ns, const QString& text) {
                m_service.add({time_ns, "site", text.toStdString(), 0.0});
            });
    connect(m_record, &QAction::triggered, this, &RecordingControls::toggle);
    connect(m_mark, &QAction::triggered, this, [this] { mark(core::steadyNow_ns()); });
    m_playLast->setEnabled(false);
    connect(m_playLast, &QAction::triggered, this, [this] { emit playRequested(m_last); });
    connect(m_folder, &QAction::triggered, this, &RecordingControls::askForFolder);
    connect(m_csv, &QAction::triggered, this, [this] {
        m_export.setUtc(m_settings.exportsUtc());
        m_export.ask(suggestedForExport());
    });
    connect(m_mcap, &QAction::triggered, this, [this] { m_export.askMcap(suggestedForExport()); });
    connect(&m_export, &RecordingExport::busyChanged, m_csv, &QAction::setDisabled);
    connect(&m_export, &RecordingExport::busyChanged, m_mcap, &QAction::setDisabled);
    connect(&m_export, &RecordingExport::finished, this,
            [this](const QString& folder, int files, int damaged, bool complete) {
                onExported(tr("%n file(s) were written to %1.", nullptr, files).arg(base::fromHome(folder)),
                           damaged, complete, folder);
            });
    connect(&m_export, &RecordingExport::finishedMcap, this,
            [this](const QString& file, int damaged, bool complete) {
                onExported(tr("%1 was written.", "a file").arg(QFileInfo(file).fileName()), damaged, complete,
                           file);
            });
    connect(&m_export, &RecordingExport::failed, this, [this](const QString& name, const core::Error& error) {
        m_page.messages().post(
            {chrome::Message::Severity::error, tr("%1 could not be exported.", "a file").arg(name),
             tr("Choose another recording or folder."), QString::fromStdString(core::describe(error))});
    });
    connect(m_undo, &QAction::triggered, &m_service.marks().undoStack(), &QUndoStack::undo);
    connect(m_redo, &QAction::triggered, &m_service.marks().undoStack(), &QUndoStack::redo);
    connect(&m_service.marks().undoStack(), &QUndoStack::canUndoChanged, m_undo, &QAction::setEnabled);
    connect(&m_service.marks().undoStack(), &QUndoStack::canRedoChanged, m_redo, &QAction::setEnabled);
    m_undo->setEnabled(false);
    m_redo->setEnabled(false);
    connect(m_indicator, &chrome::RecordingIndicator::toggleRequested, this, &RecordingControls::toggle);
    connect(m_indicator, &chrome::RecordingIndicator::markRequested, this,
            [this] { mark(core::steadyNow_ns()); });
    connect(&m_service, &RecordingService::stateChanged, this, &RecordingControls::update);
    connect(&m_service, &RecordingService::failed, this, &RecordingControls::onFailed);
    connect(&m_service, &RecordingService::finished, this, [this](const QString& path) {
        m_last = path;
        m_playLast->setEnabled(true);
        m_page.messages().post(
            {chrome::Message::Severity::information,
             tr("%1 was recorded.", "a file").arg(QFileInfo(path).fileName()),
             QString(),
             path,
             {{tr("Play it"), [this, path] { emit playRequested(path); }}, showInFolder(path)}});
    });
    connect(&m_service.marks(), &RecordingMarks::notKept, this, [this](const core::Error& error) {
        m_page.messages().post({chrome::Message::Severity::error,
                                tr("The marks of %1 could not be changed.", "a file")
                                    .arg(QFileInfo(QString::fromStdString(error.where.file)).fileName()),
                                tr("Close whatever else uses the file. It is tried again with the next "
                                   "change of a mark, and when the program ends."),
                                QString::fromStdString(core::describe(error))});
    });
    MarkViews& marks = m_page.marks();
    connect(&m_service.marks(), &RecordingMarks::changed, this,
            [this, &marks] { marks.setRecorded(m_service.marks().all(), m_service.isRecording()); });
    connect(&marks, &MarkViews::markRequested, this, &RecordingControls::mark);
    connect(&marks.list(), &MarkList::renamed, &m_service.marks(), &RecordingMarks::rename);
    connect(&marks.list(), &MarkList::removed, &m_service.marks(), &RecordingMarks::remove);
    update();
}

void RecordingControls::fill(QMenu& menu) {
    update();
    menu.addAction(m_record);
    menu.addAction(m_mark);
    menu.addAction(m_playLast);
    menu.addAction(m_folder);
    menu.addSeparator();
    menu.addAction(m_csv);
    menu.addAction(m_mcap);
}

void RecordingControls::toggle() {
    if (m_service.state() == RecordingService::State::idle)
        m_service.start(QDir(folder()).filePath(m_service.suggestedName()));
    else
        stop();
}

void RecordingControls::stop() {
    m_page.marks().list().finishEditing();
    m_service.stop();
}

void RecordingControls::mark(std::int64_t time_ns) {
    m_page.marks().list().finishEditing();
    if (m_service.isRecording())
        m_service.marks().add(time_ns);
    else
        m_page.messages().post({chrome::Message::Severity::information, tr("Nothing is recorded now."),
                                tr("Marks are kept in a recording. Ctrl+R begins one."), QString()});
}

QString RecordingControls::folder() const {
    const QString known = m_settings.recordingFolder();
    return known.isEmpty() ? RecordingFiles::usualFolder() : known;
}

void RecordingControls::onExported(const QString& text, int damaged, bool complete, const QString& place) {
    QStringList missing;
    if (damaged > 0)
        missing << tr("%n damaged block(s) left out.", nullptr, damaged);
    if (!complete)
        missing << tr("The recording was cut off; what had been written is there.");
    m_page.messages().post(
        {missing.isEmpty() ? chrome::Message::Severity::information : chrome::Message::Severity::warning,
         text,
         missing.join(QLatin1Char(' ')),
         place,
         {showInFolder(place)}});
}

chrome::Message::Action RecordingControls::showInFolder(const QString& place) {
    return {tr("Show in folder"), [place] {
                const QFileInfo file(place);
                const QString folder = file.isDir() ? place : file.absolutePath();
                QDesktopServices::openUrl(QUrl::fromLocalFile(folder));
            }};
}

QString RecordingControls::suggestedForExport() {
    const auto* shown = m_sources.active();
    const auto* played = shown != nullptr ? std::get_if<app::RecordingRequest>(&shown->request) : nullptr;
    const QString last = m_service.path();
    if (played != nullptr)
        return QString::fromStdString(played->path);
    return last.isEmpty() ? folder() + QLatin1Char('/') : last;
}

void RecordingControls::askForFolder() {
    base::askForFolder(m_window, {.title = tr("Folder of the recordings"), .folder = folder()},
                       [this](const QString& path) { m_settings.setRecordingFolder(path); });
}

void RecordingControls::tick() {
    m_service.tick();
    using State = chrome::RecordingReading::State;
    chrome::RecordingReading reading;
    switch (m_service.state()) {
    case RecordingService::State::idle:
        break;
    case RecordingService::State::starting:
        reading.state = State::starting;
        break;
    case RecordingService::State::recording:
        reading.state = State::recording;
        break;
    case RecordingService::State::stopping:
        reading.state = State::stopping;
        break;
    }
    reading.duration_s = m_service.status().duration_s;
    reading.bytes = m_service.status().bytes;
    reading.lost = m_service.status().dropped;
    if (m_service.state() != RecordingService::State::idle)
        m_problem.clear();
    reading.problem = m_problem;
    m_indicator->setReading(reading);
}

void RecordingControls::update() {
    const bool recording = m_service.isRecording();
    m_record->setText(recording ? tr("End the &recording") : tr("&Record"));
    m_record->setEnabled(recording || m_service.state() == RecordingService::State::idle);
    m_mark->setText(tr("&Mark this moment"));
    m_mark->setEnabled(recording);
    m_playLast->setText(tr("Play the &last recording"));
    m_folder->setText(tr("&Folder of the recordings\u2026"));
    m_csv->setText(tr("&Export recording as CSV\u2026"));
    m_mcap->setText(tr("Ex&port recording as MCAP\u2026"));
    m_undo->setText(tr("&Undo"));
    m_redo->setText(tr("&Redo"));
    m_page.marks().setRecorded(m_service.marks().all(), recording);
}

void RecordingControls::onFailed(const core::Error& error, bool begun) {
    const QString details = QString::fromStdString(core::describe(error));
    // The messages below are on the page Operate; the indicator is on all pages.
    m_problem = details;
    if (begun)
        m_page.messages().post(
            {chrome::Message::Severity::error,
             tr("The recording ended: %1.").arg(QString::fromStdString(error.message)),
             tr("What was recorded until then can be opened: %1").arg(QFileInfo(m_service.path()).fileName()),
             details});
    else
        m_page.messages().post({chrome::Message::Severity::error, tr("The recording could not begin."),
                                tr("Choose another folder in the menu Recording."), details});
}

} // namespace teleta::console
