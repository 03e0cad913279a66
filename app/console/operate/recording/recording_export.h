// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/operate/recording/work_progress.h"
#include "backend/core/error.h"
#include "backend/recording/csv_export.h"

#include <QObject>
#include <QString>
#include <QTimer>

#include <future>
#include <memory>
#include <string>
#include <vector>

class QProgressDialog;
class QWidget;

namespace teleta::console {

/// Writes the streams of a recording as CSV files or an MCAP file, like `teleta export`, on its own thread; a
/// non-modal window shows the progress and can cancel. One export at a time. Thread: GUI; only the destructor
/// waits, for the thread to end.
class RecordingExport : public QObject {
    Q_OBJECT

public:
    /// window: parent of dialogs.
    explicit RecordingExport(QWidget* window);
    ~RecordingExport() override;

    /// Asks for a recording and a folder. suggested: a recording; may be empty.
    void ask(const QString& suggested);
    /// folder: made when it is missing. Fails while another export runs.
    void start(const QString& path, const QString& folder);
    /// Whether the CSV files of the next export get a column of Unix times.
    void setUtc(bool utc) { m_utc = utc; }
    /// Asks for a recording and an MCAP file. suggested: a recording; may be empty.
    void askMcap(const QString& suggested);
    /// Writes over the file when it is there. Fails while another export runs.
    void startMcap(const QString& path, const QString& file);
    [[nodiscard]] bool isBusy() const { return m_result.valid(); }

signals:
    void busyChanged(bool busy);
    /// Not emitted for a cancelled export, whose files are removed. complete: the recording
    /// was not cut off.
    void finished(const QString& folder, int files, int damagedBlocks, bool complete);
    /// The same for an MCAP file.
    void finishedMcap(const QString& file, int damagedBlocks, bool complete);
    void failed(const QString& name, const core::Error& error);

private:
    using Result = core::Expected<std::vector<recording::ExportedFile>>; ///< no files: it was cancelled
    struct Progress : WorkProgress {
        bool utc = false;
        bool isNewFolder = false; ///< once it has ended, as the next one
        bool isComplete = true;
    };
    using Work = Result (*)(const std::string& path, const std::string& target, Progress& progress);
    void askForFolder(const QString& path);
    void begin(const QString& path, const QString& target, Work work);
    [[nodiscard]] static Result write(const std::string& path, const std::string& folder, Progress& progress);
    [[nodiscard]] static Result writeMcap(const std::string& path, const std::string& file,
                                          Progress& progress);
    /// Removes what was written.
    static void discard(const std::vector<recording::ExportedFile>& files, const std::string& folder,
                        bool isNewFolder);
    void look();

    QWidget* m_window;
    QString m_path;
    QString m_folder; ///< or the MCAP file
    bool m_isMcap = false;
    bool m_utc = false;
    std::shared_ptr<Progress> m_progress;
    std::future<Result> m_result;
    QProgressDialog* m_dialog = nullptr;
    QTimer m_timer;
};

} // namespace teleta::console
