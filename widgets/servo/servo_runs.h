// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/figure/svg_canvas.h"
#include "backend/servo_figure/servo_curves.h"

#include <QString>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace teleta::servo {

/// The servo runs that are compared: live ones, each from its start to a restart of its source, and recorded
/// ones. The newest kMost are kept in order of arrival. Thread: one.
class ServoRuns {
public:
    static constexpr std::size_t kMost = figure::kSvgSeries;
    /// Above this number of entries a run keeps every second one, and from then on takes every second step.
    static constexpr std::size_t kLongest = 20000;
    /// A longer time without a step becomes a gap in the curves.
    static constexpr double kGap_s = 0.5;

    /// Sets the source of the following steps. source: distinguishes sources of the same name.
    void setSource(std::string name, const void* source);
    /// Adds a step; starts a new run when the source was restarted or its time went back.
    void add(const ServoStep& step);
    void addRecorded(servo_figure::ServoCurves run);
    /// Keeps only the current run.
    void forgetOthers();

    [[nodiscard]] std::span<const servo_figure::ServoCurves> runs() const { return m_curves; }
    /// The runs as CSV in the C locale: run, time_s and the drawn columns of servo.csv; NA: undefined.
    [[nodiscard]] QString csv() const;

private:
    struct Origin {
        const void* source = nullptr; ///< null: a recording
        std::uint64_t run = 0;
        std::string name;
        int number = 1; ///< among the runs of this name
        bool balanced = false;
        bool unbalanced = false;
        std::size_t stride = 1;
        std::size_t passed = 0; ///< number of steps since the last one taken
    };

    void push(Origin origin, servo_figure::ServoCurves curves);
    [[nodiscard]] bool goesOn(const ServoStep& step) const;

    std::string m_name;
    const void* m_source = nullptr;
    std::vector<servo_figure::ServoCurves> m_curves;
    std::vector<Origin> m_origins; ///< of each
    std::size_t m_current = 0;     ///< index of the run to which steps are added; not an index: none
};

} // namespace teleta::servo
