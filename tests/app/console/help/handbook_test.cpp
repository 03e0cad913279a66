// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/translation.h"
#include "app/console/console_options.h"
#include "app/console/help/handbook.h"
#include "app/console/help/handbook_window.h"

#include <QAbstractTextDocumentLayout>
#include <QDir>
#include <QFile>
#include <QImage>
#include <QLineEdit>
#include <QListWidget>
#include <QRegularExpression>
#include <QTest>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextDocument>

using namespace teleta::console;

namespace {

const QStringList kLanguages{"en", "fr", "ja", "zh_CN"};

QStringList matches(const QString& text, const char* pattern) {
    QStringList found;
    QRegularExpressionMatchIterator each =
        QRegularExpression(QString::fromLatin1(pattern), QRegularExpression::MultilineOption)
            .globalMatch(text);
    while (each.hasNext())
        found << each.next().captured(1);
    return found;
}

} // namespace

class HandbookTest : public QObject {
    Q_OBJECT

private slots:
    void cleanup() { teleta::app::installTranslator(*QCoreApplication::instance(), QLocale("en")); }

    void hasAPageForEachPageOfTheConsole() {
        for (const QString& page : pageNames())
            QVERIFY2(handbookPages().contains(page), qPrintable(page));
    }

    void hasEveryPageInEveryLanguage_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("language");
        for (const QString& name : handbookPages())
            for (const QString& language : kLanguages)
                QTest::addRow("%s, %s", qPrintable(name), qPrintable(language)) << name << language;
    }
    void hasEveryPageInEveryLanguage() {
        QFETCH(QString, name);
        QFETCH(QString, language);
        QFile file(QStringLiteral(":/handbook/%1/%2.md").arg(language, name));
        QVERIFY2(file.open(QIODevice::ReadOnly), "the page is not there");
        const auto page = handbookPage(name, language);
        QVERIFY(page.has_value());
        QCOMPARE(page->text.toUtf8(), file.readAll());
        QVERIFY(page->text.startsWith("# "));
        QVERIFY(!page->title.isEmpty());
        const auto english = handbookPage(name, "en");
        if (language != "en")
            QVERIFY2(page->title != english->title || page->text != english->text, "it is not translated");
        // The same parts, links, keys, commands and rows of tables.
        for (const char* part : {"^(#+) ", "\\]\\(([^)]*)\\)", "^    (.*)$", "^(\\|)", "^([-0-9]+\\.?) "}) {
            QStringList here = matches(page->text, part);
            QStringList there = matches(english->text, part);
            if (QLatin1String(part) == QLatin1String("\\]\\(([^)]*)\\)")) {
                here.sort();
                there.sort();
            }
            QCOMPARE(here, there);
        }
        QStringList keys = matches(page->text, "`([^`]*)`");
        QStringList englishKeys = matches(english->text, "`([^`]*)`");
        keys.sort();
        englishKeys.sort();
        QCOMPARE(keys, englishKeys);
    }

    void linksLeadToPages() {
        for (const QString& name : handbookPages())
            for (const QString& link :
                 matches(handbookPage(name, "en")->text, "(?<!!)\\[[^\\]]*\\]\\(([^)]*)\\)"))
                QVERIFY2(link.endsWith(".md") && handbookPages().contains(link.chopped(3)), qPrintable(link));
    }

    void showsItsPictures() {
        int shown = 0;
        HandbookWindow window(nullptr);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        QTextDocument* const document = window.findChild<QTextBrowser*>()->document();
        for (const QString& name : handbookPages()) {
            const QStringList pictures =
                matches(handbookPage(name, "en")->text, "!\\[[^\\]]+\\]\\(([^)]*)\\)");
            if (pictures.isEmpty())
                continue;
            window.showPage(name);
            for (const QString& picture : pictures) {
                const auto image =
                    document->resource(QTextDocument::ImageResource, QUrl(picture)).value<QImage>();
                QVERIFY2(image.width() > 100, qPrintable(picture));
                ++shown;
            }
            // Below a picture is no more room than between lines of text.
            for (QTextBlock block = document->begin(); block.isValid(); block = block.next()) {
                if (block.begin().atEnd() || !block.begin().fragment().charFormat().isImageFormat())
                    continue;
                const QTextImageFormat format = block.begin().fragment().charFormat().toImageFormat();
                const auto image =
                    document->resource(QTextDocument::ImageResource, QUrl(format.name())).value<QImage>();
                const double height = document->documentLayout()->blockBoundingRect(block).height();
                QVERIFY2(height < image.deviceIndependentSize().height() + 60.0, qPrintable(format.name()));
            }
        }
        QCOMPARE(shown, static_cast<int>(QDir(":/handbook/pictures").entryList(QDir::Files).size()));
        QVERIFY(shown > 0);
    }

    void anUnknownLanguageIsEnglishAndAnUnknownPageIsNone() {
        QCOMPARE(handbookPage("operate", "de_DE")->text, handbookPage("operate", "en")->text);
        QCOMPARE(handbookPage("operate", "fr_CA")->text, handbookPage("operate", "fr")->text);
        QVERIFY(!handbookPage("nowhere", "en").has_value());
        QVERIFY(!handbookPage("../scenes/teleta-touch", "en").has_value());
    }

    void everyOptionThatItNamesIsOneOfThePrograms() {
        const QString help = parseOptions({"teleta-console", "--help"}).text;
        for (const QString& name : handbookPages())
            for (const QString& code : matches(handbookPage(name, "en")->text, "`(teleta-console [^`]*)`"))
                for (const QString& option : matches(code, "(--[a-z-]+)"))
                    QVERIFY2(help.contains(option), qPrintable(code));
    }

    void goesFromPageToPageAndBack() {
        HandbookWindow window(nullptr);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        window.showPage("patterns");
        QCOMPARE(window.page(), "patterns");
        auto* list = window.findChild<QListWidget*>();
        auto* text = window.findChild<QTextBrowser*>();
        QCOMPARE(list->count(), handbookPages().size() + 2);
        QCOMPARE(list->item(0)->text(), "Guide");
        QVERIFY(!(list->item(0)->flags() & Qt::ItemIsSelectable));
        QCOMPARE(list->currentItem()->text(), handbookPage("patterns", "en")->title);
        QVERIFY(text->toPlainText().startsWith(handbookPage("patterns", "en")->title));
        list->setFocus();
        QTest::keyClick(list, Qt::Key_Down);
        QCOMPARE(window.page(), "study");
        QTest::keyClick(&window, Qt::Key_Left, Qt::AltModifier);
        QCOMPARE(window.page(), "patterns");
        // Its link is followed.
        text->setSource(QUrl("calibrate.md"));
        QCOMPARE(list->currentItem()->text(), handbookPage("calibrate", "en")->title);
        // The heading of the reference is no page.
        window.showPage(handbookGuide().back());
        list->setFocus();
        QTest::keyClick(list, Qt::Key_Down);
        QCOMPARE(window.page(), handbookReference().front());
        window.showPage("no such page");
        QCOMPARE(window.page(), handbookPages().front());
        QTest::keyClick(&window, Qt::Key_Escape);
        QVERIFY(!window.isVisible());
    }

    void findsInAllPages() {
        HandbookWindow window(nullptr);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        window.showPage("first-steps");
        QTest::keyClick(&window, Qt::Key_F, Qt::ControlModifier);
        auto* field = window.findChild<QLineEdit*>();
        QTest::keyClicks(field, "dialout");
        QTest::keyClick(field, Qt::Key_Return);
        QCOMPARE(window.page(), "devices");
        auto* text = window.findChild<QTextBrowser*>();
        QCOMPARE(text->textCursor().selectedText(), "dialout");
        field->clear();
        QTest::keyClicks(field, "zebra");
        QTest::keyClick(field, Qt::Key_Return);
        QCOMPARE(window.page(), "devices");
    }

    void followsTheLanguage() {
        HandbookWindow window(nullptr);
        window.showPage("study");
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        for (const QString& language : kLanguages) {
            teleta::app::installTranslator(*QCoreApplication::instance(), QLocale(language));
            QTRY_COMPARE(window.findChild<QListWidget*>()->currentItem()->text(),
                         handbookPage("study", language)->title);
            QVERIFY(window.findChild<QTextBrowser*>()->toPlainText().startsWith(
                handbookPage("study", language)->title));
        }
    }
};

QTEST_MAIN(HandbookTest)
#include "handbook_test.moc"
