// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/model/built_in_patterns.h"
#include "tests/widgets/test_registry.h"
#include "widgets/pattern/document/pattern_document.h"

#include <QSignalSpy>
#include <QTest>

#include <algorithm>
#include <functional>

using namespace teleta;
using namespace teleta::pattern;

namespace {

Pattern sample() {
    Pattern pattern;
    pattern.id = "mine.1";
    pattern.name = "Sample";
    pattern.duration_s = 2.0;
    pattern.tracks[0] = {{0.0, 0.2}, {0.5, 0.8}, {1.0, 0.4}};
    pattern.tracks[3] = {{0.25, 0.0}, {1.5, 1.0}};
    pattern.objects.push_back({"", Ring{}, {}});
    pattern.objects.push_back({"", Ramp{0.1, 0.5, {4}}, {}});
    return pattern;
}

} // namespace

/// All edits go through the document.
class PatternDocumentTest : public QObject {
    Q_OBJECT

private slots:
    void everyEditIsUndoneAndRedone() {
        const std::vector<std::pair<const char*, std::function<void(PatternDocument&)>>> edits{
            {"add",
             [](auto& d) {
                 d.addPoint(2, {0.3, 0.5});
             }},
            {"move", [](auto& d) { d.moveSelection(0.1, -0.1); }},
            {"replace",
             [](auto& d) {
                 d.replacePoint({0, 0}, {0.7, 0.9});
             }},
            {"easing", [](auto& d) { d.setEasing(Easing::hold); }},
            {"scale", [](auto& d) { d.scaleIntensity(0.5); }},
            {"stretch", [](auto& d) { d.stretch(1.5); }},
            {"delete", [](auto& d) { d.deleteSelection(); }},
            {"cut", [](auto& d) { d.cut(); }},
            {"copy and paste",
             [](auto& d) {
                 d.copy();
                 d.paste(1.2);
             }},
            {"duplicate", [](auto& d) { d.duplicate(); }},
            {"rotate", [](auto& d) { d.rotate(1); }},
            {"mirror", [](auto& d) { d.mirror(); }},
            {"swap", [](auto& d) { d.swapArms(); }},
            {"add object",
             [](auto& d) {
                 d.addObject({"", PulseTrain{.tactors = {1}}, {}});
             }},
            {"change object",
             [](auto& d) {
                 d.replaceObject(0, {"", Ring{.turns = 4, .burst_s = {}}, {}}, "turns");
             }},
            {"bake one", [](auto& d) { d.bakeObject(1); }},
            {"overdrive", [](auto& d) { d.overdrive(); }},
            {"name", [](auto& d) { d.setName("Other"); }},
            {"notes", [](auto& d) { d.setNotes("n"); }},
            {"tags",
             [](auto& d) {
                 d.setTags({"a", " b ", ""});
             }},
            {"task", [](auto& d) { d.setTask(Task::shape); }},
            {"condition", [](auto& d) { d.setCondition(Condition::dynamic); }},
            {"duration", [](auto& d) { d.setDuration(3.0); }},
        };
        for (const auto& [name, edit] : edits) {
            PatternDocument document;
            document.setPattern(sample());
            document.select({{{0, 1}, {3, 0}}, {}});
            edit(document);
            const Pattern after = document.pattern();
            QVERIFY2(!(after == sample()), name);
            QVERIFY2(document.undoStack()->count() == 1, name);
            QVERIFY2(document.isDirty(), name);
            document.undoStack()->undo();
            QVERIFY2(document.pattern() == sample(), name);
            QVERIFY2(document.selection().points == PointRefs({{0, 1}, {3, 0}}), name);
            QVERIFY2(!document.isDirty(), name);
            document.undoStack()->redo();
            QVERIFY2(document.pattern() == after, name);
        }
    }

    void anOverdriveThatHelpsNobodySaysSo() {
        PatternDocument document;
        Pattern still;
        still.duration_s = 1.0;
        document.setPattern(still);
        QSignalSpy refusals(&document, &PatternDocument::refused);
        QSignalSpy told(&document, &PatternDocument::told);
        document.overdrive();
        QCOMPARE(told.size(), 1);
        QVERIFY2(refusals.empty(), "nothing is wrong");
        QVERIFY(document.pattern() == still);
        QCOMPARE(document.undoStack()->count(), 0);
    }

