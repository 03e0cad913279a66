// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/files/foreign_formats.h"
#include "backend/pattern/files/pattern_file.h"
#include "backend/pattern/model/bake.h"

#include <QString>

#include <algorithm>
#include <cmath>

namespace teleta::pattern {

namespace {

/// Counts the corners that are not at a whole millisecond.
void countRounded(const Tracks& tracks, LossCounter& losses) {
    for (const Track& track : tracks) {
        for (const Breakpoint& point : track) {
            const double ms = 1000.0 * point.time_s;
            if (std::abs(ms - std::round(ms)) > 1e-6)
                losses.add(LossKind::rounding, point.time_s);
        }
    }
}

/// A piece is written with the value in its middle, so a slope is off by half the rise over a piece.
void countSteps(const Tracks& tracks, LossCounter& losses) {
    std::size_t slopes = 0;
    double largest = 0.0;
    for (const Track& track : tracks) {
        for (std::size_t k = 1; k < track.size(); ++k) {
            const double length_ms = 1000.0 * (track[k].time_s - track[k - 1].time_s);
            const double rise = std::abs(track[k].intensity - track[k - 1].intensity);
            if (rise == 0.0 || length_ms <= 0.0)
                continue;
            ++slopes;
            largest = std::max(largest, 0.5 * rise * std::min(1.0, kTactPiece_ms / length_ms));
        }
    }
    if (slopes > 0)
        losses.note(LossKind::steps, slopes, QString::number(largest, 'f', 3).toStdString());
}

} // namespace

core::Expected<std::vector<Loss>> exportLosses(const Pattern& pattern, PatternFormat format) {
    LossCounter losses;
    if (format == PatternFormat::own || !isReadable(format))
        return losses.take();
    TELETA_TRY(const Tracks tracks, linearised(pattern));
    losses.add(LossKind::objects, {}, pattern.objects.size());
    if (format == PatternFormat::hjif || format == PatternFormat::tact)
        countRounded(tracks, losses);
    if (format == PatternFormat::tact)
        countSteps(tracks, losses);
    return losses.take();
}

} // namespace teleta::pattern
