// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/pattern/files/pattern_import.h"
#include "backend/pattern/files/zip_archive.h"
#include "backend/pattern/model/pattern.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace teleta::pattern {

/// Length of what the motors play for a pulse that has no length: an emphasis or a transient.
inline constexpr double kBurst_s = 0.05;

/// How files of one tactor say who wrote them, and of which tactor: "tactor 3".
inline constexpr std::string_view kEditorName = "TeleTA Console";
inline constexpr std::string_view kSourceTactor = "tactor ";

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

/// Reads AHAP: the amplitude is the square of the intensity, which is that of the event times the curves and
/// parameters of HapticIntensityControl; a transient becomes a burst of kBurst_s. Where events overlap the
/// stronger one counts. Sharpness, sounds and envelopes are losses. Error: badInput with line and column.
/// Thread: any (pure).
[[nodiscard]] core::Expected<PatternImport> patternFromAhap(std::string text, const std::string& file,
                                                            const ImportOptions& options = {});

/// Reads "tactor1.ahap" ... "tactor6.ahap".
[[nodiscard]] core::Expected<PatternImport> patternFromAhaps(std::vector<ZipEntry> entries,
                                                             const std::string& file);

/// The format .haptic 1.0: JSON with one amplitude envelope, hence one file per tactor. The frequency of
/// these motors follows the amplitude; its envelope is written equal to it, and another one is a loss when
/// read. An emphasis becomes a burst of kBurst_s. Thread: any (pure).

/// The file of one tactor. Error: refused when objects have too many corners.
[[nodiscard]] core::Expected<std::string> tactorToHaptic(const Pattern& pattern, std::size_t tactor);

/// "tactor1.haptic" ... "tactor6.haptic".
[[nodiscard]] core::Expected<std::vector<ZipEntry>> patternToHaptics(const Pattern& pattern);

/// The tactor of an entry is the number 1..6 at the end of its base name. file: name of the archive, for
/// errors. Error: badInput with entry, line and column.
[[nodiscard]] core::Expected<PatternImport> patternFromHaptics(std::vector<ZipEntry> entries,
                                                               const std::string& file);

/// Reads a single file.
[[nodiscard]] core::Expected<PatternImport> patternFromHaptic(std::string text, const std::string& file,
                                                              const ImportOptions& options = {});

/// Converts a pattern to HJIF, the JSON form of ISO/IEC 23090-31 (MPEG haptics): one perception on the
/// forearm; one channel per tactor, whose direction is its place on the ring; vectorial waves whose amplitude
/// is the intensity. Times are rounded to milliseconds; the first point of a step is moved one millisecond
/// earlier. date: "2026-01-31". Error: refused when objects have too many corners. Thread: any (pure).
[[nodiscard]] core::Expected<std::string> patternToHjif(const Pattern& pattern, const std::string& date);

/// Reads HJIF. A channel belongs to the tactor nearest to its direction, or without a direction to the tactor
/// of its index; a single channel without one is one signal, see ImportOptions. Effects of the library and
/// composed ones are read. Vectorial waves and curves play the size of their amplitude times the gain of the
/// channel, transients a burst of kBurst_s; coded wave forms, perceptions that are not vibration and channels
/// beyond the six tactors are losses. file: for errors. Error: badInput with line and column, also when
/// nothing is left to play. Thread: any (pure).
[[nodiscard]] core::Expected<PatternImport> patternFromHjif(std::string text, const std::string& file,
                                                            const ImportOptions& options = {});

/// Length of the constant pieces that approximate slopes.
inline constexpr int kTactPiece_ms = 20;

/// Converts a pattern to .tact with the layout of the forearms (six motors each) in DOT_MODE on the arm of
/// the pattern: one effect with constant pieces at whole milliseconds, see exportLosses(). Error: refused
/// when objects have too many corners. Thread: any (pure).
[[nodiscard]] core::Expected<std::string> patternToTact(const Pattern& pattern);

/// Reads the dots and paths of one forearm: that of the options, else ForearmL if it has effects, else
/// ForearmR. Dots have the playback types NONE, FADE_IN, FADE_OUT and FADE_IN_OUT; a path moves in straight
/// lines over the layout of three by two motors, and the motors around it share its energy. The other arm,
/// other devices and disabled tracks are losses. file: for errors. Error: badInput with line and column, also
/// for a file of other devices only. Thread: any (pure).
[[nodiscard]] core::Expected<PatternImport> patternFromTact(std::string text, const std::string& file,
                                                            const ImportOptions& options = {});

} // namespace teleta::pattern
