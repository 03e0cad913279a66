// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/patterns/pattern_collection.h"

#include "backend/pattern/model/built_in_patterns.h"
#include "backend/playback/pattern_program.h"
#include "widgets/base/background.h"
#include "widgets/pattern/document/pattern_names.h"

#include <QDir>
#include <QFileInfo>

#include <algorithm>
#include <utility>

namespace teleta::console {

using pattern::StoredPattern;

namespace {

/// Waits, because files often change several times in a row.
constexpr int kRest_ms = 100;
constexpr std::size_t kMostDone = 100;
/// Each watched file takes a system handle; in a larger folder only creation and deletion are watched.
constexpr int kMostWatched = 500;

} // namespace

PatternCollection::PatternCollection(QString folder, QObject* parent)
    : QObject(parent)
    , m_folder(folder.toStdString()) {
    m_pool.setMaxThreadCount(1);
    m_rest.setSingleShot(true);
    m_rest.setInterval(kRest_ms);
    connect(&m_rest, &QTimer::timeout, this, &PatternCollection::refresh);
    connect(&m_watcher, &QFileSystemWatcher::directoryChanged, &m_rest, qOverload<>(&QTimer::start));
    connect(&m_watcher, &QFileSystemWatcher::fileChanged, &m_rest, qOverload<>(&QTimer::start));
    refresh();
}

PatternCollection::~PatternCollection() {
    m_pool.waitForDone();
}

std::shared_ptr<const PatternCollection::Content>
PatternCollection::contentOf(const pattern::PatternFolder& folder, const Content& before) {
    auto content = std::make_shared<Content>();
    content->patterns = folder.read(before.patterns);
    for (const StoredPattern& stored : content->patterns) {
        if (!stored.pattern)
            continue;
        const auto known = before.programs.find(stored.id);
        const bool same = known != before.programs.end() &&
                          std::ranges::any_of(before.patterns, [&](const StoredPattern& old) {
                              return old.id == stored.id && old.pattern == stored.pattern;
                          });
        content->programs[stored.id] = same ? known->second : playback::programOf(*stored.pattern);
    }
    return content;
}

void PatternCollection::refresh() {
    if (!isPossible())
        return;
    if (m_reading) {
        m_again = true;
        return;
    }
    m_reading = true;
    base::runInBackground(
        m_pool, this,
        [folder = m_folder, before = m_content] {
            QDir().mkpath(QString::fromStdString(folder.path())); // only existing folders can be watched
            return contentOf(folder, *before);
        },
        [this](std::shared_ptr<const Content> content) {
            m_reading = false;
            m_content = std::move(content);
            m_isRead = true;
            watch();
            emit changed();
            if (std::exchange(m_again, false))
                refresh();
        });
}

void PatternCollection::watch() {
    QStringList wanted{QString::fromStdString(m_folder.path())};
    for (const StoredPattern& stored : m_content->patterns)
        if (wanted.size() < kMostWatched)
            wanted << QString::fromStdString(stored.path);
    const QStringList watched = m_watcher.files() + m_watcher.directories();
    QStringList more;
    for (const QString& path : wanted)
        if (!watched.contains(path))
            more << path;
    if (!more.isEmpty())
        m_watcher.addPaths(more);
}

std::shared_ptr<const pattern::Pattern> PatternCollection::atPath(const QString& path) const {
    const auto found = std::ranges::find(patterns(), path.toStdString(), &StoredPattern::path);
    return found == patterns().end() ? nullptr : found->pattern;
}

playback::Program PatternCollection::program(const std::string& id) const {
    if (const pattern::Pattern* builtIn = pattern::findBuiltIn(id))
        return playback::programOf(*builtIn);
    const auto found = m_content->programs.find(id);
    return found == m_content->programs.end() ? playback::Program{} : found->second;
}

QString PatternCollection::nameOf(const QString& path) const {
    const auto pattern = atPath(path);
    return pattern ? pattern::displayName(*pattern) : QFileInfo(path).fileName();
}

void PatternCollection::add(const pattern::Pattern& pattern) {
    base::runInBackground(
        m_pool, this, [folder = m_folder, pattern] { return folder.add(pattern); },
        [this](core::Expected<std::string> path) {
            if (!path) {
                emit failed(tr("The pattern could not be saved."), path.error());
                return;
            }
            refresh();
            emit added(QString::fromStdString(*path));
        });
}

void PatternCollection::duplicate(const pattern::Pattern& pattern, const QString& name) {
    base::runInBackground(
        m_pool, this,
        [folder = m_folder, pattern, name = name.toStdString()] { return folder.duplicate(pattern, name); },
        [this](core::Expected<std::string> path) {
            if (path)
                refresh();
            else
                emit failed(tr("The pattern could not be duplicated."), path.error());
        });
}

void PatternCollection::rename(const QString& path, const QString& name) {
    base::runInBackground(
        m_pool, this,
        [folder = m_folder, path = path.toStdString(), name = name.toStdString()] {
            return folder.rename(path, name);
        },
        [this, path, before = nameOf(path)](core::Expected<void> renamed) {
            refresh();
            if (renamed)
                did({path, before, {}});
            else
                emit failed(tr("%1 could not be renamed.", "a pattern").arg(before), renamed.error());
        });
}

void PatternCollection::remove(const QString& path) {
    base::runInBackground(
        m_pool, this, [folder = m_folder, path = path.toStdString()] { return folder.remove(path); },
        [this, path, name = nameOf(path)](core::Expected<std::string> deleted) {
            refresh();
            if (!deleted) {
                emit failed(tr("%1 could not be deleted.", "a pattern").arg(name), deleted.error());
                return;
            }
            did({path, name, QString::fromStdString(*deleted)});
            emit removed(path);
        });
}

void PatternCollection::did(Done done) {
    m_done.push_back(std::move(done));
    if (m_done.size() > kMostDone)
        m_done.erase(m_done.begin());
    emit doneChanged();
}

QString PatternCollection::lastDone() const {
    if (m_done.empty())
        return {};
    const Done& last = m_done.back();
    return last.deleted.isEmpty() ? tr("%1 was renamed.", "a pattern").arg(last.name)
                                  : tr("%1 was deleted.", "a pattern").arg(last.name);
}

void PatternCollection::undo() {
    if (m_done.empty())
        return;
    const Done last = m_done.back();
    m_done.pop_back();
    emit doneChanged();
    const auto work = [folder = m_folder, last]() -> core::Expected<void> {
        const std::string path = last.path.toStdString();
        if (last.deleted.isEmpty())
            return folder.rename(path, last.name.toStdString());
        TELETA_CHECK(folder.restore(last.deleted.toStdString(), path));
        return {};
    };
    base::runInBackground(m_pool, this, work, [this, name = last.name](core::Expected<void> done) {
        refresh();
        if (!done)
            emit failed(tr("%1 could not be restored.", "a pattern").arg(name), done.error());
    });
}

} // namespace teleta::console
