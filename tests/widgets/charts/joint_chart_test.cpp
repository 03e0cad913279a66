// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/input_events.h"
#include "tests/widgets/test_registry.h"
#include "widgets/base/theme.h"
#include "widgets/charts/joint_chart_view.h"
#include "widgets/charts/joint_plot.h"

#include <QApplication>
#include <QFile>
#include <QMenu>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

using namespace teleta;
using namespace teleta::charts;

namespace {

core::JointSample sampleAt(int millisecond, double elbow_Nm) {
    core::JointSample sample;
    sample.time_ns = millisecond * 1'000'000LL;
    sample.sourceTime_s = 0.001 * millisecond;
    sample.torque_Nm = {0.0, 0.01, -0.01, elbow_Nm};
    sample.angle_rad = {0.1, 0.2, 0.3, 1.0};
    return sample;
}

/// A view with 4 s at 1 kHz: the elbow's torque rises from 0 to 60 mNm between 2.0 s and 2.06 s and stays.
struct Chart {
    Chart() {
        view.resize(900, 420);
        view.show();
        QCoreApplication::processEvents();
        feed(0, 4000);
    }
    void feed(int from_ms, int to_ms) {
        std::vector<core::JointSample> samples;
        for (int i = from_ms; i < to_ms; ++i)
            samples.push_back(sampleAt(i, 0.001 * std::clamp(i - 2000, 0, 60)));
        view.append(samples);
        view.refresh();
        QCoreApplication::processEvents();
    }
    QImage draw() {
        view.refresh();
        QCoreApplication::processEvents();
        return view.plot()->grab().toImage();
    }
    static pipeline::TouchRecord touch(std::uint64_t number, double start_s, double ready_s) {
        pipeline::TouchRecord record;
        record.number = number;
        record.start_s = start_s;
        record.ready_s = ready_s;
        return record;
    }

    JointChartView view;
};

double yOfTorque(const JointPlot& plot, double torque_Nm) {
    return plot.laneGraph(JointPlot::Row::torque, 0)->valueAxis()->coordToPixel(1e3 * torque_Nm);
}

QPoint middleOf(const JointChartView& view, JointPlot::Row row) {
    return view.plot()->mapToParent(view.plot()->laneRect(row).center());
}

} // namespace