    void aHundredEditsAreUndone() {
        PatternDocument document;
        document.setPattern(sample());
        for (int i = 0; i < 120; ++i)
            document.rotate(1);
        QCOMPARE(document.undoStack()->count(), 120);
        document.rotate(1);
        for (int i = 0; i < 121; ++i)
            document.undoStack()->undo();
        QVERIFY(document.pattern() == sample());
    }

    void aDragIsOneEditAndNudgesAreOne() {
        PatternDocument document;
        document.setPattern(sample());
        document.select({{{0, 0}}, {}});
        document.beginDrag();
        document.moveSelection(0.7, 0.0); // past its neighbour
        document.moveSelection(0.1, 0.2);
        document.moveSelection(0.2, 0.3);
        document.endDrag();
        QCOMPARE(document.undoStack()->count(), 1);
        QCOMPARE(document.pattern().tracks[0][0].time_s, 0.2);
        QCOMPARE(document.pattern().tracks[0][0].intensity, 0.5);
        document.moveSelection(0.01, 0.0);
        document.moveSelection(0.01, 0.0);
        QCOMPARE(document.undoStack()->count(), 2);
        QCOMPARE(document.pattern().tracks[0][0].time_s, 0.22);
        document.select({{{0, 1}}, {}});
        document.moveSelection(0.01, 0.0);
        QCOMPARE(document.undoStack()->count(), 3);
    }

    void aFieldThatIsTypedIsOneEdit() {
        PatternDocument document;
        document.setPattern(sample());
        document.setName("A");
        document.setName("Ab");
        document.setDuration(3.0);
        document.setDuration(3.5);
        QCOMPARE(document.undoStack()->count(), 2);
        document.undoStack()->undo();
        QCOMPARE(document.pattern().duration_s, 2.0);
        QCOMPARE(document.pattern().name, std::string("Ab"));
    }

    void aBuiltInPatternIsCopiedByItsFirstEdit() {
        PatternDocument document;
        const Pattern& builtIn = *findBuiltIn("shape.A.dynamic");
        document.setPattern(builtIn);
        QVERIFY(document.isBuiltIn());
        document.selectAll();
        document.beginDrag();
        document.moveSelection(0.05, -0.1);
        document.moveSelection(0.05, -0.2);
        document.endDrag();
        QCOMPARE(document.undoStack()->count(), 1);
        QVERIFY(!document.isBuiltIn());
        QVERIFY(document.pattern().id.starts_with("mine."));
        QVERIFY(QString::fromStdString(document.pattern().name).contains("copy"));
        document.undoStack()->undo();
        QVERIFY(document.pattern() == builtIn);
        QVERIFY(*findBuiltIn("shape.A.dynamic") == builtIn);
    }

    void aDuplicateFollowsBehindAndIsSelected() {
        PatternDocument document;
        document.setPattern(sample());
        document.select({{{0, 0}, {0, 1}, {0, 2}}, {}});
        document.duplicate();
        QCOMPARE(document.pattern().tracks[0].size(), std::size_t(6));
        QCOMPARE(document.pattern().tracks[0][3].time_s, 1.01);
        QVERIFY(document.selection().points == PointRefs({{0, 3}, {0, 4}, {0, 5}}));
        document.select({{}, 1});
        document.duplicate();
        QCOMPARE(document.pattern().objects.size(), std::size_t(3));
        QCOMPARE(spanOf(document.pattern().objects[2].form).begin_s, 0.6);
    }

