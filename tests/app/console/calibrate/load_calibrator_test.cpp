// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/calibrate/load_calibrator.h"
#include "backend/equilibration/load_calibration_file.h"

#include <QFile>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QWidget>

using namespace teleta;
using calibrate::StepState;
using console::LoadCalibrator;

/// Newtons from presses with a known load, as a person finds them.
class LoadCalibratorTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;

    QString written(const char* name, const QByteArray& text) const {
        QFile file(m_folder.filePath(QLatin1String(name)));
        return file.open(QIODevice::WriteOnly) && file.write(text) == text.size() ? file.fileName()
                                                                                  : QString();
    }
    /// force = 0.5 (a - 4) - 0.25 (b - 2), without noise; the rest is a = 4, b = 2.
    QString presses() const {
        return written("presses.csv",
                       "press,a,b,force_n\n0,4,2,0\n1,8,2,2\n2,4,6,-1\n3,8,6,1\n4,12,2,4\n5,12,10,2\n"
                       "6,6,4,0.5\n");
    }
    static void tick(QWidget& view, const QString& column) {
        auto* columns = view.findChild<QListWidget*>("columns");
        columns->findItems(column, Qt::MatchExactly).constFirst()->setCheckState(Qt::Checked);
    }
    static void press(QWidget& view, const char* name) {
        QTest::mouseClick(view.findChild<QPushButton*>(QLatin1String(name)), Qt::LeftButton);
    }

private slots:
    void theGainsOfTheTickedColumnsAreFoundAndSaved() {
        QWidget window;
        LoadCalibrator loads(&window);
        calibrate::LoadsView& view = loads.view();
        window.resize(1000, 600);
        view.resize(window.size());
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        QCOMPARE(view.step().state, StepState::toDo);
        QVERIFY(!view.findChild<QPushButton*>("fit")->isEnabled());
        loads.openPresses(presses());
        QTRY_COMPARE(view.findChild<QListWidget*>("columns")->count(), 3); // press, a, b
        QVERIFY(!view.findChild<QPushButton*>("fit")->isEnabled());
        tick(view, "a");
        tick(view, "b");
        QCOMPARE(view.chosen(), (QStringList{"a", "b"}));
        press(view, "fit");
        QTRY_VERIFY(view.found() != nullptr);
        QVERIFY(std::abs(view.found()->gain(0, 0) - 0.5) < 1e-9);
        QVERIFY(std::abs(view.found()->gain(0, 1) + 0.25) < 1e-9);
        const auto* table = view.findChild<QTableWidget*>("loads");
        QCOMPARE(table->rowCount(), 2);
        QCOMPARE(table->item(0, 0)->text(), QString("force_n"));
        QCOMPARE(table->item(1, 1)->text(), QString("b"));
        QCOMPARE(view.step().state, StepState::notSaved);
        QVERIFY(!loads.isSaved());

        const QString path = m_folder.filePath("newtons.csv");
        loads.save(path);
        QTRY_VERIFY(loads.isSaved());
        QCOMPARE(view.step().state, StepState::done);
        const auto read = equilibration::readLoadCalibration(path.toStdString());
        QVERIFY(read.has_value());
        QCOMPARE(read->channels, (std::vector<std::string>{"a", "b"}));
        press(view, "undo");
        QVERIFY(view.found() == nullptr);
        loads.load(path);
        QTRY_VERIFY(view.found() != nullptr);
        QVERIFY(loads.isSaved());
        // What a file replaces comes back.
        press(view, "undo");
        QVERIFY(view.found() == nullptr);
        QVERIFY(!loads.isSaved());
    }

    void whatCannotBeFoundIsSaidAndChangesNothing() {
        QWidget window;
        LoadCalibrator loads(&window);
        calibrate::LoadsView& view = loads.view();
        const auto verdict = [&] { return view.findChild<QLabel*>("verdict")->text(); };
        loads.openPresses(written("none.csv", "a,b\n1,2\n"));
        QTRY_VERIFY2(verdict().contains("force_n"), qPrintable(verdict()));
        QCOMPARE(view.step().state, StepState::failed);
        loads.openPresses(written("few.csv", "a,force_n\n0,0\n1,1\n2,2\n"));
        QTRY_COMPARE(view.table().name, QString("few.csv"));
        tick(view, "a");
        loads.fit(view.chosen());
        QTRY_COMPARE(view.step().state, StepState::failed);
        QVERIFY(!verdict().isEmpty());
        QVERIFY(view.found() == nullptr);
        loads.openPresses(m_folder.filePath("nowhere.csv"));
        QTRY_VERIFY2(verdict().contains("nowhere.csv"), qPrintable(verdict()));
        QSignalSpy trouble(&loads, &LoadCalibrator::trouble);
        loads.save(m_folder.filePath("out.csv"));
        QCOMPARE(trouble.count(), 0); // there is nothing to save
    }
};

QTEST_MAIN(LoadCalibratorTest)
#include "load_calibrator_test.moc"
