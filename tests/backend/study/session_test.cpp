// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/session/session.h"
#include "tests/backend/study/small_protocol.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace teleta::study {

namespace {

constexpr std::int64_t kSecond_ns = 1'000'000'000;

std::int64_t at(double time_s) {
    return std::llround(time_s * 1e9);
}

/// A session of the test phase only, and functions that play its trials.
class SessionTest : public testing::Test {
protected:
    void begin(Protocol protocol = smallProtocol(), std::vector<TrialResult> done = {}) {
        m_plan = planSessions(protocol, 1, 0).front();
        m_plan.practice.clear();
        auto session = Session::create(protocol, m_plan, done, 0);
        ASSERT_TRUE(session);
        m_session.emplace(std::move(*session));
    }

    /// Onset at onset_s, end two seconds later.
    void show(double onset_s) {
        ASSERT_TRUE(m_session->startTrial(at(onset_s) - 5'000'000));
        m_session->stimulusStarted(at(onset_s));
        m_session->stimulusEnded(at(onset_s + 2.0));
    }

    void press(double time_s, std::size_t response, bool autoRepeat = false) {
        m_session->press({response, "keyboard", std::to_string(response + 1), at(time_s), autoRepeat});
    }

    void release(std::size_t response) { m_session->release("keyboard", std::to_string(response + 1)); }

    [[nodiscard]] std::size_t right() const {
        const PlannedTrial* trial = m_session->current();
        return trial == nullptr ? 0 : trial->stimulus;
    }
    [[nodiscard]] std::size_t wrong() const { return (right() + 1) % 3; }

    PlannedSession m_plan;
    std::optional<Session> m_session;
};

} // namespace

TEST_F(SessionTest, timesAnAnswerFromOnsetAndFromEnd) {
    begin();
    show(1.0);
    press(4.25, right());
    const std::optional<TrialResult> result = m_session->takeResult();
    ASSERT_TRUE(result);
    EXPECT_EQ(result->outcome, Outcome::correct);
    EXPECT_NEAR(*result->responseTime_s, 3.25, 1e-12);
    EXPECT_NEAR(*result->responseTimeOffset_s, 1.25, 1e-12);
    EXPECT_NEAR(*result->deviceLatency_ms, 5.0, 1e-9);
    EXPECT_NEAR(result->onset_s, 1.0, 1e-12);
    EXPECT_NEAR(result->duration_s, 2.0, 1e-12);
    EXPECT_EQ(result->responseKey, std::to_string(*result->response + 1));
    EXPECT_FALSE(m_session->takeResult());
}

TEST_F(SessionTest, tellsAWrongAnswer) {
    begin();
    show(1.0);
    press(2.5, wrong());
    EXPECT_EQ(m_session->takeResult()->outcome, Outcome::incorrect);
}

TEST_F(SessionTest, anAnswerAt9999CountsAndOneAt10001DoesNot) {
    begin();
    show(1.0);
    press(10.999, right());
    EXPECT_EQ(m_session->takeResult()->outcome, Outcome::correct);
    release(0), release(1), release(2);

    show(20.0);
    press(30.001, right());
    const std::optional<TrialResult> late = m_session->takeResult();
    ASSERT_TRUE(late);
    EXPECT_EQ(late->outcome, Outcome::timeout);
    EXPECT_FALSE(late->response);
    EXPECT_FALSE(late->responseTime_s);
    EXPECT_EQ(late->responseKey, "");
    show(40.0);
    m_session->advance(at(51.0));
    EXPECT_EQ(m_session->takeResult()->earlyPresses, 0U) << "a late press is not an early one";
}

TEST_F(SessionTest, theLimitItselfStillCounts) {
    begin();
    show(1.0);
    m_session->advance(at(11.0));
    EXPECT_FALSE(m_session->takeResult());
    m_session->advance(at(11.0) + 1);
    EXPECT_EQ(m_session->takeResult()->outcome, Outcome::timeout);
}

TEST_F(SessionTest, theLimitCountsFromTheEndWhereTheProtocolSaysSo) {
    begin(smallProtocol("from_end"));
    show(1.0);
    EXPECT_EQ(m_session->deadline_ns(), at(13.0));
    press(12.5, right());
    const std::optional<TrialResult> result = m_session->takeResult();
    EXPECT_EQ(result->outcome, Outcome::correct);
    EXPECT_NEAR(*result->responseTime_s, 11.5, 1e-12);
}

