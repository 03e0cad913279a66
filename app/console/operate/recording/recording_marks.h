// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/recording/recorder.h"

#include <QObject>
#include <QString>
#include <QUndoStack>

#include <cstdint>
#include <future>
#include <memory>
#include <string>
#include <vector>

namespace teleta::console {

/// A moment that somebody marked while it was recorded.
struct RecordingMark {
    std::uint64_t number = 0;
    std::int64_t time_ns = 0; ///< steady clock
    double time_s = 0.0;      ///< since the start of the recording
    QString text;
};

/// The marks of the recording that runs, or of the last one, whose file is then changed on another thread.
/// What is done to them can be undone. Thread: GUI; no call waits but the destructor, for changes to be kept.
class RecordingMarks : public QObject {
    Q_OBJECT

public:
    explicit RecordingMarks(QObject* parent = nullptr);
    ~RecordingMarks() override;

    /// A recording is about to be begun: it has none.
    void clear();
    /// From now on moments can be marked. start_ns: of the recording.
    void begin(std::shared_ptr<recording::Recorder> recorder, std::int64_t start_ns);
    /// The recording ends; its file cannot be changed yet. What was done so far can no longer be undone.
    void end();
    /// Nobody writes the file any more.
    void release();

    /// Marks now, or an earlier moment of the recording; only while it is recorded.
    void add();
    void add(std::int64_t time_ns);
    void rename(std::uint64_t number, const QString& text);
    void remove(std::uint64_t number);
    /// In order of time.
    [[nodiscard]] const std::vector<RecordingMark>& all() const { return m_marks; }
    [[nodiscard]] QUndoStack& undoStack() { return m_undo; }

    /// Looks what became of the changes of the file.
    void tick();

signals:
    void changed();
    /// Changes could not be kept in the file, which the error names. It is tried again with the next change,
    /// and at the end.
    void notKept(const core::Error& error);

private:
    friend class MarkCommand;
    /// Changes of the marks of a file that is complete.
    struct FileChanges {
        std::string path;
        std::vector<recording::MarkChange> changes;
    };
    struct Kept {
        std::vector<FileChanges> left; ///< what the files could not take, in its order
        core::Error why;               ///< of the first of it
    };

    void insert(RecordingMark& mark);
    void drop(std::uint64_t number);
    void setText(std::uint64_t number, const QString& text);
    /// To the recording that runs, or to the file of the last one.
    void keep(recording::MarkChange change);
    void keepInFile();
    /// What was left of these goes before all others.
    void giveBack(Kept& kept);
    /// Not on the GUI's thread.
    [[nodiscard]] static Kept keepInFiles(const std::vector<FileChanges>& all);

    std::shared_ptr<recording::Recorder> m_recorder; ///< null unless it is recorded
    bool m_isWritten = false;                        ///< the file is begun, written or completed
    std::string m_path;
    std::int64_t m_start_ns = 0;
    std::vector<RecordingMark> m_marks;
    QUndoStack m_undo;
    std::vector<FileChanges> m_changes; ///< for files, once they are complete and can be written
    std::future<Kept> m_keeping;
};

} // namespace teleta::console
