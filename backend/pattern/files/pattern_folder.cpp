// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/files/pattern_folder.h"

#include "backend/core/failure.h"
#include "backend/pattern/files/pattern_file.h"
#include "backend/pattern/files/pattern_format.h"
#include "backend/pattern/model/built_in_patterns.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QUuid>

#include <algorithm>
#include <set>
#include <utility>

namespace teleta::pattern {

namespace {

struct FolderText {
    Q_DECLARE_TR_FUNCTIONS(PatternFile)
};

constexpr qsizetype kLongestName = 60;
constexpr char kDeleted[] = "deleted";

core::Unexpected failure(core::ErrorKind kind, const QString& path, const QString& message,
                         const QString& expected = {}) {
    return core::failed(kind, message, expected, {path.toStdString(), 0, 0});
}

bool isRead(const QString& name) {
    const std::optional<PatternFormat> format = formatOf(name.toStdString());
    return format == PatternFormat::own || format == PatternFormat::hjif || format == PatternFormat::haptic ||
           format == PatternFormat::hapticZip || format == PatternFormat::tact;
}

/// A file name that is valid on every system.
QString fileNameOf(const QString& name) {
    QString plain;
    for (const QChar c : name.simplified().left(kLongestName))
        plain += c.isLetterOrNumber() ? c.toLower() : QLatin1Char('-');
    while (plain.contains(QLatin1String("--")))
        plain.replace(QLatin1String("--"), QLatin1String("-"));
    while (plain.endsWith(QLatin1Char('-')))
        plain.chop(1);
    while (plain.startsWith(QLatin1Char('-')))
        plain.remove(0, 1);
    return plain.isEmpty() ? QStringLiteral("pattern") : plain;
}

/// name.ending, name-2.ending ... in a folder.
QString freeIn(const QDir& folder, const QString& name, const QString& ending) {
    QString path = folder.filePath(name + ending);
    for (int k = 2; QFileInfo::exists(path); ++k)
        path = folder.filePath(QStringLiteral("%1-%2%3").arg(name).arg(k).arg(ending));
    return path;
}

core::Expected<QString> moved(const QString& from, const QString& to) {
    QFile file(from);
    if (!file.rename(to))
        return failure(core::ErrorKind::ioFailed, from, file.errorString());
    return to;
}

StoredPattern readFile(const QFileInfo& info) {
    StoredPattern stored;
    stored.path = info.filePath().toStdString();
    stored.modified_ms = info.lastModified().toMSecsSinceEpoch();
    stored.size = info.size();
    core::Expected<Pattern> pattern = loadPattern(stored.path);
    if (pattern) {
        stored.idInFile = pattern->id;
        stored.pattern = std::make_shared<const Pattern>(std::move(*pattern));
    } else {
        stored.error = pattern.error();
    }
    return stored;
}

} // namespace

std::string newPatternId() {
    return "mine." + QUuid::createUuid().toString(QUuid::Id128).left(12).toStdString();
}

PatternFolder::PatternFolder(std::string path)
    : m_path(std::move(path)) {
}

std::vector<StoredPattern> PatternFolder::read(const std::vector<StoredPattern>& before) const {
    const QDir folder(QString::fromStdString(m_path));
    std::vector<StoredPattern> all;
    std::set<std::string, std::less<>> taken;
    for (const QFileInfo& info : folder.entryInfoList(QDir::Files, QDir::Name)) {
        if (!isRead(info.fileName()) || info.fileName().startsWith(QLatin1Char('.')))
            continue;
        if (all.size() >= kMostFiles)
            break;
        const auto known = std::ranges::find(before, info.filePath().toStdString(), &StoredPattern::path);
        const bool same = known != before.end() && known->size == info.size() &&
                          known->modified_ms == info.lastModified().toMSecsSinceEpoch();
        StoredPattern stored = same ? *known : readFile(info);
        if (stored.pattern) {
            const auto isTaken = [&](const std::string& id) {
                return findBuiltIn(id) != nullptr || taken.contains(id);
            };
            std::string id = stored.idInFile;
            if (isTaken(id))
                id.append(1, '.').append(baseName(stored.path));
            const std::string withFile = id;
            for (int k = 2; isTaken(id); ++k)
                id = std::string(withFile).append(1, '-').append(std::to_string(k));
            taken.insert(id);
            stored.id = id;
            if (stored.pattern->id != id) {
                Pattern renamed = *stored.pattern;
                renamed.id = id;
                stored.pattern = std::make_shared<const Pattern>(std::move(renamed));
            }
        }
        all.push_back(std::move(stored));
    }
    return all;
}

std::string PatternFolder::freePath(const std::string& name) const {
    return freeIn(QDir(QString::fromStdString(m_path)), fileNameOf(QString::fromStdString(name)),
                  QStringLiteral(".json"))
        .toStdString();
}

core::Expected<std::string> PatternFolder::add(const Pattern& pattern) const {
    const QString folder = QString::fromStdString(m_path);
    if (!QDir().mkpath(folder))
        return failure(core::ErrorKind::ioFailed, folder, FolderText::tr("the folder cannot be created"));
    const std::string path = freePath(pattern.name);
    TELETA_CHECK(savePattern(pattern, path));
    return path;
}

core::Expected<std::string> PatternFolder::duplicate(const Pattern& pattern, const std::string& name) const {
    Pattern copy = pattern;
    copy.id = newPatternId();
    copy.name = name;
    std::erase(copy.tags, "built-in");
    return add(copy);
}

core::Expected<void> PatternFolder::rename(const std::string& path, const std::string& name) const {
    if (formatOf(path) != PatternFormat::own)
        return failure(core::ErrorKind::refused, QString::fromStdString(path),
                       FolderText::tr("this format cannot store another name"),
                       FolderText::tr("a pattern file that ends with .json"));
    TELETA_TRY(Pattern pattern, loadPattern(path));
    pattern.name = name;
    return savePattern(pattern, path);
}

core::Expected<std::string> PatternFolder::remove(const std::string& path) const {
    const QFileInfo info(QString::fromStdString(path));
    const QDir deleted(QDir(QString::fromStdString(m_path)).filePath(QLatin1String(kDeleted)));
    if (!deleted.mkpath(QStringLiteral(".")))
        return failure(core::ErrorKind::ioFailed, deleted.path(),
                       FolderText::tr("the folder cannot be created"));
    const QString name = QString::fromStdString(baseName(path));
    TELETA_TRY(const QString to,
               moved(info.filePath(), freeIn(deleted, name, info.fileName().mid(name.size()))));
    return to.toStdString();
}

core::Expected<std::string> PatternFolder::restore(const std::string& removed,
                                                   const std::string& path) const {
    const QFileInfo info(QString::fromStdString(path));
    const QString name = QString::fromStdString(baseName(path));
    TELETA_TRY(const QString to, moved(QString::fromStdString(removed),
                                       freeIn(info.dir(), name, info.fileName().mid(name.size()))));
    return to.toStdString();
}

} // namespace teleta::pattern
