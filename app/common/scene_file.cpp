// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/scene_file.h"

#include "backend/scene/scene_reader.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QString>

namespace teleta::app {

namespace {

/// The file of a scene, or the resource, which only Qt can read.
QString placeOf(const std::string& pathOrName) {
    const QString name = QString::fromStdString(pathOrName);
    const QString resource = QStringLiteral(":/scenes/%1.toml").arg(name);
    const QFileInfo file(name);
    // The results of an earlier run may lie in a folder of that name.
    return (file.exists() && !file.isDir()) || !QFile::exists(resource) ? name : resource;
}

} // namespace

core::Expected<scene::Scene> readScene(const std::string& pathOrName) {
    const QString place = placeOf(pathOrName);
    if (!place.startsWith(QStringLiteral(":/")))
        return scene::readScene(pathOrName);
    QFile file(place);
    if (!file.open(QIODevice::ReadOnly))
        return core::Unexpected(
            core::Error{core::ErrorKind::notFound, file.errorString().toStdString(), {}, {pathOrName, 0, 0}});
    return scene::parseScene(file.readAll().toStdString(), place.toStdString());
}

core::Expected<AnyScene> readAnyScene(const std::string& pathOrName) {
    const QString place = placeOf(pathOrName);
    QFile file(place);
    if (file.open(QIODevice::ReadOnly)) {
        const std::string text = file.readAll().toStdString();
        if (study::isStudyScene(text))
            return study::parseStudyScene(text, place.toStdString());
    }
    return readScene(pathOrName);
}

std::string readSceneText(const std::string& pathOrName) {
    QFile file(placeOf(pathOrName));
    return file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : std::string();
}

std::vector<std::string> sceneNames() {
    std::vector<std::string> names;
    for (const QString& file : QDir(QStringLiteral(":/scenes")).entryList(QDir::Files, QDir::Name))
        names.push_back(QFileInfo(file).completeBaseName().toStdString());
    return names;
}

} // namespace teleta::app
