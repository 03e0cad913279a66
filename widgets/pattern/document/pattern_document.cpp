// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/pattern/document/pattern_document.h"

#include "backend/pattern/edit/edit.h"
#include "backend/pattern/files/pattern_folder.h"
#include "backend/pattern/model/bake.h"
#include "backend/pattern/model/built_in_patterns.h"
#include "backend/pattern/motors/overdriven.h"
#include "widgets/pattern/document/pattern_names.h"

#include <QStringList>
#include <QUndoCommand>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace teleta::pattern {

namespace {

constexpr int kAutosaveDelay_ms = 2000;
constexpr int kNoMerge = -1;
constexpr int kDrag = 1;
constexpr int kNudge = 2;
constexpr int kFirstField = 16;
constexpr int kMirrorAxis = static_cast<int>(core::kTactors) - 1;

Pattern withoutTracks(const Pattern& pattern) {
    Pattern head;
    head.id = pattern.id;
    head.name = pattern.name;
    head.task = pattern.task;
    head.condition = pattern.condition;
    head.arm = pattern.arm;
    head.notes = pattern.notes;
    head.tags = pattern.tags;
    head.duration_s = pattern.duration_s;
    head.objects = pattern.objects;
    head.unknown = pattern.unknown;
    return head;
}

} // namespace

/// A state of the pattern. Tracks that an edit does not change are shared with the previous state.
struct PatternDocument::Snapshot {
    std::array<std::shared_ptr<const Track>, core::kTactors> tracks;
    std::shared_ptr<const Pattern> head; ///< without tracks
    Selection selection;
};

class PatternDocument::Edit : public QUndoCommand {
public:
    Edit(PatternDocument* document, Snapshot before, Snapshot after, const QString& text, int kind,
         quint64 gesture)
        : QUndoCommand(text)
        , m_document(document)
        , m_before(std::move(before))
        , m_after(std::move(after))
        , m_kind(kind)
        , m_gesture(gesture) {}

    int id() const override { return m_kind; }
    bool mergeWith(const QUndoCommand* other) override {
        const auto* next = static_cast<const Edit*>(other);
        if (next->m_gesture != m_gesture)
            return false;
        m_after = next->m_after;
        return true;
    }
    void undo() override { m_document->take(m_before); }
    void redo() override { m_document->take(m_after); }

private:
    PatternDocument* m_document;
    Snapshot m_before, m_after;
    int m_kind;
    quint64 m_gesture;
};

PatternDocument::PatternDocument(QObject* parent)
    : QObject(parent)
    , m_motors(assumedMotors()) {
    m_undo->setUndoLimit(kUndoDepth);
    m_autosave.setSingleShot(true);
    m_autosave.setInterval(kAutosaveDelay_ms);
    connect(&m_autosave, &QTimer::timeout, this, [this] {
        if (isDirty())
            emit autosaveDue(m_pattern);
    });
    connect(m_undo, &QUndoStack::cleanChanged, this, [this](bool clean) { emit dirtyChanged(!clean); });
    m_pattern.duration_s = 2.0;
    m_current = std::make_unique<Snapshot>(snapshotOf(m_pattern, {}, nullptr));
    m_compiled = CompiledPattern(m_pattern);
}

PatternDocument::~PatternDocument() = default;

PatternDocument::Snapshot PatternDocument::snapshotOf(const Pattern& pattern, const Selection& selection,
                                                      const Snapshot* before) const {
    Snapshot snapshot;
    for (std::size_t i = 0; i < core::kTactors; ++i) {
        const bool same = before && *before->tracks[i] == pattern.tracks[i];
        snapshot.tracks[i] = same ? before->tracks[i] : std::make_shared<const Track>(pattern.tracks[i]);
    }
    snapshot.head = std::make_shared<const Pattern>(withoutTracks(pattern));
    snapshot.selection = selection;
    return snapshot;
}

void PatternDocument::setPattern(Pattern pattern, const QString& path, bool unsaved) {
    m_autosave.stop();
    m_dragBase.reset();
    m_pattern = std::move(pattern);
    m_selection = {};
    ++m_gesture;
    *m_current = snapshotOf(m_pattern, {}, nullptr);
    m_undo->clear();
    if (unsaved)
        m_undo->resetClean();
    m_path = path;
    changed();
    emit selectionChanged();
    emit pathChanged();
    emit patternOpened();
}

bool PatternDocument::isBuiltIn() const {
    return findBuiltIn(m_pattern.id) != nullptr;
}

void PatternDocument::markSaved(const QString& path) {
    m_undo->setClean();
    m_autosave.stop();
    ++m_gesture;
    setPath(path);
}

void PatternDocument::setPath(const QString& path) {
    // Not std::exchange: the path may be a reference to m_path, as in markSaved(path()).
    if (path == m_path)
        return;
    m_path = path;
    emit pathChanged();
}

void PatternDocument::setMotors(const MotorProfiles& motors) {
    if (!std::all_of(motors.begin(), motors.end(), [](const MotorProfile& motor) { return motor.valid(); }))
        return;
    m_motors = motors;
    ++m_revision;
    emit motorsChanged();
}

