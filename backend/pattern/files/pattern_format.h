// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace teleta::pattern {

/// Formats of pattern files and their file name extensions:
///   own         .json         read and written; all others contain only what is played
///   hjif        .hjif         read and written
///   hapticZip   .haptic.zip   read and written, one file per tactor
///   haptic      .haptic       read and written, one tactor
///   ahapZip     .ahap.zip     read and written, one file per tactor
///   ahap        .ahap         read and written, one tactor
///   tact        .tact         read and written
///   csv         .csv          written: commanded or predicted intensities
///   wav         .wav          written: the same as 6 channels, or vibrations of these intensities
enum class PatternFormat { own, hjif, hapticZip, haptic, ahapZip, ahap, tact, csv, wav };

/// Format by the extension of a path, ignoring case; empty when it is unknown.
[[nodiscard]] std::optional<PatternFormat> formatOf(std::string_view path);

/// Says whether files of a format can be read.
[[nodiscard]] bool isReadable(PatternFormat format);

/// All extensions, for messages and file dialogs: ".json, ...".
[[nodiscard]] std::string allEndings();

/// The file name without folders and extension.
[[nodiscard]] std::string baseName(std::string_view path);

} // namespace teleta::pattern
