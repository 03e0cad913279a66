// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/analysis/analysis_script.h"

#include <QFile>
#include <QString>

namespace teleta::study {

core::Expected<std::string> analysisScript() {
    QFile file(QStringLiteral(":/studies/analysis.R"));
    if (!file.open(QIODevice::ReadOnly))
        return core::Unexpected(core::Error{core::ErrorKind::notFound,
                                            file.errorString().toStdString(),
                                            {},
                                            {file.fileName().toStdString()}});
    return file.readAll().toStdString();
}

} // namespace teleta::study
