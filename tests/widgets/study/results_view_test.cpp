// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/test_registry.h"
#include "widgets/base/theme.h"
#include "widgets/study/results/confusion_view.h"
#include "widgets/study/results/interval_chart.h"
#include "widgets/study/results/page/results_view.h"
#include "widgets/study/results/participant_picker.h"
#include "widgets/study/results/result_table.h"
#include "widgets/study/results/results_content.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QFontMetricsF>
#include <QImage>
#include <QMenu>
#include <QPainter>
#include <QSignalSpy>
#include <QTest>

#include <array>
#include <cmath>
#include <string>

using namespace teleta;
using study::ResultsContent;
using study::ResultsView;

namespace {

std::string name(const char* begin, std::size_t number) {
    return QStringLiteral("%1%2").arg(QLatin1String(begin)).arg(number).toStdString();
}

/// Data set A of the specification: correct of five, patterns P1 to P6, static and dynamic.
study::TaskResults dataSetA() {
    constexpr std::array kRows{"552555443555", "242141533232", "443221542142", "443351554443",
                               "432242542352", "442423543552", "554534554545", "543332453544"};
    study::TrialTally tally;
    for (std::size_t person = 0; person < kRows.size(); ++person) {
        const std::string id = name("s0", person + 1);
        for (std::size_t cell = 0; cell < 12; ++cell) {
            const std::string pattern = name("P", cell % 6 + 1);
            const std::string other = name("P", (cell + 1) % 6 + 1);
            for (int trial = 0; trial < 5; ++trial) {
                const bool right = trial < kRows[person][cell] - '0';
                study::TalliedTrial one;
                one.participant = id;
                one.task = "shape";
                one.condition = cell < 6 ? "static" : "dynamic";
                one.stimulus = pattern;
                one.response = right ? pattern : other;
                one.responseTime_s = 2.0;
                if (!tally.add(one))
                    qFatal("too many names");
            }
        }
    }
    return study::studyResults(tally).front();
}

const study::TaskResults& results() {
    static const study::TaskResults all = dataSetA();
    return all;
}

QString cellOf(const study::TableContent& table, const QString& row, const QString& column) {
    for (const auto& cells : table.rows) {
        if (cells[0].shown == row)
            return cells[static_cast<std::size_t>(table.header.indexOf(column))].shown;
    }
    return {};
}

} // namespace

class ResultsViewTest : public QObject {
    Q_OBJECT

private slots:
    void saysWhatWillAppearWhileThereIsNothing() {
        study::ResultsView view;
        view.resize(900, 600);
        view.show();
        QVERIFY(QTest::qWaitForWindowExposed(&view));
        const auto* nothing = view.findChild<QWidget*>("noResults");
        const auto* tabs = view.findChild<QWidget*>("resultTabs");
        view.setScene({});
        QVERIFY(nothing->isVisible() && !tabs->isVisible());
        study::ResultsScene scene;
        scene.tasks = {results()};
        view.setScene(scene);
        QVERIFY(!nothing->isVisible() && tabs->isVisible());
        view.setScene({});
        QVERIFY(nothing->isVisible() && !tabs->isVisible());
    }

    // Table of the specification, from R.
    void showsTheAnovaOfDataSetAToThePrintedDigits() {
        const study::TableContent table = ResultsContent::anova(results());
        QCOMPARE(cellOf(table, "condition", "F"), QStringLiteral("18.78"));
        QCOMPARE(cellOf(table, "condition", "p"), QStringLiteral("0.003"));
        QCOMPARE(cellOf(table, "condition", "df"), QStringLiteral("1; 7"));
        QCOMPARE(cellOf(table, "pattern", "F"), QStringLiteral("7.85"));
        QCOMPARE(cellOf(table, "pattern", "eps GG"), QStringLiteral("0.461"));
        QCOMPARE(cellOf(table, "pattern", "p GG"), QStringLiteral("0.003"));
        QCOMPARE(cellOf(table, "condition:pattern", "eps HF"), QStringLiteral("1.000"));
        QCOMPARE(cellOf(table, "condition:pattern", "p"), QStringLiteral("0.845"));
        QCOMPARE(cellOf(table, "pattern", "partial eta\u00b2"), QStringLiteral("0.529"));
        QCOMPARE(table.rows.size(), std::size_t(3 + 6));
    }

