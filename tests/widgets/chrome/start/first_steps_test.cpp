// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/theme.h"
#include "widgets/chrome/start/demo_card.h"
#include "widgets/chrome/start/first_steps.h"

#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

using teleta::chrome::DemoCard;
using teleta::chrome::FirstSteps;
namespace base = teleta::base;

/// The first things to try, on the start page.
class FirstStepsTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { base::applyTheme(base::ThemeChoice::light); }

    void aStepIsAskedForByMouseAndKeysAndTheRowIsHiddenByItsButton() {
        FirstSteps steps;
        steps.resize(900, 100);
        steps.show();
        QVERIFY(QTest::qWaitForWindowExposed(&steps));
        QSignalSpy asked(&steps, &FirstSteps::stepRequested);
        QSignalSpy hidden(&steps, &FirstSteps::hideRequested);
        const auto cards = steps.findChildren<DemoCard*>();
        QCOMPARE(cards.size(), FirstSteps::names().size());
        QTest::mouseClick(cards[1], Qt::LeftButton);
        QCOMPARE(asked.takeFirst()[0].toString(), FirstSteps::names()[1]);
        cards[2]->setFocus();
        QTest::keyClick(cards[2], Qt::Key_Space);
        QCOMPARE(asked.takeFirst()[0].toString(), FirstSteps::names()[2]);
        QTest::mouseClick(steps.findChild<QToolButton*>("hideFirstSteps"), Qt::LeftButton);
        QCOMPARE(hidden.count(), 1);
    }

    void aStepThatWasDoneHasATickAndSaysSo() {
        FirstSteps steps;
        steps.resize(900, 100);
        steps.setDone({"pattern", "no such step"});
        steps.show();
        QVERIFY(QTest::qWaitForWindowExposed(&steps));
        const auto cards = steps.findChildren<DemoCard*>();
        const QColor live = base::statusColours(steps.palette()).live;
        const auto hasTick = [&](DemoCard* card) {
            const QImage picture = card->grab().toImage();
            int green = 0;
            for (int y = 0; y < picture.height(); ++y)
                for (int x = 0; x < picture.width(); ++x)
                    green += picture.pixelColor(x, y) == live ? 1 : 0;
            return green > 20;
        };
        QVERIFY(!hasTick(cards[0]));
        QVERIFY(hasTick(cards[1]));
        QVERIFY(cards[1]->accessibleDescription().startsWith("Done."));
        QVERIFY(!cards[0]->accessibleDescription().startsWith("Done."));
        steps.setLow(true);
        QVERIFY(hasTick(cards[1]));
    }
};

QTEST_MAIN(FirstStepsTest)
#include "first_steps_test.moc"
