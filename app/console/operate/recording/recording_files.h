// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/base/console_settings.h"
#include "app/console/sources/recording_arguments.h"
#include "app/console/sources/source_manager.h"

#include <QObject>
#include <QString>
#include <QWidget>

namespace teleta::console {

/// Opens recordings as sources: .teleta files at once, CSV files after asking how
/// to read them. Files are read on other threads. Thread: GUI.
class RecordingFiles : public QObject {
    Q_OBJECT

public:
    /// window: parent of dialogs, and owner.
    RecordingFiles(SourceManager& sources, ConsoleSettings& settings, QWidget* window);

    void open(const QString& path);
    /// Opens without asking; what the command line omits is guessed.
    void openAs(const RecordingArguments& recording);
    /// Folder of the recording that was opened last, or else the given one; for a missing folder, where it
    /// would be.
    [[nodiscard]] QString folder(const QString& otherwise) const;

signals:
    void opened(const QString& path);
    void failed(const QString& name, const core::Error& error);

private:
    void play(const QString& path);
    void askHow(const CsvRequest& guess);

    SourceManager& m_sources;
    ConsoleSettings& m_settings;
    QWidget* m_window;
};

} // namespace teleta::console
