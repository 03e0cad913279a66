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

/// The file of a scene, or the resource.
std::string placeOf(const std::string& pathOrName) {
    const QString name = QString::fromStdString(pathOrName);
    const QString resource = QStringLiteral(":/scenes/%1.toml").arg(name);
    const QFileInfo file(name);
    // The results of an earlier run may lie in a folder of that name.
    return (file.exists() && !file.isDir()) || !QFile::exists(resource) ? pathOrName : resource.toStdString();
}

} // namespace

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

std::string readSceneText(const std::string& pathOrName) {
    return core::readFile(placeOf(pathOrName), core::kMostTomlBytes).value_or(std::string());
}

std::vector<std::string> sceneNames() {
    std::vector<std::string> names;
    for (const QString& file : QDir(QStringLiteral(":/scenes")).entryList(QDir::Files, QDir::Name))
        names.push_back(QFileInfo(file).completeBaseName().toStdString());
    return names;
}

} // namespace teleta::app
