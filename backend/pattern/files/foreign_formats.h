// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/pattern/files/zip_archive.h"
#include "backend/pattern/model/pattern.h"

#include <cstddef>
#include <string>
#include <vector>

namespace teleta::pattern {

/// Writes the text of one tactor's file.
using TactorText = core::Expected<std::string> (*)(const Pattern& pattern, std::size_t tactor);

/// The files "tactor1" + ending ... "tactor6" + ending, for an archive. Error: that of text. Thread: any
/// (pure).
[[nodiscard]] core::Expected<std::vector<ZipEntry>> tactorFiles(const Pattern& pattern,
                                                                const std::string& ending, TactorText text);

inline constexpr std::size_t kMostCurvePoints = 16;
inline constexpr double kLongestEvent_s = 30.0;

/// Converts one tactor to AHAP: continuous events of at most kLongestEvent_s while it is on, and curves of
/// the intensity (the square root of the amplitude) with at most kMostCurvePoints points, whose times count
/// from the start of the curve. Error: refused when objects have too many corners. Thread: any (pure).
[[nodiscard]] core::Expected<std::string> tactorToAhap(const Pattern& pattern, std::size_t tactor);

/// "tactor1.ahap" ... "tactor6.ahap".
[[nodiscard]] core::Expected<std::vector<ZipEntry>> patternToAhaps(const Pattern& pattern);

/// The format .haptic 1.0: JSON with one amplitude envelope, hence one file per tactor. The frequency of
/// these motors follows the amplitude; its envelope is written equal to it and ignored when read. An emphasis
/// becomes a burst of kEmphasis_s. Thread: any (pure).
inline constexpr double kEmphasis_s = 0.05;

/// The file of one tactor. Error: refused when objects have too many corners.
[[nodiscard]] core::Expected<std::string> tactorToHaptic(const Pattern& pattern, std::size_t tactor);

/// "tactor1.haptic" ... "tactor6.haptic".
[[nodiscard]] core::Expected<std::vector<ZipEntry>> patternToHaptics(const Pattern& pattern);

/// The tactor of an entry is the number 1..6 at the end of its base name. file: name of the archive, for
/// errors. Error: badInput with entry, line and column.
[[nodiscard]] core::Expected<Pattern> patternFromHaptics(std::vector<ZipEntry> entries,
                                                         const std::string& file);

/// Reads a single file as the pattern of the first tactor.
[[nodiscard]] core::Expected<Pattern> patternFromHaptic(std::string text, const std::string& file);

/// Converts a pattern to HJIF, the JSON form of ISO/IEC 23090-31 (MPEG haptics): one perception on the
/// forearm; one channel per tactor, whose direction is its place on the ring; vectorial waves whose amplitude
/// is the intensity. Times are rounded to milliseconds; the first point of a step is moved one millisecond
/// earlier. date: "2026-01-31". Error: refused when objects have too many corners. Thread: any (pure).
[[nodiscard]] core::Expected<std::string> patternToHjif(const Pattern& pattern, const std::string& date);

/// Reads HJIF. A channel belongs to the tactor nearest to its direction, or without a direction to the tactor
/// of its index. Basis effects with keyframes are read; intensity is amplitude times the gain of the channel;
/// frequencies follow from it and are ignored. file: for errors. Error: badInput with line and column, also
/// for what a pattern cannot represent (other effects, more than six channels, libraries). Thread: any
/// (pure).
[[nodiscard]] core::Expected<Pattern> patternFromHjif(std::string text, const std::string& file);

/// Length of the constant pieces that approximate slopes.
inline constexpr int kTactPiece_ms = 20;

/// Converts a pattern to .tact with the layout of a forearm (ForearmL or ForearmR, six motors) in DOT_MODE:
/// one effect with constant pieces at whole milliseconds. Error: refused when objects have too many corners.
/// Thread: any (pure).
[[nodiscard]] core::Expected<std::string> patternToTact(const Pattern& pattern);

/// Reads the dots of ForearmL, or of ForearmR when there is no ForearmL, with the playback types NONE,
/// FADE_IN, FADE_OUT and FADE_IN_OUT. Disabled tracks are ignored. file: for errors. Error: badInput with
/// line and column, also for what a pattern cannot represent (paths, other devices only). Thread: any (pure).
[[nodiscard]] core::Expected<Pattern> patternFromTact(std::string text, const std::string& file);

} // namespace teleta::pattern