    void tellsWhenItIsSavedAndWhenToKeepACopy() {
        PatternDocument document;
        document.setPattern(sample(), "a.json");
        document.setAutosaveDelay(0);
        QSignalSpy due(&document, &PatternDocument::autosaveDue);
        QSignalSpy dirty(&document, &PatternDocument::dirtyChanged);
        document.rotate(1);
        QVERIFY(due.wait());
        QCOMPARE(due.size(), 1);
        document.markSaved("b.json");
        QVERIFY(!document.isDirty());
        QCOMPARE(document.path(), QString("b.json"));
        QCOMPARE(dirty.size(), 2);
        document.undoStack()->undo();
        QVERIFY(document.isDirty());
    }

    void keepsItsPathWhenItIsMarkedAsSavedWhereItIs() {
        PatternDocument document;
        document.setPattern(sample(), "a.json");
        QSignalSpy moved(&document, &PatternDocument::pathChanged);
        document.markSaved(document.path());
        QCOMPARE(document.path(), QString("a.json"));
        QCOMPARE(moved.size(), 0);
    }

    void keepsACopyAlsoWhileItIsBeingEdited() {
        PatternDocument document;
        document.setPattern(sample(), "a.json");
        document.setAutosaveDelay(50);
        QSignalSpy due(&document, &PatternDocument::autosaveDue);
        // An edit every few milliseconds: a delay restarted by each of them would never end.
        QTimer edits;
        connect(&edits, &QTimer::timeout, &document, [&document] { document.rotate(1); });
        edits.start(5);
        QTRY_VERIFY(due.size() >= 3);
    }

    void whatWasRecoveredIsUnsavedUntilItIsSaved() {
        PatternDocument document;
        document.setPattern(sample(), "a.json", true);
        QVERIFY(document.isDirty());
        document.markSaved("a.json");
        QVERIFY(!document.isDirty());
    }

    void snapsToItsGridUnlessToldNot() {
        PatternDocument document;
        QCOMPARE(document.snapped(0.1234), 0.12);
        document.setSnapStep(0.05);
        QCOMPARE(document.snapped(0.13), 0.15);
        document.setSnapStep(0.0);
        QCOMPARE(document.snapStep_s(), 0.05);
        document.setSnapping(false);
        QCOMPARE(document.snapped(0.1234), 0.1234);
    }

    void followsALawInOneEdit() {
        PatternDocument document;
        Pattern fast;
        fast.id = "mine.2";
        fast.duration_s = 2.0;
        fast.objects.push_back({"", Ring{.duration_s = 1.0, .turns = 5, .burst_s = {}}, {}});
        document.setPattern(fast);
        const auto findings = checkLaws(document.pattern(), document.motors());
        const auto ring = std::find_if(findings.begin(), findings.end(),
                                       [](const Finding& f) { return f.law == Law::ringTooFast; });
        QVERIFY(ring != findings.end());
        document.fix(*ring);
        QCOMPARE(std::get<Ring>(document.pattern().objects[0].form).turns, 2); // 0.5 s >= 0.4 s a turn
        document.undoStack()->undo();
        QVERIFY(document.pattern() == fast);
    }

    void theRingOperationsMoveWholeTracks() {
        PatternDocument document;
        document.setPattern(sample());
        const Track first = sample().tracks[0];
        document.rotate(2);
        QVERIFY(document.pattern().tracks[2] == first);
        document.mirror();
        QVERIFY(document.pattern().tracks[3] == first);
        document.undoStack()->undo();
        document.swapArms();
        QVERIFY(document.pattern().tracks[4] == first);
    }

    void aStretchBeyondADayIsRefusedInWords() {
        PatternDocument document;
        document.setPattern(sample());
        QSignalSpy refusals(&document, &PatternDocument::refused);
        document.stretch(1e6);
        QCOMPARE(refusals.size(), 1);
        QVERIFY(!refusals[0][0].toString().isEmpty());
        QVERIFY(document.pattern() == sample());
    }

    void staleReferencesAreNotSelected() {
        PatternDocument document;
        document.setPattern(sample());
        document.select({{{0, 7}, {9, 0}, {3, 1}, {3, 1}}, 8});
        QVERIFY(document.selection() == (Selection{{{3, 1}}, {}}));
    }
};

namespace {
const test::Registration<PatternDocumentTest> registration;
}
#include "pattern_document_test.moc"
