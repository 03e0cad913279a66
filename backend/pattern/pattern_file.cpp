// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/pattern_file.h"

#include "backend/core/output_file.h"
#include "backend/pattern/built_in_patterns.h"
#include "backend/pattern/json_document.h"
#include "backend/pattern/pattern_format.h"
#include "backend/pattern/pattern_json.h"
#include "backend/pattern/sampled_output.h"

#include <QCoreApplication>
#include <QFile>

#include <utility>

namespace teleta::pattern {

namespace {

struct FileText {
    Q_DECLARE_TR_FUNCTIONS(PatternFile)
};

core::Error failure(core::ErrorKind kind, const std::string& path, const QString& message,
                    const QString& expected) {
    return {kind, message.toStdString(), expected.toStdString(), {path, 0, 0}};
}

core::Expected<std::string> readBytes(const std::string& path) {
    QFile file(QString::fromStdString(path));
    if (!file.exists())
        return core::Unexpected(failure(core::ErrorKind::notFound, path,
                                        FileText::tr("there is no such file or built-in pattern"),
                                        FileText::tr("a pattern file, or an id of teleta pattern list")));
    if (!file.open(QIODevice::ReadOnly))
        return core::Unexpected(failure(core::ErrorKind::ioFailed, path, file.errorString(), {}));
    // One byte more shows that the limit is passed, also with a pipe, whose size is not known.
    const QByteArray bytes = file.read(static_cast<qint64>(JsonDocument::kMostBytes) + 1);
    if (file.error() != QFileDevice::NoError)
        return core::Unexpected(failure(core::ErrorKind::ioFailed, path, file.errorString(), {}));
    if (static_cast<std::size_t>(bytes.size()) > JsonDocument::kMostBytes)
        return core::Unexpected(failure(core::ErrorKind::badInput, path,
                                        FileText::tr("the file is too large"),
                                        FileText::tr("at most %1 MiB").arg(JsonDocument::kMostBytes >> 20U)));
    return bytes.toStdString();
}

core::Expected<void> writeBytes(const std::string& path, const std::string& bytes) {
    core::Expected<core::OutputFile> file = core::OutputFile::create(path);
    if (!file)
        return core::Unexpected(file.error());
    file->write(bytes);
    return file->finish();
}

core::Error unknownEnding(const std::string& path) {
    return failure(core::ErrorKind::badInput, path, FileText::tr("the ending of the name tells no format"),
                   FileText::tr("one of %1").arg(QString::fromStdString(allEndings())));
}

core::Expected<void> orWithPath(core::Expected<void> done, const std::string& path) {
    if (!done && done.error().where.file.empty())
        done.error().where.file = path;
    return done;
}

core::Expected<void> write(const Pattern& pattern, PatternFormat format, const std::string& path) {
    const auto writeText = [&](const core::Expected<std::string>& text) {
        return text ? writeBytes(path, *text) : core::Expected<void>(core::Unexpected(text.error()));
    };
    switch (format) {
    case PatternFormat::own:
        return writeText(patternToJson(pattern));
    case PatternFormat::csv:
        return writeCsv(pattern, path, kCsvRate_Hz);
    case PatternFormat::wav:
        return writeWav(pattern, path, kWavRate_Hz);
    }
    return {};
}

core::Expected<Pattern> read(std::string bytes, PatternFormat format, const std::string& path) {
    switch (format) {
    case PatternFormat::own:
        return patternFromJson(std::move(bytes), path);
    case PatternFormat::csv:
    case PatternFormat::wav:
        break;
    }
    return core::Unexpected(failure(core::ErrorKind::badInput, path,
                                    FileText::tr("patterns are written in this format, but not read"),
                                    ".json"));
}

} // namespace

core::Expected<Pattern> loadPattern(const std::string& path) {
    core::Expected<std::string> bytes = readBytes(path);
    if (!bytes)
        return core::Unexpected(bytes.error());
    const std::optional<PatternFormat> format = formatOf(path);
    if (!format)
        return core::Unexpected(unknownEnding(path));
    core::Expected<Pattern> pattern = read(std::move(*bytes), *format, path);
    if (pattern && pattern->id.empty())
        pattern->id = baseName(path);
    return pattern;
}

core::Expected<Pattern> findPattern(const std::string& idOrPath) {
    if (const Pattern* builtIn = findBuiltIn(idOrPath))
        return *builtIn;
    return loadPattern(idOrPath);
}

core::Expected<void> savePattern(const Pattern& pattern, const std::string& path) {
    const std::optional<PatternFormat> format = formatOf(path);
    if (!format)
        return core::Unexpected(unknownEnding(path));
    return orWithPath(write(pattern, *format, path), path);
}

} // namespace teleta::pattern
