// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/test_registry.h"
#include "widgets/touch/pattern_map_table.h"

#include <QComboBox>
#include <QFile>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QWheelEvent>

using namespace teleta;
using namespace teleta::touch;
using pattern::PatternMap;

namespace {

std::vector<PatternChoice> choices() {
    std::vector<PatternChoice> all;
    for (const char* task : {"stiffness", "shape"})
        for (const char letter : {'A', 'B', 'C', 'D', 'E', 'F'})
            for (const char* condition : {"static", "dynamic"})
                if (letter != 'F' || task[1] == 'h')
                    all.push_back({std::string(task) + '.' + letter + '.' + condition,
                                   QString("%1 %2 %3").arg(task).arg(letter).arg(condition), task,
                                   condition});
    return all;
}

constexpr int kFirstShape = 5;

} // namespace

/// The table from what was recognised to a pattern.
class PatternMapTableTest : public QObject {
    Q_OBJECT

private slots:
    void hasARowForEveryLevelAndShape() {
        PatternMapTable table;
        table.setChoices(choices());
        QCOMPARE(table.table()->rowCount(), 13);
        QVERIFY(table.table()->item(0, 0)->text().contains("sponge"));
        QVERIFY(table.table()->item(4, 0)->text().contains("metal"));
        QCOMPARE(table.table()->item(kFirstShape, 0)->text(), QString("circle"));
        QCOMPARE(table.table()->item(11, 0)->text(), QString("unknown shape"));
        QCOMPARE(table.table()->item(12, 0)->text(), QString("unknown stiffness"));
        QCOMPARE(table.box(2)->currentText(), QString("stiffness C dynamic"));
        QCOMPARE(table.table()->item(2, 2)->text(), QString("stiffness, dynamic"));
        QCOMPARE(table.box(11)->currentText(), QString("nothing"));
    }

    void whatWasChosenIsReadInANarrowDockToo() {
        PatternMapTable table;
        table.setChoices(choices());
        table.resize(430, 600);
        table.show();
        QVERIFY(QTest::qWaitForWindowExposed(&table));
        const QComboBox* box = table.box(2);
        QTRY_VERIFY(box->width() >= box->sizeHint().width());
        QTRY_VERIFY(table.table()->columnWidth(0) >= table.fontMetrics().horizontalAdvance("level 5: metal"));
        QCOMPARE(table.table()->item(2, 2)->toolTip(), QString("stiffness, dynamic"));
    }

    void aKeyInABoxEditsTheMapAndIsUndone() {
        PatternMapTable table;
        table.setChoices(choices());
        table.show();
        QVERIFY(QTest::qWaitForWindowActive(&table));
        QSignalSpy changes(&table, &PatternMapTable::mapChanged);
        const int before = table.box(0)->currentIndex();
        table.box(0)->setFocus();
        QTest::keyClick(table.box(0), Qt::Key_Down);
        QCOMPARE(changes.size(), 1);
        QCOMPARE(table.box(0)->currentIndex(), before + 1);
        QCOMPARE(table.map().stiffness[0], table.box(0)->currentData().toString().toStdString());
        QTest::keySequence(table.box(0), QKeySequence::Undo);
        QCOMPARE(table.map(), PatternMap::defaults());
        QCOMPARE(table.box(0)->currentIndex(), before);
        QTest::keySequence(table.box(0), QKeySequence::Redo);
        QCOMPARE(table.box(0)->currentIndex(), before + 1);
    }

    void defaultsAreAnEditToo() {
        PatternMapTable table;
        table.setChoices(choices());
        table.choose(kFirstShape, "shape.B.static");
        table.resetToDefaults();
        QCOMPARE(table.map(), PatternMap::defaults());
        table.undoStack()->undo();
        QCOMPARE(table.map().ofShape("circle"), std::string("shape.B.static"));
    }

    void theSameChoiceAgainIsNoEdit() {
        PatternMapTable table;
        table.setChoices(choices());
        table.choose(0, "stiffness.A.dynamic");
        QCOMPARE(table.undoStack()->count(), 0);
    }

