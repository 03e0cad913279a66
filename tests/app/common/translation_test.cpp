// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/translation.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTranslator>
#include <QXmlStreamReader>

#include <gtest/gtest.h>

namespace teleta::app {
namespace {

const QString kSource = QStringLiteral(TELETA_SOURCE_DIR);

QStringList languagesOf(const QList<QLocale>& locales) {
    QStringList names;
    for (const QLocale& locale : locales)
        names.append(QStringLiteral("teleta_%1")
                         .arg(locale.language() == QLocale::Chinese
                                  ? locale.name()
                                  : QLocale::languageToCode(locale.language())));
    names.sort();
    return names;
}

struct Plural {
    QString context;
    QString source;
    QStringList forms;
    bool finished = false;
};

/// The plural messages of a .ts file.
QList<Plural> pluralsOf(QIODevice& ts) {
    QList<Plural> plurals;
    QXmlStreamReader xml(&ts);
    QString context;
    Plural message;
    while (!xml.atEnd()) {
        xml.readNext();
        const bool start = xml.isStartElement();
        if (start && xml.name() == QLatin1String("name"))
            context = xml.readElementText();
        else if (start && xml.name() == QLatin1String("source"))
            message = {context, xml.readElementText(), {}, false};
        else if (start && xml.name() == QLatin1String("translation"))
            message.finished = !xml.attributes().hasAttribute(QLatin1String("type"));
        else if (start && xml.name() == QLatin1String("numerusform"))
            message.forms.append(xml.readElementText());
        else if (xml.isEndElement() && xml.name() == QLatin1String("message") && !message.forms.isEmpty())
            plurals.append(message);
    }
    EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
    return plurals;
}

QStringList incompleteOnes(const QList<Plural>& plurals) {
    QStringList incomplete;
    for (const Plural& plural : plurals) {
        if (!plural.finished || plural.forms.size() != 2 || plural.forms.contains(QString()))
            incomplete.append(plural.source);
    }
    return incomplete;
}

class TranslationTest : public testing::Test {
protected:
    static int translatorsOf(const QCoreApplication& application) {
        return static_cast<int>(application.findChildren<QTranslator*>().size());
    }

