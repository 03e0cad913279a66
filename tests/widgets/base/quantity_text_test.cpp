// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/test_registry.h"
#include "widgets/base/numbers/quantity_text.h"

#include <QLocale>
#include <QTest>

#include <limits>

using namespace teleta;
using namespace teleta::base;

/// Numbers in columns, sentences and files.
class QuantityTextTest : public QObject {
    Q_OBJECT

private slots:
    void init() { QLocale::setDefault(QLocale::c()); }
    void cleanup() { QLocale::setDefault(QLocale::c()); }

    void fixedDigitsTellNeighboursApartHoweverLargeTheyAre() {
        QCOMPARE(fixedDigits(123.41, 3), QStringLiteral("123.410"));
        QCOMPARE(fixedDigits(12345.6, 1), QStringLiteral("12345.6"));
        QCOMPARE(fixedDigits(-0.26, 1), QStringLiteral("\u22120.3"));
        QCOMPARE(fixedDigits(-0.04, 1), QStringLiteral("0.0"));
        QLocale::setDefault(QLocale(QLocale::French, QLocale::France));
        QCOMPARE(fixedDigits(12345.6, 1), QStringLiteral("12345,6"));
    }

    void significantDigitsHaveNoZerosAfterThem() {
        QCOMPARE(significantDigits(0.5, 4), QStringLiteral("0.5"));
        QCOMPARE(significantDigits(-12.0, 4), QStringLiteral("\u221212"));
        QCOMPARE(significantDigits(0.0, 4), QStringLiteral("0"));
        QCOMPARE(significantDigits(-0.0, 4), QStringLiteral("0"));
        QCOMPARE(significantDigits(std::nullopt, 4), QStringLiteral("\u2014"));
        QLocale::setDefault(QLocale(QLocale::French, QLocale::France));
        QCOMPARE(significantDigits(2.5, 4), QStringLiteral("2,5"));
    }

    void aQuantityInASentenceIsNotFilledUpAndCanHaveMoreDigits() {
        QCOMPARE(siText(295.04, QStringLiteral("N/m")), QStringLiteral("295\u00a0N/m"));
        QCOMPARE(siText(295.04, QStringLiteral("N/m"), 1), QStringLiteral("295.0\u00a0N/m"));
        QCOMPARE(siText(-1250.0, QStringLiteral("N/m"), 1), QStringLiteral("\u22121.250\u00a0kN/m"));
        QCOMPARE(siText(0.012, QStringLiteral("N")), QStringLiteral("12.0\u00a0mN"));
        QCOMPARE(siText(999.7, QStringLiteral("N")), QStringLiteral("1.00\u00a0kN"));
        QCOMPARE(siText(std::nullopt, QStringLiteral("N")), QStringLiteral("\u2014\u00a0N"));
    }

    void whatIsUndefinedIsADashOnTheScreenAndNAInAFile() {
        for (const double value :
             {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
            QCOMPARE(fixedDigits(value, 2), QStringLiteral("\u2014"));
            QCOMPARE(csvNumber(value), QStringLiteral("NA"));
        }
        QCOMPARE(csvNumber(std::nullopt), QStringLiteral("NA"));
    }

    void aFileHasTheFewestDigitsInTheCLocale() {
        QLocale::setDefault(QLocale(QLocale::French, QLocale::France));
        QCOMPARE(csvNumber(0.1), QStringLiteral("0.1"));
        QCOMPARE(csvNumber(-1234567.0), QStringLiteral("-1234567"));
        QCOMPARE(millimetres(0.0123), QStringLiteral("12,3\u00a0mm"));
    }
};

namespace {
const test::Registration<QuantityTextTest> registration;
}
#include "quantity_text_test.moc"
