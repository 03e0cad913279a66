// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/help/about.h"

#include <QDialog>
#include <QLabel>
#include <QRegularExpression>
#include <QTest>
#include <QTextDocument>

class AboutTest : public QObject {
    Q_OBJECT

private slots:
    void namesEachLibraryWithItsVersionAndLicence() {
        QWidget window;
        window.show();
        teleta::console::openAbout(&window);
        const auto* dialog = window.findChild<QDialog*>();
        QVERIFY(dialog != nullptr);
        QTextDocument text;
        text.setHtml(dialog->findChild<QLabel*>()->text());
        const QString plain = text.toPlainText();
        for (const char* library :
             {"Qt", "VTK", "QCustomPlot", "Eigen", "OpenCV", "Ceres Solver", "Boost", "hidapi", "libmodbus",
              "librsvg", "cairo", "libzip", "JSON for Modern C\\+\\+", "toml\\+\\+"}) {
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
