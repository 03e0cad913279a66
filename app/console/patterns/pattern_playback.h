// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/bracelet/bracelet_station.h"
#include "backend/pattern/model/pattern.h"

#include <QObject>
#include <QString>
#include <QTimer>

#include <cstdint>

namespace teleta::editor {
class PatternEditor;
}

namespace teleta::console {

/// Plays what an editor shows: on the bracelet, or, where there is none to feel it on, only on the screen.
/// Edits, the loop and its range reach what is played while it plays, at most every 50 ms.
/// What others play on the bracelet does not move the editor's playhead. Thread: GUI.
class PatternPlayback : public QObject {
    Q_OBJECT

public:
    /// Both outlive it.
    PatternPlayback(BraceletStation& station, editor::PatternEditor& editor, QObject* parent = nullptr);

    void play();
    void stop();
    /// Moves the playhead.
    void tick();

    /// What the tactors do; of a bracelet that does nothing, what the pattern does at the playhead.
    [[nodiscard]] core::Intensities intensities() const;
    /// What there is to know of the bracelet, and that nothing is felt of what plays.
    [[nodiscard]] QString note() const;

private:
    enum class Way {
        none,
        felt, ///< on the bracelet
        shown ///< on the screen only
    };

    [[nodiscard]] pattern::Span range() const;
    [[nodiscard]] playback::Program program(const pattern::Span& range) const;
    [[nodiscard]] double shownAt_s() const;
    void moveTo(double time_s);
    void follow();
    void followSoon();
    void end();

    BraceletStation& m_station;
    editor::PatternEditor& m_editor;
    QTimer m_rest;          ///< after what was followed
    bool m_changed = false; ///< since then
    Way m_way = Way::none;
    std::uint64_t m_number = 0;  ///< of the program, while it is felt
    pattern::Span m_range;       ///< of the pattern that plays
    std::int64_t m_begun_ns = 0; ///< steady time at which what is shown was at the begin of its range
};

} // namespace teleta::console
