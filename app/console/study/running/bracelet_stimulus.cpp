// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/study/running/bracelet_stimulus.h"

#include "backend/core/steady_time.h"
#include "backend/playback/pattern_program.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::console {

namespace {

struct StimulusText {
    Q_DECLARE_TR_FUNCTIONS(StimulusText)
};

/// A player that has not started after this time hangs.
constexpr std::int64_t kLongestWait_ns = 500'000'000;

QString words(const playback::PlayerStatus& status) {
    switch (status.ending) {
    case playback::PlayerEnding::stopSwitch:
        return StimulusText::tr("STOP was pressed");
    case playback::PlayerEnding::deviceLost:
        return StimulusText::tr("the bracelet was lost");
    case playback::PlayerEnding::stalled:
        return StimulusText::tr("playback stalled for too long");
    case playback::PlayerEnding::sourceFailed:
        return StimulusText::tr("the pattern could not be played: %1")
            .arg(QString::fromStdString(status.message));
    case playback::PlayerEnding::stopped:
        return StimulusText::tr("something else stopped the bracelet");
    case playback::PlayerEnding::tooHot:
        return StimulusText::tr("the bracelet is too hot");
    case playback::PlayerEnding::none:
    case playback::PlayerEnding::finished:
        break;
    }
    return {};
}

/// A successful write does not prove that anything is felt.
std::int64_t onsetOf(BraceletSession& session, OnsetFrame onset) {
    const playback::PlayerCounters counters = session.player().counters();
    const std::int64_t written_ns = onset == OnsetFrame::any ? counters.firstFrame_ns : counters.onset_ns;
    return counters.confirmed && written_ns != 0 ? session.source().description().feltAt_ns(written_ns) : 0;
}

} // namespace

QString BraceletStimulus::obstacle() const {
    return m_station.isAnswering() ? QString() : m_station.note();
}

QString BraceletStimulus::description() const {
    const auto& session = m_station.session();
    if (!session)
        return m_station.note();
    const core::BraceletDescription& bracelet = session->source().description();
    const QString name = QString::fromStdString(bracelet.name);
    if (!m_station.isAnswering())
        return m_station.note();
    const playback::PlayerCounters counters = session->player().counters();
    if (counters.framesWritten == 0)
        return StimulusText::tr("%1, ready", "bracelet").arg(name);
    return StimulusText::tr("%1, ready; last stimulus: %2 frames, longest write %3 ms, %4 late, %5 lost",
                            "bracelet")
        .arg(name)
        .arg(counters.framesWritten)
        .arg(static_cast<double>(counters.writeLongest_ns) * 1e-6, 0, 'f', 2)
        .arg(counters.deadlineMisses)
        .arg(counters.framesLost);
}

void BraceletStimulus::begin(const pattern::Pattern& pattern, double atMost_s, OnsetFrame onset,
                             std::int64_t now_ns) {
    m_onset = onset;
    const std::shared_ptr<BraceletSession>& session = m_station.session();
    m_session = session;
    m_request_ns = now_ns;
    if (!session)
        return;
    playback::Program program = playback::programOf(pattern);
    program.duration_s = std::min(program.duration_s, atMost_s);
    session->player().play(std::move(program));
}

void BraceletStimulus::stop() {
    if (BraceletSession* const begun = session())
        begun->player().stop();
}

BraceletSession* BraceletStimulus::session() const {
    const std::shared_ptr<BraceletSession>& now = m_station.session();
    // Not by lock(), which could make this thread the last owner.
    const bool isSame = !m_session.owner_before(now) && !now.owner_before(m_session);
    return isSame ? now.get() : nullptr;
}

StimulusState BraceletStimulus::state(std::int64_t now_ns) const {
    StimulusState state;
    BraceletSession* const begun = session();
    if (begun == nullptr) {
        state.failure = StimulusText::tr("the bracelet was lost");
        return state;
    }
    const playback::PlayerStatus status = begun->player().status();
    if (status.begun_ns < m_request_ns) {
        if (m_stop.engaged())
            state.failure = StimulusText::tr("STOP was pressed");
        else if (now_ns - m_request_ns > kLongestWait_ns)
            state.failure = StimulusText::tr("the bracelet did not start");
        return state;
    }
    const playback::PlayerCounters counters = begun->player().counters();
    state.onset_ns = onsetOf(*begun, m_onset);
    const core::BraceletDescription& bracelet = begun->source().description();
    state.due_ns = bracelet.feltAt_ns(status.begun_ns + std::llround(1e9 * status.duration_s));
    state.frameWrite_ms = static_cast<double>(counters.writeLongest_ns) * 1e-6;
    state.framesMissed = counters.deadlineMisses + counters.framesLost;
    if (std::isfinite(bracelet.latencySpread_s))
        state.latencySpread_ms = 1e3 * bracelet.latencySpread_s;
    if (!m_stop.engaged() && m_station.isReady() && !m_station.isAnswering()) {
        state.failure = m_station.isTooHot() ? StimulusText::tr("the bracelet is too hot")
                                             : StimulusText::tr("the bracelet does not answer");
        return state;
    }
    const bool isPlaying = status.mode == playback::PlayerMode::program;
    if (counters.framesRefused > 0 && (isPlaying || status.ending == playback::PlayerEnding::finished)) {
        state.failure = StimulusText::tr("the bracelet rejected the stimulus");
        return state;
    }
    if (isPlaying)
        return state;
    if (status.ending == playback::PlayerEnding::finished && !counters.confirmed) {
        state.failure = StimulusText::tr("the bracelet did not confirm the stimulus");
        return state;
    }
    if (status.ending == playback::PlayerEnding::finished) {
        state.end_ns = bracelet.feltAt_ns(status.ended_ns);
        // The onset of a pattern that is always off is its start.
        if (state.onset_ns == 0)
            state.onset_ns = bracelet.feltAt_ns(status.begun_ns);
    } else {
        state.failure = words(status);
        if (state.failure.isEmpty())
            state.failure = StimulusText::tr("something else used the bracelet");
    }
    return state;
}

std::function<std::int64_t()> BraceletStimulus::onset() const {
    const std::shared_ptr<BraceletSession>& open = m_station.session();
    if (session() == nullptr)
        return [] { return std::int64_t{0}; };
    return [playing = open, request_ns = m_request_ns, onset = m_onset]() -> std::int64_t {
        if (playing->player().status().begun_ns < request_ns)
            return 0;
        // Told when it has come.
        const std::int64_t onset_ns = onsetOf(*playing, onset);
        return onset_ns <= core::steadyNow_ns() ? onset_ns : 0;
    };
}

std::function<std::int64_t()> UnplayedStimulus::onset() const {
    return [onset_ns = m_onset_ns] { return onset_ns; };
}

QString UnplayedStimulus::description() const {
    return StimulusText::tr("No bracelet: this rehearsal is too fast to be played");
}

void UnplayedStimulus::begin(const pattern::Pattern& pattern, double atMost_s, OnsetFrame /*onset*/,
                             std::int64_t now_ns) {
    m_onset_ns = now_ns;
    m_end_ns = now_ns + std::llround(1e9 * std::min(pattern.duration_s, atMost_s));
}

StimulusState UnplayedStimulus::state(std::int64_t now_ns) const {
    return {.onset_ns = m_onset_ns,
            .due_ns = m_end_ns,
            .end_ns = m_end_ns != 0 && now_ns >= m_end_ns ? m_end_ns : 0};
}

} // namespace teleta::console
