// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/model/built_in_patterns.h"
#include "tests/widgets/test_registry.h"
#include "widgets/base/theme.h"
#include "widgets/pattern/law_list.h"
#include "widgets/pattern/pattern_editor.h"
#include "widgets/pattern/pattern_inspector.h"
#include "widgets/pattern/stroke_pad.h"
#include "widgets/pattern/timeline/timeline_view.h"

#include <QApplication>
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMouseEvent>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>

using namespace teleta;
using namespace teleta::pattern;

namespace {

LawList& lawsOf(const PatternEditor& editor) {
    return *editor.findChild<LawList*>();
}

} // namespace

/// The parts of the editor together.
class PatternEditorTest : public QObject {
    Q_OBJECT

private slots:
    void theFieldsOfThePropertiesHaveRoomInASmallWindow() {
        PatternEditor editor;
        const int line = editor.fontMetrics().height();
        for (const int width : {60 * line, 75 * line, 110 * line}) {
            editor.resize(width, 36 * line);
            editor.show();
            QVERIFY(QTest::qWaitForWindowExposed(&editor));
            auto* inspector = editor.findChild<PatternInspector*>();
            QCoreApplication::processEvents();
            const QWidget* room = inspector->findChild<QScrollArea*>()->viewport();
            const auto fields = inspector->findChildren<QWidget*>();
            for (const QWidget* field : fields) {
                const bool isField = qobject_cast<const QLineEdit*>(field) != nullptr ||
                                     qobject_cast<const QAbstractSpinBox*>(field) != nullptr ||
                                     qobject_cast<const QComboBox*>(field) != nullptr;
                if (!field->isVisible() || !isField)
                    continue;
                const QRect place(field->mapTo(room, QPoint()), field->size());
                QVERIFY2(place.left() >= 0 && place.right() < room->width() && place.width() > 2 * line,
                         qPrintable(QStringLiteral("%1: %2 to %3 of %4")
                                        .arg(width)
                                        .arg(place.left())
                                        .arg(place.right())
                                        .arg(room->width())));
            }
            // Without a warning the laws are one line.
            const auto* laws = editor.findChild<LawList*>();
            QVERIFY(laws->isVisible());
            QTRY_VERIFY(laws->isChecked());
            QVERIFY(laws->list()->isHidden());
            const auto topOf = [&editor](const QWidget* widget) {
                return widget->mapTo(&editor, QPoint()).y();
            };
            const auto* pad = editor.findChild<StrokePad*>();
            if (topOf(inspector) > topOf(laws)) {
                QTRY_VERIFY(laws->height() <= 2 * line + 8);
                QTRY_VERIFY(topOf(inspector) - topOf(laws) <= 3 * line);
            } else {
                QTRY_COMPARE(inspector->height(), pad->height());
            }
        }
    }

    void aLawIsFixedByItsButtonAndUndone() {
        PatternEditor editor;
        Pattern fast;
        fast.id = "mine.1";
        fast.duration_s = 1.0;
        fast.objects.push_back({"", Ring{.duration_s = 1.0, .turns = 5, .burst_s = {}}, {}});
        editor.document()->setPattern(fast);
        lawsOf(editor).check();
        QTRY_VERIFY(lawsOf(editor).isChecked());
        QVERIFY(!lawsOf(editor).findings().empty());
        QVERIFY(lawsOf(editor).findChild<QPushButton*>("fix")->isEnabled());
        const std::size_t before = lawsOf(editor).findings().size();
        QTest::mouseClick(lawsOf(editor).findChild<QPushButton*>("fix"), Qt::LeftButton);
        QVERIFY(!lawsOf(editor)
                     .findChild<QPushButton*>("fix")
                     ->isEnabled()); // the findings are of the pattern before
        QTRY_VERIFY(lawsOf(editor).isChecked());
        QVERIFY(lawsOf(editor).findings().size() < before);
        QVERIFY(!(editor.document()->pattern() == fast));
        QCOMPARE(editor.document()->undoStack()->count(), 1);
        editor.document()->undoStack()->undo();
        QVERIFY(editor.document()->pattern() == fast);
        Pattern silent;
        silent.duration_s = 1.0;
        editor.document()->setPattern(silent);
        QTRY_VERIFY(lawsOf(editor).isChecked());
        QVERIFY(lawsOf(editor).findChild<QLabel*>("headline")->text().contains("no warning"));
        QVERIFY(!lawsOf(editor).findChild<QPushButton*>("fix")->isEnabled());
    }

