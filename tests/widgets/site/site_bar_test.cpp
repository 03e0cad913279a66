// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/site/site_bar.h"

#include <QLabel>
#include <QMenu>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

using teleta::site_view::SiteBar;
using teleta::site_view::SiteBarState;
using Mode = SiteBarState::Mode;

/// The bar of a site: says who controls it, and offers what can be asked for.
class SiteBarTest : public QObject {
    Q_OBJECT

    static SiteBarState at(Mode mode, const QString& controller = {}, bool here = false) {
        SiteBarState state;
        state.site = QStringLiteral("lab");
        state.reached = true;
        state.mode = mode;
        state.controller = controller;
        state.controls = here;
        return state;
    }
    static QStringList offered(const SiteBar& bar) {
        QStringList names;
        for (const auto* button : bar.findChildren<QAbstractButton*>())
            if (button->isVisibleTo(&bar))
                names << button->objectName();
        names.sort();
        return names;
    }
    static void click(SiteBar& bar, const char* name) {
        QTest::mouseClick(bar.findChild<QPushButton*>(QLatin1String(name)), Qt::LeftButton);
    }

private slots:
    void saysWhoControlsAndOffersWhatCanBeDone_data() {
        QTest::addColumn<SiteBarState>("state");
        QTest::addColumn<QString>("headline");
        QTest::addColumn<QStringList>("buttons");
        QTest::newRow("nobody") << at(Mode::free) << "lab: nobody controls" << QStringList{"requestControl"};
        SiteBarState viewing = at(Mode::free);
        viewing.viewer = true;
        QTest::newRow("viewer") << viewing << "lab: viewing" << QStringList{};
        QTest::newRow("another") << at(Mode::held, "b") << "lab: b controls" << QStringList{"takeOver"};
        SiteBarState held = at(Mode::held, "a", true);
        held.others = QStringList{"b"};
        QTest::newRow("here") << held << "lab: you control" << QStringList{"handOver", "releaseControl"};
        QTest::newRow("alone") << at(Mode::moving, "a", true) << "lab: you are moving it"
                               << QStringList{"releaseControl"};
        SiteBarState toUs = at(Mode::offered, "b");
        toUs.offeredTo = "a";
        toUs.offeredHere = true;
        QTest::newRow("offered here")
            << toUs << "lab: b offers you control" << QStringList{"accept", "decline"};
        SiteBarState away = at(Mode::offered, "a", true);
        away.offeredTo = "b";
        QTest::newRow("offered away")
            << away << "lab: handing control to b" << QStringList{"accept", "decline"};
        SiteBarState stopped = at(Mode::stopped, "a", true);
        stopped.stopHolders = QStringList{"v", "w"};
        QTest::newRow("stopped") << stopped << "lab: STOP is held by v, w"
                                 << QStringList{"releaseControl", "withdrawStop"};
        QTest::newRow("fault") << at(Mode::fault, "a", true) << "lab: an arm has a fault"
                               << QStringList{"clearFault", "releaseControl"};
        SiteBarState silent = at(Mode::held, "a", true);
        silent.reached = false;
        silent.silent_s = 0.4;
        QTest::newRow("silent") << silent << "lab does not answer (0.4 s)" << QStringList{};
    }
    void saysWhoControlsAndOffersWhatCanBeDone() {
        QFETCH(SiteBarState, state);
        QFETCH(QString, headline);
        QFETCH(QStringList, buttons);
        SiteBar bar;
        bar.setState(state);
        QCOMPARE(bar.headline(), headline);
        QCOMPARE(bar.findChild<QLabel*>("headline")->text(), headline);
        QCOMPARE(offered(bar), buttons);
    }

    void asksForWhatIsClicked() {
        SiteBar bar;
        QSignalSpy requests(&bar, &SiteBar::controlRequested);
        QSignalSpy releases(&bar, &SiteBar::releaseRequested);
        QSignalSpy takeOvers(&bar, &SiteBar::takeOverRequested);
        QSignalSpy accepts(&bar, &SiteBar::accepted);
        QSignalSpy clears(&bar, &SiteBar::faultCleared);
        bar.show();
        bar.setState(at(Mode::free));
        click(bar, "requestControl");
        QCOMPARE(requests.size(), 1);
        bar.setState(at(Mode::held, "a", true));
        click(bar, "releaseControl");
        QCOMPARE(releases.size(), 1);
        bar.setState(at(Mode::held, "b"));
        click(bar, "takeOver");
        QCOMPARE(takeOvers.size(), 1);
        SiteBarState toUs = at(Mode::offered, "b");
        toUs.offeredHere = true;
        bar.setState(toUs);
        click(bar, "accept");
        QCOMPARE(accepts.size(), 1);
        bar.setState(at(Mode::fault, "a", true));
        click(bar, "clearFault");
        QCOMPARE(clears.size(), 1);
    }

    void menusNameConsoles() {
        SiteBar bar;
        QSignalSpy handOvers(&bar, &SiteBar::handOverRequested);
        QSignalSpy withdrawals(&bar, &SiteBar::stopWithdrawn);
        SiteBarState state = at(Mode::held, "a", true);
        state.others = QStringList{"b", "c"};
        bar.setState(state);
        bar.findChild<QToolButton*>("handOver")->menu()->actions().at(1)->trigger();
        QCOMPARE(handOvers.at(0).at(0).toString(), QStringLiteral("c"));
        state = at(Mode::stopped);
        state.stopHolders = QStringList{"v"};
        bar.setState(state);
        bar.findChild<QToolButton*>("withdrawStop")->menu()->actions().at(0)->trigger();
        QCOMPARE(withdrawals.at(0).at(0).toString(), QStringLiteral("v"));
    }

    void showsTheLeaseOnlyToWhoHasIt() {
        SiteBar bar;
        SiteBarState state = at(Mode::held, "a", true);
        state.leaseShare = 0.5;
        bar.setState(state);
        auto* lease = bar.findChild<QProgressBar*>();
        QVERIFY(lease->isVisibleTo(&bar));
        QCOMPARE(lease->value(), 50);
        bar.setState(at(Mode::held, "b"));
        QVERIFY(!lease->isVisibleTo(&bar));
    }

    void tellsTimesAndWhatWasRefused() {
        SiteBar bar;
        SiteBarState state = at(Mode::held, "a", true);
        state.loop_s = 0.0412;
        state.clockBound_s = 0.0206;
        state.refused = 3;
        state.lastRefusal = "the loop takes too long";
        bar.setState(state);
        const QString details = bar.findChild<QLabel*>("details")->text();
        for (const char* part : {"loop 41 ms", "\u00b121 ms", "3 refused: the loop takes too long"})
            QVERIFY2(details.contains(QString::fromUtf8(part)), qPrintable(details));
    }
};

QTEST_MAIN(SiteBarTest)
#include "site_bar_test.moc"
