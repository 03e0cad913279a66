// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/desktop/last_session.h"

#include "app/common/scene_file.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <algorithm>
#include <array>
#include <utility>
#include <variant>

namespace teleta::console::last_session {

namespace {

struct SessionText {
    Q_DECLARE_TR_FUNCTIONS(LastSession)
};

constexpr std::array<std::pair<Entry::Kind, const char*>, 7> kWords{{{Entry::Kind::scene, "scene:"},
                                                                     {Entry::Kind::recording, "recording:"},
                                                                     {Entry::Kind::list, "list:"},
                                                                     {Entry::Kind::camera, "camera:"},
                                                                     {Entry::Kind::arm, "arm:"},
                                                                     {Entry::Kind::site, "site:"},
                                                                     {Entry::Kind::study, "study:"}}};

QString entry(Entry::Kind kind, const QString& path) {
    const auto word =
        std::find_if(kWords.begin(), kWords.end(), [kind](const auto& known) { return known.first == kind; });
    const bool isAsItIs = path.isEmpty() || path.startsWith(QLatin1String(":/"));
    return QLatin1String(word->second) + (isAsItIs ? path : QFileInfo(path).absoluteFilePath());
}

/// Empty: it cannot be opened again by itself.
QString entryOf(const OpenSource& source) {
    if (!source.list.isEmpty())
        return entry(Entry::Kind::list, source.list);
    if (const auto* scene = std::get_if<app::SceneRequest>(&source.request))
        return entry(Entry::Kind::scene, QString::fromStdString(app::scenePlace(scene->path)));
    if (const auto* recording = std::get_if<app::RecordingRequest>(&source.request))
        return entry(Entry::Kind::recording, QString::fromStdString(recording->path));
    if (const auto* csv = std::get_if<app::CsvRequest>(&source.request))
        return entry(Entry::Kind::recording, QString::fromStdString(csv->path));
    if (const auto* arm = std::get_if<app::ArmRequest>(&source.request))
        return entry(Entry::Kind::arm, QString::fromStdString(arm->path));
    if (const auto* site = std::get_if<app::SiteRequest>(&source.request))
        return entry(Entry::Kind::site, QString::fromStdString(site->path));
    return std::holds_alternative<app::CameraRequest>(source.request) ? entry(Entry::Kind::camera, {})
                                                                      : QString();
}

} // namespace

QStringList entriesOf(const std::vector<OpenSource>& open, const QString& study) {
    QStringList entries;
    for (const OpenSource& source : open)
        if (const QString entry = entryOf(source); !entry.isEmpty() && !entries.contains(entry))
            entries << entry;
    if (!study.isEmpty())
        entries << entry(Entry::Kind::study, study);
    return entries;
}

std::vector<Entry> entriesFrom(const QStringList& stored) {
    std::vector<Entry> entries;
    for (const QString& text : stored)
        for (const auto& [kind, word] : kWords) {
            if (!text.startsWith(QLatin1String(word)))
                continue;
            const QString path = text.mid(static_cast<qsizetype>(qstrlen(word)));
            if (kind == Entry::Kind::camera || QFileInfo::exists(path))
                entries.push_back({kind, path});
        }
    return entries;
}

QString text(const std::vector<Entry>& entries, const chrome::RecentNames& known) {
    QStringList names;
    for (const Entry& entry : entries) {
        const auto name = known.constFind(entry.path);
        if (entry.kind == Entry::Kind::camera)
            names << SessionText::tr("camera");
        else if (entry.kind == Entry::Kind::recording && name != known.constEnd())
            names << name->oneLine();
        else if (entry.kind == Entry::Kind::study)
            names << QFileInfo(entry.path).fileName();
        else
            names << QFileInfo(entry.path).completeBaseName();
    }
    return names.join(QStringLiteral(", "));
}

} // namespace teleta::console::last_session
