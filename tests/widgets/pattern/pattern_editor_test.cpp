// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/built_in_patterns.h"
#include "tests/widgets/test_registry.h"
#include "widgets/pattern/law_list.h"
#include "widgets/pattern/pattern_editor.h"
#include "widgets/pattern/pattern_library.h"
#include "widgets/pattern/stroke_pad.h"
#include "widgets/pattern/timeline_view.h"

#include <QApplication>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QListWidget>
#include <QMouseEvent>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QTreeWidget>

#include <cmath>

using namespace teleta;
using namespace teleta::editor;
using namespace teleta::pattern;

/// The parts of the editor together.
class PatternEditorTest : public QObject {
    Q_OBJECT

private slots:
    void theLibraryListsAllBuiltInsAndFilters() {
        PatternLibrary library;
        QCOMPARE(library.tree()->topLevelItem(0)->childCount(), 12);
        QCOMPARE(library.tree()->topLevelItem(1)->childCount(), 10);
        QTest::keyClicks(library.filter(), "shape.A");
        int shown = 0;
        for (int i = 0; i < 12; ++i)
            shown += library.tree()->topLevelItem(0)->child(i)->isHidden() ? 0 : 1;
        QCOMPARE(shown, 2);
        QVERIFY(library.tree()->topLevelItem(1)->isHidden());
        QSignalSpy opened(&library, &PatternLibrary::openRequested);
        emit library.tree()->itemActivated(library.tree()->topLevelItem(0)->child(0), 0);
        QCOMPARE(opened[0][0].toString(), QString("shape.A.static"));
    }

    void aLawIsFixedByItsButtonAndUndone() {
        PatternEditor editor;
        Pattern fast;
        fast.id = "mine.1";
        fast.duration_s = 1.0;
        fast.objects.push_back({"", Ring{.duration_s = 1.0, .turns = 5, .burst_s = {}}, {}});
        editor.document()->setPattern(fast);
        editor.laws()->check();
        QVERIFY(!editor.laws()->findings().empty());
        QVERIFY(editor.laws()->fixButton()->isEnabled());
        const std::size_t before = editor.laws()->findings().size();
        QTest::mouseClick(editor.laws()->fixButton(), Qt::LeftButton);
        QVERIFY(editor.laws()->findings().size() < before);
        QVERIFY(!(editor.document()->pattern() == fast));
        QCOMPARE(editor.document()->undoStack()->count(), 1);
        editor.document()->undoStack()->undo();
        QVERIFY(editor.document()->pattern() == fast);
        Pattern silent;
        silent.duration_s = 1.0;
        editor.document()->setPattern(silent);
        editor.laws()->check();
        QVERIFY(editor.laws()->headline().contains("no warning"));
        QVERIFY(!editor.laws()->fixButton()->isEnabled());
    }

    void aStrokeIsAnObjectAtThePlayhead() {
        PatternDocument document;
        StrokePad pad(&document);
        pad.resize(400, 200);
        pad.setStart(0.5);
        const auto send = [&pad](QEvent::Type type, const QPointF& at, quint64 time_ms) {
            QMouseEvent event(type, at, pad.mapToGlobal(at), Qt::LeftButton,
                              type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton, {});
            event.setTimestamp(time_ms);
            QApplication::sendEvent(&pad, &event);
        };
        send(QEvent::MouseButtonPress, pad.placeOf(0.0, 0.0), 1000);
        send(QEvent::MouseMove, pad.placeOf(1.0, 0.5), 1400);
        send(QEvent::MouseButtonRelease, pad.placeOf(2.0, 1.0), 1800);
        QCOMPARE(document.pattern().objects.size(), std::size_t(1));
        const auto& stroke = std::get<Stroke>(document.pattern().objects[0].form);
        QCOMPARE(stroke.start_s, 0.5);
        QCOMPARE(stroke.points.size(), std::size_t(3));
        QCOMPARE(stroke.points[1].time_s, 0.4);
        QVERIFY(std::abs(stroke.points[1].angle_rad - 1.0) < 1e-9);
        QVERIFY(std::abs(stroke.points[2].along - 1.0) < 1e-9);
        document.undoStack()->undo();
        QVERIFY(document.pattern().objects.empty());
    }

    void numbersOfAnObjectAreEdited() {
        PatternEditor editor;
        Pattern pattern;
        pattern.id = "mine.1";
        pattern.duration_s = 3.0;
        pattern.objects.push_back({"", Ring{}, {}});
        editor.document()->setPattern(pattern);
        editor.resize(1200, 800);
        editor.show();
        editor.document()->select({{}, 0});
        auto* turns = editor.findChild<QDoubleSpinBox*>("turns");
        QVERIFY(turns);
        QCOMPARE(turns->value(), 3.0);
        turns->setValue(2.0);
        QCOMPARE(std::get<Ring>(editor.document()->pattern().objects[0].form).turns, 2);
        QSignalSpy refusals(editor.document(), &PatternDocument::refused);
        QTest::mouseClick(editor.findChild<QPushButton*>("bake"), Qt::LeftButton);
        QVERIFY2(refusals.empty(), refusals.empty() ? "" : qPrintable(refusals[0][0].toString()));
        QVERIFY(editor.document()->pattern().objects.empty());
        QCOMPARE(editor.document()->undoStack()->count(), 2);
    }

    void asksToPlayAndToStop() {
        PatternEditor editor;
        editor.document()->setPattern(*findBuiltIn("shape.A.dynamic"));
        QSignalSpy plays(&editor, &PatternEditor::playRequested);
        QSignalSpy stops(&editor, &PatternEditor::stopRequested);
        QTest::keyClick(editor.timeline(), Qt::Key_Space);
        QCOMPARE(plays.size(), 1);
        editor.setPlaying(true);
        QTest::keyClick(editor.timeline(), Qt::Key_Space);
        QCOMPARE(stops.size(), 1);
        QSignalSpy moves(&editor, &PatternEditor::playheadMoved);
        editor.setPlayhead(1.0);
        QCOMPARE(editor.timeline()->playhead_s(), 1.0);
        QCOMPARE(moves.size(), 0);
    }
};

namespace {
const test::Registration<PatternEditorTest> registration;
}
#include "pattern_editor_test.moc"