void PatternDocument::select(Selection selection) {
    std::erase_if(selection.points, [this](const PointRef& p) {
        return p.track >= core::kTactors || p.index >= m_pattern.tracks[p.track].size();
    });
    std::sort(selection.points.begin(), selection.points.end());
    selection.points.erase(std::unique(selection.points.begin(), selection.points.end()),
                           selection.points.end());
    if (selection.object && *selection.object >= m_pattern.objects.size())
        selection.object.reset();
    if (selection == m_selection)
        return;
    m_selection = std::move(selection);
    ++m_gesture;
    emit selectionChanged();
}

void PatternDocument::selectAll() {
    Selection all;
    for (std::size_t t = 0; t < core::kTactors; ++t)
        for (std::size_t i = 0; i < m_pattern.tracks[t].size(); ++i)
            all.points.push_back({t, i});
    select(std::move(all));
}

void PatternDocument::setSnapping(bool snapping) {
    if (std::exchange(m_snapping, snapping) != snapping)
        emit snappingChanged();
}

void PatternDocument::setSnapStep(double step_s) {
    if (!(step_s >= kFinestSnap_s) || step_s == m_snapStep_s)
        return;
    m_snapStep_s = step_s;
    emit snappingChanged();
}

double PatternDocument::snapped(double time_s) const {
    return m_snapping ? std::round(time_s / m_snapStep_s) * m_snapStep_s : time_s;
}

void PatternDocument::changed() {
    m_compiled = CompiledPattern(m_pattern);
    ++m_revision;
    emit patternChanged();
}

void PatternDocument::take(const Snapshot& snapshot) {
    m_pattern = *snapshot.head;
    for (std::size_t i = 0; i < core::kTactors; ++i)
        m_pattern.tracks[i] = *snapshot.tracks[i];
    *m_current = snapshot;
    const bool otherSelection = !(m_selection == snapshot.selection);
    m_selection = snapshot.selection;
    if (!m_autosave.isActive()) // not restarted by each edit, or it would never fire
        m_autosave.start();
    changed();
    if (otherSelection)
        emit selectionChanged();
}

void PatternDocument::apply(Pattern after, const QString& text, Selection selection, int mergeKind) {
    if (after == m_pattern)
        return;
    if (isBuiltIn() && after.id == m_pattern.id) {
        after.id = newPatternId();
        if (after.name == m_pattern.name)
            after.name = tr("%1 (copy)").arg(displayName(m_pattern)).toStdString();
        std::erase(after.tags, "built-in");
    }
    if (mergeKind == kNoMerge)
        ++m_gesture;
    Snapshot before = *m_current;
    before.selection = m_selection;
    Snapshot next = snapshotOf(after, selection, &before);
    m_undo->push(new Edit(this, std::move(before), std::move(next), text, mergeKind, m_gesture));
}

void PatternDocument::apply(Edited edited, const QString& text, int mergeKind) {
    apply(std::move(edited.pattern), text, {std::move(edited.points), {}}, mergeKind);
}

void PatternDocument::applyOrRefuse(core::Expected<Pattern> after, const QString& text, Selection selection) {
    if (after)
        apply(std::move(*after), text, std::move(selection));
    else
        emit refused(QString::fromStdString(core::describe(after.error())));
}

template <typename Change>
void PatternDocument::edit(const QString& text, const QString& field, Change change) {
    Pattern after = m_pattern;
    change(after);
    apply(std::move(after), text, m_selection, kindOf(field));
}

int PatternDocument::kindOf(const QString& field) {
    if (field.isEmpty())
        return kNoMerge;
    return kFirstField + static_cast<int>(qHash(field) % 1'000'000U);
}

void PatternDocument::beginDrag() {
    m_dragBase = std::make_unique<Pattern>(m_pattern);
    m_dragSelection = m_selection;
    ++m_gesture;
}

void PatternDocument::endDrag() {
    m_dragBase.reset();
    ++m_gesture;
}

void PatternDocument::addPoint(std::size_t track, const Breakpoint& point) {
    apply(withPoint(m_pattern, track, point), tr("Add breakpoint"));
}

void PatternDocument::moveSelection(double time_s, double intensity) {
    const Selection& selection = m_dragBase ? m_dragSelection : m_selection;
    const int kind = m_dragBase ? kDrag : kNudge;
    Pattern base = m_dragBase ? *m_dragBase : m_pattern;
    // The first step of the drag has copied a built-in pattern.
    if (m_dragBase && findBuiltIn(base.id)) {
        base.id = m_pattern.id;
        base.name = m_pattern.name;
        base.tags = m_pattern.tags;
    }
    if (selection.object)
        apply(movedObject(base, *selection.object, time_s), tr("Move object"), selection, kind);
    else if (!selection.points.empty())
        apply(movedPoints(base, selection.points, time_s, intensity), tr("Move breakpoints"), kind);
}

void PatternDocument::replacePoint(PointRef point, const Breakpoint& breakpoint) {
    apply(replacedPoint(m_pattern, point, breakpoint), tr("Set breakpoint"));
}

