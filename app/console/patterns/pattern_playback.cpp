// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/patterns/pattern_playback.h"

#include "backend/core/steady_time.h"
#include "widgets/pattern/document/pattern_document.h"
#include "widgets/pattern/pattern_editor.h"
#include "widgets/pattern/timeline/timeline_view.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace teleta::console {

namespace {

constexpr int kFollowRest_ms = 50;
constexpr double kNsPerS = 1e9;

} // namespace

PatternPlayback::PatternPlayback(BraceletService& station, pattern::PatternEditor& editor, QObject* parent)
    : QObject(parent)
    , m_station(station)
    , m_editor(editor) {
    m_rest.setSingleShot(true);
    m_rest.setInterval(kFollowRest_ms);
    connect(&m_rest, &QTimer::timeout, this, [this] {
        if (std::exchange(m_changed, false))
            followSoon();
    });
    using pattern::PatternEditor;
    connect(&m_editor, &PatternEditor::playRequested, this, &PatternPlayback::play);
    connect(&m_editor, &PatternEditor::stopRequested, this, &PatternPlayback::stop);
    connect(&m_editor, &PatternEditor::playheadMoved, this, &PatternPlayback::moveTo);
    connect(&m_editor, &PatternEditor::loopingChanged, this, &PatternPlayback::followSoon);
    connect(m_editor.document(), &pattern::PatternDocument::patternChanged, this,
            &PatternPlayback::followSoon);
    connect(&m_station, &BraceletService::sessionChanged, this, [this] {
        if (m_way == Way::felt)
            end();
    });
}

pattern::Span PatternPlayback::range() const {
    const auto& loop = m_editor.timeline()->loop();
    const double duration_s = m_editor.document()->pattern().duration_s;
    return m_editor.looping() && loop ? *loop : pattern::Span{0.0, duration_s};
}

playback::Program PatternPlayback::program(const pattern::Span& range) const {
    auto compiled = std::make_shared<const pattern::CompiledPattern>(m_editor.document()->compiled());
    return {[compiled = std::move(compiled), begin_s = range.begin_s](double t_s) {
                return compiled->evaluate(begin_s + t_s);
            },
            range.end_s - range.begin_s};
}

void PatternPlayback::play() {
    m_range = range();
    double from_s = m_editor.timeline()->playhead_s();
    if (!(from_s >= m_range.begin_s && from_s < m_range.end_s))
        from_s = m_range.begin_s;
    if (m_station.isFree()) {
        m_way = Way::felt;
        m_number = m_station.play(program(m_range), m_editor.looping(), from_s - m_range.begin_s);
    } else {
        m_way = Way::shown;
        moveTo(from_s);
    }
    m_editor.setPlaying(true);
}

void PatternPlayback::stop() {
    // Also stops what others play: whoever presses Stop wants the bracelet to be still.
    m_station.stopPlaying();
    end();
}

void PatternPlayback::end() {
    m_way = Way::none;
    m_editor.setPlaying(false);
}

void PatternPlayback::moveTo(double time_s) {
    if (m_way == Way::felt && m_station.isPlaying(m_number))
        m_station.seek(time_s - m_range.begin_s);
    m_begun_ns =
        core::steadyNow_ns() - static_cast<std::int64_t>(std::llround((time_s - m_range.begin_s) * kNsPerS));
}

void PatternPlayback::followSoon() {
    if (m_way == Way::none)
        return;
    if (m_rest.isActive()) {
        m_changed = true;
        return;
    }
    follow();
    m_rest.start();
}

void PatternPlayback::follow() {
    const pattern::Span now = range();
    const double shift_s = m_range.begin_s - now.begin_s;
    m_begun_ns -= static_cast<std::int64_t>(std::llround(shift_s * kNsPerS));
    m_range = now;
    if (m_way != Way::felt)
        return;
    m_station.change(m_number, program(now), shift_s);
    if (m_station.isPlaying(m_number))
        m_station.setLoop(m_editor.looping());
}

double PatternPlayback::shownAt_s() const {
    return static_cast<double>(core::steadyNow_ns() - m_begun_ns) / kNsPerS;
}

void PatternPlayback::tick() {
    if (m_way == Way::felt) {
        if (!m_station.isPlaying(m_number))
            end();
        else if (const auto position_s = m_station.playingPosition_s())
            m_editor.setPlayhead(m_range.begin_s + *position_s);
    } else if (m_way == Way::shown && m_station.isStopped()) {
        end();
    } else if (m_way == Way::shown) {
        const double length_s = m_range.end_s - m_range.begin_s;
        const double position_s = shownAt_s();
        if (position_s < length_s) {
            m_editor.setPlayhead(m_range.begin_s + std::max(position_s, 0.0));
        } else if (m_editor.looping() && length_s > 0.0) {
            moveTo(m_range.begin_s + std::fmod(position_s, length_s));
            m_editor.setPlayhead(m_range.begin_s + shownAt_s());
        } else {
            m_editor.setPlayhead(m_range.end_s);
            end();
        }
    }
}

core::Intensities PatternPlayback::intensities() const {
    return m_station.isDriven() ? m_station.given()
                                : m_editor.document()->compiled().evaluate(m_editor.timeline()->playhead_s());
}

QString PatternPlayback::note() const {
    const QString note = m_station.note();
    if (m_way != Way::shown)
        return note;
    const QString shown = tr("The pattern is shown on the screen but not felt.");
    return note.isEmpty() ? shown : shown + QLatin1Char(' ') + note;
}

} // namespace teleta::console
