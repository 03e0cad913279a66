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

/// The servo runs that are compared: those that were watched, each from its start to a restart of its source,
/// and recorded ones. The newest kMost are kept, in the order in which they came. Thread: one.
class ServoRuns {
public:
    static constexpr std::size_t kMost = figure::kSvgSeries;
    /// A run with more entries keeps every second one, and takes every second step from then on.
    static constexpr std::size_t kLongest = 20000;
    /// A longer time without a step is a gap in the curves.
    static constexpr double kGap_s = 0.5;

    /// The steps that come now are of this source. source: tells apart those of the same name.
    void setSource(std::string name, const void* source);
    /// Begins a run when the source was restarted or its time went back.
    void add(const ServoStep& step);
    void addRecorded(ServoCurves run);
    /// Keeps the run that goes on.
    void forgetOthers();

    [[nodiscard]] std::span<const ServoCurves> runs() const { return m_curves; }
    /// The runs as a table, C locale: run, time_s and the columns of servo.csv that are drawn; NA: not
    /// defined.
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
        std::size_t passed = 0; ///< steps since the last one that was taken
    };

    void push(Origin origin, ServoCurves curves);
    [[nodiscard]] bool goesOn(const ServoStep& step) const;

    std::string m_name;
    const void* m_source = nullptr;
    std::vector<ServoCurves> m_curves;
    std::vector<Origin> m_origins; ///< of each
    std::size_t m_current = 0;     ///< where the steps go; none when it is no index
};

} // namespace teleta::servo
