// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/test_registry.h"
#include "widgets/base/colour_maps.h"
#include "widgets/base/theme.h"
#include "widgets/servo/servo_runs.h"
#include "widgets/servo/servo_runs_view.h"

#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

using namespace teleta::servo;

namespace {

ServoStep stepAt(double time_s, std::uint64_t run = 0, bool moment = true) {
    ServoStep step;
    step.run = run;
    step.time_s = time_s;
    step.task = TaskKind::explore;
    step.touching = true;
    step.moment = moment;
    step.force_N = 5.0 + std::sin(time_s);
    step.desired_N = 5.0;
    step.p_Base_Sensor.x() = 0.01 * time_s;
    return step;
}

QString nameOf(const ServoRuns& runs, std::size_t index) {
    return QString::fromStdString(runs.runs()[index].name);
}

const char* const kHeader =
    "time_s,phase,contact,force_true_n,force_desired_n,cop_y_m,cop_y_desired_m,coc_x_m,"
    "dzmp_y_m,dzmp_y_true_m,alpha_z_rad,alpha_z_desired_rad,x_m,y_m,z_m\n";

} // namespace

/// Servo runs that are compared, and their chart.
class ServoRunsTest : public QObject {
    Q_OBJECT

private slots:
    void aRestartBeginsAnotherRunThatSaysWhetherItHasTheMoment() {
        const int source = 0;
        ServoRuns runs;
        runs.add(stepAt(0.0)); // no source has been set
        QVERIFY(runs.runs().empty());
        runs.setSource("bar", &source);
        runs.add(stepAt(0.0, 0, false));
        runs.add(stepAt(0.1, 0, false));
        runs.add(stepAt(0.0, 1));
        runs.add(stepAt(0.05, 2));
        runs.add(stepAt(0.1, 2, false));
        runs.add(stepAt(0.1, 2)); // its time does not go on: another one
        QCOMPARE(runs.runs().size(), std::size_t{4});
        QCOMPARE(nameOf(runs, 0), QStringLiteral("bar, without DZMP"));
        QCOMPARE(nameOf(runs, 1), QStringLiteral("bar, run 2"));
        QCOMPARE(nameOf(runs, 2), QStringLiteral("bar, run 3, partly without DZMP"));
        QCOMPARE(runs.runs()[0].time_s.size(), std::size_t{2});
        runs.forgetOthers();
        QCOMPARE(runs.runs().size(), std::size_t{1});
        QCOMPARE(nameOf(runs, 0), QStringLiteral("bar, run 4"));
        runs.add(stepAt(0.2, 2));
        QCOMPARE(runs.runs()[0].time_s.size(), std::size_t{2});
    }

    void aRunOfHoursKeepsItsWholeTimeInBoundedMemory() {
        const int source = 0;
        ServoRuns runs;
        runs.setSource("bar", &source);
        constexpr int kSteps = 5 * static_cast<int>(ServoRuns::kLongest);
        for (int i = 0; i < kSteps; ++i)
            runs.add(stepAt(0.01 * i));
        QCOMPARE(runs.runs().size(), std::size_t{1});
        const std::vector<double>& time_s = runs.runs()[0].time_s;
        QVERIFY(time_s.size() <= ServoRuns::kLongest);
        QVERIFY(time_s.size() > ServoRuns::kLongest / 4);
        QCOMPARE(time_s.front(), 0.0);
        QVERIFY(time_s.back() > 0.01 * (kSteps - 1) - 0.2);
        for (std::size_t i = 1; i < time_s.size(); ++i)
            QVERIFY(time_s[i] > time_s[i - 1]);
    }

    void whatWasNotSeenIsAGapAndTheOldestRunGoesFirst() {
        const int source = 0;
        ServoRuns runs;
        runs.setSource("bar", &source);
        runs.add(stepAt(0.0));
        runs.add(stepAt(10.0));
        QCOMPARE(runs.runs()[0].force_N.size(), std::size_t{3});
        QVERIFY(std::isnan(runs.runs()[0].force_N[1]));
        teleta::servo_figure::ServoCurves recorded;
        for (std::size_t i = 1; i <= ServoRuns::kMost; ++i) {
            recorded.name = std::to_string(i);
            runs.addRecorded(recorded);
        }
        QCOMPARE(runs.runs().size(), ServoRuns::kMost);
        QCOMPARE(nameOf(runs, 0), QStringLiteral("1"));
        runs.add(stepAt(10.1)); // its run is gone
        QCOMPARE(nameOf(runs, ServoRuns::kMost - 1), QStringLiteral("bar"));
        QCOMPARE(nameOf(runs, 0), QStringLiteral("2"));
    }

    void aRecordedRunIsAddedToTheChartAndABrokenOneIsRefused() {
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("servo.csv"));
        const auto write = [&](const char* row) {
            QFile file(path);
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write(kHeader);
            file.write(row);
        };
        ServoRunsView view;
        QSignalSpy failed(&view, &ServoRunsView::failed);
        write("0.01,align,touching,four,5,0,0,0,0,0,0,0,1,2,3\n");
        view.addRecorded(path);
        QTRY_COMPARE(failed.count(), 1);
        QVERIFY(failed.front().front().toString().contains(QStringLiteral("servo.csv")));
        QVERIFY(view.runs().runs().empty());
        write("0.01,align,touching,4,5,0,0,0,0,0,0,0,1,2,3\n");
        view.addRecorded(path);
        QTRY_COMPARE(view.runs().runs().size(), std::size_t{1});
        QCOMPARE(view.runs().runs()[0].force_N, std::vector<double>{4.0});
        QVERIFY(view.figure().csv().contains(QStringLiteral(",0.01,4,5,0,0,0,0,0,0,0,0")));
    }

    void theChartIsDrawnInTheColoursOfTheThemeAndSavedAsSvgOnWhite() {
        const int source = 0;
        ServoRunsView view;
        view.resize(900, 420);
        view.setPalette(teleta::base::designedPalette(true));
        view.show();
        QVERIFY(QTest::qWaitForWindowExposed(&view));
        const QImage empty = view.grab().toImage();
        view.setSource("bar", &source);
        for (int i = 0; i < 100; ++i)
            view.append(stepAt(0.01 * i));
        view.refresh();
        const QImage chart = view.grab().toImage();
        QVERIFY(chart != empty);
        const QColor paper = view.palette().color(QPalette::Base);
        QCOMPARE(chart.pixelColor(chart.width() - 8, chart.height() - 4), paper);
        const QColor curve = teleta::base::identityColour(1, true);
        int coloured = 0;
        for (int y = 60; y < chart.height(); ++y)
            for (int x = 60; x < chart.width(); ++x)
                coloured += teleta::base::contrast(chart.pixelColor(x, y), curve) < 1.2 &&
                                    chart.pixelColor(x, y).hsvSaturation() > curve.hsvSaturation() / 2
                                ? 1
                                : 0;
        QVERIFY2(coloured > 300, "the force's curve goes through half of the picture");

        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("runs.svg"));
        QVERIFY(teleta::base::saveFigure(view.figure(), path).has_value());
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray svg = file.readAll();
        QVERIFY(svg.contains("Tactile servoing, simulated"));
        QVERIFY(svg.contains(">bar<"));
    }
};

namespace {
const teleta::test::Registration<ServoRunsTest> registration;
}
#include "servo_runs_test.moc"
