// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pattern/laws/law_checker.h"
#include "backend/pattern/model/pattern.h"
#include "backend/pattern/motors/motor_model.h"
#include "widgets/pattern/document/edit_operations.h"

#include <QObject>
#include <QString>
#include <QTimer>
#include <QUndoStack>

#include <memory>
#include <optional>

namespace teleta::pattern {

/// The selection: breakpoints, one object, or nothing.
struct Selection {
    PointRefs points;
    std::optional<std::size_t> object;

    bool operator==(const Selection&) const = default;
    [[nodiscard]] bool empty() const { return points.empty() && !object; }
};

/// The edited pattern with its selection, file path and undo stack. All edits go through it and can be
/// undone; a drag is one edit, and so are consecutive nudges. A built-in pattern is never changed: its first
/// edit also copies it with another id and name. Does no file I/O. Thread: GUI.
class PatternDocument : public QObject {
    Q_OBJECT
public:
    static constexpr int kUndoDepth = 500;
    static constexpr double kFinestSnap_s = 0.001;

    explicit PatternDocument(QObject* parent = nullptr);
    ~PatternDocument() override;

    /// Opens a pattern and clears the undo stack. path: empty if it has no file. unsaved: the file does not
    /// contain this state.
    void setPattern(Pattern pattern, const QString& path = {}, bool unsaved = false);
    [[nodiscard]] const Pattern& pattern() const { return m_pattern; }
    [[nodiscard]] const CompiledPattern& compiled() const { return m_compiled; }
    /// Number of changes of the pattern, for caches.
    [[nodiscard]] quint64 revision() const { return m_revision; }
    [[nodiscard]] bool isBuiltIn() const;

    [[nodiscard]] const QString& path() const { return m_path; }
    [[nodiscard]] bool isDirty() const { return !m_undo->isClean(); }
    /// To be called when the current state has been saved to a file.
    void markSaved(const QString& path);
    /// Sets the file of the pattern, which contains an earlier state of it.
    void setPath(const QString& path);
    [[nodiscard]] QUndoStack* undoStack() const { return m_undo; }
    /// Time from the first edit after an autosaveDue() to the next one.
    void setAutosaveDelay(int delay_ms) { m_autosave.setInterval(delay_ms); }

    /// Sets the motors for predictions and laws; an invalid profile is ignored.
    void setMotors(const MotorProfiles& motors);
    [[nodiscard]] const MotorProfiles& motors() const { return m_motors; }

    [[nodiscard]] const Selection& selection() const { return m_selection; }
    void select(Selection selection);
    void selectAll();

    void setSnapping(bool snapping);
    [[nodiscard]] bool snapping() const { return m_snapping; }
    void setSnapStep(double step_s);
    [[nodiscard]] double snapStep_s() const { return m_snapStep_s; }
    /// The nearest multiple of the step; the time itself when snapping is off.
    [[nodiscard]] double snapped(double time_s) const;

    /// Begins a drag: edits until endDrag() start from the current pattern and become one edit.
    void beginDrag();
    void endDrag();
    [[nodiscard]] bool dragging() const { return m_dragBase != nullptr; }

    void addPoint(std::size_t track, const Breakpoint& point);
    /// Moves relative to the start of the drag or, without a drag, to the current place (a nudge).
    void moveSelection(double time_s, double intensity);
    void replacePoint(PointRef point, const Breakpoint& breakpoint);
    void setEasing(Easing easing);
    void scaleIntensity(double factor);
    /// Stretches the selected breakpoints, or the whole pattern when none are selected.
    void stretch(double factor);
    void deleteSelection();

    void copy();
    void cut();
    /// Pastes at the original times, or with the begin at at_s.
    void paste(std::optional<double> at_s = std::nullopt);
    [[nodiscard]] bool canPaste() const { return !m_clip.empty(); }
    /// Inserts a copy of the selection directly after it.
    void duplicate();

    void rotate(int steps);
    /// Reverses the order of the motors: 1 and 6, 2 and 5, 3 and 4 change places.
    void mirror();
    void swapArms();

    void addObject(const PatternObject& object);
    /// Replaces an object. field: consecutive edits of one field are merged.
    void replaceObject(std::size_t index, const PatternObject& object, const QString& field = {});
    /// Error text by refused().
    void bakeObject(std::size_t index);
    /// Adds overdrive for motors(). Emits refused() on error, told() when no motor needs it.
    void overdrive();
    void fix(const Finding& finding);

    void setName(const QString& name);
    void setNotes(const QString& notes);
    void setTags(const QStringList& tags);
    void setTask(Task task);
    void setCondition(Condition condition);
    void setDuration(double duration_s);

signals:
    void patternChanged();
    /// Another pattern was opened.
    void patternOpened();
    void selectionChanged();
    void pathChanged();
    void dirtyChanged(bool dirty);
    void snappingChanged();
    void motorsChanged();
    /// There are unsaved edits: time to back them up. Emitted repeatedly while the pattern is being edited.
    void autosaveDue(const teleta::pattern::Pattern& pattern);
    /// An edit was refused.
    void refused(const QString& message);
    /// An edit had nothing to do.
    void told(const QString& message);

private:
    class Edit;
    struct Snapshot;

    void apply(Pattern after, const QString& text, Selection selection, int mergeKind = -1);
    /// The edited breakpoints are selected.
    void apply(Edited edited, const QString& text, int mergeKind = -1);
    void applyOrRefuse(core::Expected<Pattern> after, const QString& text, Selection selection);
    /// change(Pattern&). field: consecutive edits of one field are merged.
    template <typename Change>
    void edit(const QString& text, const QString& field, Change change);
    void removeSelection(const QString& text);
    void insert(const PointClip& clip, double later_s, const QString& text);
    void take(const Snapshot& snapshot);
    void changed();
    [[nodiscard]] Snapshot snapshotOf(const Pattern& pattern, const Selection& selection,
                                      const Snapshot* before) const;
    [[nodiscard]] static int kindOf(const QString& field);

    Pattern m_pattern;
    CompiledPattern m_compiled;
    MotorProfiles m_motors;
    Selection m_selection;
    PointClip m_clip;
    QString m_path;
    QUndoStack* m_undo = new QUndoStack(this);
    QTimer m_autosave;
    std::unique_ptr<Snapshot> m_current;
    std::unique_ptr<Pattern> m_dragBase;
    Selection m_dragSelection;
    quint64 m_revision = 0;
    quint64 m_gesture = 0;
    double m_snapStep_s = 0.01;
    bool m_snapping = true;
};

} // namespace teleta::pattern
