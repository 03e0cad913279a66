// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/scene_file.h"

#include "backend/core/data/input_file.h"
#include "backend/core/keys/toml_depth.h"
#include "backend/scene/scene_reader.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QString>

namespace teleta::app {

namespace {

/// The file of a scene or another kind, or the resource.
std::string placeOf(const std::string& pathOrName, const QString& kind = QStringLiteral("scenes")) {
    const QString name = QString::fromStdString(pathOrName);
    const QString resource = QStringLiteral(":/%1/%2.toml").arg(kind, name);
    const QFileInfo file(name);
    // The results of an earlier run may lie in a folder of that name.
    return (file.exists() && !file.isDir()) || !QFile::exists(resource) ? pathOrName : resource.toStdString();
}

} // namespace

std::string scenePlace(const std::string& pathOrName) {
    return placeOf(pathOrName);
}

core::Expected<scene::Scene> readScene(const std::string& pathOrName) {
    return scene::readScene(placeOf(pathOrName));
}

core::Expected<AnyScene> readAnyScene(const std::string& pathOrName) {
    const std::string place = placeOf(pathOrName);
    TELETA_TRY(const std::string text, core::readFile(place, core::kMostTomlBytes));
    if (study::isStudyScene(text))
        return study::parseStudyScene(text, place);
    return scene::parseScene(text, place);
}

core::Expected<std::string> sceneText(const std::string& pathOrName) {
    return core::readFile(placeOf(pathOrName), core::kMostTomlBytes);
}

std::string readSceneText(const std::string& pathOrName) {
    return sceneText(pathOrName).value_or(std::string());
}

std::string sweepPlace(const std::string& pathOrName) {
    return placeOf(pathOrName, QStringLiteral("sweeps"));
}

QStringList sweepNames() {
    QStringList names;
    for (const QString& file : QDir(QStringLiteral(":/sweeps")).entryList(QDir::Files, QDir::Name))
        names << QFileInfo(file).completeBaseName();
    return names;
}

std::vector<std::string> sceneNames() {
    std::vector<std::string> names;
    for (const QString& file : QDir(QStringLiteral(":/scenes")).entryList(QDir::Files, QDir::Name))
        names.push_back(QFileInfo(file).completeBaseName().toStdString());
    return names;
}

} // namespace teleta::app
