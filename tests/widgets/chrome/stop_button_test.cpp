// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/theme.h"
#include "widgets/chrome/stop_button.h"

#include <QImage>
#include <QSignalSpy>
#include <QTest>

using teleta::chrome::StopButton;

/// STOP: at once on the way down, and back only by holding.
class StopButtonTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { teleta::base::applyTheme(teleta::base::ThemeChoice::light); }

    void isLargeEnoughToHit() {
        const StopButton button;
        QVERIFY(button.sizeHint().height() >= StopButton::kMinimumSide_px);
        QVERIFY(button.sizeHint().width() >= StopButton::kMinimumSide_px);
    }

    void stopsOnPressAndNotOnRelease() {
        StopButton button;
        QSignalSpy stops(&button, &StopButton::stopRequested);
        QTest::mousePress(&button, Qt::LeftButton);
        QCOMPARE(stops.size(), 1);
        QTest::mouseRelease(&button, Qt::LeftButton);
        QCOMPARE(stops.size(), 1);
    }

    void aClickDoesNotReleaseWhileStopped() {
        StopButton button;
        button.setEngaged(true);
        QSignalSpy stops(&button, &StopButton::stopRequested);
        QSignalSpy releases(&button, &StopButton::releaseRequested);
        QTest::mouseClick(&button, Qt::LeftButton);
        QTest::keyClick(&button, Qt::Key_Space);
        QCOMPARE(releases.size(), 0);
        QCOMPARE(stops.size(), 0);
    }

    void holdingReleasesOnce() {
        StopButton button;
        button.setEngaged(true);
        QSignalSpy releases(&button, &StopButton::releaseRequested);
        QTest::mousePress(&button, Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(releases.size(), 1, 5 * StopButton::kHold_ms);
        button.setEngaged(false);
        QTest::mouseRelease(&button, Qt::LeftButton);
        QCOMPARE(releases.size(), 1);
    }

    void canBeHeldWithTheKeyboardToo() {
        StopButton button;
        button.setEngaged(true);
        QSignalSpy releases(&button, &StopButton::releaseRequested);
        QTest::keyPress(&button, Qt::Key_Space);
        QTRY_COMPARE_WITH_TIMEOUT(releases.size(), 1, 5 * StopButton::kHold_ms);
        QTest::keyRelease(&button, Qt::Key_Space);
    }

    void looksDifferentWhileStoppedAndSaysSo() {
        StopButton button;
        button.resize(button.sizeHint());
        const QColor red = teleta::base::statusColours(button.palette()).stop;
        const QPoint inside(button.width() - 12, button.height() / 2);
        QCOMPARE(button.grab().toImage().pixelColor(inside), red);
        const QString running = button.accessibleName();
        button.setEngaged(true);
        QVERIFY(button.grab().toImage().pixelColor(inside) != red);
        QVERIFY(button.accessibleName() != running);
        QVERIFY(!button.toolTip().isEmpty());
    }
};

QTEST_MAIN(StopButtonTest)
#include "stop_button_test.moc"