    // 100 times the mean of the rows of data set A; the t interval is that of R's t.test.
    void accuracyIsTheMeanOfParticipantsWithTheirDots() {
        const study::IntervalChartContent chart = ResultsContent::accuracy(results(), {});
        QCOMPARE(chart.categories, (QStringList{"dynamic", "static"}));
        double sum = 0.0;
        for (const double one : chart.series[0].points[1].single)
            sum += one;
        QCOMPARE(chart.series[0].points[1].single.size(), std::size_t(8));
        QVERIFY(std::abs(*chart.series[0].points[1].value - sum / 8.0) < 1e-9);
        QVERIFY(std::abs(chart.series[0].points[1].single[0] - 90.0) < 1e-9); // 27 of 30
        QVERIFY(std::abs(*chart.reference - 100.0 / 6.0) < 1e-9);
    }

    // Wilson's interval of 27/30 from the roots of its quadratic.
    void oneParticipantHasWilsonsInterval() {
        const study::IntervalChartContent chart =
            ResultsContent::accuracy(results(), {.group = {QStringLiteral("s01")}});
        const study::ChartPoint& point = chart.series[0].points[1];
        const double n = 30.0, share = 0.9, z = 1.959963984540054;
        const double middle = (share + z * z / (2 * n)) / (1 + z * z / n);
        const double half = z / (1 + z * z / n) * std::sqrt(share * (1 - share) / n + z * z / (4 * n * n));
        QVERIFY(std::abs(point.interval->low - 100 * (middle - half)) < 1e-6);
        QVERIFY(std::abs(point.interval->high - 100 * (middle + half)) < 1e-6);
        QVERIFY(point.single.empty());
    }

    void everyPatternHasBothConditionsAndTheirComparison() {
        const study::IntervalChartContent chart = ResultsContent::patterns(results(), {});
        QCOMPARE(chart.categories.size(), 6);
        QCOMPARE(chart.series.size(), std::size_t(2));
        QCOMPARE(chart.notes.size(), 6);
        for (const QString& note : chart.notes)
            QVERIFY2(note.startsWith(QStringLiteral("p ")), qPrintable(note));
        QVERIFY(study::intervalChartCsv(chart).startsWith(
            QStringLiteral("category,series,value,low,high,singles\nP1,")));
    }

    // The specification: at 30 trials a pure guesser of six patterns shows 0.74 bit.
    void saysWhatAGuesserWouldShow() {
        const QString note = ResultsContent::transferNote(results());
        QVERIFY2(note.contains(QStringLiteral("30 trials")), qPrintable(note));
        QVERIFY2(note.contains(QLocale().toString(0.74, 'f', 2)), qPrintable(note));
    }

    void followsTheChoiceOfTaskAndParticipant() {
        ResultsView view;
        study::ResultsScene scene;
        scene.tasks = {results()};
        scene.taskNames.insert("shape", "Object shape");
        scene.conditionNames["shape"].insert("static", "statique");
        scene.mode = study::Mode::pilot;
        view.setScene(scene);
        // A condition without a name is called by its id, and data have the id in every language.
        QCOMPARE(view.findChild<study::IntervalChart*>("accuracyChart")->content().categories,
                 (QStringList{"dynamic", "statique"}));
        QVERIFY(view.matrices()[1]->content().title.startsWith("statique, "));
        QCOMPARE(view.findChild<study::ResultTable*>("groupTable")->item(1, 0)->text(),
                 QStringLiteral("statique"));
        QVERIFY(view.findChild<study::ResultTable*>("groupTable")->csv().contains("\nstatic,"));
        QVERIFY(!view.findChild<study::ResultTable*>("groupTable")->csv().contains("statique"));
        view.resize(1200, 900);
        view.show();
        QCOMPARE(view.matrices().size(), std::size_t(2));
        QCOMPARE(view.matrices()[1]->content().matrix.total(), 8 * 30);
        QCOMPARE(view.matrices()[1]->content().mode, study::Mode::pilot);
        study::ParticipantPicker* who = view.findChild<study::ParticipantPicker*>("resultParticipant");
        QCOMPARE(who->text(), QStringLiteral("All participants"));
        auto* box = who->menu()->findChild<QCheckBox*>("s01");
        QVERIFY(box != nullptr);
        box->click();
        QCOMPARE(who->chosen(), QStringList("s01"));
        QCOMPARE(view.matrices()[1]->content().matrix.total(), 30);
        QCOMPARE(view.matrices()[1]->content().matrix.correct(), 27);
        QCOMPARE(view.findChild<study::ResultTable*>("peopleTable")->rowCount(), 2);
        view.setScene(scene);
        QCOMPARE(who->chosen(), QStringList("s01"));
        QCOMPARE(who->text(), QStringLiteral("s01"));
        auto* counts = view.findChild<QComboBox*>("resultCounts");
        counts->setCurrentIndex(1);
        for (const study::ConfusionView* matrix : view.matrices())
            QVERIFY(matrix->content().percent);
    }

