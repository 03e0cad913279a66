// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace teleta::study {

/// What a trial asks.
enum class Design {
    identification, ///< which of several patterns was it?
    yesNo,          ///< was there anything?
    interval,       ///< in which of two to four intervals was it?
    sameDifferent,  ///< were the two intervals the same?
    compare,        ///< which of two intervals had more?
};

/// What a level sets.
enum class Vary {
    intensity, ///< factor of all intensities, 0..1
    onset,     ///< onset_s of the only sweep
    burst,     ///< burst_s of the only sweep or ring, or the width of the only pulse train
    duration,  ///< duration_s of the only ring, phantom, ramp or pulse train
    balance,   ///< of the only phantom, 0..1
};

/// Words of the files: identification, yes_no, interval, same_different, compare.
[[nodiscard]] const char* toString(Design design);
/// intensity, onset_s, burst_s, duration_s, balance.
[[nodiscard]] const char* toString(Vary vary);
/// Unit of a level in tables: drive, s, balance.
[[nodiscard]] const char* unitOf(Vary vary);

/// What a task of any design but identification asks about.
struct LevelTask {
    Vary vary = Vary::intensity;
    double reference = 0.0; ///< level to compare with; 0: nothing, or a time or balance of 0
    std::string procedure;  ///< how levels are chosen, as in files
};

} // namespace teleta::study
