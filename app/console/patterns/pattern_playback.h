// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/bracelet/bracelet_service.h"
#include "backend/pattern/model/pattern.h"

#include <QObject>
#include <QString>
#include <QTimer>

#include <cstdint>

namespace teleta::pattern {
class PatternEditor;
}

namespace teleta::console {

/// Plays the pattern of an editor on the bracelet or, without a bracelet, on the screen only. Edits, looping
/// and its range take effect while playing, at most every 50 ms. Patterns that others play on the bracelet do
/// not move the editor's playhead. Thread: GUI.
class PatternPlayback : public QObject {
    Q_OBJECT

public:
    /// station and editor: must outlive this object.
    PatternPlayback(BraceletService& station, pattern::PatternEditor& editor, QObject* parent = nullptr);

    void play();
    void stop();
    /// Moves the playhead.
    void tick();

    /// Current intensities of the tactors; while nothing plays, those of the pattern at the playhead.
    [[nodiscard]] core::Intensities intensities() const;
    /// Note about the bracelet, for example that the pattern is only shown.
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

    BraceletService& m_station;
    pattern::PatternEditor& m_editor;
    QTimer m_rest;          ///< delay after an update
    bool m_changed = false; ///< since the last update
    Way m_way = Way::none;
    std::uint64_t m_number = 0;  ///< number of the program while it plays on the bracelet
    pattern::Span m_range;       ///< played range of the pattern
    std::int64_t m_begun_ns = 0; ///< steady time at which the shown pattern was at the begin of its range
};

} // namespace teleta::console
