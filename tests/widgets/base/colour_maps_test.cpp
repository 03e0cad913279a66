// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/test_registry.h"
#include "widgets/base/colour_maps.h"
#include "widgets/base/theme.h"

#include <QTest>

#include <array>
#include <cmath>
#include <limits>

using namespace teleta::base;

namespace {

using Vector = std::array<double, 3>;
using Matrix = std::array<Vector, 3>;

Vector linearOf(const QColor& colour) {
    const auto linear = [](double v) {
        return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    };
    return {linear(colour.redF()), linear(colour.greenF()), linear(colour.blueF())};
}

Vector labOf(const Vector& rgb) {
    const auto f = [](double t) {
        return t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0;
    };
    const double x = 0.4124564 * rgb[0] + 0.3575761 * rgb[1] + 0.1804375 * rgb[2];
    const double y = 0.2126729 * rgb[0] + 0.7151522 * rgb[1] + 0.0721750 * rgb[2];
    const double z = 0.0193339 * rgb[0] + 0.1191920 * rgb[1] + 0.9503041 * rgb[2];
    return {116.0 * f(y) - 16.0, 500.0 * (f(x / 0.95047) - f(y)), 200.0 * (f(y) - f(z / 1.08883))};
}

double distance(const Vector& a, const Vector& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// Full colour blindness after Machado, Oliveira, Fernandes (2009), on linear RGB.
constexpr std::array<Matrix, 4> kVisions{{
    {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
    {{{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}},
    {{{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}},
    {{{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}}},
}};

Vector seenBy(const Matrix& vision, const Vector& rgb) {
    Vector seen{};
    for (std::size_t i = 0; i < 3; ++i)
        seen[i] = std::clamp(vision[i][0] * rgb[0] + vision[i][1] * rgb[1] + vision[i][2] * rgb[2], 0.0, 1.0);
    return seen;
}

} // namespace

class ColourMapsTest : public QObject {
    Q_OBJECT
private slots:
    /// Values of matplotlib 3.6.3, colormaps['cividis'].
    void cividisIsThePublishedMap() {
        QCOMPARE(cividis()[0], qRgb(0, 34, 78));
        QCOMPARE(cividis()[64], qRgb(67, 78, 108));
        QCOMPARE(cividis()[128], qRgb(125, 124, 120));
        QCOMPARE(cividis()[192], qRgb(188, 174, 108));
        QCOMPARE(cividis()[255], qRgb(254, 232, 56));
    }

    void cividisGrowsLighterInEvenSteps() {
        double smallest = 100.0, largest = 0.0;
        for (std::size_t i = 8; i < cividis().size(); i += 8) {
            const double step =
                labOf(linearOf(QColor(cividis()[i])))[0] - labOf(linearOf(QColor(cividis()[i - 8])))[0];
            smallest = std::min(smallest, step);
            largest = std::max(largest, step);
        }
        QVERIFY2(smallest > 1.0, qPrintable(QString::number(smallest)));
        QVERIFY2(largest < 4.0, qPrintable(QString::number(largest)));
    }

    /// Values of matplotlib 3.6.3, colormaps['coolwarm'], which is Moreland's table: at 0, 1/4, 1/2, 3/4, 1.
    void divergingIsTheOneOfMoreland() {
        const std::array<Vector, 5> published{{{0.2298057, 0.298717966, 0.753683153},
                                               {0.552953156, 0.688929332, 0.995375608},
                                               {0.865395197, 0.86541021, 0.865395561},
                                               {0.958003065, 0.602842431, 0.481775914},
                                               {0.705673158, 0.01555616, 0.150232812}}};
        for (std::size_t k = 0; k < published.size(); ++k) {
            const double position = 0.25 * static_cast<double>(k) * (kMapEntries - 1);
            const auto below = static_cast<std::size_t>(position);
            const auto above = std::min<std::size_t>(below + 1, kMapEntries - 1);
            const QColor colour = mixed(QColor(diverging()[below]), QColor(diverging()[above]),
                                        position - static_cast<double>(below));
            const Vector ours{colour.redF(), colour.greenF(), colour.blueF()};
            for (std::size_t c = 0; c < 3; ++c)
                QVERIFY2(
                    std::abs(ours[c] - published[k][c]) < 0.01,
                    qPrintable(QStringLiteral("quarter %1 component %2: %3").arg(k).arg(c).arg(ours[c])));
        }
    }

    void sharesOutsideTheMapAreClamped() {
        QCOMPARE(colourAt(cividis(), -3.0), cividis().front());
        QCOMPARE(colourAt(cividis(), 7.0), cividis().back());
        QCOMPARE(colourAt(cividis(), std::numeric_limits<double>::quiet_NaN()), cividis().front());
        QCOMPARE(colourAt(cividis(), 0.5), cividis()[128]);
    }

    /// A difference of 15 in CIELAB is told apart at a glance; 2.3 is the smallest that is seen at all.
    void identitiesKeepApartForEveryVision_data() {
        QTest::addColumn<bool>("onDark");
        QTest::newRow("light") << false;
        QTest::newRow("dark") << true;
    }
    void identitiesKeepApartForEveryVision() {
        QFETCH(bool, onDark);
        for (std::size_t v = 0; v < kVisions.size(); ++v)
            for (int i = 1; i <= kIdentityColours; ++i)
                for (int j = i + 1; j <= kIdentityColours; ++j) {
                    const double apart =
                        distance(labOf(seenBy(kVisions[v], linearOf(identityColour(i, onDark)))),
                                 labOf(seenBy(kVisions[v], linearOf(identityColour(j, onDark)))));
                    QVERIFY2(apart > 15.0, qPrintable(QStringLiteral("vision %1, identities %2 and %3: %4")
                                                          .arg(v)
                                                          .arg(i)
                                                          .arg(j)
                                                          .arg(apart)));
                }
    }

    void identitiesReadOnTheirBackground() {
        for (int i = 1; i <= kIdentityColours; ++i) {
            QVERIFY(contrast(identityColour(i, false), designedPalette(false).color(QPalette::Base)) >= 2.9);
            QVERIFY(contrast(identityColour(i, true), designedPalette(true).color(QPalette::Base)) >= 4.0);
        }
    }

    void theNinthIdentityStartsAgain() {
        QCOMPARE(identityColour(9, false), identityColour(1, false));
        QVERIFY(identityColour(0, false).isValid());
        QCOMPARE(identityColour(-7, true), identityColour(1, true));
    }
};

static const teleta::test::Registration<ColourMapsTest> registration;

#include "colour_maps_test.moc"
