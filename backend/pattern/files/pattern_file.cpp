// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/files/pattern_file.h"

#include "backend/core/data/input_file.h"
#include "backend/core/data/output_file.h"
#include "backend/core/failure.h"
#include "backend/pattern/files/foreign_formats.h"
#include "backend/pattern/files/pattern_format.h"
#include "backend/pattern/files/pattern_json.h"
#include "backend/pattern/files/zip_archive.h"
#include "backend/pattern/model/bake.h"
#include "backend/pattern/model/built_in_patterns.h"

#include <QCoreApplication>
#include <QDate>

#include <utility>
#include <vector>

namespace teleta::pattern {

namespace {

struct FileText {
    Q_DECLARE_TR_FUNCTIONS(FileText)
};

core::Unexpected failure(core::ErrorKind kind, const std::string& path, const QString& message,
                         const QString& expected) {
    return core::failed(kind, message, expected, {path, 0, 0});
}

core::Expected<std::string> readBytes(const std::string& path) {
    core::Expected<std::string> bytes = core::readFile(path);
    if (!bytes && bytes.error().kind == core::ErrorKind::notFound)
        return failure(core::ErrorKind::notFound, path,
                       FileText::tr("there is no such file or built-in pattern"),
                       FileText::tr("a pattern file, or an id listed by teleta pattern list"));
    return bytes;
}

core::Unexpected unknownEnding(const std::string& path) {
    return failure(core::ErrorKind::badInput, path, FileText::tr("the file name extension is unknown"),
                   FileText::tr("one of %1").arg(QString::fromStdString(allEndings())));
}

core::Expected<void> orWithPath(core::Expected<void> done, const std::string& path) {
    if (!done && done.error().where.file.empty())
        done.error().where.file = path;
    return done;
}

/// Writes the only active tactor, for formats with one tactor per file.
core::Expected<std::string>
onlyTactor(const Pattern& pattern, const std::string& path, const std::string& zipEnding,
           core::Expected<std::string> (*text)(const Pattern& pattern, std::size_t tactor)) {
    TELETA_TRY(const Tracks tracks, linearised(pattern));
    std::size_t only = 0;
    int active = 0;
    for (std::size_t i = 0; i < core::kTactors; ++i) {
        if (tracks[i].empty())
            continue;
        only = i;
        ++active;
    }
    if (active > 1)
        return failure(core::ErrorKind::refused, path,
                       FileText::tr("this format holds one tactor, the pattern uses more"),
                       FileText::tr("a name that ends with %1").arg(QString::fromStdString(zipEnding)));
    return text(pattern, only);
}

core::Expected<std::string> zipped(const core::Expected<std::vector<ZipEntry>>& entries) {
    TELETA_CHECK(entries);
    return writeZip(*entries);
}

core::Expected<void> write(const Pattern& pattern, PatternFormat format, const std::string& path,
                           const SampleOptions& samples) {
    const auto writeText = [&](const core::Expected<std::string>& text) {
        return text.and_then([&](const std::string& content) { return core::writeFile(path, content); });
    };
    switch (format) {
    case PatternFormat::own:
        return writeText(patternToJson(pattern));
    case PatternFormat::hjif:
        return writeText(patternToHjif(pattern, QDate::currentDate().toString(Qt::ISODate).toStdString()));
    case PatternFormat::hapticZip:
        return writeText(zipped(patternToHaptics(pattern)));
    case PatternFormat::haptic:
        return writeText(onlyTactor(pattern, path, ".haptic.zip", tactorToHaptic));
    case PatternFormat::ahapZip:
        return writeText(zipped(patternToAhaps(pattern)));
    case PatternFormat::ahap:
        return writeText(onlyTactor(pattern, path, ".ahap.zip", tactorToAhap));
    case PatternFormat::tact:
        return writeText(patternToTact(pattern));
    case PatternFormat::csv:
        return writeCsv(pattern, path, samples);
    case PatternFormat::wav:
        return writeWav(pattern, path, samples);
    }
    return {};
}

core::Expected<PatternImport> read(std::string bytes, PatternFormat format, const std::string& path,
                                   const ImportOptions& options) {
    const auto unpacked = [&] { return readZip(bytes, path); };
    switch (format) {
    case PatternFormat::own:
        return patternFromJson(std::move(bytes), path).map([](Pattern pattern) {
            return PatternImport{std::move(pattern), {}, false, false};
        });
    case PatternFormat::hjif:
        return patternFromHjif(std::move(bytes), path, options);
    case PatternFormat::hapticZip: {
        TELETA_TRY(std::vector<ZipEntry> entries, unpacked());
        return patternFromHaptics(std::move(entries), path);
    }
    case PatternFormat::haptic:
        return patternFromHaptic(std::move(bytes), path, options);
    case PatternFormat::ahapZip: {
        TELETA_TRY(std::vector<ZipEntry> entries, unpacked());
        return patternFromAhaps(std::move(entries), path);
    }
    case PatternFormat::ahap:
        return patternFromAhap(std::move(bytes), path, options);
    case PatternFormat::tact:
        return patternFromTact(std::move(bytes), path, options);
    case PatternFormat::csv:
    case PatternFormat::wav:
        break;
    }
    return failure(core::ErrorKind::badInput, path, FileText::tr("this format can be written but not read"),
                   ".json, .hjif, .haptic.zip, .haptic, .ahap.zip, .ahap, .tact");
}

} // namespace

core::Expected<PatternImport> importPattern(const std::string& path, const ImportOptions& options) {
    TELETA_TRY(std::string bytes, readBytes(path));
    const std::optional<PatternFormat> format = formatOf(path);
    if (!format)
        return unknownEnding(path);
    core::Expected<PatternImport> import = read(std::move(bytes), *format, path, options);
    if (import && import->pattern.id.empty())
        import->pattern.id = baseName(path);
    return import;
}

core::Expected<Pattern> loadPattern(const std::string& path) {
    return importPattern(path).map([](PatternImport import) { return std::move(import.pattern); });
}

core::Expected<PatternImport> findImport(const std::string& idOrPath, const ImportOptions& options) {
    if (const Pattern* builtIn = findBuiltIn(idOrPath))
        return PatternImport{*builtIn, {}, false, false};
    return importPattern(idOrPath, options);
}

core::Expected<Pattern> findPattern(const std::string& idOrPath) {
    return findImport(idOrPath).map([](PatternImport import) { return std::move(import.pattern); });
}

core::Expected<void> savePattern(const Pattern& pattern, const std::string& path,
                                 const SampleOptions& samples) {
    const std::optional<PatternFormat> format = formatOf(path);
    if (!format)
        return unknownEnding(path);
    return orWithPath(write(pattern, *format, path, samples), path);
}

} // namespace teleta::pattern
