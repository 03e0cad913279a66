// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/study/running/study_runner.h"
#include "backend/study/protocol/protocol.h"
#include "tests/app/console/study/running_session.h"
#include "widgets/study/participant/answer_button.h"
#include "widgets/study/participant/participant_window.h"

#include <QDateTime>
#include <QTest>

#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace teleta::test {

using console::StimulusState;
using console::StudyRunner;
using study::Hold;
using study::Outcome;
using study::ParticipantWindow;
using study::Phase;
using study::Stage;

inline constexpr std::int64_t kMs = 1'000'000;
inline constexpr std::int64_t kS = 1'000'000'000;

/// A bracelet that does what the test says.
class ScriptedStimulus : public console::StimulusOutput {
public:
    QString obstacle() const override { return m_obstacle; }
    QString description() const override { return QStringLiteral("scripted"); }
    bool isSimulated() const override { return true; }
    void begin(const pattern::Pattern& pattern, double atMost_s, console::OnsetFrame onset,
               std::int64_t) override {
        m_begun.push_back(pattern.id);
        m_last = pattern;
        m_atMost_s = atMost_s;
        m_onset = onset;
        m_state = {};
    }
    void stop() override { ++m_stops; }
    StimulusState state(std::int64_t) const override { return m_state; }
    std::function<std::int64_t()> onset() const override {
        return [this] { return m_state.onset_ns; };
    }

    QString m_obstacle;
    StimulusState m_state;
    std::vector<std::string> m_begun;
    pattern::Pattern m_last; ///< that was begun
    double m_atMost_s = 0.0;
    console::OnsetFrame m_onset = console::OnsetFrame::notZero;
    int m_stops = 0;
};

inline study::Protocol protocol(const char* extra = "") {
    const std::string text = std::string(R"(name = "short"
stimulus_s = 2.0
response_limit_s = 10.0
response_window = "from_onset"
order = "full_random"
)") + extra + R"(
[practice]
repetitions = 1
feedback = true
diagram = true
[test]
repetitions = 2
[masking_noise]
colour = "none"
[[task]]
id = "shape"
condition = [{ id = "static" }]
pattern = [{ letter = "A", name = "circle" }, { letter = "B", name = "rectangle" }]
)";
    auto parsed = study::parseProtocol(text, "test");
    if (!parsed)
        qFatal("%s", core::describe(parsed.error()).c_str());
    return *parsed;
}

/// One session driven by a participant's keys, with a clock and a device of the test.
class StudyRunnerBench {
protected:
    std::int64_t m_now = 100 * kS;
    core::StopSwitch m_stop;
    std::unique_ptr<ScriptedStimulus> m_device;
    std::unique_ptr<StudyRunner> m_runner;
    std::unique_ptr<ParticipantWindow> m_window;
    study::Protocol m_protocol;
    study::StimulusSet m_stimuli;
    study::PlannedSession m_plan;
    QDateTime m_utc{QDate(2026, 11, 3), QTime(14, 22, 33), Qt::UTC};
    std::vector<study::TrialResult> m_kept;
    std::vector<QDateTime> m_times;          ///< with which results were to be kept, in vain too
    std::deque<StudyRunner::Kept> m_waiting; ///< results that are being kept, when m_slowDisk
    bool m_slowDisk = false;
    bool m_fullDisk = false;
    core::ErrorKind m_failure = core::ErrorKind::ioFailed; ///< of the full disk

    void make(const char* extra = "") {
        m_stop.release();
        m_slowDisk = m_fullDisk = false;
        m_failure = core::ErrorKind::ioFailed;
        m_kept.clear();
        m_times.clear();
        m_waiting.clear();
        m_device = std::make_unique<ScriptedStimulus>();
        m_protocol = protocol(extra);
        m_stimuli = study::StimulusSet::of(m_protocol, {}, "test").value();
        m_plan = study::planSessions(m_protocol, 1, 0).front();
        m_runner = std::make_unique<StudyRunner>(
            m_stop, [this] { return m_now; }, [this] { return m_utc; },
            [this](const study::TrialResult& result, const QDateTime& ended, StudyRunner::Kept kept) {
                m_times.push_back(ended);
                if (m_fullDisk) {
                    kept(core::Unexpected(core::Error{m_failure, "disk full", {}, {}}));
                    return;
                }
                m_kept.push_back(result);
                if (m_slowDisk)
                    m_waiting.push_back(std::move(kept));
                else
                    kept({});
            });
        m_window = std::make_unique<ParticipantWindow>([this] { return m_now; });
        m_window->setChoices({{"A", "circle", {}}, {"B", "rectangle", {}}});
        QObject::connect(m_window.get(), &ParticipantWindow::nextRequested, m_runner.get(),
                         &StudyRunner::next);
        QObject::connect(m_window.get(), &ParticipantWindow::replayRequested, m_runner.get(),
                         &StudyRunner::replay);
        QObject::connect(m_window.get(), &ParticipantWindow::pressed, m_runner.get(), &StudyRunner::press);
        QObject::connect(m_window.get(), &ParticipantWindow::released, m_runner.get(),
                         [this](const QString& device, const QString& key) {
                             m_runner->release(device.toStdString(), key.toStdString());
                         });
        m_window->show();
        begin();
    }
    void begin(const std::vector<study::TrialResult>& kept = {}) {
        const auto begun = m_runner->begin(*m_device, m_protocol, m_stimuli, m_plan, kept, m_now);
        QVERIFY2(begun.has_value(), begun ? "" : core::describe(begun.error()).c_str());
    }

    const study::Session& session() { return sessionOf(*m_runner); }
    const study::PlannedTrial& current() { return trialOf(*m_runner); }
    Stage stage() { return session().stage(); }
    void pass(std::int64_t time_ns) { m_now += time_ns; }
    void space() { QTest::keyClick(m_window.get(), Qt::Key_Space); }
    void digit(std::size_t number) {
        QTest::keyClick(m_window.get(), static_cast<Qt::Key>(Qt::Key_0 + static_cast<int>(number)));
    }
    /// Asks for the next trial, whose stimulus begins 8 ms later.
    void startTrial() {
        space();
        QCOMPARE(stage(), Stage::starting);
        pass(8 * kMs);
        m_device->m_state.onset_ns = m_now;
        m_runner->poll();
        QCOMPARE(stage(), Stage::stimulus);
    }
    void endStimulus() {
        pass(2 * kS);
        m_device->m_state.end_ns = m_now;
        m_runner->poll();
        QCOMPARE(stage(), Stage::answering);
    }
    std::size_t presented() { return current().stimulus; }
    void doTrial() {
        startTrial();
        endStimulus();
        const std::size_t answer = presented() + 1;
        pass(700 * kMs);
        digit(answer);
    }
    void finishPractice() {
        doTrial();
        doTrial();
        space();
        QCOMPARE(m_runner->hold(), Hold::blockEnd);
        m_runner->goOn();
    }

    void tearDown() {
        m_window.reset();
        m_runner.reset();
    }
};

} // namespace teleta::test
