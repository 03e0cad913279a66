// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/base/console_settings.h"
#include "app/console/operate/recording/recording_import.h"
#include "app/console/sources/recording_arguments.h"
#include "app/console/sources/source_manager.h"

#include <QObject>
#include <QString>
#include <QWidget>

#include <string>

namespace teleta::console {

/// Opens recordings as sources: .teleta files at once, CSV files after asking how to read them, MCAP files
/// and frames of other programs as the recordings that are made of them. What such a file leaves open is
/// asked. Files are read on other threads. Thread: GUI.
class RecordingFiles : public QObject {
    Q_OBJECT

public:
    /// window: parent of dialogs, and owner.
    RecordingFiles(SourceManager& sources, ConsoleSettings& settings, QWidget* window);

    void open(const QString& path);
    /// Frames in CSV as they were opened the last time; asks when that is not known.
    void reopen(const QString& path);
    /// Opens without asking; what the command line omits is guessed.
    void openAs(const RecordingArguments& recording);
    /// Folder of the recording that was opened last, or else the given one; for a missing folder, where it
    /// would be.
    [[nodiscard]] QString folder(const QString& otherwise) const;

    /// Where recordings go when no folder was chosen.
    [[nodiscard]] static QString usualFolder();

signals:
    void opened(const QString& path);
    /// A recording was made of a file, and is opened now. missing: what was left out; empty: nothing.
    void imported(const QString& file, const QString& recording, const QString& missing);
    /// A file is not opened, as a person wishes.
    void cancelled(const QString& file);
    void failed(const QString& name, const core::Error& error);

private:
    void play(const QString& path);
    void askHow(const app::CsvRequest& guess);
    /// Where the recording of an imported file belongs.
    [[nodiscard]] QString recordingOf(const QString& file) const;
    void import(const QString& file, const frames::FrameRequest& request = {});
    void onNotImported(const QString& file, const core::Error& error);
    /// What a file of frames leaves open.
    /// why: what is wrong with what was known; empty: a person wants to change it.
    void askFrames(const QString& file, const QString& why);
    void askFrames(const QString& file, const QString& why, const std::string& family);
    /// A recording is where that of the file belongs.
    void askWhether(const QString& file, const QString& recording, const frames::FrameRequest& request);

    SourceManager& m_sources;
    ConsoleSettings& m_settings;
    QWidget* m_window;
    RecordingImport m_import;
};

} // namespace teleta::console
