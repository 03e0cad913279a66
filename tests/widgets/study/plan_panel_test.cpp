// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/test_registry.h"
#include "widgets/base/theme.h"
#include "widgets/study/planning/plan_content.h"
#include "widgets/study/planning/plan_panel.h"
#include "widgets/study/results/curve_view.h"

#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QFontMetrics>
#include <QImage>
#include <QLabel>
#include <QSignalSpy>
#include <QTest>

using namespace teleta;
using study::PlanContent;
using study::PlanPanel;

namespace {

study::Protocol protocol() {
    study::Protocol two;
    two.name = "two";
    two.test.repetitions = 5;
    study::StudyTask shape;
    shape.id = shape.name = "shape";
    shape.patterns = {{"A", "A"}, {"B", "B"}};
    shape.conditions = {"static", "dynamic"};
    study::StudyTask one = shape;
    one.id = one.name = "stiffness";
    one.conditions = {"static"};
    two.tasks = {shape, one};
    return two;
}

study::Protocol levels() {
    study::Protocol one;
    one.name = "levels";
    study::StudyTask task;
    task.id = task.name = "detection";
    task.design = study::Design::yesNo;
    task.conditions = {"rest"};
    task.levels.range = {study::LevelScale::log10, 0.01, 1.0};
    one.tasks = {task};
    return one;
}

study::PowerPlan planOf(std::optional<std::size_t> answer, std::optional<std::size_t> other = {}) {
    study::PowerPlan plan;
    plan.points = {{6, 1000, 400, 0}, {8, 1000, 930, 0}};
    plan.participants = answer;
    plan.orParticipants = other;
    return plan;
}

} // namespace

class PlanPanelTest : public QObject {
    Q_OBJECT

private slots:
    void offersTheLinesOfTheAnalyses() {
        const auto tests = PlanContent::tests(protocol());
        QCOMPARE(tests.size(), std::size_t(3 + 1));
        QCOMPARE(tests[0].id, QStringLiteral("shape:condition"));
        QCOMPARE(tests[3].id, QStringLiteral("stiffness:pattern"));
        const auto thresholds = PlanContent::tests(levels());
        QCOMPARE(thresholds.size(), std::size_t(1));
        QCOMPARE(thresholds[0].id, QStringLiteral("detection:threshold"));
        QVERIFY(PlanContent::tests({}).empty());
    }

    void saysWhatIsMissingWhileThereIsNoPlan() {
        PlanPanel panel;
        auto* curve = panel.findChild<study::CurveView*>("planCurve");
        auto* spread = panel.findChild<QDoubleSpinBox*>("planParticipantSd");
        study::Protocol nothing;
        nothing.name = "nothing";
        panel.setProtocol(nothing);
        QVERIFY(!spread->isEnabled());
        QVERIFY(!panel.findChild<QLabel*>("planAnswer")->text().isEmpty());
        QVERIFY(!curve->content().nothing.isEmpty());
        panel.setProtocol(protocol());
        QVERIFY(spread->isEnabled());
        QVERIFY(panel.findChild<QLabel*>("planAnswer")->text().isEmpty());
        QVERIFY(curve->content().nothing.contains("power"));
        panel.setPlan(planOf(8), *panel.request());
        QVERIFY(!curve->content().series[0].points.empty());
        // Another language does not take it away, another protocol does.
        QEvent language(QEvent::LanguageChange);
        QCoreApplication::sendEvent(&panel, &language);
        QVERIFY(!curve->content().series.empty());
        panel.setProtocol(levels());
        QVERIFY(curve->content().series.empty());
    }

