// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/study/running/bracelet_stimulus.h"
#include "backend/motors/motor_file.h"
#include "tests/app/console/study/study_bench.h"

#include <QMessageBox>

#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>

using namespace teleta;
using test::kPatience_ms;

namespace {

constexpr double kNobodyMeasured = std::numeric_limits<double>::quiet_NaN();

std::int64_t toNs(double time_s) {
    return std::llround(time_s * 1e9);
}

pattern::Pattern pulse() {
    pattern::Pattern pulse;
    pulse.duration_s = 0.2;
    pulse.tracks[0] = {{0.1, 1.0, pattern::Easing::hold}, {0.2, 1.0}};
    return pulse;
}

} // namespace

/// What results of a study change at the connected bracelet, and when it is felt.
class StudyBraceletTest : public QObject, protected test::StudyBench {
    Q_OBJECT

    QTemporaryDir m_settings;

    [[nodiscard]] QMessageBox* question() { return m_page->findChild<QMessageBox*>("useForBracelet"); }
    void answerQuestion(QMessageBox::ButtonRole role) {
        for (QAbstractButton* button : question()->buttons()) {
            if (question()->buttonRole(button) == role) {
                QTest::mouseClick(button, Qt::LeftButton);
                return;
            }
        }
        QFAIL("there is no such button");
    }
    [[nodiscard]] pattern::MotorProfiles weaker() const {
        pattern::MotorProfiles profiles = m_station->calibration().profiles();
        profiles[1].fullDrive = 0.75;
        return profiles;
    }

private slots:
    void initTestCase() { qputenv("XDG_CONFIG_HOME", m_settings.path().toUtf8()); }
    void init() { setUp(); }
    void cleanup() { tearDown(); }

    void timesAreWhenTheyAreFelt_data() {
        QTest::addColumn<double>("latency_s");
        QTest::addColumn<bool>("isAny");
        for (const bool isAny : {false, true}) {
            const char* const which = isAny ? ", first frame" : ", first that is felt";
            QTest::addRow("not measured%s", which) << kNobodyMeasured << isAny;
            QTest::addRow("an hour%s", which) << 3600.0 << isAny;
        }
    }
    void timesAreWhenTheyAreFelt() {
        QFETCH(double, latency_s);
        QFETCH(bool, isAny);
        openPage();
        QTRY_VERIFY_WITH_TIMEOUT(m_station->isAnswering(), kPatience_ms);
        setLatency(latency_s);
        const std::int64_t latency_ns = std::isfinite(latency_s) ? toNs(latency_s) : 0;
        console::BraceletStimulus stimulus(*m_station, *m_stop);
        QCOMPARE(stimulus.onset()(), std::int64_t{0});
        const auto now = [&] { return stimulus.state(core::steadyNow_ns()); };
        stimulus.begin(pulse(), 0.2, isAny ? console::OnsetFrame::any : console::OnsetFrame::notZero,
                       core::steadyNow_ns());
        {
            const std::function<std::int64_t()> onset = stimulus.onset();
            QTRY_VERIFY_WITH_TIMEOUT(now().end_ns != 0 || !now().failure.isEmpty(), kPatience_ms);
            QVERIFY2(now().failure.isEmpty(), qPrintable(now().failure));
            const playback::PlayerCounters counters = m_station->session()->player().counters();
            const playback::PlayerStatus status = m_station->session()->player().status();
            const std::int64_t written_ns = isAny ? counters.firstFrame_ns : counters.onset_ns;
            QVERIFY(written_ns != 0);
            QVERIFY2(counters.firstFrame_ns < counters.onset_ns, "the pulse begins with nothing");
            QCOMPARE(now().onset_ns, written_ns + latency_ns);
            QCOMPARE(now().due_ns, status.begun_ns + toNs(0.2) + latency_ns);
            QCOMPARE(now().end_ns, status.ended_ns + latency_ns);
            // It is told when it has come, not when it is only known.
            QCOMPARE(onset(), latency_ns == 0 ? written_ns : 0);
            setLatency(0.001);
            QTRY_COMPARE_WITH_TIMEOUT(onset(), written_ns + toNs(0.001), kPatience_ms);
        }
    }

    void theOnsetOfAPatternThatIsAlwaysOffIsWhenItsStartWouldBeFelt() {
        openPage();
        QTRY_VERIFY_WITH_TIMEOUT(m_station->isAnswering(), kPatience_ms);
        setLatency(3600.0);
        pattern::Pattern nothing;
        nothing.duration_s = 0.1;
        console::BraceletStimulus stimulus(*m_station, *m_stop);
        const auto now = [&] { return stimulus.state(core::steadyNow_ns()); };
        stimulus.begin(nothing, 0.1, console::OnsetFrame::notZero, core::steadyNow_ns());
        QTRY_VERIFY_WITH_TIMEOUT(now().end_ns != 0 || !now().failure.isEmpty(), kPatience_ms);
        QVERIFY2(now().failure.isEmpty(), qPrintable(now().failure));
        const playback::PlayerStatus status = m_station->session()->player().status();
        QCOMPARE(now().onset_ns, status.begun_ns + toNs(3600.0));
        QCOMPARE(now().end_ns, status.ended_ns + toNs(3600.0));
    }

    void aTrialKeepsTheLatencyOfTheBracelet() {
        openStudy();
        setLatency(0.25, 0.00125);
        beginSession();
        doTrial();
        QTRY_COMPARE_WITH_TIMEOUT(kept().size(), std::size_t(1), kPatience_ms);
        QVERIFY(kept()[0].result.deviceLatency_ms.value_or(0.0) >= 250.0);
        QCOMPARE(kept()[0].result.latencySpread_ms, std::optional(1.25));
    }

    void fullDrivesAreUsedAndSavedOnlyAfterAQuestion() {
        openStudy();
        const std::string serial = m_station->calibration().bracelet;
        const std::string path = motors::profilePath(serial);
        QVERIFY2(!path.empty(), "the simulated bracelet has a serial number");
        QCOMPARE(m_station->calibration().motors[1].profile.fullDrive, 1.0);

        emit resultsView().useRequested(weaker(), QStringLiteral("P01"));
        QVERIFY(question() != nullptr);
        QVERIFY(question()->informativeText().contains(QStringLiteral("P01")));
        answerQuestion(QMessageBox::RejectRole);
        QTRY_VERIFY_WITH_TIMEOUT(question() == nullptr, kPatience_ms);
        QCOMPARE(m_station->calibration().motors[1].profile.fullDrive, 1.0);

        emit resultsView().useRequested(weaker(), QStringLiteral("P01"));
        answerQuestion(QMessageBox::AcceptRole);
        QCOMPARE(m_station->calibration().motors[1].profile.fullDrive, 0.75);
        QTRY_VERIFY_WITH_TIMEOUT(motors::findMotors(serial).value().has_value(), kPatience_ms);
        const auto saved = motors::findMotors(serial);
        QCOMPARE((*saved)->motors[1].profile.fullDrive, 0.75);
        QCOMPARE((*saved)->motors[1].startFrom, motors::CalibratedMotor::Origin::answers);
        QCOMPARE((*saved)->motors[1].lagFrom, motors::CalibratedMotor::Origin::assumed);
    }
};

QTEST_MAIN(StudyBraceletTest)
#include "study_bracelet_test.moc"
