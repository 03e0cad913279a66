// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/test_registry.h"
#include "widgets/base/console_style.h"
#include "widgets/base/theme.h"

#include <QApplication>
#include <QCheckBox>
#include <QImage>
#include <QPainter>
#include <QRadioButton>
#include <QStyle>
#include <QStyleOptionButton>
#include <QTest>
#include <QWidget>

using namespace teleta::base;

class ThemeTest : public QObject {
    Q_OBJECT
private slots:
    void cleanup() { applyTheme(ThemeChoice::light); }

    /// Ratios of WCAG 2.1: black on white is 21:1, and #767676 is the lightest grey with 4.5:1 on white.
    void contrastIsTheOneOfWcag() {
        QCOMPARE(contrast(Qt::black, Qt::white), 21.0);
        QCOMPARE(contrast(Qt::white, Qt::white), 1.0);
        QVERIFY(contrast(QColor("#767676"), Qt::white) >= 4.5);
        QVERIFY(contrast(QColor("#777777"), Qt::white) < 4.5);
    }

    void textReadsOnEveryGround_data() {
        QTest::addColumn<bool>("dark");
        QTest::newRow("light") << false;
        QTest::newRow("dark") << true;
    }
    void textReadsOnEveryGround() {
        QFETCH(bool, dark);
        const QPalette palette = designedPalette(dark);
        QCOMPARE(isDark(palette), dark);
        const auto reads = [&](QPalette::ColorRole text, QPalette::ColorRole ground, double least) {
            const double ratio = contrast(palette.color(text), palette.color(ground));
            QVERIFY2(ratio >= least,
                     qPrintable(QStringLiteral("roles %1 on %2: %3").arg(text).arg(ground).arg(ratio)));
        };
        reads(QPalette::WindowText, QPalette::Window, 10.0);
        reads(QPalette::Text, QPalette::Base, 10.0);
        reads(QPalette::Text, QPalette::AlternateBase, 10.0);
        reads(QPalette::ButtonText, QPalette::Button, 9.0);
        reads(QPalette::HighlightedText, QPalette::Highlight, 4.5);
        reads(QPalette::ToolTipText, QPalette::ToolTipBase, 9.0);
        reads(QPalette::PlaceholderText, QPalette::Base, 4.5);
        reads(QPalette::Link, QPalette::Base, 4.5);
        reads(QPalette::Highlight, QPalette::Base, 3.0);
    }

    void statusColoursCarryText_data() { textReadsOnEveryGround_data(); }
    void statusColoursCarryText() {
        QFETCH(bool, dark);
        const QPalette palette = designedPalette(dark);
        const StatusColours& colours = statusColours(palette);
        for (const QColor& colour : {colours.live, colours.stale, colours.lost, colours.simulated,
                                     colours.recorded, colours.neutral})
            for (const auto ground : {QPalette::Window, QPalette::Base})
                QVERIFY2(contrast(colour, palette.color(ground)) >= 4.5, qPrintable(colour.name()));
        QVERIFY(contrast(Qt::white, colours.stop) >= 4.5);
    }

    void applyingAThemeReachesEveryWidget() {
        QWidget widget;
        widget.show();
        applyTheme(ThemeChoice::dark);
        QTRY_VERIFY(isDark(widget.palette()));
        QVERIFY(qobject_cast<ConsoleStyle*>(QApplication::style()) != nullptr);
        applyTheme(ThemeChoice::light);
        QTRY_VERIFY(!isDark(widget.palette()));
    }

    void boxesThatCanBeCheckedAreSeen_data() { textReadsOnEveryGround_data(); }
    /// WCAG 2.1, 1.4.11: the edge of a control has a contrast of 3 at least to what is around it.
    void boxesThatCanBeCheckedAreSeen() {
        QFETCH(bool, dark);
        applyTheme(dark ? ThemeChoice::dark : ThemeChoice::light);
        const QCheckBox box;
        const QRadioButton button;
        for (const QWidget* control :
             {static_cast<const QWidget*>(&box), static_cast<const QWidget*>(&button)}) {
            QStyleOptionButton option;
            option.initFrom(control);
            option.state |= QStyle::State_Off;
            option.rect = QRect(0, 0, 14, 14);
            QImage image(14, 14, QImage::Format_RGB32);
            const QColor ground = control->palette().color(QPalette::Window);
            image.fill(ground);
            QPainter painter(&image);
            control->style()->drawPrimitive(control == &box ? QStyle::PE_IndicatorCheckBox
                                                            : QStyle::PE_IndicatorRadioButton,
                                            &option, &painter, control);
            painter.end();
            // The middle of each side lies on the edge.
            for (const QPoint at : {QPoint(7, 0), QPoint(0, 7), QPoint(13, 7), QPoint(7, 13)})
                QVERIFY2(contrast(image.pixelColor(at), ground) >= 3.0,
                         qPrintable(image.pixelColor(at).name() + QLatin1Char('/') + ground.name()));
        }
    }

    void theSystemThemeIsOneOfTheTwoDesignedOnes() {
        applyTheme(ThemeChoice::system);
        const QColor window = QApplication::palette().color(QPalette::Window);
        QVERIFY(window == designedPalette(false).color(QPalette::Window) ||
                window == designedPalette(true).color(QPalette::Window));
    }

    void lengthsFollowTheFont() {
        QWidget widget;
        QFont font = widget.font();
        font.setPointSizeF(10.0);
        widget.setFont(font);
        const int normal = em(&widget, 10.0);
        QCOMPARE(grid(&widget, 20.0), normal);
        font.setPointSizeF(20.0);
        widget.setFont(font);
        QVERIFY(std::abs(em(&widget, 10.0) - 2 * normal) <= 12); // hinting rounds the line height
    }

    void sizedTextKeepsPointsOrPixels() {
        QFont points;
        points.setPointSizeF(10.0);
        QCOMPARE(sized(points, kLargeText).pointSizeF(), 15.0);
        QFont pixels;
        pixels.setPixelSize(20);
        QCOMPARE(sized(pixels, kSmallText).pixelSize(), 17);
    }

    void textOnAColourIsTheReadableOne() {
        QCOMPARE(readableOn(QColor("#fee838")), QColor(Qt::black));
        QCOMPARE(readableOn(QColor("#00224e")), QColor(Qt::white));
    }
};

static const teleta::test::Registration<ThemeTest> registration;

#include "theme_test.moc"
