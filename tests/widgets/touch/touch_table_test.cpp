// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/test_registry.h"
#include "tests/widgets/touch/sample_records.h"
#include "widgets/touch/touch_table.h"

#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QIcon>
#include <QLabel>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>

using namespace teleta;
using namespace teleta::touch;

namespace {

QString cell(const TouchTable& table, int row, int column, int role = Qt::DisplayRole) {
    return table.view()->model()->index(row, column).data(role).toString();
}

} // namespace

/// The list of the recent touches.
class TouchTableTest : public QObject {
    Q_OBJECT

private slots:
    void theNewestTouchIsOnTop() {
        TouchTable table;
        for (const std::uint64_t number : {1, 2, 10})
            table.append(test::recordOf(number, std::nullopt));
        QCOMPARE(cell(table, 0, TouchModel::number), QString("10"));
        QCOMPARE(cell(table, 2, TouchModel::number), QString("1"));
    }

    void showsWhatWasFoundOutWithUnits() {
        TouchTable table;
        table.append(test::recordOf(7, test::estimateOf(1325.9, 1290.0, 1360.0)));
        const auto plain = [&](int column) {
            return cell(table, 0, column).replace(QChar(0x00a0), u' ').remove(QChar(0x2002));
        };
        QCOMPARE(plain(TouchModel::time), QString("14.000 s"));
        QCOMPARE(plain(TouchModel::point), QString::fromUtf8("470,−50,−12 mm"));
        QCOMPARE(plain(TouchModel::distance), QString("170 mm"));
        QCOMPARE(plain(TouchModel::stiffness), QString::fromUtf8("1.33 kN/m (1.29 … 1.36 kN/m)"));
        QCOMPARE(plain(TouchModel::material), QString("rubber sponge, SAFE"));
        QCOMPARE(plain(TouchModel::level), QString("2"));
        QCOMPARE(plain(TouchModel::condition), QString("12.5"));
        QVERIFY(cell(table, 0, TouchModel::time, Qt::ToolTipRole).contains("46"));
    }

    void aHiddenComponentIsMarkedInsteadOfPrinted() {
        TouchTable table;
        table.append(test::recordOf(1, std::nullopt));
        const QString force = cell(table, 0, TouchModel::force);
        QVERIFY2(force.startsWith(QChar(0x2013)), qPrintable(force));
        QVERIFY(force.contains("1.20"));
        QVERIFY(cell(table, 0, TouchModel::force, Qt::ToolTipRole).contains("x: not observable"));
    }

    void aBoundIsShownAsSuch() {
        TouchTable table;
        table.append(test::recordOf(1, test::boundOf(34686.0)));
        QVERIFY(cell(table, 0, TouchModel::stiffness).startsWith("at least 34.7"));
        QCOMPARE(cell(table, 0, TouchModel::material), QString("metal, DANGER"));
        QVERIFY(!table.view()->model()->index(0, TouchModel::material).data(Qt::DecorationRole).isNull());
    }

    void aRefusalTellsItsReason() {
        TouchTable table;
        pipeline::TouchRecord record = test::recordOf(1, std::nullopt);
        record.refusal = stiffness::Refusal::windowNotReached;
        table.append(record);
        QCOMPARE(cell(table, 0, TouchModel::stiffness), QString("none"));
        QVERIFY(cell(table, 0, TouchModel::stiffness, Qt::ToolTipRole).contains("too little"));
    }

    void whatTheSkinDidNotFeelIsADash() {
        TouchTable table;
        pipeline::TouchRecord record = test::recordOf(1, std::nullopt);
        record.located = false;
        record.force.reset();
        table.append(record);
        for (const int column :
             {TouchModel::point, TouchModel::distance, TouchModel::force, TouchModel::stiffness,
              TouchModel::material, TouchModel::level, TouchModel::condition})
            QCOMPARE(cell(table, 0, column), QString(QChar(0x2014)));
    }

    void aRecordOfTheSameNumberIsReplaced() {
        TouchTable table;
        table.append(test::recordOf(1, std::nullopt));
        table.append(test::recordOf(1, test::estimateOf(282.0, 270.0, 295.0)));
        QCOMPARE(table.touches(), 1);
        QCOMPARE(cell(table, 0, TouchModel::level), QString("1"));
    }

    void theOldestTouchIsForgottenWhenThereAreTooMany() {
        TouchTable table(nullptr, 3);
        for (std::uint64_t number = 1; number <= 5; ++number)
            table.append(test::recordOf(number, std::nullopt));
        QCOMPARE(table.touches(), 3);
        QCOMPARE(cell(table, 0, TouchModel::number), QString("5"));
        QCOMPARE(cell(table, 2, TouchModel::number), QString("3"));
        QVERIFY(!table.select(2));
    }

