// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/base/console_settings.h"
#include "app/console/sources/recording_arguments.h"
#include "app/console/sources/source_manager.h"

#include <QObject>
#include <QString>
#include <QWidget>

namespace teleta::console {

/// Opens recordings as sources: those of this program (.teleta) at once, CSV files after it was asked how
/// they are to be read. Files are read on other threads. Thread: GUI.
class RecordingFiles : public QObject {
    Q_OBJECT

public:
    /// window: of the dialogs, and owner.
    RecordingFiles(SourceManager& sources, ConsoleSettings& settings, QWidget* window);

    void open(const QString& path);
    /// Asks nothing: what the command line does not say is guessed.
    void openAs(const RecordingArguments& recording);
    /// Where the newest recording is that was opened, or else that folder; of one that is not there, where it
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