TEST_F(SessionTest, countsPressesBeforeTheWindowAsEarly) {
    begin(smallProtocol("from_end"));
    press(0.5, 0);
    release(0);
    ASSERT_TRUE(m_session->startTrial(at(1.0)));
    press(1.001, 1);
    release(1);
    m_session->stimulusStarted(at(1.005));
    press(2.0, 2);
    release(2);
    m_session->stimulusEnded(at(3.005));
    press(4.0, right());
    const std::optional<TrialResult> result = m_session->takeResult();
    EXPECT_EQ(result->outcome, Outcome::correct);
    EXPECT_EQ(result->earlyPresses, 3U);
}

TEST_F(SessionTest, ignoresAKeyThatIsStillDownFromTheTrialBefore) {
    begin();
    show(1.0);
    press(2.0, 0);
    ASSERT_TRUE(m_session->takeResult());
    show(10.0);
    press(11.0, 0, true);
    press(11.1, 0);
    EXPECT_FALSE(m_session->takeResult());
    release(0);
    press(12.5, 0);
    const std::optional<TrialResult> result = m_session->takeResult();
    ASSERT_TRUE(result);
    EXPECT_NEAR(*result->responseTime_s, 2.5, 1e-12);
    EXPECT_EQ(result->earlyPresses, 0U);
}

TEST_F(SessionTest, aFaultOfTheDeviceShowsTheTrialAgainAtTheEnd) {
    begin();
    const std::size_t stimulus = right();
    ASSERT_TRUE(m_session->startTrial(0));
    m_session->stimulusStarted(at(0.005));
    m_session->deviceFailed(at(0.7));
    const std::optional<TrialResult> failed = m_session->takeResult();
    ASSERT_TRUE(failed);
    EXPECT_EQ(failed->outcome, Outcome::deviceError);
    EXPECT_EQ(failed->deviceFaults, 1U);
    EXPECT_FALSE(failed->responseTime_s);
    EXPECT_EQ(m_session->remainingTrials(), 6U);
    TrialResult last;
    for (int i = 0; i < 6; ++i) {
        show(10.0 + 20.0 * i);
        m_session->advance(at(10.0 + 20.0 * i + 15.0));
        last = m_session->takeResult().value();
    }
    EXPECT_EQ(last.planned.trial, 1U);
    EXPECT_EQ(last.planned.attempt, 2U);
    EXPECT_EQ(last.planned.stimulus, stimulus);
    EXPECT_EQ(last.trialInBlock, 7U);
    EXPECT_EQ(m_session->stage(), Stage::finished);
}

TEST_F(SessionTest, showsNoTrialBeforeTheLastResultIsTaken) {
    begin();
    show(1.0);
    press(2.0, 0);
    EXPECT_FALSE(m_session->startTrial(at(3.0)));
    ASSERT_TRUE(m_session->takeResult());
    EXPECT_TRUE(m_session->startTrial(at(3.0)));
}

TEST_F(SessionTest, replaysAsOftenAsTheProtocolAllows) {
    begin(smallProtocol("from_onset", "replays = 1"));
    show(1.0);
    EXPECT_TRUE(m_session->replay(at(4.0)));
    m_session->stimulusStarted(at(4.01));
    m_session->stimulusEnded(at(6.01));
    EXPECT_FALSE(m_session->replay(at(7.0)));
    press(7.01, right());
    const std::optional<TrialResult> result = m_session->takeResult();
    EXPECT_EQ(result->replays, 1U);
    EXPECT_NEAR(*result->responseTime_s, 3.0, 1e-12);
}

TEST_F(SessionTest, pausesBetweenTrialsOnly) {
    begin();
    EXPECT_TRUE(m_session->pause());
    EXPECT_FALSE(m_session->startTrial(0));
    m_session->goOn();
    ASSERT_TRUE(m_session->startTrial(0));
    EXPECT_FALSE(m_session->pause());
}

TEST_F(SessionTest, anAbortKeepsTheTrialAsAborted) {
    begin();
    show(1.0);
    m_session->abort(at(3.5));
    EXPECT_EQ(m_session->takeResult()->outcome, Outcome::aborted);
    EXPECT_EQ(m_session->stage(), Stage::aborted);
    EXPECT_FALSE(m_session->startTrial(at(4.0)));
}