    void theLettersOfTheMatricesAreExplained() {
        ResultsView view;
        study::ResultsScene scene;
        scene.tasks = {results()};
        view.setScene(scene);
        const auto* letters = view.findChild<QLabel*>("letters");
        QVERIFY(letters->isHidden());
        scene.patternNames[QString::fromStdString(results().task)] = {{"P1", "circle"}, {"P3", "triangle"}};
        view.setScene(scene);
        QVERIFY(!letters->isHidden());
        QCOMPARE(letters->text(), QString("P1: circle   P3: triangle"));
    }

    void aLongRemarkIsWrappedWhereTheTableHasNoRoom() {
        study::ResultTable table(QStringLiteral("group"));
        QString remark = QStringLiteral("remark");
        for (int i = 0; i < 30; ++i)
            remark += QStringLiteral(" and more");
        table.setRows({"Condition", "Remark"}, {}, {{{"static"}, {remark}}, {{"dynamic"}, {"none"}}});
        table.resize(800, 400);
        table.show();
        QVERIFY(QTest::qWaitForWindowExposed(&table));
        const int line = table.rowHeight(1);
        QTRY_VERIFY(table.rowHeight(0) > line);
        QVERIFY(table.columnViewportPosition(1) + table.columnWidth(1) <= table.viewport()->width());
        const int columnWidth = table.columnWidth(0);
        table.resize(4000, 400);
        QTRY_COMPARE(table.rowHeight(0), line);
        QCOMPARE(table.columnWidth(0), columnWidth);
    }

    void matricesGrowWithThePage() {
        ResultsView view;
        study::ResultsScene scene;
        scene.tasks = {results()};
        view.setScene(scene);
        view.resize(1000, 600);
        view.show();
        QVERIFY(QTest::qWaitForWindowExposed(&view));
        const int low = view.matrices()[0]->height();
        view.resize(1600, 1200);
        QTRY_VERIFY(view.matrices()[0]->height() > 5 * low / 4);
        view.resize(1000, 600);
        QTRY_COMPARE(view.matrices()[0]->height(), low);
    }

    void titlesAndNotesOfANarrowChartAreWhole() {
        const QFont font = QApplication::font();
        const int em = static_cast<int>(QFontMetricsF(font).height());
        study::IntervalChartContent content;
        content.title = QStringLiteral("Right answers, mean of participants, 95 % t interval");
        content.axis = QStringLiteral("right, %");
        content.highest = 100.0;
        content.categories = {QStringLiteral("A"), QStringLiteral("B"), QStringLiteral("C")};
        for (int i = 0; i < 3; ++i)
            content.notes << QStringLiteral("p = 0.045; Holm 0.134");
        content.series = {{QStringLiteral("test"), {{50.0, {}, {}}, {60.0, {}, {}}, {70.0, {}, {}}}}};
        QImage image(18 * em, 17 * em, QImage::Format_RGB32);
        image.fill(Qt::white);
        QPainter painter(&image);
        painter.setFont(font);
        study::paintIntervalChart(painter, image.rect(), content, base::designedPalette(false));
        painter.end();
        const auto isBlank = [&](const QRect& strip) {
            for (int y = strip.top(); y <= strip.bottom(); ++y)
                for (int x = strip.left(); x <= strip.right(); ++x)
                    if (image.pixel(x, y) != qRgb(255, 255, 255))
                        return false;
            return true;
        };
        // The title ends before both edges, the notes before the next one and the lower edge.
        QVERIFY(isBlank({0, 0, 1, 2 * em}));
        QVERIFY(isBlank({image.width() - 1, 0, 1, 2 * em}));
        QVERIFY(isBlank({0, image.height() - 1, image.width(), 1}));
        const double category = (image.width() - 4.8 * em) / 3.0;
        for (int edge = 1; edge < 3; ++edge)
            QVERIFY(
                isBlank({qRound(4.0 * em + edge * category), image.height() - 3 * em / 2, 1, 3 * em / 2}));
    }

