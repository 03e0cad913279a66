// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/chrome/recent_name.h"

#include <QDir>
#include <QFileInfo>

#include <utility>

namespace teleta::chrome {

QString RecentName::oneLine() const {
    return about.isEmpty() ? title : title + QStringLiteral(", ") + about;
}

QList<RecentName> recentNamesOf(const QStringList& paths, const RecentNames& known) {
    QList<RecentName> names;
    for (const QString& path : paths)
        names << known.value(path, {QFileInfo(path).fileName(), {}, {}});
    const auto tellApart = [&](const auto& more) {
        QStringList before;
        for (const RecentName& name : std::as_const(names))
            before << name.oneLine();
        for (qsizetype i = 0; i < names.size(); ++i)
            if (before.count(before[i]) > 1)
                more(names[i], QFileInfo(paths[i]));
    };
    tellApart([](RecentName& name, const QFileInfo& /*file*/) {
        if (!name.exact.isEmpty())
            name.about = name.exact;
    });
    tellApart([](RecentName& name, const QFileInfo& file) { name.title = file.fileName(); });
    tellApart([](RecentName& name, const QFileInfo& file) {
        name.title += QStringLiteral(" (%1)").arg(file.dir().dirName());
    });
    tellApart([](RecentName& name, const QFileInfo& file) { name.title = file.filePath(); });
    return names;
}

} // namespace teleta::chrome
