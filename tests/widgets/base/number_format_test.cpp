// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/test_registry.h"
#include "widgets/base/numbers/moment_unit.h"
#include "widgets/base/numbers/number_format.h"
#include "widgets/base/numbers/steady_estimate.h"
#include "widgets/base/numbers/tabular_text.h"

#include <QApplication>
#include <QImage>
#include <QLocale>
#include <QPainter>
#include <QTest>

#include <cmath>
#include <limits>

using namespace teleta::base;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Reads figure spaces as spaces, so that expectations stay legible.
QString plain(QString text) {
    return text.replace(QChar(0x2007), u' ').replace(QChar(0x2212), u'-').replace(QChar(0x00a0), u' ');
}

} // namespace

class NumberFormatTest : public QObject {
    Q_OBJECT
private slots:
    void threeSignificantDigitsInAFixedWidth_data() {
        QTest::addColumn<double>("value");
        QTest::addColumn<QString>("text");
        QTest::newRow("zero") << 0.0 << " 0.00";
        QTest::newRow("small") << 0.0512 << " 0.05";
        QTest::newRow("unit") << 1.234 << " 1.23";
        QTest::newRow("ten") << 12.34 << " 12.3";
        QTest::newRow("hundred") << 123.4 << "  123";
        QTest::newRow("thousand") << 1234.4 << " 1234";
        QTest::newRow("negative") << -12.34 << "-12.3";
        QTest::newRow("rounds into the next decade") << 9.996 << " 10.0";
        QTest::newRow("rounds into the next decade again") << 99.96 << "  100";
        QTest::newRow("no minus on zero") << -0.001 << " 0.00";
        QTest::newRow("infinity") << kInfinity << QStringLiteral("    \u221e");
        QTest::newRow("minus infinity") << -kInfinity << QStringLiteral("   -\u221e");
        QTest::newRow("not a number") << kNaN << QStringLiteral("    \u2014");
    }
    void threeSignificantDigitsInAFixedWidth() {
        QFETCH(double, value);
        QFETCH(QString, text);
        QCOMPARE(plain(threeDigits(value)), text);
        QCOMPARE(threeDigits(value).size(), qsizetype(kNumberWidth));
    }

    void undefinedIsADashAndNeverZero() {
        QCOMPARE(plain(threeDigits(std::nullopt)), QStringLiteral("    \u2014"));
        QCOMPARE(plain(wholeNumber(kNaN)), QStringLiteral("    \u2014"));
        QVERIFY(!siQuantity(std::nullopt, QStringLiteral("N")).contains(u'0'));
    }

    void theDecimalSignIsTheUsers() {
        QLocale::setDefault(QLocale(QLocale::French));
        const QString text = plain(threeDigits(1.234));
        QLocale::setDefault(QLocale::c());
        QCOMPARE(text, QStringLiteral(" 1,23"));
    }

    void siPrefixesKeepThreeDigits_data() {
        QTest::addColumn<double>("value");
        QTest::addColumn<QString>("text");
        QTest::newRow("milli") << 0.01234 << " 12.3 mN";
        QTest::newRow("none") << 2.0 << " 2.00  N";
        QTest::newRow("kilo") << 8562.9 << " 8.56 kN";
        QTest::newRow("rounds up a prefix") << 999.7 << " 1.00 kN";
        QTest::newRow("negative micro") << -3.3e-6 << QStringLiteral("-3.30 \u00b5N");
        QTest::newRow("zero") << 0.0 << " 0.00  N";
        QTest::newRow("below the smallest prefix") << 1e-15 << " 0.00 pN";
    }
    void siPrefixesKeepThreeDigits() {
        QFETCH(double, value);
        QFETCH(QString, text);
        QCOMPARE(plain(siQuantity(value, QStringLiteral("N"))), text);
    }

    void unitsStandBehindASpaceAndDegreesDoNot() {
        QCOMPARE(plain(withUnit(QStringLiteral("5"), QStringLiteral("mm"))), QStringLiteral("5 mm"));
        QCOMPARE(withUnit(QStringLiteral("5"), QStringLiteral("\u00b0")), QStringLiteral("5\u00b0"));
        QCOMPARE(withUnit(QStringLiteral("5"), QString()), QStringLiteral("5"));
    }

    void countsNeverClaimMore_data() {
        QTest::addColumn<quint64>("count");
        QTest::addColumn<QString>("text");
        QTest::newRow("zero") << quint64(0) << "0";
        QTest::newRow("999") << quint64(999) << "999";
        QTest::newRow("1230") << quint64(1230) << "1.23 k";
        QTest::newRow("1239") << quint64(1239) << "1.23 k";
        QTest::newRow("999999") << quint64(999999) << "999 k";
        QTest::newRow("45.6 million") << quint64(45'678'901) << "45.6 M";
    }
    void countsNeverClaimMore() {
        QFETCH(quint64, count);
        QFETCH(QString, text);
        QCOMPARE(plain(shortCount(count)), text);
    }

