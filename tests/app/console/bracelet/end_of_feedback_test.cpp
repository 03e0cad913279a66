// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/device/stream_tap.h"
#include "backend/core/steady_time.h"
#include "backend/pipeline/touch/touch_record.h"
#include "tests/app/console/bracelet/patient_bracelet.h"

#include <QTemporaryDir>
#include <QTest>

#include <cstring>
#include <memory>

using namespace teleta;
using console::BraceletChoice;
using console::BraceletService;

namespace {

/// So long that it does not end by itself in a test.
playback::Program longProgram(const std::string& /*id*/ = {}) {
    core::Intensities half{};
    half.fill(0.5);
    return {[half](double) { return half; }, 600.0};
}

} // namespace

/// What is played for touches ends when the arm tells nothing any more.
class EndOfFeedbackTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_config;
    core::StopSwitch m_stop;
    std::unique_ptr<BraceletService> m_station;

    [[nodiscard]] std::int64_t begun_ns() const { return m_station->session()->player().counters().begun_ns; }
    void touch(std::uint64_t number) {
        pipeline::TouchRecord record;
        record.number = number;
        record.ready_ns = core::steadyNow_ns();
        record.stiffness.emplace();
        record.stiffness->material = stiffness::Material::metal;
        m_station->feedback()->onTouch(record);
    }

private slots:
    void initTestCase() { qputenv("XDG_CONFIG_HOME", m_config.path().toLocal8Bit()); }
    void init() {
        m_station = test::patientBracelet(m_stop);
        m_station->choose(BraceletChoice::simulated);
        QTRY_VERIFY((m_station->tick(), m_station->isReady()));
        m_station->setLibrary(longProgram);
        m_station->setMap(pattern::PatternMap::defaults());
        m_station->setMode(pipeline::FeedbackMode::stiffness);
    }
    void cleanup() { m_station.reset(); }

    void theNewestOfTwoTouchesOneRightAfterTheOtherIsEnded() {
        touch(1);
        QTRY_VERIFY(begun_ns() != 0);
        const std::int64_t first_ns = begun_ns();
        touch(2);
        // The first one is still what the bracelet tells of.
        m_station->tick();
        QTRY_VERIFY(begun_ns() != first_ns);
        m_station->endFeedback();
        QTRY_VERIFY(!m_station->isDriven());
    }

    void aTouchThatNobodyHasLookedAtYetIsEnded() {
        touch(1);
        QTRY_VERIFY(m_station->isDriven());
        m_station->endFeedback();
        QTRY_VERIFY(!m_station->isDriven());
    }

    // Its first frame would be off, and the touch felt one frame later.
    void whatATouchTellsIsFeltFromTheFirstFrameOn() {
        m_station->setLibrary([](const std::string&) {
            return playback::Program{[](double t_s) {
                                         core::Intensities wanted{};
                                         wanted.fill(t_s > 0.0 ? 0.5 : 0.0);
                                         return wanted;
                                     },
                                     600.0};
        });
        const auto frames = std::make_shared<core::StreamTap>(100'000);
        m_station->session()->record(frames);
        touch(1);
        core::TappedFrames first;
        QTRY_VERIFY_WITH_TIMEOUT(frames->pop(first), 60'000);
        m_station->session()->record(nullptr);
        float share = 0.0F;
        QVERIFY(first.values.size() >= sizeof(share));
        std::memcpy(&share, first.values.data(), sizeof(share));
        QVERIFY(share > 0.0F);
    }

    void aPatternThatBeginsWithARestIsFeltLaterThanItBegins() {
        constexpr double kRest_s = 1.0;
        m_station->setLibrary([](const std::string&) {
            return playback::Program{[](double t_s) {
                                         core::Intensities wanted{};
                                         wanted.fill(t_s > kRest_s ? 0.5 : 0.0);
                                         return wanted;
                                     },
                                     600.0};
        });
        touch(1);
        QTRY_VERIFY((m_station->tick(), m_station->lastEvent() && m_station->lastEvent()->onset_s));
        const console::TouchReceipt event = *m_station->lastEvent();
        QVERIFY(event.begin_s && *event.begin_s >= 0.0);
        QVERIFY(*event.onset_s > *event.begin_s);
        QCOMPARE(m_station->touchToSkin()->median_s, *event.begin_s);
    }

    void whatIsPlayedForSomethingElseGoesOn() {
        touch(1);
        QTRY_VERIFY(m_station->isDriven());
        const std::uint64_t number = m_station->play(longProgram(), false);
        m_station->endFeedback();
        QTRY_VERIFY(m_station->session()->player().status().program == number &&
                    m_station->playingPosition_s().value_or(0.0) > 0.05);
        m_station->endFeedback();
        QVERIFY(m_station->isPlaying(number));
    }
};

QTEST_MAIN(EndOfFeedbackTest)
#include "end_of_feedback_test.moc"
