// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pipeline/touch/found_objects.h"
#include "backend/pipeline/touch/touch_record.h"

#include <cstdint>
#include <vector>

namespace teleta::pipeline {

/// The touches of a recording, each once however often its part is played. A touch is the same as an earlier
/// one when their times in the recording overlap. Thread: one.
class TouchHistory {
public:
    /// A touch that began this much earlier was heard from its beginning; the one before it was cut off by a
    /// jump.
    static constexpr double kCutOff_s = 0.05;

    enum class Kind {
        first,  ///< it was not known
        again,  ///< it was known as well or better
        better, ///< it was known, but cut off, or evaluated with other settings
    };

    /// Numbers the touch from 1 in the order in which touches were heard; one that was known keeps its
    /// number. One that is heard again gets what is known of it, with the steady times of now.
    Kind add(TouchRecord& touch);
    /// The next new touch is of another object, wherever it is.
    void closeObject() { m_closed = true; }
    /// What is known was evaluated with other settings; touches that are heard from now on replace it.
    void settingsChanged() { ++m_settings; }
    void clear() { *this = TouchHistory(); }

    /// The objects that these touches outline, made anew.
    void fill(FoundObjects& objects) const;

private:
    struct Heard {
        TouchRecord record;
        bool ofAnotherObject = false;
        std::uint64_t settings = 0;
    };

    std::vector<Heard> m_heard;
    bool m_closed = false;
    std::uint64_t m_settings = 0;
};

} // namespace teleta::pipeline