    void namesThePatternThatWouldBePlayedNow() {
        PatternMapTable table;
        table.setChoices(choices());
        QVERIFY(table.patternNow().empty());
        table.setRecognisedStiffness(3);
        QCOMPARE(table.patternNow(), std::string("stiffness.C.dynamic"));
        QVERIFY2(table.textNow().contains("rubber") && table.textNow().contains("stiffness C dynamic"),
                 qPrintable(table.textNow()));
        QVERIFY(table.table()->item(2, 0)->text().contains("now"));
        table.setRecognisedShape(contour::Shape::triangle);
        QCOMPARE(table.patternNow(), std::string("shape.C.dynamic"));
        QVERIFY(!table.table()->item(2, 0)->text().contains("now"));
        QVERIFY(table.table()->item(kFirstShape + 2, 0)->background() !=
                table.table()->item(2, 0)->background());
        table.choose(kFirstShape + 2, "shape.A.static");
        QVERIFY(table.textNow().contains("shape A static"));
        table.setRecognisedShape(contour::Shape::unknown);
        QVERIFY(table.textNow().contains("Nothing is played"));
        table.setRecognisedStiffness(9);
        QVERIFY(!table.recognisedRow());
    }

    void aPatternThatIsMissingStaysInTheMap() {
        PatternMapTable table;
        table.setChoices(choices());
        PatternMap map = PatternMap::defaults();
        map.stiffness[1] = "mine";
        table.setMap(map);
        QVERIFY(table.box(1)->currentText().contains("mine"));
        QVERIFY(table.box(1)->currentText().contains("missing"));
        table.setRecognisedStiffness(2);
        QVERIFY(table.textNow().contains("missing"));
        QCOMPARE(table.map(), map);
    }

    void aWheelOverABoxChangesNothing() {
        PatternMapTable table;
        table.setChoices(choices());
        QWheelEvent wheel(QPointF(5, 5), QPointF(5, 5), QPoint(), QPoint(0, -120), Qt::NoButton, {},
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(table.box(0), &wheel);
        QCOMPARE(table.map(), PatternMap::defaults());
    }

    void whatIsExportedIsImportedAgainAsOneEdit() {
        const QTemporaryDir folder;
        const QString path = folder.filePath("map.json");
        PatternMapTable table;
        table.setChoices(choices());
        table.choose(0, "stiffness.B.static");
        table.choose(kFirstShape + 6, "shape.F.static");
        QVERIFY(table.exportTo(path).has_value());
        PatternMapTable other;
        other.setChoices(choices());
        QVERIFY(other.importFrom(path).has_value());
        QCOMPARE(other.map(), table.map());
        QCOMPARE(other.undoStack()->count(), 1);
        QVERIFY(!table.exportTo(folder.filePath("none/map.json")).has_value());
    }

    void aWrongFileIsRefusedWithThePlace_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<int>("line");
        QTest::newRow("not JSON") << QByteArray("{\n  \"format\": ") << 2;
        QTest::newRow("another format") << QByteArray("{\n\"format\": \"x\",\n\"version\": 1}") << 2;
        QTest::newRow("four levels")
            << QByteArray("{\n\"format\": \"teleta-pattern-map\",\n\"version\": 1,\n\"stiffness\": "
                          "[\"\", \"\", \"\", \"\"],\n\"shape\": {}}")
            << 4;
        QTest::newRow("a number for an id")
            << QByteArray("{\n\"format\": \"teleta-pattern-map\",\n\"version\": 1,\n\"stiffness\": "
                          "[\"\", \"\",\n 7, \"\", \"\"],\n\"shape\": {}}")
            << 5;
    }
    void aWrongFileIsRefusedWithThePlace() {
        QFETCH(QByteArray, text);
        QFETCH(int, line);
        const QTemporaryDir folder;
        const QString path = folder.filePath("map.json");
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(text);
        file.close();
        PatternMapTable table;
        const auto result = table.importFrom(path);
        QVERIFY(!result.has_value());
        QCOMPARE(result.error().kind, core::ErrorKind::badInput);
        QCOMPARE(result.error().where.file, path.toStdString());
        QCOMPARE(result.error().where.line, line);
        QCOMPARE(table.map(), PatternMap::defaults());
        QCOMPARE(table.undoStack()->count(), 0);
    }
};

namespace {
const test::Registration<PatternMapTableTest> registration;
}
#include "pattern_map_table_test.moc"