/// Joint torques and angles over time.
class JointChartTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { base::applyTheme(base::ThemeChoice::light); }

    void eachJointHasItsCurveInMillinewtonMetres() {
        Chart chart;
        const JointPlot& plot = *chart.view.plot();
        const auto last = [&](std::size_t joint) {
            const auto data = plot.laneGraph(JointPlot::Row::torque, joint)->data();
            double value = 0.0;
            for (auto it = data->constBegin(); it != data->constEnd(); ++it)
                if (!std::isnan(it->value))
                    value = it->value;
            return value;
        };
        QCOMPARE(last(0), 0.0);
        QCOMPARE(last(1), 10.0);
        QCOMPARE(last(2), -10.0);
        QCOMPARE(last(3), 60.0);
    }

    void theTorqueWindowIsABandOnBothSidesOfZero() {
        Chart chart;
        chart.view.append(std::vector{sampleAt(4000, -0.06)});
        chart.view.refresh(); // a sample this close to the last one is drawn when no other follows
        const QImage image = chart.draw();
        const int x =
            static_cast<int>(chart.view.plot()->xOf(-9.03)); // before the first sample, off the grid
        const auto at = [&](double torque_Nm) {
            return image.pixelColor(x, static_cast<int>(yOfTorque(*chart.view.plot(), torque_Nm)));
        };
        const QColor ground = chart.view.palette().color(QPalette::Base);
        QVERIFY(at(0.035) != ground);
        QCOMPARE(at(-0.035), at(0.035));
        QCOMPARE(at(0.015), ground);
        QCOMPARE(at(0.055), ground);
        chart.view.setWindow(stiffness::TorqueWindow{0.01, 0.018});
        const QImage other = chart.draw();
        const int y = static_cast<int>(yOfTorque(*chart.view.plot(), 0.015));
        QVERIFY(other.pixelColor(x, y) != ground);
    }

    void aTouchIsShadedFromItsStartToItsEstimate() {
        Chart chart;
        QVERIFY(chart.view.addTouch(Chart::touch(7, 2.0, 2.5)));
        chart.view.setSpan(5.0);
        const QImage image = chart.draw();
        QCOMPARE(chart.view.plot()->touches().size(), std::size_t{1});
        const Shade shade = chart.view.plot()->touches()[0];
        QVERIFY(std::abs(shade.from - (2.0 - 3.999)) < 1e-9);
        QVERIFY(std::abs(shade.to - (2.5 - 3.999)) < 1e-9);
        QCOMPARE(shade.label, QString("7"));
        const int y = static_cast<int>(yOfTorque(*chart.view.plot(), 0.015));
        const auto at = [&](double time_s) {
            return image.pixelColor(static_cast<int>(chart.view.plot()->xOf(time_s - 3.999)), y);
        };
        const QColor ground = chart.view.palette().color(QPalette::Base);
        QVERIFY(at(2.23) != ground);
        QCOMPARE(at(1.83), ground);
        QCOMPARE(at(2.67), ground);
    }

    void aTouchThatIsNoLongerKeptIsNotShaded() {
        Chart chart;
        QVERIFY(!chart.view.addTouch(Chart::touch(1, -5.0, -4.5)));
        JointChartView empty;
        QVERIFY(!empty.addTouch(Chart::touch(1, 0.0, 0.1)));
    }

    void aPeakOfOneSampleIsNotLost() {
        Chart chart;
        chart.view.append(std::vector{sampleAt(4000, 0.2)});
        chart.feed(4001, 60000);
        chart.view.setSpan(60.0);
        const auto data = chart.view.plot()->laneGraph(JointPlot::Row::torque, 3)->data();
        double peak = 0.0;
        for (auto it = data->constBegin(); it != data->constEnd(); ++it)
            peak = std::isnan(it->value) ? peak : std::max(peak, it->value);
        QCOMPARE(peak, 200.0);
        // 60 000 samples, but no more points than smallest and largest of each pixel column.
        QVERIFY(data->size() <= 2 * chart.view.plot()->width() + 8);
    }

    void pausedItStandsStillAndKeepsSamples() {
        Chart chart;
        QTest::keyClick(&chart.view, Qt::Key_Space);
        QVERIFY(chart.view.isPaused());
        chart.feed(4000, 5000);
        QVERIFY(std::abs(chart.view.end_s() - 3.999) < 1e-9);
        QCOMPARE(chart.view.history().size(), std::size_t{5000});
        QTest::keyClick(&chart.view, Qt::Key_End);
        QVERIFY(!chart.view.isPaused());
        QVERIFY(std::abs(chart.view.end_s() - 4.999) < 1e-9);
    }

    void theCursorReadsAllJointsAtItsTime() {
        Chart chart;
        chart.view.setSpan(5.0);
        const QRect area = chart.view.plot()->laneRect(JointPlot::Row::torque);
        const int x = static_cast<int>(std::lround(chart.view.plot()->xOf(2.03 - 3.999)));
        test::hover(chart.view.plot(), QPoint(x, area.center().y()));
        QVERIFY(chart.view.cursorTime_s());
        // Two pixels of 5 s over the width, at 1 mNm a millisecond.
        const double tolerance_mNm = 2.0 * 5000.0 / area.width();
        const QString text = chart.view.plot()->lanePanel(JointPlot::Row::torque)->lines()[3].value;
        const double shown = text.section(QChar(0x00a0), 0, 0).remove(QChar(0x2007)).toDouble();
        QVERIFY2(std::abs(shown - 30.0) <= tolerance_mNm, qPrintable(text));
        QVERIFY(text.endsWith("mNm"));
    }

    void anArmWithoutTouchesHasNewtonMetresAndItsOwnNames() {
        Chart chart;
        chart.view.setJointNames({"base", "lower", "upper", "wrist"});
        const auto elbow = [&] { return chart.view.plot()->lanePanel(JointPlot::Row::torque)->lines()[3]; };
        const auto valueOf = [&] {
            chart.view.refresh();
            return elbow().value.section(QChar(0x00a0), 0, 0).remove(QChar(0x2007)).toDouble();
        };
        QCOMPARE(valueOf(), 60.0);
        chart.view.setWindow(std::nullopt);
        QCOMPARE(valueOf(), 0.06);
        QVERIFY2(elbow().value.endsWith("Nm") && !elbow().value.endsWith("mNm"), qPrintable(elbow().value));
        QCOMPARE(elbow().name, QStringLiteral("wrist"));
        chart.view.setWindow(stiffness::TorqueWindow());
        QCOMPARE(valueOf(), 60.0);
    }

    void anglesAreARowOfTheirOwnInDegrees() {
        Chart chart;
        QVERIFY(chart.view.plot()->laneRect(JointPlot::Row::angle).isEmpty());
        chart.view.findChild<QAction*>("angles")->trigger();
        chart.draw();
        const QRect torque = chart.view.plot()->laneRect(JointPlot::Row::torque);
        const QRect angle = chart.view.plot()->laneRect(JointPlot::Row::angle);
        QVERIFY(angle.top() > torque.bottom());
        QVERIFY(std::abs(angle.height() - torque.height()) <= 2);
        const QString text = chart.view.plot()->lanePanel(JointPlot::Row::angle)->lines()[3].value;
        QVERIFY2(text.contains("57.3"), qPrintable(text)); // 1 rad
    }

    void showingATouchBringsItToTheMiddle() {
        Chart chart;
        chart.feed(4000, 20000);
        QVERIFY(chart.view.addTouch(Chart::touch(3, 9.0, 9.2)));
        chart.view.setSpan(5.0);
        QVERIFY(chart.view.showTouch(3));
        QVERIFY(chart.view.isPaused());
        QVERIFY(std::abs(chart.view.end_s() - (9.1 + 2.5)) < 1e-9);
        QVERIFY(!chart.view.showTouch(99));
    }

    void wheelsScrollAndZoomOnlyWithTheirKeys() {
        Chart chart;
        const QPointF middle = chart.view.plot()->laneRect(JointPlot::Row::torque).center();
        QVERIFY(!test::turnWheel(chart.view.plot(), middle, 1));
        QVERIFY(test::turnWheel(chart.view.plot(), middle, 1, Qt::ControlModifier));
        QCOMPARE(chart.view.span_s(), 8.0); // one step of 1.25 from 10 s
    }

    void theEndsOfAnAxisAreTyped() {
        Chart chart;
        chart.view.findChild<QAction*>("angles")->trigger();
        chart.draw();
        JointPlot* plot = chart.view.plot();
        const auto type = [&](JointPlot::Row row, const QString& text) {
            const QRect area = plot->laneRect(row);
            test::typeAt(&chart.view, plot, QPoint(area.left() - 10, area.center().y()), text);
            chart.draw();
        };
        const ValueRange automatic = plot->laneRange(JointPlot::Row::torque);
        type(JointPlot::Row::torque, QStringLiteral("-20 80"));
        QVERIFY(plot->fixedLaneRange(JointPlot::Row::torque));
        QVERIFY(std::abs(plot->laneRange(JointPlot::Row::torque).low + 20.0) < 1e-9);
        QVERIFY(std::abs(plot->laneRange(JointPlot::Row::torque).high - 80.0) < 1e-9);
        // 80 mNm lie above 60 mNm by a fifth of the axis, which is 110 % as high as what was typed.
        const double perNm = (yOfTorque(*plot, 0.06) - yOfTorque(*plot, 0.08)) / 0.02;
        const QRect area = plot->laneRect(JointPlot::Row::torque);
        QVERIFY(std::abs(perNm * 0.11 - area.height()) <= 2.0);
        QVERIFY(!plot->fixedLaneRange(JointPlot::Row::angle));
        type(JointPlot::Row::angle, QStringLiteral("0 90"));
        QVERIFY(std::abs(plot->laneRange(JointPlot::Row::angle).high - 90.0) < 1e-9);
        type(JointPlot::Row::torque, QStringLiteral("80 -20"));
        QCOMPARE(plot->fixedLaneRange(JointPlot::Row::torque)->high, 80.0);
        type(JointPlot::Row::torque, QString());
        QVERIFY(!plot->fixedLaneRange(JointPlot::Row::torque));
        QVERIFY(std::abs(plot->laneRange(JointPlot::Row::torque).high - automatic.high) < 1e-9);
    }

    void theContextMenuTellsWhetherAnAxisIsAutomatic() {
        Chart chart;
        const auto automatic = [&] {
            QMenu menu;
            chart.view.populateMenu(menu, middleOf(chart.view, JointPlot::Row::torque));
            for (const QAction* action : menu.actions())
                if (action->text().remove(u'&') == QStringLiteral("Automatic range"))
                    return action->isChecked();
            return false;
        };
        QVERIFY(automatic());
        chart.view.plot()->setFixedLaneRange(JointPlot::Row::torque, ValueRange{-20.0, 80.0});
        QVERIFY(!automatic());
        QMenu elsewhere;
        chart.view.populateMenu(elsewhere, {-1, -1});
        for (const QAction* action : elsewhere.actions())
            QVERIFY(!action->text().contains(QStringLiteral("range")));
    }

    void theDataAreTheShownStretch() {
        Chart chart;
        chart.view.setSpan(0.05);
        const QStringList lines = chart.view.figure().csv().split(u'\n', Qt::SkipEmptyParts);
        QCOMPARE(lines[0],
                 QString("time_s,joint1_angle_rad,joint1_torque_nm,joint2_angle_rad,joint2_torque_nm,"
                         "joint3_angle_rad,joint3_torque_nm,joint4_angle_rad,joint4_torque_nm"));
        QVERIFY(lines.size() == 51 || lines.size() == 52); // 50 ms at 1 kHz, both ends
        QCOMPARE(lines.last(), QString("3.999,0.1,0,0.2,0.01,0.3,-0.01,1,0.06"));
    }

    void picturesAreVectors() {
        Chart chart;
        chart.view.addTouch(Chart::touch(7, 2.0, 2.5));
        const QTemporaryDir folder;
        const QString path = folder.filePath("joints.svg");
        QVERIFY(base::saveFigure(chart.view.figure(), path).has_value());
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray svg = file.readAll();
        QVERIFY(svg.contains("polyline"));
        QVERIFY(!svg.contains("<image"));
    }

    void clearForgetsSamplesAndTouches() {
        Chart chart;
        chart.view.addTouch(Chart::touch(7, 2.0, 2.5));
        chart.view.setPaused(true);
        chart.view.clear();
        QVERIFY(!chart.view.isPaused());
        QVERIFY(chart.view.history().empty());
        QVERIFY(chart.view.plot()->touches().empty());
    }
};

namespace {
const test::Registration<JointChartTest> registration;
}
#include "joint_chart_test.moc"
