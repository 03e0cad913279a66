// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/test_registry.h"
#include "widgets/touch/run_sheet.h"

#include <QLabel>
#include <QLineEdit>
#include <QTableView>
#include <QTest>

#include <utility>

using namespace teleta;
using namespace teleta::touch;

namespace {

pipeline::FoundObject objectOf(std::uint64_t number) {
    pipeline::FoundObject object;
    object.number = number;
    object.first_s = 12.5;
    object.touches = 3;
    object.p_Base_Centre_m = {0.19, -0.012, -0.34};
    object.contact = contact::ContactType::edge;
    object.highestForce_N = 0.5;
    object.stiffness = stiffness::Stiffness{
        .value_NPerM = 282.0, .se_NPerM = {}, .lower95_NPerM = 275.0, .upper95_NPerM = 290.0};
    object.material = stiffness::Material::sponge;
    object.recognition.emplace();
    object.recognition->shape = contour::Shape::circle;
    object.recognition->confidence = 0.97;
    return object;
}

QString cell(const RunSheet& sheet, int row, int column) {
    return sheet.view()->model()->index(row, column).data().toString().replace(QChar(0x00a0), u' ');
}

struct Desk {
    Desk() {
        sheet.setObjects({objectOf(1), objectOf(2), objectOf(3)});
        sheet.show();
        active = QTest::qWaitForWindowActive(&sheet);
        sheet.view()->setFocus();
    }
    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
        QTest::keyClick(sheet.view(), key, modifiers);
    }
    [[nodiscard]] int rows() const { return sheet.view()->model()->rowCount(); }

    RunSheet sheet;
    bool active = false;
};

} // namespace

/// The list of the objects that were found.
class RunSheetTest : public QObject {
    Q_OBJECT

private slots:
    void showsWhatIsKnownWithUnits() {
        Desk desk;
        QCOMPARE(desk.rows(), 3);
        QCOMPARE(cell(desk.sheet, 0, RunSheetModel::number), QString("1"));
        QCOMPARE(cell(desk.sheet, 0, RunSheetModel::time), QString("12.500 s"));
        QCOMPARE(cell(desk.sheet, 0, RunSheetModel::place), QString::fromUtf8("190, \u221212 mm"));
        QCOMPARE(cell(desk.sheet, 0, RunSheetModel::contact), QString("edge"));
        QCOMPARE(cell(desk.sheet, 0, RunSheetModel::stiffness), QString::fromUtf8("282 N/m (275 … 290 N/m)"));
        QCOMPARE(cell(desk.sheet, 0, RunSheetModel::material), QString("sponge, SAFE"));
        QCOMPARE(cell(desk.sheet, 0, RunSheetModel::shape), QString("circle (97 %)"));
    }

    void theEndsOfANarrowIntervalCanBeToldApart() {
        Desk desk;
        const auto shown = [&](double low_NPerM, double high_NPerM) {
            auto object = objectOf(1);
            object.stiffness = stiffness::Stiffness{.value_NPerM = 295.0,
                                                    .se_NPerM = {},
                                                    .lower95_NPerM = low_NPerM,
                                                    .upper95_NPerM = high_NPerM};
            desk.sheet.setObjects({object, objectOf(2), objectOf(3)});
            return cell(desk.sheet, 0, RunSheetModel::stiffness);
        };
        QCOMPARE(shown(294.6, 295.3), QString::fromUtf8("295 N/m (294.6 … 295.3 N/m)"));
        QCOMPARE(shown(294.98, 295.01), QString::fromUtf8("295 N/m (294.98 … 295.01 N/m)"));
        QCOMPARE(shown(295.0, 295.0), QString("295 N/m"));
    }

    void anEmptySheetSaysWhatFillsIt() {
        RunSheet sheet;
        const auto hint = [&] { return sheet.view()->viewport()->findChild<QLabel*>()->text(); };
        QVERIFY(hint().contains("Drive the arm"));
        for (const auto recorded : {base::Provenance::recorded, base::Provenance::recordedSimulation}) {
            sheet.setProvenance(recorded);
            QVERIFY(hint().contains("Play the recording"));
        }
        sheet.setProvenance(base::Provenance::simulated);
        QVERIFY(hint().contains("Drive the arm"));
    }

    void aNameIsTypedAndUndone() {
        Desk desk;
        QVERIFY(desk.active);
        desk.sheet.view()->setCurrentIndex(desk.sheet.model().index(1, RunSheetModel::name));
        desk.key(Qt::Key_F2);
        auto* editor = desk.sheet.view()->findChild<QLineEdit*>();
        QVERIFY(editor);
        QTest::keyClicks(editor, "  red,  \"big\" box ");
        QTest::keyClick(editor, Qt::Key_Return);
        QTRY_COMPARE(cell(desk.sheet, 1, RunSheetModel::name), QString("red, \"big\" box"));
        QVERIFY(desk.sheet.csv().contains("\n2,\"red, \"\"big\"\" box\",12.5,"));
        desk.key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(cell(desk.sheet, 1, RunSheetModel::name), QString());
        desk.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(cell(desk.sheet, 1, RunSheetModel::name), QString("red, \"big\" box"));
    }