    // Rows of data set A: s01 has 27 (static) and 26 (dynamic) right of 30, s02 14 and 18, s03 16 and 18, s04
    // 20 and 25.
    void showsTwoGroupsSideBySide() {
        ResultsView view;
        study::ResultsScene scene;
        scene.tasks = {results()};
        view.setScene(scene);
        view.findChild<study::ParticipantPicker*>("resultParticipant")
            ->choose({"s02", "s01", "nobody of that name"});
        view.findChild<study::ParticipantPicker*>("resultBeside")->choose({"s03", "s04"});
        QCOMPARE(view.findChild<study::ParticipantPicker*>("resultParticipant")->chosen(),
                 (QStringList{"s01", "s02"}));
        QCOMPARE(view.matrices().size(), std::size_t(4));
        const auto right = [&](std::size_t matrix) {
            return view.matrices()[matrix]->content().matrix.correct();
        };
        QCOMPARE(right(0), 26 + 18); // dynamic comes first
        QCOMPARE(right(1), 27 + 14);
        QCOMPARE(right(2), 18 + 25);
        QCOMPARE(right(3), 16 + 20);
        for (const study::ConfusionView* matrix : view.matrices())
            QCOMPARE(matrix->content().matrix.total(), 60);
        QVERIFY2(view.matrices()[3]->content().title.contains("s03, s04"),
                 qPrintable(view.matrices()[3]->content().title));
        const auto& accuracy = view.findChild<study::IntervalChart*>("accuracyChart")->content();
        QCOMPARE(accuracy.series.size(), std::size_t(2));
        QVERIFY(std::abs(*accuracy.series[0].points[1].value - 100.0 * (27 + 14) / 60) < 1e-9);
        QVERIFY(std::abs(*accuracy.series[1].points[1].value - 100.0 * (16 + 20) / 60) < 1e-9);
        QCOMPARE(view.findChild<study::IntervalChart*>("patternChart")->content().series.size(),
                 std::size_t(4));
        for (const QString& note : view.findChild<study::IntervalChart*>("patternChart")->content().notes)
            QVERIFY2(note.isEmpty(), "p is of all participants");
        QCOMPARE(view.findChild<study::IntervalChart*>("timeChart")->content().series.size(), std::size_t(2));
        QCOMPARE(view.findChild<study::ResultTable*>("peopleTable")->rowCount(), 8);
        view.findChild<study::ParticipantPicker*>("resultBeside")->choose({});
        QCOMPARE(view.matrices().size(), std::size_t(2));
        QCOMPARE(view.findChild<study::IntervalChart*>("accuracyChart")->content().series.size(),
                 std::size_t(1));
        view.findChild<study::ParticipantPicker*>("resultParticipant")->choose({});
        QVERIFY(!view.findChild<study::IntervalChart*>("patternChart")->content().notes[0].isEmpty());
    }

    void aPickerNamesAFewAndCountsMany() {
        study::ParticipantPicker picker;
        picker.setChoices({"P01", "P02", "P03", "P04", "P05"}, QStringLiteral("everybody"));
        QSignalSpy changed(&picker, &study::ParticipantPicker::chosenChanged);
        QCOMPARE(picker.text(), QStringLiteral("everybody"));
        picker.choose({"P05", "P01"});
        QCOMPARE(picker.text(), QStringLiteral("P01, P05"));
        picker.choose({"P01", "P02", "P03", "P04"});
        QVERIFY2(picker.text().startsWith("4 participant"), qPrintable(picker.text()));
        QCOMPARE(changed.count(), 2);
        picker.setChoices({"P01", "P06"}, QStringLiteral("everybody"));
        QCOMPARE(picker.chosen(), QStringList("P01"));
        QCOMPARE(changed.count(), 3);
    }

    void showsNothingWithoutTrials() {
        ResultsView view;
        view.setScene({});
        view.show();
        QVERIFY(!view.findChild<study::ResultTable*>("groupTable")->isVisible());
        QVERIFY(!view.findChild<QComboBox*>("resultTask")->isEnabled());
    }

    void aTablesDataAreInTheCLocale() {
        study::ResultTable table(QStringLiteral("t"));
        table.setRows({"a", "b, c"}, {}, {{{"1,5", "1.5"}, {"x \"y\""}}});
        QCOMPARE(table.csv(), QStringLiteral("a,\"b, c\"\n1.5,\"x \"\"y\"\"\"\n"));
    }
};

static const test::Registration<ResultsViewTest> registration;
#include "results_view_test.moc"