TEST_F(SessionTest, practiceWaitsForTheFeedbackToBeSeen) {
    const Protocol protocol = smallProtocol();
    const PlannedSession plan = planSessions(protocol, 1, 0).front();
    auto session = Session::create(protocol, plan, {}, 0);
    ASSERT_TRUE(session);
    EXPECT_EQ(session->remainingTrials(), 9U);
    ASSERT_TRUE(session->startTrial(0));
    session->stimulusStarted(0);
    session->press({0, "touch", "1", kSecond_ns, false});
    EXPECT_EQ(session->stage(), Stage::feedback);
    ASSERT_TRUE(session->takeResult());
    EXPECT_FALSE(session->startTrial(2 * kSecond_ns));
    session->feedbackSeen();
    EXPECT_EQ(session->stage(), Stage::ready);
}

TEST_F(SessionTest, goesOnBehindWhatWasKept) {
    begin();
    std::vector<TrialResult> done;
    show(1.0);
    press(2.0, 0);
    release(0);
    done.push_back(m_session->takeResult().value());
    ASSERT_TRUE(m_session->startTrial(at(5.0)));
    m_session->deviceFailed(at(5.1));
    done.push_back(m_session->takeResult().value());
    std::vector<PlannedTrial> expected;
    for (int i = 0; i < 5; ++i) {
        show(10.0 + 20.0 * i);
        m_session->advance(at(10.0 + 20.0 * i + 15.0));
        expected.push_back(m_session->takeResult()->planned);
    }
    begin(smallProtocol(), done);
    for (const PlannedTrial& trial : expected) {
        ASSERT_NE(m_session->current(), nullptr);
        EXPECT_EQ(m_session->current()->trial, trial.trial);
        EXPECT_EQ(m_session->current()->attempt, trial.attempt);
        EXPECT_EQ(m_session->current()->stimulus, trial.stimulus);
        show(10.0 * static_cast<double>(trial.trial) + 1000.0);
        m_session->advance(std::numeric_limits<std::int64_t>::max());
        (void)m_session->takeResult();
    }
    EXPECT_EQ(m_session->stage(), Stage::finished);
}

TEST_F(SessionTest, refusesResultsOfAnotherPlan) {
    begin();
    show(1.0);
    press(2.0, 0);
    std::vector<TrialResult> done{m_session->takeResult().value()};
    done.front().planned.stimulus = (done.front().planned.stimulus + 1) % 3;
    const auto session = Session::create(smallProtocol(), m_plan, done, 0);
    ASSERT_FALSE(session);
    EXPECT_EQ(session.error().kind, core::ErrorKind::refused);
}

TEST_F(SessionTest, timesAnAnswerFromTheEndThatAShortStimulusWouldHaveHad) {
    begin();
    ASSERT_TRUE(m_session->startTrial(0));
    m_session->stimulusStarted(at(1.0), at(1.3));
    press(1.25, right());
    TrialResult result = m_session->takeResult().value();
    EXPECT_NEAR(result.responseTime_s.value(), 0.25, 1e-9);
    EXPECT_NEAR(result.responseTimeOffset_s.value(), -0.05, 1e-9);
    release(result.response.value());
    ASSERT_TRUE(m_session->startTrial(at(2.0)));
    m_session->stimulusStarted(at(3.0), at(3.3));
    m_session->stimulusEnded(at(3.3));
    press(3.35, right());
    EXPECT_NEAR(m_session->takeResult()->responseTimeOffset_s.value(), 0.05, 1e-9);
}

TEST_F(SessionTest, takesAPressByItsOwnTimeAlthoughTheOnsetIsKnownBefore) {
    begin();
    ASSERT_TRUE(m_session->startTrial(0));
    m_session->stimulusStarted(at(1.0));
    press(0.999, right());
    EXPECT_EQ(m_session->stage(), Stage::stimulus);
    release(right());
    press(1.0, right());
    const TrialResult result = m_session->takeResult().value();
    EXPECT_EQ(result.earlyPresses, 1U);
    EXPECT_EQ(result.responseTime_s, 0.0);
}

TEST_F(SessionTest, takesAPressByItsOwnTimeAlthoughTheEndIsKnownBefore) {
    Protocol protocol = smallProtocol();
    protocol.window = ResponseWindow::fromEnd;
    begin(protocol);
    show(1.0);
    press(2.9, right());
    EXPECT_EQ(m_session->stage(), Stage::answering);
    release(right());
    press(3.0, right());
    const TrialResult result = m_session->takeResult().value();
    EXPECT_EQ(result.earlyPresses, 1U);
    EXPECT_EQ(result.responseTimeOffset_s, 0.0);
}

} // namespace teleta::study