    void whatIsTypedStaysWhenObjectsAreTouchedOrFoundMeanwhile() {
        Desk desk;
        QVERIFY(desk.active);
        desk.sheet.view()->setCurrentIndex(desk.sheet.model().index(1, RunSheetModel::shape));
        desk.key(Qt::Key_F2);
        auto* editor = desk.sheet.view()->findChild<QLineEdit*>();
        QVERIFY(editor);
        QTest::keyClicks(editor, "po");
        auto touched = objectOf(2);
        touched.touches = 4;
        desk.sheet.setObjects({objectOf(1), touched, objectOf(3)});
        desk.sheet.setObjects({objectOf(1), touched, objectOf(3), objectOf(4)});
        QCOMPARE(cell(desk.sheet, 1, RunSheetModel::touches), QString("4"));
        QTest::keyClicks(editor, "st");
        QTest::keyClick(editor, Qt::Key_Return);
        QTRY_COMPARE(cell(desk.sheet, 1, RunSheetModel::name), QString("post"));
    }

    void whatIsDeletedComesBackWithItsName() {
        Desk desk;
        QVERIFY(desk.active);
        desk.sheet.model().rename(2, "post");
        desk.sheet.view()->selectRow(1);
        desk.key(Qt::Key_Delete);
        QCOMPARE(desk.rows(), 2);
        QCOMPARE(cell(desk.sheet, 1, RunSheetModel::number), QString("3"));
        QVERIFY(!desk.sheet.csv().contains("post"));
        desk.sheet.setObjects({objectOf(1), objectOf(2), objectOf(3), objectOf(4)}); // meanwhile one is found
        QCOMPARE(desk.rows(), 3);
        desk.key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(desk.rows(), 4);
        QCOMPARE(cell(desk.sheet, 1, RunSheetModel::name), QString("post"));
    }

    void anObjectThatIsTouchedAgainKeepsRowAndSelection() {
        Desk desk;
        desk.sheet.view()->selectRow(1);
        auto changed = objectOf(2);
        changed.touches = 9;
        desk.sheet.setObjects({objectOf(1), changed, objectOf(3)});
        QCOMPARE(cell(desk.sheet, 1, RunSheetModel::touches), QString("9"));
        QCOMPARE(desk.sheet.view()->currentIndex().row(), 1);
        desk.sheet.setObjects({objectOf(1)}); // another run
        QCOMPARE(desk.rows(), 1);
    }

    void whatWasPutDownComesBackWithTheRunItIsAbout() {
        Desk desk;
        QVERIFY(desk.active);
        desk.sheet.model().rename(1, "post");
        desk.sheet.view()->selectRow(2);
        desk.key(Qt::Key_Delete);
        QCOMPARE(desk.rows(), 2);
        auto notes = desk.sheet.model().takeNotes();
        QCOMPARE(desk.rows(), 0);
        desk.sheet.setObjects({objectOf(1)}); // another arm is looked at
        QCOMPARE(cell(desk.sheet, 0, RunSheetModel::name), QString());
        desk.key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(cell(desk.sheet, 0, RunSheetModel::name), QString());
        desk.sheet.model().setNotes(std::move(notes));
        QCOMPARE(desk.rows(), 0);
        desk.sheet.setObjects({objectOf(1), objectOf(2), objectOf(3), objectOf(4)});
        QCOMPARE(desk.rows(), 3);
        QCOMPARE(cell(desk.sheet, 0, RunSheetModel::name), QString("post"));
        desk.key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(desk.rows(), 4);
        desk.key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(cell(desk.sheet, 0, RunSheetModel::name), QString());
    }

    void notesOfARunThatBeganAnewMeanwhileAreForgotten() {
        Desk desk;
        desk.sheet.model().rename(1, "post");
        auto notes = desk.sheet.model().takeNotes();
        desk.sheet.model().setNotes(std::move(notes));
        desk.sheet.setObjects({objectOf(1)});
        QCOMPARE(cell(desk.sheet, 0, RunSheetModel::name), QString());
    }

    void csvNamesEverySource_data() {
        QTest::addColumn<base::Provenance>("provenance");
        QTest::newRow("live") << base::Provenance::live;
        QTest::newRow("recorded") << base::Provenance::recorded;
        QTest::newRow("simulated") << base::Provenance::simulated;
        QTest::newRow("recorded_simulation") << base::Provenance::recordedSimulation;
    }
    void csvNamesEverySource() {
        QFETCH(base::Provenance, provenance);
        Desk desk;
        desk.sheet.setProvenance(provenance);
        QCOMPARE(desk.sheet.csv().split(u'\n')[1].section(u',', -1), QString(QTest::currentDataTag()));
    }

    void csvSaysWhereItIsFromAndWhatIsNotKnown() {
        RunSheet sheet;
        sheet.setProvenance(base::Provenance::simulated);
        auto object = objectOf(1);
        object.stiffness.reset();
        object.material.reset();
        object.recognition.reset();
        sheet.setObjects({object});
        QCOMPARE(sheet.csv().split(u'\n')[1],
                 QString("1,,12.5,0.19,-0.012,3,edge,0.5,NA,NA,NA,NA,NA,NA,simulated"));
    }
};

namespace {
const test::Registration<RunSheetTest> registration;
}
#include "run_sheet_test.moc"
