// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace teleta::pattern {

/// Formats of pattern files, told by the end of the file's name.
///   own         .json         in and out; all others hold only what is played
///   hjif        .hjif         in and out
///   hapticZip   .haptic.zip   in and out, a file a tactor
///   haptic      .haptic       in and out, one tactor
///   ahapZip     .ahap.zip     out, a file a tactor
///   ahap        .ahap         out, one tactor
///   tact        .tact         in and out
///   csv         .csv          out: commanded or predicted intensities
///   wav         .wav          out: 6 channels of the same
enum class PatternFormat { own, hjif, hapticZip, haptic, ahapZip, ahap, tact, csv, wav };

/// Upper and lower case count the same. Empty: no format has this ending.
[[nodiscard]] std::optional<PatternFormat> formatOf(std::string_view path);

/// All endings, for messages and file dialogs: ".json, ...".
[[nodiscard]] std::string allEndings();

/// The file's name without folders and ending.
[[nodiscard]] std::string baseName(std::string_view path);

} // namespace teleta::pattern
