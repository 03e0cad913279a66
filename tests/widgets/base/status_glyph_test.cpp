// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/test_registry.h"
#include "widgets/base/controls/badge.h"
#include "widgets/base/controls/status_glyph.h"
#include "widgets/base/icons.h"
#include "widgets/base/theme.h"

#include <QImage>
#include <QPainter>
#include <QSet>
#include <QTest>

using namespace teleta::base;
using teleta::core::DeviceState;

namespace {

constexpr std::array kStates{DeviceState::closed,       DeviceState::connecting, DeviceState::live,
                             DeviceState::paused,       DeviceState::stale,      DeviceState::lost,
                             DeviceState::reconnecting, DeviceState::finished};

template <typename Paint>
QImage drawn(Paint&& paint) {
    QImage image(32, 32, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    paint(painter);
    return image;
}

/// What is left of a picture without its colours: where it is opaque and not light.
QByteArray shapeOf(const QImage& image) {
    QByteArray shape;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const QRgb pixel = image.pixel(x, y);
            shape += qAlpha(pixel) > 128 && qGray(pixel) < 235 ? '#' : ' ';
        }
    return shape;
}

} // namespace

class StatusGlyphTest : public QObject {
    Q_OBJECT
private slots:
    void everyStateHasItsOwnShapeAndWord() {
        QSet<QByteArray> shapes;
        QSet<QString> words;
        for (const DeviceState state : kStates) {
            const QByteArray shape = shapeOf(drawn([&](QPainter& painter) {
                paintStatusGlyph(painter, QRectF(0, 0, 32, 32), state, designedPalette(false));
            }));
            QVERIFY(shape.count('#') > 40);
            shapes.insert(shape);
            words.insert(statusWord(state));
        }
        QCOMPARE(shapes.size(), qsizetype(kStates.size()));
        QCOMPARE(words.size(), qsizetype(kStates.size()));
    }

    void liveIsGreenStaleIsAmberLostIsRed() {
        for (const bool dark : {false, true}) {
            const QPalette palette = designedPalette(dark);
            const int green = statusColour(DeviceState::live, palette).hslHue();
            const int amber = statusColour(DeviceState::stale, palette).hslHue();
            const int red = statusColour(DeviceState::lost, palette).hslHue();
            const int violet = statusColours(palette).simulated.hslHue();
            QVERIFY(green > 110 && green < 160);
            QVERIFY(amber > 30 && amber < 50);
            QVERIFY(red < 12 || red > 348);
            QVERIFY(violet > 260 && violet < 290);
        }
    }

    void theGlyphIsDrawnInTheColourOfItsState() {
        const QPalette palette = designedPalette(true);
        const QImage image = drawn([&](QPainter& painter) {
            paintStatusGlyph(painter, QRectF(0, 0, 32, 32), DeviceState::live, palette);
        });
        QCOMPARE(image.pixelColor(16, 16), statusColours(palette).live);
        QCOMPARE(qAlpha(image.pixel(1, 1)), 0);
    }

    void agesStayShort_data() {
        QTest::addColumn<double>("age_s");
        QTest::addColumn<QString>("text");
        QTest::newRow("fresh") << 0.04 << "0.0 s";
        QTest::newRow("tenths") << 3.26 << "3.3 s";
        QTest::newRow("never 10.0") << 9.96 << "9 s";
        QTest::newRow("seconds") << 12.7 << "12 s";
        QTest::newRow("minutes") << 300.0 << "5 min";
        QTest::newRow("hours") << 7300.0 << "2 h";
        QTest::newRow("a clock that ran back") << -1.0 << "0.0 s";
    }
    void agesStayShort() {
        QFETCH(double, age_s);
        QFETCH(QString, text);
        QCOMPARE(ageText(age_s), text);
    }

    void everyIconIsDrawnAndNoTwoAreAlike() {
        QSet<QByteArray> shapes;
        int icons = 0;
        for (int i = 0; i <= static_cast<int>(Icon::more); ++i, ++icons) {
            const QByteArray shape = shapeOf(drawn([i](QPainter& painter) {
                paintIcon(painter, QRectF(0, 0, 32, 32), static_cast<Icon>(i), Qt::black);
            }));
            QVERIFY2(shape.count('#') > 12, qPrintable(QString::number(i)));
            shapes.insert(shape);
        }
        QCOMPARE(shapes.size(), qsizetype(icons));
    }

    void iconsFollowThePalette() {
        for (const bool dark : {false, true}) {
            applyTheme(dark ? ThemeChoice::dark : ThemeChoice::light);
            const QImage image = themeIcon(Icon::play).pixmap(32, 32).toImage();
            const QColor centre = image.pixelColor(image.width() / 2, image.height() / 2);
            QCOMPARE(centre.rgb(), designedPalette(dark).color(QPalette::ButtonText).rgb());
        }
        applyTheme(ThemeChoice::light);
    }

    void onlyLiveDataHaveNoBadge() {
        QVERIFY(provenanceText(Provenance::live).isEmpty());
        QVERIFY(!provenanceText(Provenance::simulated).isEmpty());
        QVERIFY(provenanceText(Provenance::simulated) != provenanceText(Provenance::recorded));
    }
};

static const teleta::test::Registration<StatusGlyphTest> registration;

#include "status_glyph_test.moc"
