// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/recording/recording.h"

#include <QString>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace teleta::test {

/// All frames of a stream in one row.
struct Frames {
    std::vector<double> sourceTime_s;
    std::vector<std::byte> values;
};

/// Of a stream, from first to last.
inline Frames framesOf(const recording::Recording& recording, const std::string& name) {
    Frames all;
    for (std::size_t i = 0; i < recording.streams().size(); ++i) {
        if (recording.streams()[i].name != name)
            continue;
        recording::StreamReader reader = recording.reader(i);
        core::TappedFrames block;
        while (reader.next(block).value_or(false)) {
            all.sourceTime_s.insert(all.sourceTime_s.end(), block.sourceTime_s.begin(),
                                    block.sourceTime_s.end());
            all.values.insert(all.values.end(), block.values.begin(), block.values.end());
        }
    }
    return all;
}

/// Frames of the reference picture or tare that a recording has.
inline std::uint64_t referencesIn(const QString& path) {
    const auto recording = recording::Recording::open(path.toStdString());
    for (std::size_t i = 0; recording && i < recording->streams().size(); ++i)
        if (recording->streams()[i].name.ends_with("-reference"))
            return recording->extent(i).value().value_or(recording::Recording::Extent()).frames;
    return 0;
}

} // namespace teleta::test
