// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/operate/recording/work_progress.h"
#include "backend/core/error.h"
#include "backend/frames/frame_request.h"
#include "backend/mcap/recorded/mcap_import.h"

#include <QObject>
#include <QPointer>
#include <QProgressDialog>
#include <QString>
#include <QTimer>

#include <future>
#include <memory>
#include <vector>

class QWidget;

namespace teleta::console {

/// Makes recordings of MCAP files and of frames of other programs, like `teleta import`, each on its own
/// thread; a non-modal window shows the progress and can cancel. Thread: GUI; only the destructor waits, for
/// the threads to end.
class RecordingImport : public QObject {
    Q_OBJECT

public:
    /// window: parent of dialogs.
    explicit RecordingImport(QWidget* window);
    ~RecordingImport() override;

    /// Where the recording of a file belongs: beside it, or in the other folder if nothing can be
    /// written there.
    [[nodiscard]] static QString recordingOf(const QString& file, const QString& otherFolder);
    /// The same name with the first number, from 2, that makes it free.
    [[nodiscard]] static QString freeName(const QString& recording);

    /// recording: must not be there, nor be made by another import; its folder is made when it is missing.
    /// request: of a file of frames, what is known of it besides its path.
    void start(const QString& file, const QString& recording, const frames::FrameRequest& request = {});
    [[nodiscard]] bool isBusy() const { return !m_jobs.empty(); }

signals:
    /// missing: what was left out or damaged, for people; empty: nothing.
    void imported(const QString& file, const QString& recording, const QString& missing);
    /// No recording is left.
    void cancelled(const QString& file);
    void failed(const QString& file, const core::Error& error);

private:
    using Result = core::Expected<QString>; ///< what was left out or damaged
    struct Job {
        QString file;
        QString recording;
        std::shared_ptr<WorkProgress> progress;
        std::future<Result> result;
        QPointer<QProgressDialog> dialog;
    };
    [[nodiscard]] static Result make(const QString& file, const QString& recording,
                                     const frames::FrameRequest& request, WorkProgress& progress);
    [[nodiscard]] static Result makeOfFrames(const QString& recording, frames::FrameRequest request,
                                             WorkProgress& progress);
    [[nodiscard]] static QString missing(const mcap::McapImport& import);
    void look();
    void finish(Job job);

    QWidget* m_window;
    std::vector<Job> m_jobs;
    QTimer m_timer;
};

} // namespace teleta::console
