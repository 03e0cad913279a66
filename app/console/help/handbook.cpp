// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/help/handbook.h"

#include <QFile>

namespace teleta::console {

namespace {

QString firstHeading(const QString& text) {
    const QString line = text.section(QLatin1Char('\n'), 0, 0);
    return line.startsWith(QLatin1String("# ")) ? line.mid(2).trimmed() : line;
}

} // namespace

const QStringList& handbookGuide() {
    static const QStringList pages{
        QStringLiteral("first-steps"),   QStringLiteral("operate"),   QStringLiteral("teleoperation"),
        QStringLiteral("arm-over-ros2"), QStringLiteral("two-sites"), QStringLiteral("devices"),
        QStringLiteral("recordings"),    QStringLiteral("plot"),      QStringLiteral("patterns"),
        QStringLiteral("study"),         QStringLiteral("calibrate"), QStringLiteral("cost"),
        QStringLiteral("sweeps")};
    return pages;
}

const QStringList& handbookReference() {
    static const QStringList pages{QStringLiteral("files"),        QStringLiteral("codebook"),
                                   QStringLiteral("intervals"),    QStringLiteral("thresholds"),
                                   QStringLiteral("command-line"), QStringLiteral("python")};
    return pages;
}

QStringList handbookPages() {
    return handbookGuide() + handbookReference();
}

std::optional<HandbookPage> handbookPage(const QString& name, const QString& language) {
    for (const QString& folder : {language, language.section(QLatin1Char('_'), 0, 0), QStringLiteral("en")}) {
        QFile file(QStringLiteral(":/handbook/%1/%2.md").arg(folder, name));
        if (folder.isEmpty() || !file.open(QIODevice::ReadOnly))
            continue;
        const QString text = QString::fromUtf8(file.readAll());
        return HandbookPage{name, firstHeading(text), text};
    }
    return std::nullopt;
}

} // namespace teleta::console
