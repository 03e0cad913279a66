// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/recording/csv_export.h"

#include <QObject>
#include <QString>
#include <QTimer>

#include <atomic>
#include <future>
#include <memory>
#include <string>
#include <vector>

class QProgressDialog;
class QWidget;

namespace teleta::console {

/// Writes the streams of a recording as CSV files, as `teleta export` does, on a thread of its own; a window
/// that blocks nothing shows how far it is and can cancel it. One export at a time. Thread: GUI; no call
/// waits but the destructor, for the thread to see that it is to end.
class RecordingExport : public QObject {
    Q_OBJECT

public:
    /// window: of dialogs.
    explicit RecordingExport(QWidget* window);
    ~RecordingExport() override;

    /// Asks for a recording and a folder. suggested: a recording; may be empty.
    void ask(const QString& suggested);
    /// folder: made when it is missing. Fails while another export runs.
    void start(const QString& path, const QString& folder);
    [[nodiscard]] bool isBusy() const { return m_result.valid(); }

signals:
    void busyChanged(bool busy);
    /// Nothing is said of an export that was cancelled, and none of its files stays. complete: the recording
    /// was not cut off.
    void finished(const QString& folder, int files, int damagedBlocks, bool complete);
    void failed(const QString& name, const core::Error& error);

private:
    using Result = core::Expected<std::vector<recording::ExportedFile>>; ///< no files: it was cancelled
    struct Progress {
        std::atomic<double> share{0.0};
        std::atomic<bool> cancelled{false};
        bool isNewFolder = false; ///< once it has ended, as the next one
        bool isComplete = true;
    };
    void askForFolder(const QString& path);
    [[nodiscard]] static Result write(const std::string& path, const std::string& folder, Progress& progress);
    /// Removes what was written.
    static void discard(const std::vector<recording::ExportedFile>& files, const std::string& folder,
                        bool isNewFolder);
    void look();

    QWidget* m_window;
    QString m_path;
    QString m_folder;
    std::shared_ptr<Progress> m_progress;
    std::future<Result> m_result;
    QProgressDialog* m_dialog = nullptr;
    QTimer m_timer;
};

} // namespace teleta::console
