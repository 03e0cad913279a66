// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/test_registry.h"
#include "widgets/base/numbers/calm_range.h"

#include <QTest>

using teleta::base::CalmRange;
using teleta::base::niceStep;

class CalmRangeTest : public QObject {
    Q_OBJECT
private slots:
    void stepsAreOneTwoTwoAndAHalfOrFive_data() {
        QTest::addColumn<double>("value");
        QTest::addColumn<double>("step");
        QTest::newRow("exact one") << 1.0 << 1.0;
        QTest::newRow("just over one") << 1.01 << 2.0;
        QTest::newRow("two and a bit") << 2.1 << 2.5;
        QTest::newRow("three") << 3.0 << 5.0;
        QTest::newRow("six") << 6.0 << 10.0;
        QTest::newRow("tiny") << 3e-12 << 5e-12;
        QTest::newRow("huge") << 1.5e12 << 2e12;
    }
    void stepsAreOneTwoTwoAndAHalfOrFive() {
        QFETCH(double, value);
        QFETCH(double, step);
        QVERIFY(std::abs(niceStep(value) - step) < 1e-9 * step);
    }

    void opensAtOnceToARoundNumber() {
        CalmRange range(0.1);
        QVERIFY(range.update(0.0, 0.93, 0.0));
        QCOMPARE(range.low(), 0.0);
        QCOMPARE(range.high(), 1.0);
        QVERIFY(range.update(0.0, 3.4, 0.01));
        QCOMPARE(range.high(), 4.0);
    }

    void staysWhileTheDataMoveInsideIt() {
        CalmRange range(0.1);
        range.update(0.0, 3.4, 0.0);
        for (int i = 1; i < 1000; ++i)
            QVERIFY(!range.update(0.0, 3.0 + 0.5 * (i % 2), 0.005 * i));
    }

    void closesOnlyAfterTheDataNeededClearlyLessForAWhile() {
        CalmRange range(0.1, 4.0);
        range.update(0.0, 8.0, 0.0);
        QVERIFY(!range.update(0.0, 1.0, 0.5));
        QCOMPARE(range.high(), 8.0);
        double time_s = 0.5;
        while (time_s < 60.0)
            range.update(0.0, 1.0, time_s += 0.5);
        // Rounding to steps adds at most 40 %, and the range closes when it is more than a quarter too wide.
        QVERIFY2(range.high() <= 1.75, qPrintable(QString::number(range.high())));
        QVERIFY(range.high() >= 1.0);
    }

    void noiseDoesNotFillThePicture() {
        CalmRange range(0.5);
        range.update(0.0, 0.003, 0.0);
        QVERIFY(range.high() - range.low() >= 0.5);
        QCOMPARE(range.low(), 0.0);
    }

    void aJumpOfTimeBackwardsForgetsNothing() {
        CalmRange range(0.1);
        range.update(0.0, 8.0, 1000.0);
        QVERIFY(!range.update(0.0, 7.0, 3.0));
        QCOMPARE(range.high(), 8.0);
    }

    void bothEndsFollowSignedData() {
        CalmRange range(1.0);
        range.update(-17.0, 3.0, 0.0);
        QVERIFY(range.low() <= -17.0 && range.low() >= -25.0);
        QVERIFY(range.high() >= 3.0 && range.high() <= 10.0);
    }
};

static const teleta::test::Registration<CalmRangeTest> registration;

#include "calm_range_test.moc"
