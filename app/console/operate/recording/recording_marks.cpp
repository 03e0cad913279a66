// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/operate/recording/recording_marks.h"

#include "backend/core/steady_time.h"
#include "backend/recording/mark_changes.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <utility>

namespace teleta::console {

/// Something that is done to a mark, and undone.
class MarkCommand : public QUndoCommand {
public:
    enum class What { add, remove, rename };
    MarkCommand(RecordingMarks& marks, What what, RecordingMark mark, QString text = {})
        : m_marks(marks)
        , m_what(what)
        , m_mark(std::move(mark))
        , m_text(std::move(text)) {
        setText(what == What::add      ? RecordingMarks::tr("mark")
                : what == What::remove ? RecordingMarks::tr("removal of a mark")
                                       : RecordingMarks::tr("text of a mark"));
    }

    void redo() override {
        if (m_what == What::rename)
            m_marks.setText(m_mark.number, m_text);
        else
            setThere(m_what == What::add);
    }
    void undo() override {
        if (m_what == What::rename)
            m_marks.setText(m_mark.number, m_mark.text);
        else
            setThere(m_what != What::add);
    }

private:
    void setThere(bool there) {
        if (there)
            m_marks.insert(m_mark);
        else
            m_marks.drop(m_mark.number);
    }

    RecordingMarks& m_marks;
    What m_what;
    RecordingMark m_mark;
    QString m_text;
};

RecordingMarks::RecordingMarks(QObject* parent)
    : QObject(parent) {
}

RecordingMarks::~RecordingMarks() {
    if (m_keeping.valid()) {
        Kept kept = m_keeping.get();
        giveBack(kept);
    }
    (void)keepInFiles(m_changes);
}

void RecordingMarks::clear() {
    m_isWritten = true;
    m_marks.clear();
    m_undo.clear();
    emit changed();
}

void RecordingMarks::begin(std::shared_ptr<recording::Recorder> recorder, std::int64_t start_ns) {
    m_recorder = std::move(recorder);
    m_path = m_recorder->path();
    m_start_ns = start_ns;
}

void RecordingMarks::end() {
    m_recorder.reset();
    // What was done while it was recorded is not undone by mistake long after its end.
    m_undo.clear();
}

void RecordingMarks::release() {
    m_isWritten = false;
    keepInFile();
}

void RecordingMarks::tick() {
    if (!m_keeping.valid() || m_keeping.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
        return;
    Kept kept = m_keeping.get();
    const bool areNew = !m_changes.empty();
    const bool isKept = kept.left.empty();
    giveBack(kept);
    if (areNew)
        keepInFile();
    if (!isKept)
        emit notKept(kept.why);
}

void RecordingMarks::add() {
    add(core::steadyNow_ns());
}

void RecordingMarks::add(std::int64_t time_ns) {
    if (!m_recorder)
        return;
    const std::int64_t inside_ns = std::clamp(time_ns, m_start_ns, core::steadyNow_ns());
    m_undo.push(new MarkCommand(*this, MarkCommand::What::add,
                                {0, inside_ns, core::elapsed_s(m_start_ns, inside_ns), {}}));
}

void RecordingMarks::rename(std::uint64_t number, const QString& text) {
    const auto found = std::ranges::find(m_marks, number, &RecordingMark::number);
    if (found != m_marks.end() && found->text != text)
        m_undo.push(new MarkCommand(*this, MarkCommand::What::rename, *found, text));
}

void RecordingMarks::remove(std::uint64_t number) {
    const auto found = std::ranges::find(m_marks, number, &RecordingMark::number);
    if (found != m_marks.end())
        m_undo.push(new MarkCommand(*this, MarkCommand::What::remove, *found));
}

void RecordingMarks::keep(recording::MarkChange change) {
    if (!m_recorder) {
        if (m_changes.empty() || m_changes.back().path != m_path)
            m_changes.push_back({m_path, {}});
        m_changes.back().changes.push_back(std::move(change));
        keepInFile();
    } else if (change.restored_ns) {
        m_recorder->restoreMark(change.number, std::move(*change.note), *change.restored_ns);
    } else if (change.note) {
        m_recorder->renameMark(change.number, std::move(*change.note));
    } else {
        m_recorder->removeMark(change.number);
    }
}

void RecordingMarks::keepInFile() {
    // One after the other: those that come meanwhile wait.
    if (m_changes.empty() || m_isWritten || m_keeping.valid())
        return;
    m_keeping = std::async(std::launch::async, &RecordingMarks::keepInFiles, std::exchange(m_changes, {}));
}

void RecordingMarks::giveBack(Kept& kept) {
    m_changes.insert(m_changes.begin(), std::make_move_iterator(kept.left.begin()),
                     std::make_move_iterator(kept.left.end()));
    kept.left.clear();
}

RecordingMarks::Kept RecordingMarks::keepInFiles(const std::vector<FileChanges>& all) {
    Kept kept;
    for (const FileChanges& file : all) {
        // None before those that came earlier.
        const bool waits = std::ranges::find(kept.left, file.path, &FileChanges::path) != kept.left.end();
        const core::Expected<void> done =
            waits ? core::Expected<void>() : recording::changeMarks(file.path, file.changes);
        if (!done && kept.left.empty())
            kept.why = done.error();
        if (!done || waits)
            kept.left.push_back(file);
    }
    return kept;
}

void RecordingMarks::insert(RecordingMark& mark) {
    // One that comes back keeps its number: older commands know it by that.
    if (mark.number == 0)
        mark.number = m_recorder->mark(mark.text.toStdString(), mark.time_ns);
    else
        keep({mark.number, mark.text.toStdString(), mark.time_ns});
    const auto place = std::ranges::upper_bound(m_marks, mark.time_ns, {}, &RecordingMark::time_ns);
    m_marks.insert(place, mark);
    emit changed();
}

void RecordingMarks::drop(std::uint64_t number) {
    keep({number, std::nullopt});
    std::erase_if(m_marks, [&](const RecordingMark& mark) { return mark.number == number; });
    emit changed();
}

void RecordingMarks::setText(std::uint64_t number, const QString& text) {
    const auto found = std::ranges::find(m_marks, number, &RecordingMark::number);
    if (found == m_marks.end())
        return;
    keep({number, text.toStdString()});
    found->text = text;
    emit changed();
}

} // namespace teleta::console
