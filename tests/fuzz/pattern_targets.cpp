// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/files/foreign_formats.h"
#include "backend/pattern/files/pattern_json.h"
#include "backend/pattern/files/recovery_file.h"
#include "backend/pattern/files/zip_archive.h"
#include "backend/pattern/laws/law_checker.h"
#include "backend/pattern/motors/motor_prediction.h"
#include "backend/pattern/motors/sampled_output.h"
#include "tests/backend/core/temporary_folder.h"
#include "tests/fuzz/fuzz_check.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/support/floating_point_traps.h"

#include <atomic>
#include <cmath>

namespace teleta::fuzz {

namespace {

using namespace pattern;

// Longer patterns only take time: everything that depends on the length is tested with shorter ones.
constexpr double kChecked_s = 20.0;
constexpr double kSampled_s = 2.0;

void requireEvaluates(const Pattern& pattern) {
    const CompiledPattern compiled(pattern);
    for (const double share : {-0.1, 0.0, 0.1, 0.333, 0.5, 0.9, 0.999, 1.0, 1.1}) {
        const double t_s = share * pattern.duration_s;
        const core::Intensities intensities = evaluate(pattern, t_s);
        for (const double intensity : intensities)
            require(intensity >= 0.0 && intensity <= 1.0, "intensities are 0..1");
        require(intensities == compiled.evaluate(t_s), "a compiled pattern is the same pattern");
    }
}

void requireInRange(const Pattern& pattern) {
    require(pattern.duration_s >= 0.0 && pattern.duration_s <= Pattern::kLongest_s, "a duration is in range");
    require(pattern.objects.size() <= Pattern::kMostObjects, "a pattern has not too many objects");
    for (const Track& track : pattern.tracks) {
        for (std::size_t i = 0; i < track.size(); ++i) {
            require(std::isfinite(track[i].time_s), "times are finite");
            require(track[i].intensity >= 0.0 && track[i].intensity <= 1.0, "breakpoints are 0..1");
            require(i == 0 || track[i].time_s >= track[i - 1].time_s, "times never decrease");
        }
    }
}

void requireSound(const Pattern& pattern) {
    requireInRange(pattern);
    const test::FloatingPointTraps traps;
    requireEvaluates(pattern);
    if (pattern.duration_s > kChecked_s)
        return;
    for (const Finding& finding : checkLaws(pattern, assumedMotors())) {
        require(std::isfinite(finding.value) && std::isfinite(finding.limit), "findings have numbers");
        if (const std::optional<Pattern> mended = fixed(pattern, finding)) {
            requireInRange(*mended);
            requireEvaluates(*mended);
        }
    }
    if (pattern.duration_s > kSampled_s)
        return;
    const std::atomic<bool> cancelled = false;
    const auto prediction = MotorPrediction::of(CompiledPattern(pattern), assumedMotors(), cancelled);
    require(prediction.has_value(), "a short pattern is predicted");
    const MotorPrediction::Bin bin = prediction->over(0, 0.0, pattern.duration_s);
    require(bin.low >= 0.0F && bin.low <= bin.high && bin.high <= 1.0F, "predictions are 0..1");
}

bool isSound(const core::Expected<PatternImport>& import) {
    if (!import) {
        requireExplained(import.error());
        return false;
    }
    requireSound(import->pattern);
    for (const Loss& loss : import->losses)
        require(!describe(loss).empty() && *toString(loss.kind) != '\0', "a loss is described");
    return true;
}

bool isSound(const core::Expected<Pattern>& pattern) {
    if (!pattern) {
        requireExplained(pattern.error());
        return false;
    }
    requireSound(*pattern);
    return true;
}

/// Whatever is written can be read and is valid.
void requireReadable(const core::Expected<PatternImport>& import) {
    require(import.has_value(), import ? "" : describe(import.error()));
    requireSound(import->pattern);
}

std::vector<ZipEntry> unpacked(const std::vector<ZipEntry>& entries) {
    const core::Expected<std::string> zip = writeZip(entries);
    require(zip.has_value(), "entries make an archive");
    core::Expected<std::vector<ZipEntry>> again = readZip(*zip, kInput);
    require(again.has_value(), "an archive is read back");
    return std::move(*again);
}

} // namespace

bool patternJson(Bytes bytes) {
    const core::Expected<Pattern> pattern = patternFromJson(textOf(bytes), kInput);
    if (!isSound(pattern))
        return false;
    const core::Expected<std::string> text = patternToJson(*pattern);
    require(text.has_value(), "what was read can be written");
    const core::Expected<Pattern> again = patternFromJson(*text, kInput);
    require(again && *again == *pattern, "a pattern comes back as it was written");
    return true;
}

bool patternExport(Bytes bytes) {
    const core::Expected<Pattern> pattern = patternFromJson(textOf(bytes), kInput);
    if (!pattern || pattern->duration_s > kChecked_s)
        return pattern.has_value();
    if (const auto hjif = patternToHjif(*pattern, "2026-01-31"))
        requireReadable(patternFromHjif(*hjif, kInput));
    if (const auto tact = patternToTact(*pattern))
        requireReadable(patternFromTact(*tact, kInput));
    if (const auto haptics = patternToHaptics(*pattern))
        requireReadable(patternFromHaptics(unpacked(*haptics), kInput));
    if (const auto ahaps = patternToAhaps(*pattern))
        requireReadable(patternFromAhaps(unpacked(*ahaps), kInput));
    if (pattern->duration_s <= kSampled_s) {
        static const test::TemporaryFolder folder;
        const SampleOptions options{.rate_Hz = 100.0, .motors = assumedMotors()};
        require(writeCsv(*pattern, folder.path("a.csv"), options).has_value(), "samples become CSV");
        require(writeWav(*pattern, folder.path("a.wav"), options).has_value(), "samples become sound");
    }
    return true;
}

bool patternAhap(Bytes bytes) {
    return isSound(patternFromAhap(textOf(bytes), kInput));
}

bool patternHjif(Bytes bytes) {
    return isSound(patternFromHjif(textOf(bytes), kInput));
}

bool patternHaptic(Bytes bytes) {
    return isSound(patternFromHaptic(textOf(bytes), kInput));
}

bool patternHapticZip(Bytes bytes) {
    core::Expected<std::vector<ZipEntry>> entries = readZip(textOf(bytes), kInput);
    if (!entries) {
        requireExplained(entries.error());
        return false;
    }
    require(entries->size() <= kMostZipEntries, "an archive has not too many entries");
    return isSound(patternFromHaptics(std::move(*entries), kInput));
}

bool patternTact(Bytes bytes) {
    return isSound(patternFromTact(textOf(bytes), kInput));
}

bool patternMap(Bytes bytes) {
    const core::Expected<PatternMap> map = patternMapFromJson(textOf(bytes), kInput);
    if (!map) {
        requireExplained(map.error());
        return false;
    }
    const core::Expected<PatternMap> again = patternMapFromJson(patternMapToJson(*map), kInput);
    require(again && *again == *map, "a map comes back as it was written");
    return true;
}

bool patternRecovery(Bytes bytes) {
    static const test::TemporaryFolder folder;
    const std::string path = folder.write("input.json", textOf(bytes)); // the extension determines the format
    const core::Expected<RecoveredPattern> recovered = readRecovery(path);
    if (!recovered) {
        requireExplained(recovered.error(), path);
        return false;
    }
    requireInRange(recovered->pattern);
    require(recovered->edited_ms >= 0, "a time of an edit is in range");
    return true;
}

} // namespace teleta::fuzz
