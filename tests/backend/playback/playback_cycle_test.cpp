// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/backend/playback/playback_cycle_fixture.h"

#include <array>
#include <cmath>
#include <random>
#include <stdexcept>

using namespace teleta;
using namespace teleta::test;

TEST_F(PlaybackCycleTest, writesNothingUnasked) {
    make();
    EXPECT_EQ(run(), PacingClock::kNever_ns);
    m_clock->add(1000 * kMs_ns);
    EXPECT_EQ(run(), PacingClock::kNever_ns);
    EXPECT_TRUE(written().empty());
    EXPECT_EQ(m_cycle->status().mode, PlayerMode::idle);
    EXPECT_EQ(m_cycle->status().ending, PlayerEnding::none);
}

TEST_F(PlaybackCycleTest, writesAProgramAtAbsoluteDeadlinesInOneFrameEach) {
    make();
    const std::int64_t begin_ns = m_clock->now_ns();
    EXPECT_EQ(play(clockOf1s()), begin_ns + kPeriod_ns);
    runOnTime(995 * kMs_ns);
    const auto frames = written();
    ASSERT_EQ(frames.size(), 200U);
    for (std::size_t k = 0; k < frames.size(); ++k) {
        EXPECT_EQ(frames[k].time_ns, begin_ns + static_cast<std::int64_t>(k) * kPeriod_ns);
        EXPECT_NEAR(frames[k].frame.drive[0], 0.005 * static_cast<double>(k) * kFullDrive, 1.0);
        EXPECT_EQ(frames[k].frame.timeout_ms, 100) << "in every frame, so that the board stops by itself";
    }
    const auto counters = m_cycle->counters();
    EXPECT_EQ(counters.framesWritten, 200U);
    EXPECT_EQ(counters.deadlineMisses, 0U);
    EXPECT_NEAR(counters.rate_Hz, 200.0, 1e-6);
    EXPECT_EQ(counters.begun_ns, begin_ns);
    EXPECT_EQ(counters.firstFrame_ns, begin_ns);
    EXPECT_EQ(counters.onset_ns, begin_ns + kPeriod_ns) << "the first frame is at intensity 0";
    EXPECT_NEAR(m_cycle->status().position_s, 0.995, 1e-12);
}

TEST_F(PlaybackCycleTest, endsAProgramWithAZeroFrame) {
    make();
    play(steady(1.0, 0.1));
    runOnTime(500 * kMs_ns);
    const auto frames = written();
    ASSERT_EQ(frames.size(), 21U);
    EXPECT_TRUE(isOff(frames[20].frame.drive));
    EXPECT_EQ(frames[20].time_ns - frames[0].time_ns, 100 * kMs_ns);
    EXPECT_FALSE(isOff(frames[19].frame.drive));
    EXPECT_EQ(m_cycle->status().ending, PlayerEnding::finished);
    EXPECT_EQ(m_cycle->status().begun_ns, frames[0].time_ns);
    EXPECT_EQ(m_cycle->status().ended_ns, frames[20].time_ns);
    EXPECT_EQ(m_cycle->status().position_s, 0.1);
    EXPECT_EQ(m_cycle->status().given, all(0.0));
}

TEST_F(PlaybackCycleTest, endsProgramsWithoutLengthOrContentAtOnce) {
    make();
    for (const double duration_s : {0.0, -1.0, std::nan("")}) {
        EXPECT_EQ(play(steady(1.0, duration_s), true), PacingClock::kNever_ns) << duration_s;
        EXPECT_EQ(m_cycle->status().ending, PlayerEnding::finished);
        EXPECT_TRUE(lastIsOff());
    }
    EXPECT_EQ(play({{}, 1.0}), PacingClock::kNever_ns);
    for (const auto& frame : written())
        EXPECT_TRUE(isOff(frame.frame.drive));
}

