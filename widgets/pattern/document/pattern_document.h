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

namespace teleta::editor {

/// What is selected: breakpoints, or one object, or nothing.
struct Selection {
    PointRefs points;
    std::optional<std::size_t> object;

    bool operator==(const Selection&) const = default;
    [[nodiscard]] bool empty() const { return points.empty() && !object; }
};

/// The pattern that is edited, with its selection, file and edits. All edits go through it and each of them
/// can be undone; a drag is one edit, and so are nudges that follow on each other. A built-in pattern is
/// never changed: its first edit makes a copy of it with another id and name, as part of that edit.
/// Does no file I/O. Thread: GUI.
class PatternDocument : public QObject {
    Q_OBJECT
public:
    static constexpr int kUndoDepth = 500;
    static constexpr double kFinestSnap_s = 0.001;

    explicit PatternDocument(QObject* parent = nullptr);
    ~PatternDocument() override;

    /// Opens a pattern and forgets the edits of the one before. path: empty for one without a file. unsaved:
    /// its file does not hold it.
    void setPattern(pattern::Pattern pattern, const QString& path = {}, bool unsaved = false);
    [[nodiscard]] const pattern::Pattern& pattern() const { return m_pattern; }
    [[nodiscard]] const pattern::CompiledPattern& compiled() const { return m_compiled; }
    /// Counts the changes of the pattern, for caches.
    [[nodiscard]] quint64 revision() const { return m_revision; }
    [[nodiscard]] bool isBuiltIn() const;

    [[nodiscard]] const QString& path() const { return m_path; }
    [[nodiscard]] bool isDirty() const { return !m_undo->isClean(); }
    /// The pattern, as it is now, lies in a file.
    void markSaved(const QString& path);
    /// The pattern has a file from now on, which holds an earlier state of it.
    void setPath(const QString& path);
    [[nodiscard]] QUndoStack* undoStack() const { return m_undo; }
    /// How long after the first edit since the last one autosaveDue() comes.
    void setAutosaveDelay(int delay_ms) { m_autosave.setInterval(delay_ms); }

    /// Motors of the predicted curves and the laws; an invalid profile is not taken.
    void setMotors(const pattern::MotorProfiles& motors);
    [[nodiscard]] const pattern::MotorProfiles& motors() const { return m_motors; }

    [[nodiscard]] const Selection& selection() const { return m_selection; }
    void select(Selection selection);
    void selectAll();

    void setSnapping(bool snapping);
    [[nodiscard]] bool snapping() const { return m_snapping; }
    void setSnapStep(double step_s);
    [[nodiscard]] double snapStep_s() const { return m_snapStep_s; }
    /// The nearest multiple of the step; the time itself when snapping is off.
    [[nodiscard]] double snapped(double time_s) const;

    /// A drag begins: what follows until endDrag() is computed from the pattern as it is now, and is one
    /// edit.
    void beginDrag();
    void endDrag();
    [[nodiscard]] bool dragging() const { return m_dragBase != nullptr; }
    /// The pattern before the drag; without one as it is now.
    [[nodiscard]] const pattern::Pattern& dragBase() const;

    void addPoint(std::size_t track, const pattern::Breakpoint& point);
    /// By so much since the drag began, or, without a drag, since now (a nudge).
    void moveSelection(double time_s, double intensity);
    void replacePoint(PointRef point, const pattern::Breakpoint& breakpoint);
    void setEasing(pattern::Easing easing);
    void scaleIntensity(double factor);
    /// The selected breakpoints, or the whole pattern when none is selected.
    void stretch(double factor);
    void deleteSelection();

    void copy();
    void cut();
    /// At the times at which it was copied; or with its begin at a time.
    void paste(std::optional<double> at_s = std::nullopt);
    [[nodiscard]] bool canPaste() const { return !m_clip.empty(); }
    /// Once more, right behind itself.
    void duplicate();

    void rotate(int steps);
    /// The order of the motors the other way round: 1 and 6, 2 and 5, 3 and 4 change places.
    void mirror();
    void swapArms();

    void addObject(const pattern::PatternObject& object);
    /// field: edits of one field that follow on each other are one edit.
    void replaceObject(std::size_t index, const pattern::PatternObject& object, const QString& field = {});
    /// Error text by refused().
    void bakeObject(std::size_t index);
    void bakeAll();
    /// Helps motors() up, pattern::overdriven. Error text by refused(); that none needs help by
    /// told().
    void overdrive();
    void fix(const pattern::Finding& finding);

    void setName(const QString& name);
    void setNotes(const QString& notes);
    void setTags(const QStringList& tags);
    void setTask(pattern::Task task);
    void setCondition(pattern::Condition condition);
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
    void clipboardChanged();
    /// There are edits that are not saved: time to keep a copy of them. While the pattern is being edited it
    /// comes again and again.
    void autosaveDue(const teleta::pattern::Pattern& pattern);
    /// An edit could not be done.
    void refused(const QString& message);
    /// All is well, and there was nothing to do.
    void told(const QString& message);

private:
    class Edit;
    struct Snapshot;

    void apply(pattern::Pattern after, const QString& text, Selection selection, int mergeKind = -1);
    void take(const Snapshot& snapshot);
    void changed();
    [[nodiscard]] Snapshot snapshotOf(const pattern::Pattern& pattern, const Selection& selection,
                                      const Snapshot* before) const;
    [[nodiscard]] static int kindOf(const QString& field);

    pattern::Pattern m_pattern;
    pattern::CompiledPattern m_compiled;
    pattern::MotorProfiles m_motors;
    Selection m_selection;
    PointClip m_clip;
    QString m_path;
    QUndoStack* m_undo;
    QTimer m_autosave;
    std::unique_ptr<Snapshot> m_current;
    std::unique_ptr<pattern::Pattern> m_dragBase;
    Selection m_dragSelection;
    quint64 m_revision = 0;
    quint64 m_gesture = 0;
    double m_snapStep_s = 0.01;
    bool m_snapping = true;
};

} // namespace teleta::editor
