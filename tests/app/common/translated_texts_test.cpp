// SPDX-License-Identifier: GPL-3.0-or-later
// The translations hold every text that the sources have today, and none besides.
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QSet>
#include <QStringList>
#include <QTemporaryDir>
#include <QXmlStreamReader>

#include <gtest/gtest.h>

namespace teleta::app {
namespace {

const QString kSource = QStringLiteral(TELETA_SOURCE_DIR);
const QStringList kFiles{QStringLiteral("teleta_fr.ts"), QStringLiteral("teleta_ja.ts"),
                         QStringLiteral("teleta_zh_CN.ts")};

struct Message {
    QString context;
    QString source;
    QString comment;
    QStringList translations; ///< more than one: plural forms
    bool numbered = false;
    bool finished = true;
};

QList<Message> messagesOf(const QString& path) {
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << path.toStdString();
    QList<Message> messages;
    QXmlStreamReader xml(&file);
    QString context;
    Message message;
    while (!xml.atEnd()) {
        xml.readNext();
        if (xml.isEndElement() && xml.name() == QLatin1String("message"))
            messages.append(message);
        if (!xml.isStartElement())
            continue;
        if (xml.name() == QLatin1String("name")) {
            context = xml.readElementText();
        } else if (xml.name() == QLatin1String("message")) {
            message = {};
            message.context = context;
            message.numbered = xml.attributes().hasAttribute(QLatin1String("numerus"));
        } else if (xml.name() == QLatin1String("source")) {
            message.source = xml.readElementText();
        } else if (xml.name() == QLatin1String("comment")) {
            message.comment = xml.readElementText();
        } else if (xml.name() == QLatin1String("translation")) {
            message.finished = !xml.attributes().hasAttribute(QLatin1String("type"));
            if (!message.numbered)
                message.translations = {xml.readElementText()};
        } else if (xml.name() == QLatin1String("numerusform")) {
            message.translations.append(xml.readElementText());
        }
    }
    EXPECT_FALSE(xml.hasError()) << path.toStdString() << ": " << xml.errorString().toStdString();
    return messages;
}

QString keyOf(const Message& message) {
    return message.context + QLatin1String(": ") + message.source +
           (message.comment.isEmpty() ? QString() : QLatin1String(" / ") + message.comment);
}

QSet<QString> keysOf(const QList<Message>& messages) {
    QSet<QString> keys;
    for (const Message& message : messages)
        keys.insert(keyOf(message));
    return keys;
}

/// What a text and its translation have in common, in any order.
QStringList fixedParts(const QString& text, bool numbered) {
    static const QRegularExpression parts(
        QStringLiteral("%L?[1-9][0-9]?|%n|</?[a-zA-Z][^>]*>|\n|^ | $|(?<!&)&(?=[^& ])"));
    QStringList found;
    auto matches = parts.globalMatch(text);
    while (matches.hasNext()) {
        const QString part = matches.next().captured();
        // A form may say "one" in words.
        if (!numbered || part != QLatin1String("%n"))
            found << part;
    }
    found.sort();
    return found;
}

} // namespace

TEST(TranslatedTexts, holdWhatTheSourcesHoldToday) {
    const QTemporaryDir folder;
    QStringList arguments{
        QStringLiteral("-silent"), QStringLiteral("-no-obsolete"), QStringLiteral("-I"),
        QStringLiteral("."),       QStringLiteral("-extensions"),  QStringLiteral("cpp,h"),
        QStringLiteral("app"),     QStringLiteral("widgets"),      QStringLiteral("backend"),
        QStringLiteral("devices"), QStringLiteral("-ts")};
    for (const QString& file : kFiles) {
        const QString copy = folder.filePath(file);
        ASSERT_TRUE(QFile::copy(kSource + QStringLiteral("/translations/") + file, copy));
        arguments << copy;
    }
    QProcess lupdate;
    lupdate.setWorkingDirectory(kSource);
    lupdate.start(QStringLiteral(TELETA_LUPDATE), arguments);
    ASSERT_TRUE(lupdate.waitForFinished(120'000) && lupdate.exitCode() == 0)
        << lupdate.readAllStandardError().toStdString();
    for (const QString& file : kFiles) {
        const QList<Message> today = messagesOf(folder.filePath(file));
        ASSERT_GT(today.size(), 1000);
        for (const Message& message : today) {
            EXPECT_TRUE(message.finished) << file.toStdString() << " has to be translated (build the target "
                                          << "update_translations first): " << keyOf(message).toStdString();
        }
        const QSet<QString> kept =
            keysOf(messagesOf(kSource + QStringLiteral("/translations/") + file)) - keysOf(today);
        for (const QString& key : kept)
            ADD_FAILURE() << file.toStdString() << " has a text that is gone: " << key.toStdString();
    }
}

// lupdate takes the name of a class for the context where it does not see Q_DECLARE_TR_FUNCTIONS: such a text
// is never found.
TEST(TranslatedTexts, areInTheContextsThatTheProgramAsksFor) {
    QSet<QString> contexts;
    for (const Message& message : messagesOf(kSource + QStringLiteral("/translations/") + kFiles.front()))
        contexts.insert(message.context);
    static const QRegularExpression declared(QStringLiteral(
        "(?:struct|class)\\s+(\\w+)[^{;]*\\{\\s*(?:public:)?\\s*Q_DECLARE_TR_FUNCTIONS\\((\\w+)\\)"));
    int seen = 0;
    for (const char* folder : {"app", "backend", "devices", "widgets"}) {
        QDirIterator files(kSource + QLatin1Char('/') + QLatin1String(folder),
                           {QStringLiteral("*.cpp"), QStringLiteral("*.h")}, QDir::Files,
                           QDirIterator::Subdirectories);
        while (files.hasNext()) {
            QFile file(files.next());
            ASSERT_TRUE(file.open(QIODevice::ReadOnly));
            const QString text = QString::fromUtf8(file.readAll());
            for (auto found = declared.globalMatch(text); found.hasNext();) {
                const QRegularExpressionMatch match = found.next();
                ++seen;
                EXPECT_TRUE(match.captured(1) == match.captured(2) || !contexts.contains(match.captured(1)))
                    << file.fileName().toStdString() << ": " << match.captured(1).toStdString();
            }
        }
    }
    EXPECT_GT(seen, 100);
}

TEST(TranslatedTexts, keepPlacesTagsLinesAndMnemonics) {
    for (const QString& file : kFiles) {
        for (const Message& message : messagesOf(kSource + QStringLiteral("/translations/") + file)) {
            ASSERT_FALSE(message.translations.isEmpty()) << keyOf(message).toStdString();
            for (const QString& translation : message.translations)
                EXPECT_EQ(fixedParts(translation, message.numbered),
                          fixedParts(message.source, message.numbered))
                    << file.toStdString() << ": " << keyOf(message).toStdString() << " -> "
                    << translation.toStdString();
        }
    }
}

} // namespace teleta::app