    int m_argc = 1;
    char m_name[17] = "translation_test";
    char* m_argv[2] = {m_name, nullptr};
    QCoreApplication m_application{m_argc, m_argv};
};

TEST_F(TranslationTest, embedsOneFileForEveryLanguage) {
    QStringList names;
    for (const QString& file : QDir(QStringLiteral(":/i18n")).entryList(QDir::Files, QDir::Name))
        names.append(file.chopped(3));
    EXPECT_EQ(names, languagesOf(availableLocales()));
}

TEST_F(TranslationTest, installsTheLanguageThatWasAskedFor) {
    EXPECT_EQ(installTranslator(m_application, QLocale(QStringLiteral("ja_JP"))).language(),
              QLocale::Japanese);
    EXPECT_EQ(installTranslator(m_application, QLocale(QStringLiteral("fr_CA"))).language(), QLocale::French);
    EXPECT_EQ(installTranslator(m_application, QLocale(QStringLiteral("zh_CN"))).name(),
              QStringLiteral("zh_CN"));
}

TEST_F(TranslationTest, fallsBackToEnglish) {
    EXPECT_EQ(installTranslator(m_application, QLocale::c()).language(), QLocale::English);
    EXPECT_EQ(installTranslator(m_application, QLocale(QStringLiteral("sw_KE"))).language(),
              QLocale::English);
    EXPECT_EQ(installTranslator(m_application, QLocale(QStringLiteral("zh_TW"))).language(),
              QLocale::English);
}

TEST_F(TranslationTest, replacesTheLanguageInstalledBefore) {
    installTranslator(m_application, QLocale(QLocale::French));
    const int once = translatorsOf(m_application);
    installTranslator(m_application, QLocale(QLocale::Japanese));
    installTranslator(m_application, QLocale(QLocale::French));
    EXPECT_EQ(translatorsOf(m_application), once);
}

TEST_F(TranslationTest, countsInEnglish) {
    QFile ts(kSource + QStringLiteral("/translations/teleta_en.ts"));
    ASSERT_TRUE(ts.open(QIODevice::ReadOnly));
    const QList<Plural> plurals = pluralsOf(ts);
    ASSERT_FALSE(plurals.isEmpty());
    installTranslator(m_application, QLocale(QLocale::English));
    const auto count = [](const Plural& plural, int n) {
        return QCoreApplication::translate(plural.context.toUtf8().constData(),
                                           plural.source.toUtf8().constData(), nullptr, n);
    };
    for (const Plural& plural : plurals) {
        ASSERT_EQ(plural.forms.size(), 2);
        EXPECT_EQ(count(plural, 1),
                  QString(plural.forms[0]).replace(QLatin1String("%n"), QLatin1String("1")));
        EXPECT_EQ(count(plural, 2),
                  QString(plural.forms[1]).replace(QLatin1String("%n"), QLatin1String("2")));
        EXPECT_EQ(count(plural, 0),
                  QString(plural.forms[1]).replace(QLatin1String("%n"), QLatin1String("0")));
    }
}

TEST_F(TranslationTest, seesPluralsInServicesWithoutQObject) {
    const QTemporaryDir folder;
    QFile code(folder.filePath(QStringLiteral("service.cpp")));
    ASSERT_TRUE(code.open(QIODevice::WriteOnly));
    code.write("#include <QCoreApplication>\n"
               "QString f(int n) { return QCoreApplication::translate(\"Service\", \"%n frame(s)\", nullptr, "
               "n); }\n");
    code.close();
    QProcess lupdate;
    lupdate.setWorkingDirectory(folder.path());
    lupdate.start(QStringLiteral(TELETA_LUPDATE),
                  {QStringLiteral("-silent"), QStringLiteral("-pluralonly"), QStringLiteral("service.cpp"),
                   QStringLiteral("-ts"), QStringLiteral("new_en.ts")});
    ASSERT_TRUE(lupdate.waitForFinished() && lupdate.exitCode() == 0);
    QFile ts(folder.filePath(QStringLiteral("new_en.ts")));
    ASSERT_TRUE(ts.open(QIODevice::ReadOnly));
    EXPECT_EQ(incompleteOnes(pluralsOf(ts)), QStringList(QStringLiteral("%n frame(s)")));
}

TEST_F(TranslationTest, hasBothFormsOfEveryEnglishPlural) {
    const QTemporaryDir folder;
    const QString copy = folder.filePath(QStringLiteral("teleta_en.ts"));
    ASSERT_TRUE(QFile::copy(kSource + QStringLiteral("/translations/teleta_en.ts"), copy));
    QProcess lupdate;
    lupdate.setWorkingDirectory(kSource);
    lupdate.start(QStringLiteral(TELETA_LUPDATE),
                  {QStringLiteral("-silent"), QStringLiteral("-pluralonly"), QStringLiteral("-no-obsolete"),
                   QStringLiteral("-I"), QStringLiteral("."), QStringLiteral("-extensions"),
                   QStringLiteral("cpp,h"), QStringLiteral("app"), QStringLiteral("widgets"),
                   QStringLiteral("backend"), QStringLiteral("devices"), QStringLiteral("-ts"), copy});
    ASSERT_TRUE(lupdate.waitForFinished() && lupdate.exitCode() == 0)
        << lupdate.readAllStandardError().toStdString();
    QFile ts(copy);
    ASSERT_TRUE(ts.open(QIODevice::ReadOnly));
    const QStringList incomplete = incompleteOnes(pluralsOf(ts));
    EXPECT_TRUE(incomplete.isEmpty()) << "build the target update_translations and fill teleta_en.ts: "
                                      << incomplete.join(QStringLiteral("; ")).toStdString();
}

} // namespace
} // namespace teleta::app
