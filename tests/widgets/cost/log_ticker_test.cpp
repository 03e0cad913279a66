// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/test_registry.h"
#include "widgets/cost/log_ticker.h"

#include <QSet>
#include <QTest>

#include <limits>

using teleta::cost::LogTicker;

class LogTickerTest : public QObject {
    Q_OBJECT

    static QStringList labels(double lower, double upper, const QString& unit) {
        QStringList texts;
        for (const double tick : LogTicker::ticksWithin(lower, upper))
            texts << LogTicker::label(tick, unit).replace(QChar(0x00a0), QLatin1Char(' '));
        return texts;
    }

private slots:
    void severalDecadesHaveOneTickEach() {
        QCOMPARE(labels(7e-4, 0.5, QStringLiteral("s")),
                 (QStringList{QStringLiteral("1 ms"), QStringLiteral("10 ms"), QStringLiteral("100 ms")}));
    }
    void lessThanThreeDecadesHaveTicksWithinThem() {
        QCOMPARE(labels(1.8e-6, 3.6e-5, QStringLiteral("s")),
                 (QStringList{QStringLiteral("2 \u00b5s"), QStringLiteral("5 \u00b5s"),
                              QStringLiteral("10 \u00b5s"), QStringLiteral("20 \u00b5s")}));
    }
    void manyDecadesSkipSome() {
        QCOMPARE(
            labels(5e-17, 2e-2, QStringLiteral("rad")),
            (QStringList{QStringLiteral("1e-16 rad"), QStringLiteral("1e-14 rad"), QStringLiteral("1 prad"),
                         QStringLiteral("100 prad"), QStringLiteral("10 nrad"), QStringLiteral("1 \u00b5rad"),
                         QStringLiteral("100 \u00b5rad"), QStringLiteral("10 mrad")}));
    }
    void sharesAreInPercent() {
        QCOMPARE(labels(1e-3, 2.0, QStringLiteral("1")),
                 (QStringList{QStringLiteral("0.1 %"), QStringLiteral("1 %"), QStringLiteral("10 %"),
                              QStringLiteral("100 %")}));
    }
    void noTwoTicksOfAnAxisReadTheSame() {
        for (double lower = 1e-15; lower < 1e3; lower *= 1.7)
            for (const double factor : {2.5, 6.0, 40.0, 900.0, 1e5, 1e11}) {
                const QStringList texts = labels(lower, factor * lower, QStringLiteral("m"));
                QVERIFY(!texts.isEmpty());
                QCOMPARE(QSet<QString>(texts.begin(), texts.end()).size(), texts.size());
            }
    }
    void aRangeThatIsNoneHasNoTicks() {
        QVERIFY(LogTicker::ticksWithin(0.0, 1.0).isEmpty());
        QVERIFY(LogTicker::ticksWithin(1.0, 1.0).isEmpty());
        QVERIFY(LogTicker::ticksWithin(-1.0, 1.0).isEmpty());
        QVERIFY(LogTicker::ticksWithin(std::numeric_limits<double>::quiet_NaN(), 1.0).isEmpty());
        QVERIFY(LogTicker::ticksWithin(1.0, std::numeric_limits<double>::infinity()).isEmpty());
    }
};

namespace {
const teleta::test::Registration<LogTickerTest> registration;
}

#include "log_ticker_test.moc"
