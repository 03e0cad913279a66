// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/playback/pattern_program.h"

#include <algorithm>
#include <memory>

namespace teleta::playback {

Program programOf(const pattern::Pattern& pattern) {
    // A function object is copied, a pattern of an hour should not be.
    auto compiled = std::make_shared<const pattern::CompiledPattern>(pattern);
    const double duration_s = compiled->duration_s();
    return {[compiled = std::move(compiled)](double t_s) { return compiled->evaluate(t_s); }, duration_s};
}

double promptBegin_s(const Program& program, double rate_Hz) {
    const double second_s = 1.0 / rate_Hz;
    if (!program.evaluate || !(second_s < program.duration_s))
        return 0.0;
    const auto isOff = [&program](double t_s) {
        return std::ranges::none_of(program.evaluate(t_s), [](double intensity) { return intensity > 0.0; });
    };
    try {
        return isOff(0.0) && !isOff(second_s) ? second_s : 0.0;
    } catch (...) {
        return 0.0;
    }
}

DriveRanges rangesOf(const pattern::MotorProfiles& motors) {
    DriveRanges ranges{};
    for (std::size_t i = 0; i < ranges.size(); ++i)
        if (!motors[i].rangeAssumed)
            ranges[i] = {motors[i].startDrive, motors[i].fullDrive};
    return ranges;
}

} // namespace teleta::playback