    void aValueThatMovesLessThanItsStepDoesNotFlicker() {
        SteadyNumber number;
        QVERIFY(number.update(1.2349));
        QCOMPARE(plain(number.text()), QStringLiteral(" 1.23"));
        for (const double value : {1.2351, 1.2399, 1.2249, 1.2201, 1.236})
            QVERIFY(!number.update(value));
        QVERIFY(number.update(1.2401));
        QCOMPARE(plain(number.text()), QStringLiteral(" 1.24"));
    }

    void aSlowDriftIsFollowed() {
        SteadyNumber number;
        for (int i = 0; i <= 1000; ++i)
            number.update(0.001 * i);
        QVERIFY(std::abs(*number.shown() - 1.0) <= 0.01);
    }

    void becomingUndefinedIsAChange() {
        SteadyNumber number;
        QVERIFY(!number.update(std::nullopt));
        QVERIFY(number.update(1.0));
        QVERIFY(number.update(kNaN));
        QVERIFY(!number.shown());
        QVERIFY(!number.update(std::nullopt));
    }

    void aRateIsShownInWholeNumbers() {
        SteadyNumber rate(1.0);
        rate.update(199.7);
        QCOMPARE(plain(rate.text()), QStringLiteral("  200"));
        QVERIFY(!rate.update(200.9));
        QVERIFY(!rate.update(199.2));
        QVERIFY(rate.update(198.9));
    }

    void anEstimateHasTheDecimalsOfItsError_data() {
        QTest::addColumn<double>("value");
        QTest::addColumn<double>("error");
        QTest::addColumn<QString>("text");
        QTest::newRow("usual") << 1.2346 << 0.0512 << "1.235 \u00b1 0.051";
        QTest::newRow("small") << 0.01234 << 0.0012 << "0.0123 \u00b1 0.0012";
        QTest::newRow("rounds up") << -1.2 << 0.0996 << "-1.20 \u00b1 0.10";
        QTest::newRow("one") << 12.34 << 1.04 << " 12.3 \u00b1 1.0";
        QTest::newRow("large") << 1234.0 << 150.4 << " 1234 \u00b1 150";
        QTest::newRow("no error") << 1.5 << 0.0 << " 1.50";
        QTest::newRow("unknown error") << 1.5 << kNaN << " 1.50";
        QTest::newRow("undefined") << kNaN << 0.1 << "    \u2014";
        QTest::newRow("infinite") << kInfinity << 0.1 << "    \u2014";
    }
    void anEstimateHasTheDecimalsOfItsError() {
        QFETCH(double, value);
        QFETCH(double, error);
        QFETCH(QString, text);
        SteadyEstimate estimate;
        estimate.update(value, error);
        QCOMPARE(plain(estimate.text()), text);
    }

    void anEstimateThatMovesLessThanAStepDoesNotFlicker() {
        SteadyEstimate estimate;
        estimate.update(1.25, 0.050);
        estimate.update(1.2508, 0.0508);
        QCOMPARE(plain(estimate.text()), QStringLiteral("1.250 \u00b1 0.050"));
        estimate.update(1.2512, 0.0512);
        QCOMPARE(plain(estimate.text()), QStringLiteral("1.251 \u00b1 0.051"));
        estimate.update(1.2512, 0.51);
        QCOMPARE(plain(estimate.text()), QStringLiteral(" 1.25 \u00b1 0.51"));
    }

    void momentsBelowOneNewtonmetreHaveTheSmallerUnit() {
        QCOMPARE(momentUnit(0.999).name, QStringLiteral("mNm"));
        QCOMPARE(momentUnit(0.999).perNm, 1e3);
        QCOMPARE(momentUnit(1.0).name, QStringLiteral("Nm"));
        QCOMPARE(momentUnit(kNaN).name, QStringLiteral("mNm"));
    }

    void figureSpacesTakeTheRoomOfADigit() {
        const QFontMetricsF metrics(QApplication::font());
        QCOMPARE(tabularWidth(metrics, QString(QChar(0x2007)) + QStringLiteral("123")),
                 tabularWidth(metrics, QStringLiteral("8888")));
        QCOMPARE(tabularWidth(metrics, QStringLiteral("1.11")),
                 tabularWidth(metrics, QStringLiteral("8.88")));
    }

    void tabularTextEndsAtTheRightEdge() {
        QImage image(200, 40, QImage::Format_ARGB32_Premultiplied);
        image.fill(Qt::white);
        QPainter painter(&image);
        painter.setPen(Qt::black);
        drawTabularText(painter, QRectF(0, 0, 180, 40), Qt::AlignRight | Qt::AlignVCenter, threeDigits(8.88));
        painter.end();
        int right = -1;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                if (qGray(image.pixel(x, y)) < 128)
                    right = std::max(right, x);
        QVERIFY2(right > 172 && right < 180, qPrintable(QString::number(right)));
    }
};

static const teleta::test::Registration<NumberFormatTest> registration;

#include "number_format_test.moc"