    void theKeyboardStaysAtTheLawsAfterAFix() {
        PatternEditor editor;
        editor.resize(1200, 800);
        editor.show();
        editor.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&editor));
        Pattern fast;
        fast.id = "mine.1";
        fast.duration_s = 1.0;
        fast.objects.push_back({"", Ring{.duration_s = 1.0, .turns = 5, .burst_s = {}}, {}});
        editor.document()->setPattern(fast);
        lawsOf(editor).check();
        QTRY_VERIFY(lawsOf(editor).isChecked());
        auto* fix = lawsOf(editor).findChild<QPushButton*>("fix");
        fix->setFocus();
        QTest::keyClick(fix, Qt::Key_Space);
        QTRY_VERIFY(lawsOf(editor).isChecked());
        QWidget* focus = QApplication::focusWidget();
        QVERIFY(focus != nullptr);
        QVERIFY2(lawsOf(editor).isAncestorOf(focus), focus->metaObject()->className());
        // So the keys that follow are commands, not a new name.
        QSignalSpy exported(&editor, &PatternEditor::exportRequested);
        const std::string name = editor.document()->pattern().name;
        QTest::keyClick(focus, Qt::Key_E, Qt::ControlModifier);
        QCOMPARE(exported.count(), 1);
        QTest::keyClicks(QApplication::focusWidget(), QStringLiteral("file"));
        QCOMPARE(editor.document()->pattern().name, name);
    }

    void ctrlEExportsFromATextFieldToo() {
        PatternEditor editor;
        editor.resize(1200, 800);
        editor.show();
        editor.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&editor));
        QSignalSpy exported(&editor, &PatternEditor::exportRequested);
        int fields = 0;
        for (QWidget* field : editor.findChild<PatternInspector*>()->findChildren<QWidget*>()) {
            if (!field->isVisible() || (qobject_cast<QLineEdit*>(field) == nullptr &&
                                        qobject_cast<QDoubleSpinBox*>(field) == nullptr))
                continue;
            field->setFocus();
            if (QApplication::focusWidget() != field)
                continue;
            QTest::keyClick(field, Qt::Key_E, Qt::ControlModifier);
            QCOMPARE(exported.count(), ++fields);
        }
        QVERIFY(fields >= 2);
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

    void aStrokeBeyondTheVisibleTimeIsScrolledTo() {
        PatternEditor editor;
        Pattern pattern;
        pattern.id = "mine.1";
        pattern.duration_s = 4.0;
        editor.document()->setPattern(pattern);
        editor.resize(1200, 800);
        editor.show();
        QVERIFY(QTest::qWaitForWindowExposed(&editor));
        auto* timeline = editor.findChild<TimelineView*>();
        timeline->showSpan(0.0, 2.0);
        editor.setPlayhead(3.0);
        auto* pad = editor.findChild<StrokePad*>();
        pad->setFocus();
        for (const Qt::Key key : {Qt::Key_Space, Qt::Key_Right, Qt::Key_Space, Qt::Key_Return})
            QTest::keyClick(pad, key);
        QCOMPARE(editor.document()->pattern().objects.size(), std::size_t(1));
        QVERIFY(timeline->begin_s() <= 3.0);
        QVERIFY(timeline->begin_s() + timeline->span_s() >= 3.0 + StrokePad::kKeyStep_s);
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

    void twoPatternsAreComparedInNumbers() {
        PatternEditor editor;
        Pattern ramp;
        ramp.id = "mine.1";
        ramp.duration_s = 1.0;
        ramp.tracks[2] = {{0.0, 0.0}, {1.0, 1.0}};
        editor.document()->setPattern(ramp);
        auto other = std::make_shared<Pattern>();
        other->name = "silence";
        other->duration_s = 1.0;
        const auto* comparison = editor.findChild<QLabel*>("comparison");
        QVERIFY(comparison->parentWidget()->isHidden());
        editor.compareWith(other);
        // Largest 1 at its end; rms over six motors sqrt(1/3 / 6).
        QTRY_VERIFY2(comparison->text().contains("100.0 %"), qPrintable(comparison->text()));
        QVERIFY(comparison->text().contains("motor 3"));
        QVERIFY(comparison->text().contains("23.6 %"));
        editor.document()->select({{{2, 1}}, {}});
        editor.document()->deleteSelection();
        editor.document()->select({{{2, 0}}, {}});
        editor.document()->deleteSelection();
        QTRY_VERIFY(comparison->text().contains("no difference"));
        QVERIFY(!comparison->parentWidget()->isHidden());
        editor.compareWith(nullptr);
        QVERIFY(comparison->parentWidget()->isHidden());
    }

    void aStrokeIsDrawnWithKeysAlone() {
        PatternDocument document;
        StrokePad pad(&document);
        pad.resize(400, 200);
        QTest::keyClick(&pad, Qt::Key_Space);
        QTest::keyClick(&pad, Qt::Key_Right);
        QTest::keyClick(&pad, Qt::Key_Right);
        QTest::keyClick(&pad, Qt::Key_Down);
        QTest::keyClick(&pad, Qt::Key_Space);
        QTest::keyClick(&pad, Qt::Key_Space);
        QTest::keyClick(&pad, Qt::Key_Backspace);
        QVERIFY(document.pattern().objects.empty());
        QTest::keyClick(&pad, Qt::Key_Return);
        QCOMPARE(document.pattern().objects.size(), std::size_t(1));
        const auto& stroke = std::get<Stroke>(document.pattern().objects[0].form);
        QCOMPARE(stroke.points.size(), std::size_t(2));
        QCOMPARE(stroke.points[1].time_s, StrokePad::kKeyStep_s);
        QVERIFY(std::abs(stroke.points[1].angle_rad - std::numbers::pi / 3.0) < 1e-12);
        QCOMPARE(stroke.points[1].along, 0.25);
        QTest::keyClick(&pad, Qt::Key_Space);
        QTest::keyClick(&pad, Qt::Key_Escape);
        QTest::keyClick(&pad, Qt::Key_Return);
        QCOMPARE(document.pattern().objects.size(), std::size_t(1));
    }

    void everyNumberOfEveryObjectCanBeTyped_data() {
        QTest::addColumn<int>("form");
        QTest::addColumn<QStringList>("fields");
        QTest::newRow("sweep") << 0 << QStringList{"start", "burst", "onset", "intensity"};
        QTest::newRow("ring") << 1 << QStringList{"start", "length", "turns", "first", "burst", "intensity"};
        QTest::newRow("phantom") << 2 << QStringList{"start", "length", "first",    "second",
                                                     "from",  "to",     "intensity"};
        QTest::newRow("ramp") << 3 << QStringList{"start", "length", "from", "to"};
        QTest::newRow("pulse train") << 4 << QStringList{"start", "length", "period", "width", "intensity"};
        QTest::newRow("stroke") << 5 << QStringList{"start",      "length",     "turned",   "intensity",
                                                    "pointAngle", "pointAlong", "pointTime"};
    }
    void everyNumberOfEveryObjectCanBeTyped() {
        QFETCH(int, form);
        QFETCH(QStringList, fields);
        const std::array<ObjectForm, 6> forms{
            Sweep{.start_s = 0.0, .burst_s = 0.1, .onset_s = {}, .tactors = {0, 1}, .intensity = 1.0},
            Ring{.start_s = 0.0, .duration_s = 2.0, .burst_s = {}},
            Phantom{},
            Ramp{.tactors = {0}},
            PulseTrain{.tactors = {0}},
            Stroke{.points = {{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}}}};
        PatternEditor editor;
        Pattern pattern;
        pattern.id = "mine.1";
        pattern.duration_s = 5.0;
        pattern.objects.push_back({"", forms[static_cast<std::size_t>(form)], {}});
        editor.document()->setPattern(pattern);
        editor.document()->select({{}, 0});
        for (const QString& name : fields) {
            auto* box = editor.findChild<PatternInspector*>()->findChild<QDoubleSpinBox*>(name);
            QVERIFY2(box, qPrintable(name));
            const double wanted = box->value() > 0.5 * box->maximum() ? box->value() - box->singleStep()
                                                                      : box->value() + box->singleStep();
            const quint64 before = editor.document()->revision();
            box->setValue(wanted);
            QVERIFY2(editor.document()->revision() > before, qPrintable(name));
            QVERIFY2(std::abs(box->value() - wanted) < 1e-3, qPrintable(name)); // as the pattern has it
            editor.document()->undoStack()->undo();
            QVERIFY2(editor.document()->pattern() == pattern, qPrintable(name));
        }
        auto* name = editor.findChild<PatternInspector*>()->findChild<QLineEdit*>("objectName");
        QTest::keyClicks(name, "wave");
        QCOMPARE(editor.document()->pattern().objects[0].name, std::string("wave"));
        QCOMPARE(editor.document()->undoStack()->count(), 1);
    }

    void theLawOfApparentMotionIsTurnedOnAndOff() {
        PatternEditor editor;
        Pattern pattern;
        pattern.id = "mine.1";
        pattern.duration_s = 3.0;
        pattern.objects.push_back({"", Ring{.burst_s = {}}, {}});
        editor.document()->setPattern(pattern);
        editor.document()->select({{}, 0});
        auto* byLaw = editor.findChild<PatternInspector*>()->findChild<QCheckBox*>("burstByLaw");
        QVERIFY(byLaw && byLaw->isChecked());
        byLaw->click();
        const auto ring = [&editor] { return std::get<Ring>(editor.document()->pattern().objects[0].form); };
        QVERIFY(ring().burst_s && std::abs(*ring().burst_s - 0.1994) < 1e-4); // 3 turns in 2 s: 199.4 ms
        byLaw->click();
        QVERIFY(!ring().burst_s);
        editor.findChild<PatternInspector*>()->findChild<QCheckBox*>("counterClockwise")->click();
        QVERIFY(!ring().counterClockwise);
    }

    void theLoopIsSetByNumbersAndByKeys() {
        PatternEditor editor;
        editor.document()->setPattern(*findBuiltIn("shape.A.dynamic"));
        editor.findChild<PatternInspector*>()->findChild<QDoubleSpinBox*>("loopEnd")->setValue(1.5);
        QVERIFY(editor.timeline()->loop());
        QCOMPARE(editor.timeline()->loop()->end_s, 1.5);
        QVERIFY(editor.looping());
        editor.setPlayhead(0.5);
        QTest::keyClick(editor.timeline(), Qt::Key_BracketLeft);
        QCOMPARE(editor.timeline()->loop()->begin_s, 0.5);
        QCOMPARE(editor.findChild<PatternInspector*>()->findChild<QDoubleSpinBox*>("loopBegin")->value(),
                 0.5);
        QTest::keyClick(editor.timeline(), Qt::Key_Backslash);
        QVERIFY(!editor.timeline()->loop());
    }

    void breakpointsAndObjectsAreChosenWithKeys() {
        PatternEditor editor;
        Pattern pattern;
        pattern.id = "mine.1";
        pattern.duration_s = 2.0;
        pattern.tracks[0] = {{0.1, 0.2}, {0.5, 0.4}, {0.9, 0.6}};
        pattern.objects = {{"a", Phantom{}, {}}, {"b", Phantom{.start_s = 1.0}, {}}};
        editor.document()->setPattern(pattern);
        QTest::keyClick(editor.timeline(), Qt::Key_Period);
        QTest::keyClick(editor.timeline(), Qt::Key_Greater, Qt::ShiftModifier);
        QVERIFY(editor.document()->selection().points == PointRefs({{0, 0}, {0, 1}}));
        QTest::keyClick(editor.timeline(), Qt::Key_Right);
        QCOMPARE(editor.document()->pattern().tracks[0][1].time_s, 0.51);
        QTest::keyClick(editor.timeline(), Qt::Key_N);
        QVERIFY(editor.document()->selection().object == std::size_t(0));
        QTest::keyClick(editor.timeline(), Qt::Key_N, Qt::ShiftModifier);
        QVERIFY(editor.document()->selection().object == std::size_t(1));
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