    void theFieldsStandBelowEachOtherAndTheTitleIsWhole() {
        PlanPanel panel;
        panel.resize(940, 600); // of a window of 1024 x 700
        panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&panel));
        const auto leftOf = [&](const char* name) {
            auto* field = panel.findChild<QWidget*>(QLatin1String(name));
            return field->mapTo(&panel, QPoint()).x();
        };
        panel.setProtocol(protocol());
        QCoreApplication::processEvents();
        QTRY_COMPARE(leftOf("planShare0"), leftOf("planParticipantSd"));
        QTRY_COMPARE(leftOf("planShare1"), leftOf("planFrom"));
        panel.setProtocol(levels());
        QTRY_COMPARE(leftOf("planThreshold"), leftOf("planFrom"));
        // A title that is too long for one line reaches neither edge of the picture.
        panel.setProtocol(protocol());
        auto* curve = panel.findChild<study::CurveView*>("planCurve");
        study::CurveContent content = PlanContent::curve(
            planOf(8), *panel.request(),
            QStringLiteral("The shape of what was touched by the arm: conditions by patterns"));
        curve->setContent(content);
        const QImage picture = curve->grab().toImage();
        QVERIFY(QFontMetrics(base::bold(curve->font())).horizontalAdvance(content.title) > curve->width());
        const QColor paper = curve->palette().color(QPalette::Base);
        const int em = curve->fontMetrics().height();
        for (int y = em / 2; y < 3 * em; ++y)
            for (const int x : {2, picture.width() - 3})
                QCOMPARE(picture.pixelColor(x, y), paper);
    }

    void theRequestIsWhatTheFormSays() {
        PlanPanel panel;
        QVERIFY(!panel.request());
        panel.setProtocol(protocol());
        panel.findChild<QDoubleSpinBox*>("planShare0")->setValue(60.0);
        panel.findChild<QDoubleSpinBox*>("planShare1")->setValue(85.0);
        panel.findChild<QDoubleSpinBox*>("planParticipantSd")->setValue(0.3);
        panel.findChild<QSpinBox*>("planFrom")->setValue(4);
        panel.findChild<QSpinBox*>("planTo")->setValue(9);
        panel.findChild<QSpinBox*>("planStep")->setValue(2);
        const auto request = panel.request();
        QVERIFY(request.has_value());
        QCOMPARE(request->test, QStringLiteral("shape:condition"));
        QCOMPARE(request->settings.participants, (std::vector<std::size_t>{4, 6, 8}));
        QCOMPARE(request->settings.target, 0.9);
        const study::TaskTruth* truth = request->truth.find("shape");
        QVERIFY(truth != nullptr);
        QCOMPARE(truth->participantSd, 0.3);
        QCOMPARE(truth->conditions[1].correct, 0.85);
        panel.findChild<QSpinBox*>("planFrom")->setValue(20);
        QVERIFY(!panel.request().has_value());
    }

    void aTaskWithLevelsAsksForItsThreshold() {
        PlanPanel panel;
        panel.setProtocol(levels());
        panel.show();
        auto* threshold = panel.findChild<QDoubleSpinBox*>("planThreshold");
        QVERIFY(threshold->isVisible());
        QVERIFY(!panel.findChild<QDoubleSpinBox*>("planParticipantSd")->isVisible());
        QVERIFY(panel.findChild<QDoubleSpinBox*>("planShare0") == nullptr);
        QCOMPARE(threshold->value(), 0.1); // the middle of the logarithms
        panel.findChild<QDoubleSpinBox*>("planGuess")->setValue(5.0);
        panel.findChild<QDoubleSpinBox*>("planWidth")->setValue(0.08);
        auto request = panel.request();
        QVERIFY(request && request->wish);
        QCOMPARE(request->test, QStringLiteral("detection:threshold"));
        QCOMPARE(request->wish->halfWidth, 0.08);
        QVERIFY(!request->wish->trials);
        QCOMPARE(request->settings.studies, std::size_t(1000));
        QCOMPARE(request->settings.mostStudies, std::size_t(4000));
        const study::TaskTruth* truth = request->truth.find("detection");
        QVERIFY(truth != nullptr && truth->threshold);
        QCOMPARE(truth->threshold->guess, 0.05);
        QCOMPARE(truth->threshold->slope, 3.5);
        panel.findChild<QSpinBox*>("planTrials")->setValue(60);
        QCOMPARE(panel.request()->wish->trials, std::optional<std::size_t>(60));
        panel.setPlan(planOf(8U), *panel.request());
        QVERIFY(panel.findChild<study::CurveView*>("planCurve")->content().title.startsWith("Precision: "));
        // What a file says is not what the form says, but the wish is.
        study::StudyTruth read;
        read.tasks.push_back({"detection", 0.0, 0.0, {}, study::ThresholdTruth{0.3, 2.0, 0.0, 0.0, 0.1}});
        panel.setTruth(read, QStringLiteral("truth.toml"));
        QVERIFY(!threshold->isEnabled());
        QVERIFY(panel.findChild<QDoubleSpinBox*>("planWidth")->isEnabled());
        QCOMPARE(panel.request()->truth.tasks[0].threshold->threshold, 0.3);
        // Patterns again.
        panel.setProtocol(protocol());
        QVERIFY(!threshold->isVisible());
        QVERIFY(panel.findChild<QDoubleSpinBox*>("planParticipantSd")->isVisible());
        QCOMPARE(panel.request()->settings.studies, std::size_t(10'000));
        QVERIFY(!panel.request()->wish);
    }

    void theFieldsOfAThresholdHaveRoomWheneverTheTaskComes() {
        PlanPanel panel;
        panel.resize(1200, 800);
        panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&panel));
        for (const study::Protocol& one : {levels(), protocol(), levels()}) {
            panel.setProtocol(one);
            QCoreApplication::processEvents();
            const bool ofThreshold = one.tasks[0].design != study::Design::identification;
            const char* name = ofThreshold ? "planWidth" : "planParticipantSd";
            auto* field = panel.findChild<QWidget*>(name);
            QVERIFY(field->visibleRegion().boundingRect().height() >= field->sizeHint().height());
        }
    }

    void theNumberOfStudiesStaysWithinOneKindOfTest() {
        study::Protocol mixed = protocol();
        mixed.tasks.push_back(levels().tasks[0]);
        PlanPanel panel;
        panel.setProtocol(mixed);
        auto* tests = panel.findChild<QComboBox*>("planTest");
        auto* studies = panel.findChild<QComboBox*>("planStudies");
        studies->setCurrentIndex(studies->findData(40'000));
        tests->setCurrentIndex(1);
        QCOMPARE(panel.request()->settings.studies, std::size_t(40'000));
        tests->setCurrentIndex(tests->findData("detection:threshold"));
        QCOMPARE(panel.request()->settings.studies, std::size_t(1000));
        auto* curve = panel.findChild<study::CurveView*>("planCurve");
        QVERIFY(curve->content().nothing.contains("narrow enough"));
        tests->setCurrentIndex(0);
        QCOMPARE(panel.request()->settings.studies, std::size_t(10'000));
        QVERIFY(curve->content().nothing.contains("power"));
    }

    void aStraightScaleHasSpreadsInItsUnit() {
        study::Protocol times = levels();
        times.tasks[0].design = study::Design::compare;
        times.tasks[0].levels.vary = study::Vary::onset;
        times.tasks[0].levels.range = {study::LevelScale::linear, 0.1, 0.5};
        PlanPanel panel;
        panel.setProtocol(times);
        panel.show();
        QCOMPARE(panel.findChild<QDoubleSpinBox*>("planThreshold")->value(), 0.3);
        QCOMPARE(panel.findChild<QDoubleSpinBox*>("planWidth")->suffix(), QStringLiteral(" s"));
        QCOMPARE(panel.findChild<QDoubleSpinBox*>("planSlope")->value(), 0.04);
        QVERIFY(!panel.findChild<QDoubleSpinBox*>("planGuess")->isVisible());
    }

    void aTaskWithOneConditionHasOneShare() {
        PlanPanel panel;
        panel.setProtocol(protocol());
        panel.findChild<QComboBox*>("planTest")->setCurrentIndex(3);
        QVERIFY(panel.findChild<QDoubleSpinBox*>("planShare0") != nullptr);
        QTRY_VERIFY(panel.findChild<QDoubleSpinBox*>("planShare1") == nullptr);
        QCOMPARE(panel.request()->truth.tasks[0].conditions.size(), std::size_t(1));
    }

    void aTruthOfAFileLocksTheShares() {
        PlanPanel panel;
        panel.setProtocol(protocol());
        panel.show();
        study::StudyTruth truth;
        truth.tasks.push_back({"shape", 0.1, 0.1, {{"static", 0.5, {}}, {"dynamic", 0.9, {}}}});
        panel.setTruth(truth, QStringLiteral("truth.toml"));
        QVERIFY(!panel.findChild<QDoubleSpinBox*>("planShare0")->isEnabled());
        QCOMPARE(panel.request()->truth.tasks[0].conditions[1].correct, 0.9);
        QTest::mouseClick(panel.findChild<QPushButton*>("planOwn"), Qt::LeftButton);
        QVERIFY(panel.findChild<QDoubleSpinBox*>("planShare0")->isEnabled());
    }

    void whileItRunsTheFormIsLockedAndCanBeCancelled() {
        PlanPanel panel;
        panel.setProtocol(protocol());
        panel.show();
        auto* start = panel.findChild<QPushButton*>("planStart");
        auto* cancel = panel.findChild<QPushButton*>("planCancel");
        QVERIFY(!cancel->isEnabled());
        QSignalSpy planned(&panel, &PlanPanel::planRequested);
        QSignalSpy cancelled(&panel, &PlanPanel::cancelRequested);
        QTest::mouseClick(start, Qt::LeftButton);
        QCOMPARE(planned.count(), 1);
        panel.setRunning(0.25);
        QVERIFY(!start->isEnabled());
        QCOMPARE(panel.findChild<QProgressBar*>("planProgress")->value(), 250);
        QTest::mouseClick(cancel, Qt::LeftButton);
        QCOMPARE(cancelled.count(), 1);
        panel.setPlan(planOf(8U), *panel.request());
        QVERIFY(start->isEnabled());
        const study::CurveContent& curve = panel.findChild<study::CurveView*>("planCurve")->content();
        QCOMPARE(curve.series[0].points.size(), std::size_t(2));
        QCOMPARE(curve.series[0].points[0].y, 40.0);
        QVERIFY(curve.series[0].points[0].interval->low < 40.0);
        QCOMPARE(*curve.reference, 90.0);
        QVERIFY(panel.findChild<QLabel*>("planAnswer")->text().contains(QStringLiteral("8 participants")));
    }

    void theAnswerSaysWhatChanceCannotTell() {
        const study::PlanSettings settings{{6, 8}, 1000};
        QVERIFY(PlanContent::answer(planOf(6U, 8U), settings).contains(QStringLiteral("6 or 8")));
        QVERIFY(PlanContent::answer(planOf({}), settings).contains(QStringLiteral("No number up to 8")));
        study::PowerPlan cut = planOf(8U);
        cut.cancelled = true;
        QVERIFY(PlanContent::answer(cut, settings).startsWith(QStringLiteral("Cancelled")));
    }
};

static const test::Registration<PlanPanelTest> registration;
#include "plan_panel_test.moc"
