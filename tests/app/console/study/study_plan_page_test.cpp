// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/console/study/study_bench.h"
#include "widgets/study/planning/plan_panel.h"
#include "widgets/study/results/curve_view.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QTest>

using namespace teleta;
using test::kPatience_ms;

/// The view Plan of the Study page, with its pool thread.
class StudyPlanPageTest : public QObject, protected test::StudyBench {
    Q_OBJECT

    template <typename Widget>
    Widget* find(const char* name) {
        return m_page->findChild<Widget*>(QLatin1String(name));
    }

private slots:
    void init() { setUp(); }
    void cleanup() { tearDown(); }

    void aPlanRunsInTheBackgroundAndCanBeCancelled() {
        openStudy();
        m_page->bringForward(QStringLiteral("plan"));
        auto* start = find<QPushButton>("planStart");
        QTRY_VERIFY_WITH_TIMEOUT(start->isEnabled(), kPatience_ms);
        find<QSpinBox>("planFrom")->setValue(3);
        find<QSpinBox>("planTo")->setValue(4);
        find<QComboBox>("planStudies")->setCurrentIndex(0);
        QTest::mouseClick(start, Qt::LeftButton);
        QVERIFY(!start->isEnabled());
        QTRY_VERIFY_WITH_TIMEOUT(start->isEnabled(), kPatience_ms);
        const auto& points = find<study::CurveView>("planCurve")->content().series[0].points;
        QVERIFY(!points.empty());
        QVERIFY(points[0].interval.has_value());
        QVERIFY(!find<QLabel>("planAnswer")->text().isEmpty());
        // Many studies of many people would take minutes.
        find<QSpinBox>("planTo")->setValue(200);
        find<QSpinBox>("planStep")->setValue(1);
        find<QComboBox>("planStudies")->setCurrentIndex(2);
        QTest::mouseClick(start, Qt::LeftButton);
        QTest::mouseClick(find<QPushButton>("planCancel"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(start->isEnabled(), kPatience_ms);
        QVERIFY(find<QLabel>("planAnswer")->text().startsWith(QStringLiteral("Cancelled")));
    }

    void aThresholdIsPlannedForToo() {
        openPage();
        study::StudyHead levels = head(study::Mode::pilot, 0.1);
        levels.protocol = study::readNamedProtocol("tactor-detection").value();
        controller().create(studyFolder().toStdString(), levels);
        QTRY_VERIFY_WITH_TIMEOUT(controller().overview().has_value(), kPatience_ms);
        m_page->bringForward(QStringLiteral("plan"));
        QCOMPARE(find<QComboBox>("planTest")->currentData().toString(),
                 QStringLiteral("detection:threshold"));
        find<QSpinBox>("planTrials")->setValue(10);
        find<QDoubleSpinBox>("planWidth")->setValue(2.0);
        find<QSpinBox>("planFrom")->setValue(3);
        find<QSpinBox>("planTo")->setValue(3);
        auto* start = find<QPushButton>("planStart");
        QTRY_VERIFY_WITH_TIMEOUT(start->isEnabled(), kPatience_ms);
        QTest::mouseClick(start, Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(start->isEnabled(), 10 * kPatience_ms);
        const study::CurveContent& curve = find<study::CurveView>("planCurve")->content();
        QCOMPARE(curve.series[0].points.size(), std::size_t(1));
        const study::CurvePoint& point = curve.series[0].points[0];
        QCOMPARE(point.x, 3.0);
        QVERIFY(point.y > 0.0 && point.y < 100.0 && point.interval);
        QVERIFY(find<QLabel>("planAnswer")->text().contains(QStringLiteral("up to 3")));
    }

    void aPilotWithTooFewParticipantsSaysWhatItNeeds() {
        openStudy();
        m_page->bringForward(QStringLiteral("plan"));
        auto* pilot = find<QPushButton>("planPilot");
        QTRY_VERIFY_WITH_TIMEOUT(pilot->isEnabled(), kPatience_ms);
        QTest::mouseClick(pilot, Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(
            find<QLabel>("planAnswer")->text().contains(QStringLiteral("5 participants")), kPatience_ms);
    }
};

QTEST_MAIN(StudyPlanPageTest)
#include "study_plan_page_test.moc"
