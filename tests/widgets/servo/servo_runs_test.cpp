// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/test_registry.h"
#include "widgets/base/colour_maps.h"
#include "widgets/base/theme.h"
#include "widgets/servo/servo_runs.h"
#include "widgets/servo/servo_runs_view.h"

#include <QFile>
#include <QFontMetricsF>
#include <QLineF>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>

#include <array>
#include <cmath>
#include <vector>

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

/// A step of a run whose curves go from the top to the bottom of their lanes.
ServoStep wildStep(double time_s, std::uint64_t run) {
    ServoStep step = stepAt(time_s, run);
    const double swing = std::sin(9.0 * time_s);
    step.force_N = 5.0 + 5.0 * swing;
    step.copY_m = 0.01 * swing;
    step.cocX_m = -0.01 * swing;
    step.dzmpY_m = step.dzmpYTrue_m = 0.002 * swing;
    step.alphaZ_rad = 0.4 * swing;
    step.p_Base_Sensor.x() = 0.05 * swing;
    return step;
}

/// A text of the chart, with the rectangle in which it stands.
struct ChartText {
    QString text;
    QString kind;
    QRectF rect;
};

/// What is written in a chart, and the lines of its curves.
struct ChartParts {
    std::vector<ChartText> texts;
    std::vector<QLineF> curves;
};

ChartParts partsOf(const QByteArray& svg) {
    ChartParts parts;
    QFont font(QStringLiteral("sans-serif"));
    font.setPixelSize(12); // of class small
    const QFontMetricsF metrics(font);
    QXmlStreamReader reader(svg);
    while (!reader.atEnd()) {
        if (reader.readNext() != QXmlStreamReader::StartElement)
            continue;
        const QXmlStreamAttributes attributes = reader.attributes();
        const QString kind = attributes.value("class").toString();
        if (reader.name() == QLatin1String("text") && kind.contains(QLatin1String("small"))) {
            const QPointF at(attributes.value("x").toDouble(), attributes.value("y").toDouble());
            const bool turned = attributes.value("transform").startsWith(QLatin1String("rotate(-90"));
            const QString text = reader.readElementText();
            const double width = metrics.horizontalAdvance(text);
            // Digits and capitals reach from the base line to the height of a capital.
            QRectF rect(0.0, -metrics.capHeight(), width, metrics.capHeight());
            if (kind.contains(QLatin1String("end")))
                rect.translate(-width, 0.0);
            if (kind.contains(QLatin1String("middle")))
                rect.translate(-0.5 * width, 0.0);
            if (turned)
                rect = QRectF(rect.top(), -rect.right(), rect.height(), rect.width());
            parts.texts.push_back({text, kind, rect.translated(at)});
        } else if (reader.name() == QLatin1String("path") &&
                   (kind.contains(QLatin1String("thin")) || kind == QLatin1String("dotted"))) {
            const QStringList points = attributes.value("d").toString().mid(1).split(QLatin1Char('L'));
            QPointF before;
            for (qsizetype i = 0; i < points.size(); ++i) {
                const QPointF point(points[i].section(QLatin1Char(' '), 0, 0).toDouble(),
                                    points[i].section(QLatin1Char(' '), 1).toDouble());
                if (i > 0)
                    parts.curves.emplace_back(before, point);
                before = point;
            }
        }
    }
    return parts;
}

bool crosses(const QRectF& rect, const QLineF& line) {
    const std::array corners{rect.topLeft(), rect.topRight(), rect.bottomRight(), rect.bottomLeft()};
    if (rect.contains(line.p1()) || rect.contains(line.p2()))
        return true;
    for (std::size_t i = 0; i < corners.size(); ++i)
        if (line.intersects(QLineF(corners[i], corners[(i + 1) % corners.size()])) ==
            QLineF::BoundedIntersection)
            return true;
    return false;
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

    void aRunThatDoesNotComeToExploringSaysThatItHasNoMoment() {
        const int source = 0;
        ServoRuns runs;
        runs.setSource("bar", &source);
        for (const TaskKind task : {TaskKind::freeMotion, TaskKind::align, TaskKind::edgeControl}) {
            ServoStep step = stepAt(0.1 * static_cast<double>(task), 0, false);
            step.task = task;
            runs.add(step);
            // The first two never turn by the moment.
            QCOMPARE(nameOf(runs, 0), task == TaskKind::edgeControl ? QStringLiteral("bar, without DZMP")
                                                                    : QStringLiteral("bar"));
        }
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

    void titlesOfRowsLieOnNoCurveAndNoOtherText_data() {
        QTest::addColumn<QSize>("size");
        QTest::addColumn<int>("runs");
        for (const int runs : {1, 2}) {
            // The dock at 1024 x 700 and at 1600 x 1000, maximised, and narrow.
            for (const QSize size : {QSize(560, 240), QSize(840, 400), QSize(1500, 860), QSize(420, 700)})
                QTest::addRow("%d x %d, %d", size.width(), size.height(), runs) << size << runs;
        }
    }
    void titlesOfRowsLieOnNoCurveAndNoOtherText() {
        QFETCH(QSize, size);
        QFETCH(int, runs);
        const int source = 0;
        ServoRunsView view;
        view.resize(900, 500);
        view.show();
        QVERIFY(QTest::qWaitForWindowExposed(&view));
        view.setSource("bar", &source);
        for (int run = 0; run < runs; ++run)
            for (int i = 0; i < 400; ++i)
                view.append(wildStep(0.02 * i, static_cast<std::uint64_t>(run)));
        view.resize(size);
        QTRY_COMPARE(view.size(), size);
        view.refresh();
        const ChartParts parts = partsOf(view.chart());
        QVERIFY(parts.curves.size() > 100);
        int titles = 0;
        for (const ChartText& title : parts.texts) {
            if (!title.kind.startsWith(QLatin1String("ink")))
                continue;
            ++titles;
            for (const QLineF& curve : parts.curves)
                QVERIFY2(!crosses(title.rect, curve), qPrintable(title.text));
            for (const ChartText& other : parts.texts)
                QVERIFY2(&other == &title || !other.rect.intersects(title.rect),
                         qPrintable(title.text + QStringLiteral(" on ") + other.text));
        }
        QVERIFY2(titles >= 6, "each row has one");
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