void PatternDocument::setEasing(Easing easing) {
    apply(easedPoints(m_pattern, m_selection.points, easing), tr("Change curve"), m_selection);
}

void PatternDocument::scaleIntensity(double factor) {
    apply(scaledPoints(m_pattern, m_selection.points, factor), tr("Scale intensity"), m_selection);
}

void PatternDocument::stretch(double factor) {
    if (m_selection.points.size() > 1)
        apply(stretchedPoints(m_pattern, m_selection.points, factor), tr("Stretch in time"));
    else
        applyOrRefuse(stretched(m_pattern, factor), tr("Stretch in time"), m_selection);
}

void PatternDocument::removeSelection(const QString& text) {
    if (m_selection.object)
        apply(withoutObject(m_pattern, *m_selection.object), text, {});
    else if (!m_selection.points.empty())
        apply(withoutPoints(m_pattern, m_selection.points), text, {});
}

void PatternDocument::deleteSelection() {
    removeSelection(m_selection.object ? tr("Delete object") : tr("Delete breakpoints"));
}

void PatternDocument::copy() {
    if (!m_selection.empty())
        m_clip = copiedPoints(m_pattern, m_selection.points, m_selection.object);
}

void PatternDocument::cut() {
    copy();
    removeSelection(tr("Cut"));
}

void PatternDocument::insert(const PointClip& clip, double later_s, const QString& text) {
    if (clip.empty())
        return;
    Edited edited = pastedPoints(m_pattern, clip, later_s);
    Selection selection{std::move(edited.points), {}};
    if (!clip.objects.empty())
        selection.object = edited.pattern.objects.size() - 1;
    apply(std::move(edited.pattern), text, std::move(selection));
}

void PatternDocument::paste(std::optional<double> at_s) {
    insert(m_clip, at_s ? *at_s - m_clip.span().begin_s : 0.0, tr("Paste"));
}

void PatternDocument::duplicate() {
    const PointClip clip = copiedPoints(m_pattern, m_selection.points, m_selection.object);
    const Span span = clip.span();
    // Breakpoints start one step later, so that the copy does not replace the last one.
    const double gap_s = clip.objects.empty() ? m_snapStep_s : 0.0;
    insert(clip, span.end_s - span.begin_s + gap_s, tr("Duplicate"));
}

void PatternDocument::rotate(int steps) {
    apply(rotated(m_pattern, steps), tr("Rotate"), {});
}

void PatternDocument::mirror() {
    apply(mirrored(m_pattern, kMirrorAxis), tr("Mirror"), {});
}

void PatternDocument::swapArms() {
    apply(forOtherArm(m_pattern), tr("Swap arms"), {});
}

void PatternDocument::addObject(const PatternObject& object) {
    Pattern after = withObject(m_pattern, object);
    const std::size_t index = after.objects.size() - 1;
    apply(std::move(after), tr("Add object"), {{}, index});
}

void PatternDocument::replaceObject(std::size_t index, const PatternObject& object, const QString& field) {
    if (index >= m_pattern.objects.size())
        return;
    edit(tr("Change object"), field, [&](Pattern& after) { after.objects[index] = object; });
}

void PatternDocument::bakeObject(std::size_t index) {
    if (index < m_pattern.objects.size())
        applyOrRefuse(bake(m_pattern, {index}), tr("Bake object"), {});
}

void PatternDocument::overdrive() {
    auto helped = overdriven(m_pattern, m_motors);
    if (helped && *helped == m_pattern)
        emit told(tr("No motor needs overdrive here: the pattern is unchanged."));
    else
        applyOrRefuse(std::move(helped), tr("Overdrive"), {});
}

void PatternDocument::fix(const Finding& finding) {
    if (auto better = fixed(m_pattern, finding))
        apply(std::move(*better), tr("Follow the law"), m_selection);
}

void PatternDocument::setName(const QString& name) {
    edit(tr("Rename"), QStringLiteral("name"), [&](Pattern& after) { after.name = name.toStdString(); });
}

void PatternDocument::setNotes(const QString& notes) {
    edit(tr("Edit notes"), QStringLiteral("notes"),
         [&](Pattern& after) { after.notes = notes.toStdString(); });
}

void PatternDocument::setTags(const QStringList& tags) {
    edit(tr("Edit tags"), {}, [&](Pattern& after) {
        after.tags.clear();
        for (const QString& tag : tags)
            if (!tag.trimmed().isEmpty())
                after.tags.push_back(tag.trimmed().toStdString());
    });
}

void PatternDocument::setTask(Task task) {
    edit(tr("Change task"), {}, [&](Pattern& after) { after.task = task; });
}

void PatternDocument::setCondition(Condition condition) {
    edit(tr("Change condition"), {}, [&](Pattern& after) { after.condition = condition; });
}

void PatternDocument::setDuration(double duration_s) {
    if (duration_s > 0.0)
        edit(tr("Change duration"), QStringLiteral("duration"),
             [&](Pattern& after) { after.duration_s = std::min(duration_s, Pattern::kLongest_s); });
}

} // namespace teleta::pattern