TEST_F(PlaybackCycleTest, beginsALoopAnewWithoutAGap) {
    make();
    play(clockOf1s(), true);
    runOnTime(2500 * kMs_ns);
    const auto frames = written();
    ASSERT_EQ(frames.size(), 501U);
    EXPECT_NEAR(frames[200].frame.drive[0], 0.0, 1.0);
    EXPECT_NEAR(frames[300].frame.drive[0], 0.5 * kFullDrive, 1.0);
    PlayerCommands commands;
    commands.loop = false;
    run(std::move(commands));
    runOnTime(400 * kMs_ns);
    EXPECT_EQ(m_cycle->status().mode, PlayerMode::program);
    EXPECT_NEAR(m_cycle->status().position_s, 0.9, 1e-9);
    runOnTime(200 * kMs_ns);
    EXPECT_EQ(m_cycle->status().ending, PlayerEnding::finished)
        << "after the loop was taken away, the position goes on in the present turn";
}

TEST_F(PlaybackCycleTest, seeksWithinTheProgramAndStartsWhereAsked) {
    make();
    play(clockOf1s(), false, 0.25);
    EXPECT_NEAR(written().back().frame.drive[0], 0.25 * kFullDrive, 1.0);
    PlayerCommands commands;
    commands.seek_s = 0.75;
    run(std::move(commands));
    m_clock->add(kPeriod_ns);
    run();
    EXPECT_NEAR(written().back().frame.drive[0], 0.755 * kFullDrive, 1.0);
    PlayerCommands nowhere;
    nowhere.seek_s = std::nan("");
    run(std::move(nowhere));
    m_clock->add(kPeriod_ns);
    run();
    EXPECT_NEAR(written().back().frame.drive[0], 0.76 * kFullDrive, 1.0);
    PlayerCommands beyond;
    beyond.seek_s = 9.0;
    run(std::move(beyond));
    m_clock->add(kPeriod_ns);
    run();
    EXPECT_EQ(m_cycle->status().ending, PlayerEnding::finished);
}

TEST_F(PlaybackCycleTest, endsWhenItStoodStillLongerThanTheBoardsTimeout) {
    make();
    play(steady(1.0));
    m_clock->add(kPeriod_ns + 100 * kMs_ns);
    run();
    EXPECT_EQ(m_cycle->status().mode, PlayerMode::program);
    m_clock->add(200 * kMs_ns);
    EXPECT_EQ(run(), PacingClock::kNever_ns);
    EXPECT_EQ(m_cycle->status().ending, PlayerEnding::stalled);
    EXPECT_TRUE(lastIsOff());

    play(steady(1.0));
    m_bracelet.whileWriting([this] { m_clock->add(101 * kMs_ns); });
    m_clock->add(kPeriod_ns);
    EXPECT_EQ(run(), PacingClock::kNever_ns);
    EXPECT_EQ(m_cycle->status().ending, PlayerEnding::stalled) << "a write that takes that long";
    EXPECT_TRUE(lastIsOff());
}

TEST_F(PlaybackCycleTest, writesNothingOfAProgramThatTookLongerThanTheBoardsTimeout) {
    make();
    play({[this](double t_s) {
              if (t_s > 0.0)
                  m_clock->add(101 * kMs_ns);
              return all(1.0);
          },
          kInfinity});
    m_bracelet.forget();
    m_clock->add(kPeriod_ns);
    EXPECT_EQ(run(), PacingClock::kNever_ns);
    EXPECT_EQ(m_cycle->status().ending, PlayerEnding::stalled);
    ASSERT_EQ(written().size(), 1U);
    EXPECT_TRUE(lastIsOff());
}

TEST_F(PlaybackCycleTest, stopsInTheCycleInWhichItSeesSTOP) {
    make();
    play(steady(1.0));
    runOnTime(50 * kMs_ns);
    m_stop.engage();
    m_clock->add(kPeriod_ns);
    EXPECT_EQ(run(), PacingClock::kNever_ns);
    EXPECT_TRUE(lastIsOff());
    EXPECT_EQ(written().back().time_ns, m_clock->now_ns()) << "in the very next cycle";
    EXPECT_EQ(m_cycle->status().ending, PlayerEnding::stopSwitch);
}

