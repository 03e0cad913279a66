// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contour/shape_recogniser.h"
#include "backend/core/threads/bounded_queue.h"
#include "backend/core/threads/latest_copy.h"
#include "backend/pattern/model/pattern_map.h"
#include "backend/pipeline/touch/touch_record.h"
#include "backend/playback/player_types.h"
#include "backend/stiffness/material.h"

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace teleta::pipeline {

/// What a touch tells on the bracelet.
enum class FeedbackMode { off, stiffness, shape, both };

/// One thing that was recognised, and the pattern that was sent for it.
struct FeedbackSent {
    std::uint64_t touch = 0; ///< TouchRecord::number
    std::optional<stiffness::Material> material;
    std::optional<contour::Shape> shape;
    bool unknownStiffness = false; ///< the touch has a stiffness that is not reliable: no material is told
    std::string patternId;         ///< empty: the map has none for it, nothing was sent
    bool missing = false;          ///< the map has this id, but there is no such pattern: nothing was sent
    bool refused = false;     ///< there is no bracelet, or it is used for something else: nothing was sent
    std::int64_t felt_ns = 0; ///< steady time of the sample that completed the touch
    /// When it came from another computer, which read it; 0: it was read by this one.
    std::int64_t arrived_ns = 0;
    std::int64_t sent_ns = 0; ///< steady time at which it was evaluated and the pattern handed over
};

/// Turns what was recognised into patterns on the bracelet: the material of every touch that has a stiffness,
/// and the shape whenever it becomes another one with a confidence of at least kLeastConfidence. Both at one
/// touch are played one after the other, kPause_s apart. Thread: onTouch() and onContour() by the pipeline's,
/// popSent() and settings by one viewer (the GUI's).
class TactileFeedback {
public:
    static constexpr double kLeastConfidence = 0.9;
    static constexpr double kPause_s = 0.3;
    static constexpr std::size_t kSentKept = 256;

    /// Hands a program to the player; returns at once. False: there is none that takes it.
    using Play = std::function<bool(playback::Program)>;
    /// Pattern of an id, ready to be played; without evaluate when there is none.
    using Library = std::function<playback::Program(const std::string& id)>;

    explicit TactileFeedback(Play play);

    /// Looks the patterns of the map up. An id that the library does not know plays nothing, and is told as
    /// missing.
    void setMap(const pattern::PatternMap& map, const Library& library);
    void setMode(FeedbackMode mode);

    /// As soon as a touch is evaluated.
    void onTouch(const TouchRecord& record);
    /// When the same touch has been added to the contour, which takes its time.
    void onContour(const TouchRecord& record, const ExploredContour& contour);

    /// Takes the oldest message that the viewer has not seen.
    bool popSent(FeedbackSent& sent) { return m_sent.pop(sent); }

private:
    struct Entry {
        std::string id;
        playback::Program program; ///< without evaluate: nothing is played
    };
    struct Settings {
        FeedbackMode mode = FeedbackMode::both;
        std::array<Entry, pattern::kStiffnessLevels> stiffness;
        Entry unknownStiffness;
        std::array<Entry, pattern::kRecognisedShapes.size()> shape;
    };

    [[nodiscard]] std::optional<contour::Shape> newShape(const ExploredContour& contour);
    /// Null when the stiffness of this touch is not to be told.
    [[nodiscard]] static const Entry* ofStiffness(const Settings& settings, const TouchRecord& record);
    /// taken: whether the player took the entry's program.
    [[nodiscard]] static FeedbackSent messageOf(const TouchRecord& record, const Entry& entry, bool taken);

    Play m_play;
    core::LatestCopy<std::shared_ptr<const Settings>> m_settings;
    std::optional<contour::Shape> m_lastShape;
    core::BoundedQueue<FeedbackSent> m_sent{kSentKept};
};

} // namespace teleta::pipeline
