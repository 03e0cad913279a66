// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/bracelet/tapped_bracelet.h"
#include "app/console/study/running/bracelet_stimulus.h"
#include "backend/core/steady_time.h"
#include "backend/pattern/model/built_in_patterns.h"
#include "backend/playback/pattern_program.h"
#include "devices/simulated/simulated_bracelet.h"
#include "tests/app/console/bracelet/patient_bracelet.h"

#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include <memory>

using namespace teleta;
using namespace teleta::console;

/// What the board says of itself reaches the operator, and what it does not take is not taken for felt.
class BraceletAlarmsTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_config;
    core::StopSwitch m_stop;
    std::unique_ptr<BraceletService> m_station;
    QTimer m_clock;

    [[nodiscard]] simulated::SimulatedBracelet& bracelet() {
        auto& tapped =
            dynamic_cast<TappedBracelet&>(const_cast<core::BraceletSource&>(m_station->session()->source()));
        return dynamic_cast<simulated::SimulatedBracelet&>(tapped.bracelet());
    }
    [[nodiscard]] bool detailsHave(const char* text) const {
        const auto reading = m_station->reading();
        return reading && reading->details.contains(QLatin1String(text));
    }
    [[nodiscard]] static const pattern::Pattern& strong() {
        return *pattern::findBuiltIn("stiffness.E.static");
    }

private slots:
    // Limits and profiles of their own, whatever else runs meanwhile.
    void initTestCase() { qputenv("XDG_CONFIG_HOME", m_config.path().toLocal8Bit()); }
    void init() {
        m_station = test::patientBracelet(m_stop);
        m_clock.disconnect();
        connect(&m_clock, &QTimer::timeout, m_station.get(), &BraceletService::tick);
        m_clock.start(5);
        m_station->choose(BraceletChoice::simulated);
        QTRY_VERIFY(m_station->isAnswering());
    }
    void cleanup() {
        m_clock.stop();
        m_station.reset();
    }

    void aBraceletThatIsTooHotIsOffAndSaysSo() {
        m_station->play(playback::programOf(strong()), true);
        QTRY_VERIFY(m_station->isDriven());
        bracelet().setFaults({.tooHot = true});
        QTRY_VERIFY(!m_station->isDriven());
        QVERIFY(!m_station->isAnswering());
        QVERIFY(m_station->isTooHot());
        QVERIFY2(m_station->note().contains(QLatin1String("too hot")), qPrintable(m_station->note()));
        QVERIFY(detailsHave("too hot"));
        QVERIFY(detailsHave("85.0"));

        BraceletStimulus stimulus(*m_station, m_stop);
        QVERIFY(stimulus.obstacle().contains(QLatin1String("too hot")));
        stimulus.begin(strong(), 2.0, OnsetFrame::notZero, core::steadyNow_ns());
        QTRY_VERIFY(!stimulus.state(core::steadyNow_ns()).failure.isEmpty());
        QVERIFY(stimulus.state(core::steadyNow_ns()).failure.contains(QLatin1String("too hot")));

        bracelet().setFaults({});
        QTRY_VERIFY(m_station->isAnswering());
        QVERIFY(!m_station->isDriven());
        QVERIFY(!detailsHave("too hot"));
    }

    void aSupplyThatIsLowIsTold() {
        QVERIFY(detailsHave("5.00 V"));
        bracelet().setFaults({.supplyLow = true});
        QTRY_VERIFY(m_station->note().contains(QLatin1String("4.10 V")));
        QVERIFY2(m_station->isAnswering(), "it plays on");
        QVERIFY(detailsHave("supply low"));
    }

    // A trial of a detection may begin with nothing, or have nothing at all.
    void aTrialThatBeginsWithNothingHasTheOnsetOfItsFirstFrame() {
        pattern::Pattern late;
        late.duration_s = 1.1;
        late.tracks[0] = {{1.0, 1.0, pattern::Easing::hold}, {1.1, 1.0}};
        BraceletStimulus stimulus(*m_station, m_stop);
        const auto end = [&](OnsetFrame onset) {
            stimulus.begin(late, 1.1, onset, core::steadyNow_ns());
            const auto isOver = [&] { return stimulus.state(core::steadyNow_ns()).end_ns != 0; };
            (void)QTest::qWaitFor(isOver, 10'000);
            return stimulus.state(core::steadyNow_ns());
        };
        const StimulusState whole = end(OnsetFrame::any);
        QVERIFY2(whole.failure.isEmpty(), qPrintable(whole.failure));
        QVERIFY(whole.end_ns - whole.onset_ns > 1'000'000'000);
        QVERIFY(end(OnsetFrame::notZero).end_ns - stimulus.state(core::steadyNow_ns()).onset_ns <
                1'000'000'000);

        late.tracks[0].clear();
        late.duration_s = 0.2;
        const StimulusState nothing = end(OnsetFrame::any);
        QVERIFY2(nothing.failure.isEmpty(), qPrintable(nothing.failure));
        QVERIFY(nothing.onset_ns != 0);
        QVERIFY(nothing.onset_ns < nothing.end_ns);
    }

    void whatTheBoardRefusesIsNoStimulus() {
        bracelet().setFaults({.refuse = true});
        BraceletStimulus stimulus(*m_station, m_stop);
        stimulus.begin(strong(), 0.1, OnsetFrame::notZero, core::steadyNow_ns());
        QTRY_VERIFY(!stimulus.state(core::steadyNow_ns()).failure.isEmpty());
        const StimulusState state = stimulus.state(core::steadyNow_ns());
        QVERIFY2(state.failure.contains(QLatin1String("rejected")), qPrintable(state.failure));
        QCOMPARE(state.onset_ns, std::int64_t{0});
        QVERIFY(m_station->note().contains(QLatin1String("refused")));
        QVERIFY(detailsHave("frames refused"));
    }
};

QTEST_MAIN(BraceletAlarmsTest)
#include "bracelet_alarms_test.moc"
