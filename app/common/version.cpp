// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/version.h"

#include "app/common/source_commit.h" // written at each build by packaging/cmake/write_commit.cmake

#include <QJsonDocument>
#include <QJsonObject>

namespace teleta::app {

QString Version::text() const {
    if (commit.isEmpty())
        return number;
    return number + QLatin1Char('+') + commit + (modified ? QStringLiteral(".modified") : QString());
}

const Version& version() {
    static const Version built{QStringLiteral(TELETA_VERSION), QStringLiteral(TELETA_COMMIT),
                               TELETA_COMMIT_MODIFIED};
    return built;
}

QString versionJson(const QString& program) {
    const Version& built = version();
    const QJsonObject document{
        {QStringLiteral("name"), program},
        {QStringLiteral("version"), built.number},
        {QStringLiteral("commit"), built.commit.isEmpty() ? QJsonValue() : QJsonValue(built.commit)},
        {QStringLiteral("modified"), built.modified}};
    return QString::fromUtf8(QJsonDocument(document).toJson());
}

QString citation() {
    const Version& built = version();
    const QString date = QStringLiteral(TELETA_RELEASE_DATE);
    QString text = QStringLiteral("@software{teleta_console,\n"
                                  "  title   = {{TeleTA Console}},\n"
                                  "  author  = {{The TeleTA Console authors}},\n"
                                  "  version = {%1},\n"
                                  "  date    = {%2},\n"
                                  "  year    = {%3},\n"
                                  "  license = {GPL-3.0-or-later}")
                       .arg(built.number, date, date.left(4));
    if (!built.commit.isEmpty())
        text += QStringLiteral(",\n  note    = {Commit %1}").arg(built.commit);
    return text + QStringLiteral("\n}\n");
}

} // namespace teleta::app
