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

/// A moment marked during a recording.
struct RecordingMark {
    std::uint64_t number = 0;
    std::int64_t time_ns = 0; ///< steady clock
    double time_s = 0.0;      ///< since the start of the recording
    QString text;
};

/// The marks of the current recording, or of the last one, whose file is changed on another thread.
/// Every change can be undone. Thread: GUI; only the destructor waits, for changes to be written.
class RecordingMarks : public QObject {
    Q_OBJECT

public:
    explicit RecordingMarks(QObject* parent = nullptr);
    ~RecordingMarks() override;

    /// Call before a recording starts: removes all marks.
    void clear();
    /// Allows marks from now on. start_ns: start of the recording.
    void begin(std::shared_ptr<recording::Recorder> recorder, std::int64_t start_ns);
    /// Call when the recording ends: clears the undo stack. The file cannot be changed yet.
    void end();
    /// Call when nobody writes the file any more: changes may be written to it.
    void release();

    /// Marks now, or an earlier moment; only during a recording.
    void add();
    void add(std::int64_t time_ns);
    void rename(std::uint64_t number, const QString& text);
    void remove(std::uint64_t number);
    /// In order of time.
    [[nodiscard]] const std::vector<RecordingMark>& all() const { return m_marks; }
    [[nodiscard]] QUndoStack& undoStack() { return m_undo; }

    /// Collects the result of changes to the file.
    void tick();

signals:
    void changed();
    /// Changes could not be written to the file that the error names. The next change tries again,
    /// and so does the destructor.
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