    void aClickOnATitleSortsByNumbersNotByText() {
        TouchTable table;
        table.resize(1200, 300);
        table.append(test::recordOf(1, test::estimateOf(900.0, 800.0, 950.0)));
        table.append(test::recordOf(2, test::estimateOf(10000.0, 9000.0, 12000.0)));
        table.append(test::recordOf(3, std::nullopt));
        table.show();
        QHeaderView* header = table.view()->horizontalHeader();
        const QPoint title(header->sectionViewportPosition(TouchModel::stiffness) + 20, header->height() / 2);
        QTest::mouseClick(header->viewport(), Qt::LeftButton, {}, title);
        QCOMPARE(header->sortIndicatorSection(), int(TouchModel::stiffness));
        QStringList order;
        for (int click = 0; click < 2; ++click) {
            const bool rising = header->sortIndicatorOrder() == Qt::AscendingOrder;
            QCOMPARE(cell(table, rising ? 0 : 1, TouchModel::number), QString("1"));
            QCOMPARE(cell(table, rising ? 1 : 0, TouchModel::number), QString("2"));
            QCOMPARE(cell(table, 2, TouchModel::number),
                     QString("3")); // without a value: last in both orders
            order << QString::number(rising);
            QTest::mouseClick(header->viewport(), Qt::LeftButton, {}, title);
        }
        QVERIFY(order[0] != order[1]);
        // Also with the arrow a title is whole.
        for (int column = 0; column + 1 < header->count(); ++column)
            QTRY_VERIFY2(header->sectionSize(column) >= header->sectionSizeHint(column),
                         qPrintable(QString::number(column)));
    }

    void keysMoveTheSelectionAndReturnTellsIt() {
        TouchTable table;
        for (std::uint64_t number = 1; number <= 3; ++number)
            table.append(test::recordOf(number, std::nullopt));
        table.show();
        QVERIFY(table.select(3));
        QSignalSpy activations(&table, &TouchTable::touchActivated);
        QTest::keyClick(table.view(), Qt::Key_Down);
        QCOMPARE(table.selected(), std::optional<std::uint64_t>(2));
        QTest::keyClick(table.view(), Qt::Key_Return);
        QCOMPARE(activations.size(), 1);
        QCOMPARE(activations[0][0].value<std::uint64_t>(), 2U);
    }

    void theSelectionStaysOnItsTouchWhenNewOnesComeIn() {
        TouchTable table;
        table.append(test::recordOf(1, std::nullopt));
        QVERIFY(table.select(1));
        table.append(test::recordOf(2, std::nullopt));
        QCOMPARE(table.selected(), std::optional<std::uint64_t>(1));
    }

    void copyTakesTheSelectedRowsAsTabSeparatedText() {
        TouchTable table;
        table.append(test::recordOf(1, test::estimateOf(282.0, 270.0, 295.0)));
        table.append(test::recordOf(2, std::nullopt));
        table.show();
        QVERIFY(table.select(1));
        QTest::keySequence(table.view(), QKeySequence::Copy);
        const QStringList lines = QGuiApplication::clipboard()->text().split(u'\n', Qt::SkipEmptyParts);
        QCOMPARE(lines.size(), 2);
        QVERIFY(lines[0].startsWith("touch\tstart_s\t"));
        QCOMPARE(lines[1],
                 QString("1\t2\t2.046\t4\t0.05\t0.17\t0\t0.47\t-0.05\t-0.012\tNA\t-0.35\t1.2\t12.5\t"
                         "282\t270\t295\tsponge\ttrue\t1\tNA\tNA"));
    }

    void anUnreliableStiffnessHasNoMaterialAndSaysWhy() {
        auto touch = test::estimateOf(282.0, 270.0, 295.0);
        touch.reliable = false;
        touch.warnings = {teleta::stiffness::TouchWarning::rateDependent};
        TouchTable table;
        table.append(test::recordOf(1, touch));
        table.show();
        const QAbstractItemModel& model = *table.view()->model();
        const QModelIndex index = model.index(0, TouchModel::stiffness);
        QVERIFY(!index.data(Qt::DecorationRole).value<QIcon>().isNull());
        QVERIFY(index.data(Qt::ToolTipRole).toString().contains("how quickly the object is pressed"));
        QCOMPARE(model.index(0, TouchModel::material).data().toString(), "cannot tell");
        QVERIFY(!model.index(0, TouchModel::material).data(Qt::DecorationRole).isValid());
        QVERIFY(table.select(1));
        QTest::keySequence(table.view(), QKeySequence::Copy);
        QVERIFY(QGuiApplication::clipboard()->text().trimmed().endsWith("NA\tNA\tNA\tNA\trate_dependent"));
    }

    void withoutASelectionAllRowsAreTaken() {
        TouchTable table;
        table.append(test::recordOf(1, std::nullopt));
        table.append(test::recordOf(2, std::nullopt));
        QCOMPARE(table.chosen().size(), std::size_t{2});
        QCOMPARE(table.chosen()[0].number, std::uint64_t{2});
    }

    void anEmptyTableSaysWhatToDo() {
        TouchTable table;
        table.show();
        auto* label = table.view()->viewport()->findChild<QLabel*>();
        QVERIFY(label && label->isVisible());
        QVERIFY(label->text().contains("Touch an object"));
        table.append(test::recordOf(1, std::nullopt));
        QVERIFY(!label->isVisible());
        table.clear();
        QVERIFY(label->isVisible());
    }
};

namespace {
const test::Registration<TouchTableTest> registration;
}
#include "touch_table_test.moc"