TEST_F(PlaybackCycleTest, looksAtSTOPBeforeCommandsAndPlaysOnlyWhenAskedAgain) {
    make();
    m_stop.engage();
    EXPECT_EQ(play(steady(1.0)), PacingClock::kNever_ns);
    EXPECT_EQ(m_cycle->status().ending, PlayerEnding::stopSwitch);
    for (const auto& frame : written())
        EXPECT_TRUE(isOff(frame.frame.drive));
    m_stop.release();
    m_bracelet.forget();
    m_clock->add(1000 * kMs_ns);
    EXPECT_EQ(run(), PacingClock::kNever_ns);
    EXPECT_TRUE(written().empty()) << "releasing STOP moves nothing";
    play(steady(1.0));
    EXPECT_FALSE(lastIsOff());
}

TEST_F(PlaybackCycleTest, writesNothingOfAProgramDuringWhichSTOPWasEngaged) {
    make();
    play({[this](double) {
              m_stop.engage();
              return all(1.0);
          },
          1.0});
    ASSERT_EQ(written().size(), 1U);
    EXPECT_TRUE(lastIsOff());
    EXPECT_EQ(m_cycle->status().ending, PlayerEnding::stopSwitch);
}

TEST_F(PlaybackCycleTest, zeroesWhenStoppedAndWhenClosed) {
    make();
    play(steady(1.0));
    PlayerCommands commands;
    commands.stop = true;
    m_clock->add(1 * kMs_ns);
    EXPECT_EQ(run(std::move(commands)), PacingClock::kNever_ns);
    EXPECT_TRUE(lastIsOff());
    EXPECT_EQ(m_cycle->status().ending, PlayerEnding::stopped);
    play(steady(1.0));
    EXPECT_FALSE(lastIsOff());
    m_cycle->close();
    EXPECT_TRUE(lastIsOff());
}

TEST_F(PlaybackCycleTest, zeroesWhenTheProgramThrows) {
    make();
    const auto failAt = [](double fail_s, auto what) {
        return Program{[=](double t_s) {
                           if (t_s >= fail_s)
                               throw what;
                           return all(1.0);
                       },
                       1.0};
    };
    play(failAt(0.05, std::runtime_error("no such breakpoint")));
    runOnTime(200 * kMs_ns);
    EXPECT_EQ(written().size(), 11U);
    EXPECT_TRUE(lastIsOff());
    EXPECT_EQ(m_cycle->status().ending, PlayerEnding::sourceFailed);
    EXPECT_EQ(m_cycle->status().message, "no such breakpoint");
    play(failAt(0.0, 7));
    EXPECT_TRUE(lastIsOff());
    EXPECT_EQ(m_cycle->status().ending, PlayerEnding::sourceFailed);
    EXPECT_TRUE(m_cycle->status().message.empty());
}

TEST_F(PlaybackCycleTest, endsWhenTheBraceletIsUnpluggedAndDoesNotGoOnByItself) {
    make();
    play(steady(1.0));
    runOnTime(20 * kMs_ns);
    m_bracelet.connect(0);
    m_clock->add(kPeriod_ns);
    EXPECT_EQ(run(), PacingClock::kNever_ns);
    EXPECT_EQ(m_cycle->status().ending, PlayerEnding::deviceLost);
    m_bracelet.connect(2);
    m_bracelet.forget();
    m_clock->add(1000 * kMs_ns);
    EXPECT_EQ(run(), PacingClock::kNever_ns);
    EXPECT_TRUE(written().empty());
    play(steady(1.0));
    EXPECT_FALSE(lastIsOff());
    EXPECT_EQ(written().back().frame.connection, 2U);
}

TEST_F(PlaybackCycleTest, endsAlsoWhenTheBraceletCameBackBetweenTwoCycles) {
    make();
    play(steady(1.0));
    runOnTime(20 * kMs_ns);
    m_bracelet.forget();
    m_bracelet.connect(2);
    m_clock->add(kPeriod_ns);
    EXPECT_EQ(run(), PacingClock::kNever_ns);
    EXPECT_EQ(m_cycle->status().ending, PlayerEnding::deviceLost);
    for (const auto& frame : written())
        EXPECT_TRUE(isOff(frame.frame.drive));
}

