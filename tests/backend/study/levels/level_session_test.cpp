// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/session/session_flow.h"
#include "backend/study/session/simulated_observer.h"
#include "tests/backend/study/levels/level_protocol.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

namespace teleta::study {

namespace {

constexpr std::int64_t kS = 1'000'000'000;
const std::string kDetection = "design = \"interval\"\n" + kTwoTracks + kStimulus + kLogLevels +
                               "procedure = { kind = \"bayes\", most_trials = 5, least_trials = 5 }\n";

/// Runs a session to its end or until so many trials; the answers are right two times of three.
std::vector<TrialResult> run(const Protocol& protocol, const PlannedSession& plan,
                             std::vector<TrialResult> done, std::size_t most) {
    auto session = Session::create(protocol, plan, done, 0);
    if (!session) {
        ADD_FAILURE() << core::describe(session.error());
        return done;
    }
    std::int64_t now_ns = static_cast<std::int64_t>(done.size()) * 100 * kS;
    while (session->current() != nullptr && done.size() < most) {
        now_ns += kS;
        if (session->stage() == Stage::feedback)
            session->feedbackSeen();
        EXPECT_TRUE(session->startTrial(now_ns));
        session->stimulusStarted(now_ns);
        session->stimulusEnded(now_ns + 3 * kS / 2);
        const PlannedTrial* const shown = session->current();
        const std::size_t right = shown == nullptr ? 0 : shown->stimulus;
        const KeyPress press{done.size() % 3 == 0 ? 1 - right : right, "keyboard", "Digit1", now_ns + 2 * kS,
                             false};
        session->press(press);
        session->release("keyboard", "Digit1");
        done.push_back(session->takeResult().value());
        now_ns += 3 * kS;
    }
    return done;
}

} // namespace

TEST(LevelSession, endsWhenAllItsTracksAreOver) {
    const Protocol protocol = levelProtocol(kDetection, 2);
    const PlannedSession plan = planSessions(protocol, 4, 0)[0];
    const std::vector<TrialResult> results = run(protocol, plan, {}, 1000);
    ASSERT_EQ(results.size(), 4U + 10U);
    EXPECT_EQ(plan.practiceTrials + plan.testTrials, results.size());
    for (std::size_t i = 0; i < results.size(); ++i) {
        EXPECT_EQ(results[i].planned.phase, i < 4 ? Phase::practice : Phase::test);
        EXPECT_EQ(results[i].responseTimeOffset_s, 0.5) << "from the end of the last interval";
        if (i < 4) {
            EXPECT_EQ(results[i].planned.level, 1.0) << "practice is at the highest level";
        }
    }
}

TEST(LevelSession, takesAnAnswerBeforeTheLastIntervalHasEndedForEarly) {
    const Protocol protocol = levelProtocol(kDetection, 0);
    auto session = Session::create(protocol, planSessions(protocol, 4, 0)[0], {}, 0).value();
    ASSERT_TRUE(session.startTrial(kS));
    session.stimulusStarted(kS);
    session.press({0, "keyboard", "Digit1", 2 * kS, false});
    session.release("keyboard", "Digit1");
    EXPECT_EQ(session.stage(), Stage::stimulus);
    session.stimulusEnded(kS + 3 * kS / 2);
    session.press({0, "keyboard", "Digit1", 3 * kS, false});
    const TrialResult result = session.takeResult().value();
    EXPECT_EQ(result.earlyPresses, 1U);
    EXPECT_EQ(result.responseTimeOffset_s, 0.5);
}

TEST(LevelSession, resumesWithTheSameTrials) {
    const Protocol protocol = levelProtocol(kDetection, 1);
    const PlannedSession plan = planSessions(protocol, 4, 0)[0];
    const std::vector<TrialResult> whole = run(protocol, plan, {}, 1000);
    for (std::size_t cut = 0; cut <= whole.size(); ++cut) {
        const std::vector<TrialResult> half(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(cut));
        const std::vector<TrialResult> resumed = run(protocol, plan, half, 1000);
        ASSERT_EQ(resumed.size(), whole.size()) << cut;
        for (std::size_t i = 0; i < whole.size(); ++i) {
            EXPECT_EQ(resumed[i].planned.level, whole[i].planned.level) << cut << ' ' << i;
            EXPECT_EQ(resumed[i].planned.target, whole[i].planned.target) << cut << ' ' << i;
            EXPECT_EQ(resumed[i].planned.track, whole[i].planned.track) << cut << ' ' << i;
        }
    }
}

TEST(LevelSession, refusesKeptTrialsThatThePlanDoesNotHave) {
    const Protocol protocol = levelProtocol(kDetection, 0);
    const PlannedSession plan = planSessions(protocol, 4, 0)[0];
    const std::vector<TrialResult> good = run(protocol, plan, {}, 3);
    const auto isRefused = [&](const std::function<void(PlannedTrial&)>& change) {
        std::vector<TrialResult> kept = good;
        change(kept[1].planned);
        const auto session = Session::create(protocol, plan, kept, 0);
        return !session && session.error().kind == core::ErrorKind::refused;
    };
    EXPECT_FALSE(isRefused([](PlannedTrial&) {}));
    EXPECT_TRUE(isRefused([](PlannedTrial& trial) { *trial.level *= 1.001; }));
    EXPECT_TRUE(isRefused([](PlannedTrial& trial) { trial.level.reset(); }));
    EXPECT_TRUE(isRefused([](PlannedTrial& trial) { trial.track = "t9"; }));
    EXPECT_TRUE(isRefused([](PlannedTrial& trial) { trial.target = 1 - *trial.target; }));
    EXPECT_TRUE(isRefused([](PlannedTrial& trial) { trial.stimulus = 1 - trial.stimulus; }));
}

TEST(LevelSession, ofAComparisonTellsNobodyWhatWasRight) {
    const Protocol protocol = [] {
        Protocol made =
            levelProtocol("design = \"compare\"\n" + kStimulus +
                              "level = { lowest = 0.2, highest = 1.0, reference = 0.6 }\nprocedure = "
                              "{ kind = \"bayes\" }\n",
                          1);
        made.practice.feedback = true;
        return made;
    }();
    auto session = Session::create(protocol, planSessions(protocol, 4, 0)[0], {}, 0).value();
    EXPECT_FALSE(session.settings(Phase::practice).feedback);
}

TEST(SimulatedObserver, isReadFromWords) {
    const auto observer = SimulatedObserver::parse("t=0.2,slope=3,lapse=0.05,sd=0.1");
    ASSERT_TRUE(observer);
    EXPECT_EQ(observer->threshold, 0.2);
    EXPECT_EQ(observer->slope, 3.0);
    EXPECT_EQ(observer->lapse, 0.05);
    EXPECT_EQ(observer->sd, 0.1);
    EXPECT_TRUE(SimulatedObserver::parse(""));
    for (const char* wrong :
         {"t", "t=", "t=x", "t=-1", "t=0", "lapse=0.9", "lapse=-0.1", "sd=-1", "slope=nan", "b=3"}) {
        const auto refused = SimulatedObserver::parse(wrong);
        ASSERT_FALSE(refused) << wrong;
        EXPECT_EQ(refused.error().kind, core::ErrorKind::badInput);
    }
}

TEST(SimulatedObserver, answersWithTheSharesOfItsFunction) {
    const StudyTask task = levelProtocol(kDetection).tasks[0];
    const SimulatedObserver observer = *SimulatedObserver::parse("t=0.1,slope=3.5,lapse=0.04");
    const PsychometricFunction function = observer.functionOf(task, "rest", 1);
    EXPECT_EQ(function.guess, 0.5);
    PlannedTrial trial;
    trial.target = 1;
    constexpr int kTrials = 20'000;
    for (const double level : {0.02, 0.1, 0.3}) {
        trial.level = level;
        int right = 0;
        for (std::uint64_t seed = 0; seed < kTrials; ++seed)
            right += SimulatedObserver::answer(function, task, trial, seed) == 1U ? 1 : 0;
        // Weibull with its threshold at one half.
        const double share = 0.5 + 0.46 * (1.0 - std::pow(2.0, -std::pow(level / 0.1, 3.5)));
        EXPECT_NEAR(right / double(kTrials), share, 5.0 * std::sqrt(share * (1.0 - share) / kTrials))
            << level;
    }
}

TEST(SimulatedObserver, differBetweenPeopleByTheirSpread) {
    const StudyTask task = levelProtocol(kDetection).tasks[0];
    const SimulatedObserver observer = *SimulatedObserver::parse("t=0.1,sd=0.2");
    double sum = 0.0;
    double squares = 0.0;
    constexpr int kPeople = 4000;
    for (std::size_t i = 0; i < kPeople; ++i) {
        const double t = std::log10(observer.functionOf(task, "rest", observerSeed(9, i)).threshold);
        sum += t;
        squares += t * t;
    }
    const double mean = sum / kPeople;
    EXPECT_NEAR(mean, -1.0, 5.0 * 0.2 / std::sqrt(kPeople));
    EXPECT_NEAR(std::sqrt(squares / kPeople - mean * mean), 0.2, 0.015);
}

} // namespace teleta::study
