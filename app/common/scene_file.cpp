// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/scene_file.h"

#include "backend/scene/scene_reader.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QString>

namespace teleta::app {

core::Expected<scene::Scene> readScene(const std::string& pathOrName) {
    QString resource = QString::fromStdString(pathOrName);
    if (!resource.startsWith(QStringLiteral(":/"))) {
        resource = QStringLiteral(":/scenes/%1.toml").arg(resource);
        const QFileInfo file(QString::fromStdString(pathOrName));
        // The results of an earlier run may lie in a folder of that name.
        if ((file.exists() && !file.isDir()) || !QFile::exists(resource))
            return scene::readScene(pathOrName);
    }
    // Only Qt can read it.
    QFile file(resource);
    if (!file.open(QIODevice::ReadOnly))
        return core::Unexpected(
            core::Error{core::ErrorKind::notFound, file.errorString().toStdString(), {}, {pathOrName, 0, 0}});
    return scene::parseScene(file.readAll().toStdString(), resource.toStdString());
}

std::vector<std::string> sceneNames() {
    std::vector<std::string> names;
    for (const QString& file : QDir(QStringLiteral(":/scenes")).entryList(QDir::Files, QDir::Name))
        names.push_back(QFileInfo(file).completeBaseName().toStdString());
    return names;
}

} // namespace teleta::app