TEST_F(PlaybackCycleTest, endsWhenTheBraceletAnswersNoMoreAndDoesNotGoOnWhenItWakes) {
    for (const bool live : {false, true}) {
        make();
        m_bracelet.setMute(false);
        const auto post = [&] { m_cycle->setpoints().post({all(1.0), m_clock->now_ns()}); };
        const auto runFor = [&](std::int64_t duration_ns) {
            for (std::int64_t t_ns = 0; t_ns < duration_ns; t_ns += kPeriod_ns) {
                m_clock->add(kPeriod_ns);
                post();
                (void)run();
            }
        };
        if (live)
            startLive();
        else
            play(steady(1.0));
        runFor(2000 * kMs_ns);
        ASSERT_FALSE(lastIsOff());
        m_bracelet.setMute(true);
        const std::int64_t mute_ns = m_clock->now_ns();
        runFor(990 * kMs_ns);
        EXPECT_FALSE(lastIsOff()) << "a pause of less than 1 s";
        runFor(100 * kMs_ns);
        EXPECT_TRUE(lastIsOff());
        EXPECT_EQ(m_cycle->status().ending, PlayerEnding::deviceLost);
        EXPECT_EQ(m_cycle->status().ended_ns - mute_ns, 1005 * kMs_ns);
        m_bracelet.setMute(false);
        m_bracelet.forget();
        runFor(1000 * kMs_ns);
        EXPECT_TRUE(written().empty()) << "only when asked";
    }
}

TEST_F(PlaybackCycleTest, refusesToPlayWithoutABracelet) {
    make();
    m_bracelet.connect(0);
    EXPECT_EQ(play(steady(1.0)), PacingClock::kNever_ns);
    EXPECT_EQ(m_cycle->status().ending, PlayerEnding::deviceLost);
    EXPECT_EQ(startLive(), PacingClock::kNever_ns);
    EXPECT_EQ(m_cycle->status().ending, PlayerEnding::deviceLost);
}

TEST_F(PlaybackCycleTest, followsSetpointsAtOnceButOncePerPeriod) {
    make();
    startLive();
    EXPECT_TRUE(lastIsOff()) << "zero before anything was posted";
    ASSERT_EQ(written().size(), 1U);
    m_clock->add(1 * kMs_ns);
    EXPECT_TRUE(m_cycle->takesSetpointAtOnce());
    m_cycle->setpoints().post({all(0.5), m_clock->now_ns()});
    run();
    ASSERT_EQ(written().size(), 2U);
    EXPECT_EQ(written().back().frame.drive[0], 2047);
    EXPECT_FALSE(m_cycle->takesSetpointAtOnce());
    m_cycle->setpoints().post({all(0.25), m_clock->now_ns()});
    run();
    EXPECT_EQ(written().size(), 2U) << "the next one waits for the deadline";
    m_clock->add(4 * kMs_ns);
    run();
    ASSERT_EQ(written().size(), 3U);
    EXPECT_EQ(written().back().frame.drive[0], 1023);
    EXPECT_TRUE(m_cycle->takesSetpointAtOnce());
    EXPECT_EQ(m_cycle->counters().latencyLongest_ns, 4 * kMs_ns);
    EXPECT_EQ(m_cycle->counters().deadlineMisses, 0U);
}

