// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/beside_file.h"

#include <QDir>
#include <QFileInfo>
#include <QString>

namespace teleta::core {

std::string besideFile(const std::string& file, const std::string& path) {
    return QFileInfo(QString::fromStdString(file)).dir().filePath(QString::fromStdString(path)).toStdString();
}

} // namespace teleta::core
