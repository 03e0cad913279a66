// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/test_registry.h"
#include "widgets/touch/jog/joint_range.h"

#include <QTest>

#include <limits>
#include <numbers>

using teleta::touch::JointRange;

class JointRangeTest : public QObject {
    Q_OBJECT

    static constexpr double kEndless = std::numeric_limits<double>::infinity();

private slots:
    void aJointWithLimitsSaysWhenItIsAtOne() {
        JointRange range;
        range.setRange(-1.0, 2.0);
        range.setAngle(0.5);
        QVERIFY2(range.text().contains("28.6"), qPrintable(range.text()));
        QVERIFY(!range.atLimit());
        range.setAngle(1.995);
        QVERIFY(range.atLimit());
        QVERIFY(range.text().contains("limit"));
    }

    void aJointWithoutLimitsIsShownWithinAHalfTurn() {
        JointRange range;
        range.setRange(-kEndless, kEndless);
        QCOMPARE(range.toolTip(), QString("Turns without limits"));
        // Three turns and 10 degrees back.
        range.setAngle(-6.0 * std::numbers::pi - std::numbers::pi / 18.0);
        QVERIFY2(range.text().contains("10.0"), qPrintable(range.text()));
        range.setAngle(std::numbers::pi);
        QVERIFY(!range.atLimit());
    }

    void aJointThatSlidesIsShownInMillimetres() {
        JointRange range;
        range.setUnit(JointRange::Unit::millimetre);
        range.setRange(0.0, 0.25);
        range.setAngle(0.1);
        QVERIFY2(range.text().contains("100"), qPrintable(range.text()));
        QVERIFY(range.text().endsWith("mm"));
        QVERIFY(range.toolTip().contains("250"));
    }
};

namespace {
const teleta::test::Registration<JointRangeTest> registration;
}
#include "joint_range_test.moc"
