// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/help/about.h"

#include <QApplication>
#include <QDialog>
#include <QIcon>
#include <QImage>
#include <QLabel>
#include <QPixmap>
#include <QRegularExpression>
#include <QScreen>
#include <QScrollBar>
#include <QSet>
#include <QTableWidget>
#include <QTest>
#include <QTextDocument>

class AboutTest : public QObject {
    Q_OBJECT

private slots:
    void theShortcutsAreShownWhole() {
        QWidget window;
        window.show();
        teleta::console::openShortcuts(&window);
        const auto* dialog = window.findChild<QDialog*>();
        QVERIFY(dialog != nullptr);
        const auto* table = dialog->findChild<QTableWidget*>();
        QTRY_VERIFY(table->isVisible());
        QTRY_VERIFY(!table->horizontalScrollBar()->isVisible());
        const QSize screen = dialog->screen()->availableSize();
        QVERIFY(dialog->width() <= screen.width() && dialog->height() <= screen.height());
        QStringList keys;
        for (int row = 0; row < table->rowCount(); ++row)
            keys << table->item(row, 0)->text();
        for (const char* known : {"Ctrl+1 to 6", "F5, Shift+F5, Ctrl+F5", "Ctrl+Shift+M", "Ctrl+Shift+N",
                                  "Ctrl+Z, Ctrl+Y", "F11", "F1"})
            QVERIFY2(keys.contains(QLatin1String(known)), known);
        QCOMPARE(table->item(0, 0)->text(), "Everywhere");
        QCOMPARE(table->columnSpan(0, 0), 2);
        const auto cutRows = [table] {
            int cut = 0;
            for (int row = 0; row < table->rowCount(); ++row) {
                if (table->item(row, 1) == nullptr) // a heading
                    continue;
                const QRect room = table->visualItemRect(table->item(row, 1));
                const QRect text = table->fontMetrics().boundingRect(
                    QRect(0, 0, room.width(), 10'000), Qt::TextWordWrap, table->item(row, 1)->text());
                cut += room.height() < text.height() ? 1 : 0;
            }
            return cut;
        };
        QTRY_COMPARE(cutRows(), 0);
    }

    void aRowDoesNotSayItsHeadingAgain() {
        QWidget window;
        window.show();
        teleta::console::openShortcuts(&window);
        const auto* table = window.findChild<QTableWidget*>();
        QVERIFY(table != nullptr);
        const auto lastWord = [](const QString& text) {
            return text.section(QLatin1Char(' '), -1).toLower();
        };
        QString heading;
        QStringList said;
        QSet<QString> headings;
        for (int row = 0; row < table->rowCount(); ++row) {
            if (table->item(row, 1) == nullptr) {
                heading = table->item(row, 0)->text();
                QVERIFY2(!headings.contains(heading), qPrintable(heading));
                headings.insert(heading);
                continue;
            }
            // "in the timeline" and the like, under "In the timeline of a pattern".
            const QString effect = table->item(row, 1)->text();
            const QString place = effect.section(QStringLiteral(", "), -1);
            const bool isPlace =
                place.startsWith(QLatin1String("in the ")) || place.startsWith(QLatin1String("on the page "));
            if (isPlace && (heading.contains(lastWord(place), Qt::CaseInsensitive) ||
                            heading.startsWith(place, Qt::CaseInsensitive)))
                said << effect;
        }
        QVERIFY(headings.size() > 3);
        QCOMPARE(said, QStringList());
    }

    void namesEachLibraryWithItsVersionAndLicence() {
        QPixmap icon(64, 64);
        icon.fill(Qt::red);
        QApplication::setWindowIcon(QIcon(icon));
        QWidget window;
        window.show();
        teleta::console::openAbout(&window);
        const auto* dialog = window.findChild<QDialog*>();
        QVERIFY(dialog != nullptr);
        QTextDocument text;
        text.setHtml(dialog->findChild<QLabel*>("aboutText")->text());
        const QImage shown = dialog->findChild<QLabel*>("icon")->pixmap().toImage();
        QCOMPARE(shown.pixelColor(shown.rect().center()), QColor(Qt::red));
        const QString plain = text.toPlainText();
        for (const char* library :
             {"Qt", "VTK", "QCustomPlot", "Eigen", "OpenCV", "Boost", "hidapi", "libmodbus", "librsvg",
              "cairo", "libzip", "JSON for Modern C\\+\\+", "toml\\+\\+"}) {
            const QRegularExpression row(
                QStringLiteral("(^|\n)%1\n[0-9]+\\.[0-9]+(\\.[0-9]+)?\n[A-Z][A-Za-z]+")
                    .arg(QLatin1String(library)));
            QVERIFY2(row.match(plain).hasMatch(),
                     qPrintable(QLatin1String(library) + QLatin1Char('\n') + plain));
        }
    }
};

QTEST_MAIN(AboutTest)
#include "about_test.moc"