TEST_F(PlaybackCycleTest, keepsItsRateUnder10000SetpointsASecond) {
    make();
    startLive();
    const std::int64_t begin_ns = m_clock->now_ns();
    for (int i = 0; i < 10'000; ++i) {
        m_clock->add(100'000);
        m_cycle->setpoints().post({all(i % 2 == 0 ? 5.0 : 0.5), m_clock->now_ns()});
        m_cycle->setpoints().post({all(0.5), m_clock->now_ns()});
        run();
    }
    EXPECT_EQ(m_clock->now_ns() - begin_ns, 1000 * kMs_ns);
    const auto frames = written();
    EXPECT_GE(frames.size(), 200U);
    EXPECT_LE(frames.size(), 402U) << "one at each deadline and one between two";
    for (const auto& frame : frames)
        EXPECT_LE(frame.frame.drive[0], 2047) << "the latest setpoint wins";
    EXPECT_GE(m_cycle->counters().setpointsReplaced, 10'000U);
    EXPECT_EQ(m_cycle->counters().deadlineMisses, 0U);
}

// A minute of 10 000 setpoints a second, most of them of no use, from two makers at once.
TEST_F(PlaybackCycleTest, holdsEveryLimitUnder10000SetpointsASecond) {
    SafetyLimits limits;
    limits.userLimit = {1.0, 0.9, 0.8, 0.75, 0.3, 0.0};
    make({}, limits);
    startLive();
    std::mt19937_64 random(7);
    std::uniform_int_distribution<int> kind(0, 99);
    std::uniform_real_distribution<double> between(0.0, 1.0);
    const auto wild = [&] {
        Intensities intensities;
        for (double& intensity : intensities) {
            const int drawn = kind(random);
            intensity = drawn == 0   ? std::nan("")
                        : drawn == 1 ? -5.0
                        : drawn == 2 ? -kInfinity
                        : drawn == 3 ? between(random)
                        : drawn < 50 ? kInfinity
                                     : 5.0;
        }
        return intensities;
    };
    std::array<double, core::kTactors> heat{}, before{};
    double hottest = 0.0;
    std::int64_t last_ns = m_clock->now_ns();
    for (int i = 0; i < 600'000; ++i) {
        m_clock->add(100'000);
        m_cycle->setpoints().post({wild(), m_clock->now_ns()});
        if (i % 3 == 0)
            m_cycle->setpoints().post({wild(), m_clock->now_ns() + 3600 * 1000 * kMs_ns});
        run();
        for (const auto& [frame, time_ns] : written()) {
            const double elapsed_s = static_cast<double>(time_ns - last_ns) * 1e-9;
            last_ns = time_ns;
            for (std::size_t motor = 0; motor < core::kTactors; ++motor) {
                const double drive = static_cast<double>(frame.drive[motor]) / kFullDrive;
                // h' = (u^2 - h) / T of the drive before, which held until now.
                heat[motor] += (before[motor] * before[motor] - heat[motor]) *
                               -std::expm1(-elapsed_s / limits.heatTime_s);
                ASSERT_LE(drive, limits.userLimit[motor] + 1e-9) << motor;
                ASSERT_LE(drive - before[motor], limits.rise_perS * elapsed_s + 1.0 / kFullDrive) << motor;
                ASSERT_LE(heat[motor], limits.heatBudget * (1.0 + 1e-6)) << motor;
                before[motor] = drive;
                hottest = std::max(hottest, heat[motor]);
            }
        }
        m_bracelet.forget();
    }
    EXPECT_GT(hottest, 0.99 * limits.heatBudget) << "the load came to the budget";
    EXPECT_EQ(m_cycle->status().mode, PlayerMode::live);
    EXPECT_EQ(m_cycle->counters().deadlineMisses, 0U);
}

TEST_F(PlaybackCycleTest, zeroesWhenTheLastSetpointIsOlderThan100ms) {
    make();
    startLive();
    const std::int64_t made_ns = m_clock->now_ns();
    m_cycle->setpoints().post({all(1.0), made_ns});
    runOnTime(300 * kMs_ns);
    for (const auto& frame : written()) {
        if (frame.time_ns - made_ns > 100 * kMs_ns) {
            EXPECT_TRUE(isOff(frame.frame.drive));
        } else if (frame.time_ns > made_ns) {
            EXPECT_FALSE(isOff(frame.frame.drive));
        }
    }
    EXPECT_TRUE(lastIsOff());
    EXPECT_TRUE(m_cycle->status().silent);
    EXPECT_EQ(m_cycle->status().mode, PlayerMode::live);
    EXPECT_EQ(m_cycle->counters().watchdogTrips, 1U);
    m_cycle->setpoints().post({all(1.0), m_clock->now_ns()});
    run();
    EXPECT_FALSE(lastIsOff());
    EXPECT_FALSE(m_cycle->status().silent);
}

TEST_F(PlaybackCycleTest, doesNotFollowASetpointThatIsOldWhenItComes) {
    make();
    startLive();
    m_clock->add(1 * kMs_ns);
    m_cycle->setpoints().post({all(1.0), m_clock->now_ns() - 101 * kMs_ns});
    run();
    EXPECT_TRUE(lastIsOff());
    EXPECT_TRUE(m_cycle->status().silent);
}

TEST_F(PlaybackCycleTest, zeroesAtOnceWhenSetpointsStayAwayHoweverSlowAFallMayBe) {
    make({}, {.rise_perS = kInfinity, .fall_perS = 0.5, .heatBudget = 1.0});
    startLive();
    m_clock->add(1 * kMs_ns);
    const std::int64_t made_ns = m_clock->now_ns();
    m_cycle->setpoints().post({all(1.0), made_ns});
    runOnTime(110 * kMs_ns);
    ASSERT_GT(written().back().time_ns - made_ns, 100 * kMs_ns);
    EXPECT_TRUE(lastIsOff());
}

TEST_F(PlaybackCycleTest, countsTheAgeOfASetpointOfTheFutureFromNow) {
    make();
    startLive();
    m_clock->add(1 * kMs_ns);
    m_cycle->setpoints().post({all(1.0), m_clock->now_ns() + 3'600'000 * kMs_ns});
    run();
    EXPECT_FALSE(lastIsOff());
    runOnTime(110 * kMs_ns);
    EXPECT_TRUE(lastIsOff());
    EXPECT_TRUE(m_cycle->status().silent);
}

TEST_F(PlaybackCycleTest, doesNotFollowASetpointThatWasNeverMade) {
    make();
    startLive();
    m_clock->add(1 * kMs_ns);
    m_cycle->setpoints().post({all(1.0), std::numeric_limits<std::int64_t>::min()});
    run();
    EXPECT_TRUE(lastIsOff());
    EXPECT_TRUE(m_cycle->status().silent);
}

TEST_F(PlaybackCycleTest, takesSetpointsThatAreNoNumbersAsOff) {
    make();
    startLive();
    m_clock->add(1 * kMs_ns);
    m_cycle->setpoints().post({{std::nan(""), -1.0, 7.0, 0.5, kInfinity, -kInfinity}, m_clock->now_ns()});
    run();
    EXPECT_EQ(written().back().frame.drive, (core::Drive{0, 0, kFullDrive, 2047, kFullDrive, 0}));
}

TEST_F(PlaybackCycleTest, endsLiveOnSTOPAndFollowsNoSetpointAfterItsRelease) {
    make();
    startLive();
    m_stop.engage();
    m_cycle->setpoints().post({all(1.0), m_clock->now_ns()});
    run();
    m_stop.release();
    m_bracelet.forget();
    m_cycle->setpoints().post({all(1.0), m_clock->now_ns()});
    EXPECT_EQ(run(), PacingClock::kNever_ns);
    EXPECT_TRUE(written().empty());
    EXPECT_EQ(m_cycle->status().ending, PlayerEnding::stopSwitch);
}

TEST_F(PlaybackCycleTest, runsNoFasterThanTheBraceletCan) {
    m_bracelet.setMaximumRate_Hz(50.0);
    make();
    EXPECT_EQ(m_cycle->rate_Hz(), 50.0);
    play(steady(1.0));
    runOnTime(1000 * kMs_ns);
    EXPECT_EQ(written().size(), 51U);
}

TEST_F(PlaybackCycleTest, takesNoRateThatItsWatchdogsWouldTakeForAStandstill) {
    for (const double rate_Hz : {0.0, -1.0, 1.0, std::nan("")}) {
        make({.rate_Hz = rate_Hz, .boardTimeout_ms = 1});
        EXPECT_EQ(m_cycle->rate_Hz(), 20.0) << rate_Hz;
        EXPECT_EQ(play(steady(1.0)), m_clock->now_ns() + 50 * kMs_ns);
        EXPECT_EQ(written().back().frame.timeout_ms, 150) << "three periods";
    }
}

TEST_F(PlaybackCycleTest, countsTheFramesLostSinceItBegan) {
    make();
    m_bracelet.setFramesLost(7);
    play(steady(1.0));
    m_bracelet.setFramesLost(10);
    EXPECT_EQ(m_cycle->counters().framesLost, 3U);
    play(steady(1.0));
    EXPECT_EQ(m_cycle->counters().framesLost, 0U);
    EXPECT_EQ(m_cycle->counters().framesWritten, 1U);
}

TEST_F(PlaybackCycleTest, countsAsConfirmedByAFrameOfItsOwnOnly) {
    make();
    m_bracelet.setNumbers(300, 44);
    play({[](double) { return all(0.5); }, 1.0});
    EXPECT_FALSE(m_cycle->counters().confirmed);
    m_bracelet.setNumbers(310, 300);
    EXPECT_FALSE(m_cycle->counters().confirmed) << "the last frame before";
    m_bracelet.setNumbers(310, 301);
    EXPECT_TRUE(m_cycle->counters().confirmed);
    play({[](double) { return all(0.5); }, 1.0});
    EXPECT_FALSE(m_cycle->counters().confirmed);
}

TEST_F(PlaybackCycleTest, keepsTheHeatOfTheMotorsFromOneProgramToTheNext) {
    PlayerConfig config;
    config.clock = m_clock;
    config.limits = {.rise_perS = kInfinity, .heatTime_s = 1.0, .heatBudget = 0.25};
    m_cycle = std::make_unique<PlaybackCycle>(m_bracelet, m_stop, std::move(config));
    play(steady(1.0));
    runOnTime(2000 * kMs_ns);
    EXPECT_NEAR(written().back().frame.drive[0], 0.5 * kFullDrive, 1.0);
    play(steady(1.0));
    m_clock->add(kPeriod_ns);
    run();
    EXPECT_LT(written().back().frame.drive[0], 0.6 * kFullDrive) << "starting anew does not cool a motor";
}

TEST_F(PlaybackCycleTest, endsWhenItWasLateForABoardThatWaitsLessThanTheTimeout) {
    // The board stops its motors after 30 ms, whatever is asked of it.
    m_bracelet.setLongestTimeout_ms(30);
    make();
    play(steady(1.0));
    EXPECT_EQ(written().back().frame.timeout_ms, 30);
    m_clock->add(28 * kMs_ns);
    (void)run();
    EXPECT_EQ(m_cycle->status().mode, PlayerMode::program);
    m_clock->add(40 * kMs_ns);
    (void)run();
    EXPECT_EQ(m_cycle->status().ending, PlayerEnding::stalled) << "the motors stood still meanwhile";
    EXPECT_TRUE(lastIsOff());
}

TEST_F(PlaybackCycleTest, countsHowLateEachRegularFrameIs) {
    make();
    play(steady(1.0));
    for (int k = 0; k < 9; ++k) {
        m_clock->add(kPeriod_ns);
        (void)run();
    }
    m_clock->add(kPeriod_ns + 3 * kMs_ns);
    (void)run();
    const playback::PlayerTimings timings = m_cycle->timings();
    EXPECT_EQ(timings.lateness.count(), 11U);
    EXPECT_EQ(timings.lateness.quantile_ns(0.9), 0);
    EXPECT_EQ(timings.lateness.longest_ns(), 3 * kMs_ns);
    EXPECT_EQ(m_cycle->counters().deadlineMisses, 0U) << "late, but before the next deadline";
}

TEST_F(PlaybackCycleTest, mapsIntensitiesToTheMotorsButNotRawDrives) {
    playback::DriveRanges ranges;
    ranges.fill({0.2, 0.8});
    make({.ranges = ranges});
    play(steady(0.25));
    EXPECT_EQ(written().back().frame.drive[0], 1433) << "4095 (0.2 + 0.25 0.6), rounded down";
    Program raw = steady(0.1);
    raw.raw = true;
    play(raw);
    EXPECT_EQ(written().back().frame.drive[0], 409);
    PlayerCommands commands;
    commands.ranges = playback::DriveRanges{};
    m_clock->add(kPeriod_ns);
    (void)run(std::move(commands));
    play(steady(0.5));
    EXPECT_EQ(written().back().frame.drive[0], 2047);
}
