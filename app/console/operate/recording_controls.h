// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/base/console_settings.h"
#include "app/console/operate/recording/recording_export.h"
#include "app/console/operate/recording/recording_service.h"
#include "widgets/chrome/message_bar.h"

#include <QObject>
#include <QString>

class QAction;
class QMenu;
class QWidget;

namespace teleta::chrome {
class RecordingIndicator;
}

namespace teleta::console {

class OperatePage;

/// The controls for recording: actions with shortcuts, status bar, messages, folder.
/// Thread: GUI.
class RecordingControls : public QObject {
    Q_OBJECT

public:
    /// window: parent of dialogs, and owner.
    RecordingControls(RecordingService& service, SourceManager& sources, OperatePage& page,
                      ConsoleSettings& settings, QWidget* window);

    /// For the status bar, which owns it.
    [[nodiscard]] chrome::RecordingIndicator* indicator() { return m_indicator; }
    [[nodiscard]] RecordingExport& csv() { return m_export; }
    /// Adds the actions.
    void fill(QMenu& menu);
    /// Starts a recording in the usual folder, or ends it.
    void toggle();
    /// Ends the recording; first takes the text of a mark that is being typed.
    void stop();
    void tick();
    /// Folder of the recordings.
    [[nodiscard]] QString folder() const;

signals:
    /// The recording that has just been made shall be opened.
    void playRequested(const QString& path);

private:
    /// Shows the folder of a file, or a folder, in the desktop's file manager.
    [[nodiscard]] static chrome::Message::Action showInFolder(const QString& place);
    void mark(std::int64_t time_ns);
    void askForFolder();
    [[nodiscard]] QString suggestedForExport();
    void onExported(const QString& text, int damaged, bool complete, const QString& place);
    void update();
    void onFailed(const core::Error& error, bool begun);

    RecordingService& m_service;
    SourceManager& m_sources;
    OperatePage& m_page;
    ConsoleSettings& m_settings;
    QWidget* m_window;
    RecordingExport m_export;
    chrome::RecordingIndicator* m_indicator;
    QAction* m_record;
    QAction* m_mark;
    QAction* m_playLast;
    QAction* m_folder;
    QAction* m_csv;
    QAction* m_mcap;
    QAction* m_undo;
    QAction* m_redo;
    QString m_last;    ///< path of the recording that was made last; empty: none
    QString m_problem; ///< of the last recording; empty: none, or another one has begun
};

} // namespace teleta::console
