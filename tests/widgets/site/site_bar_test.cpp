// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/site/site_bar.h"

#include <QLabel>
#include <QLineEdit>
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

    void whatIsNeededSeldomIsInTheToolTip() {
        SiteBar bar;
        SiteBarState state = at(Mode::held, "b");
        state.persons = {{"b", "B. <i>Name</i>"}, {"v", "V. Name"}};
        state.viewers = QStringList{"v", "w"};
        state.medianLoop_s = 0.0412;
        state.slowLoop_s = 0.0634;
        state.clockOffset_s = -12.3456;
        state.clockBound_s = 0.0206;
        state.statesLost = 2;
        state.losses = {{"arm: joints", 12}, {"pad", 0}};
        state.refused = 4;
        state.refusedBy = {{"STOP is engaged", 3}, {"the arm is not live", 1}};
        bar.setState(state);
        const auto* details = bar.findChild<QLabel*>("details");
        const QString told = details->accessibleDescription();
        QCOMPARE(told, QStringLiteral(
                           "In control: b (B. <i>Name</i>); Viewers: v (V. Name), w; "
                           "Loop: median 41 ms, 99 %: 63 ms; Clock offset: -12.346 s \u00b1 21 ms; "
                           "2 state(s) of the site were lost on the way; Lost on the way, arm: joints: 12; "
                           "Lost on the way, pad: 0; Refused: STOP is engaged (3); "
                           "Refused: the arm is not live (1)"));
        QVERIFY2(details->toolTip().contains("B. &lt;i&gt;Name"), "a name is no markup");
        QCOMPARE(bar.findChild<QLabel*>("headline")->toolTip(), details->toolTip());
    }

    void personsAreNamedWhereTheyTellWhoTheyAre() {
        SiteBar bar;
        SiteBarState state = at(Mode::held, "b");
        state.persons = {{"b", "B. Name"}};
        bar.setState(state);
        QCOMPARE(bar.headline(), QStringLiteral("lab: B. Name controls"));
        state.controller = "c";
        bar.setState(state);
        QCOMPARE(bar.headline(), QStringLiteral("lab: c controls"));
        SiteBarState here = at(Mode::held, "a", true);
        here.others = QStringList{"b", "c"};
        here.persons = {{"b", "B. Name"}};
        bar.setState(here);
        const auto entries = bar.findChild<QToolButton*>("handOver")->menu()->actions();
        QCOMPARE(entries.at(0)->text(), QStringLiteral("b (B. Name)"));
        QCOMPARE(entries.at(1)->text(), QStringLiteral("c"));
    }

    void whoDeclinesMaySayWhy() {
        SiteBar bar;
        QSignalSpy declines(&bar, &SiteBar::declined);
        bar.show();
        auto* reason = bar.findChild<QLineEdit*>("reason");
        QVERIFY(!reason->isVisible());
        SiteBarState away = at(Mode::offered, "a", true);
        away.offeredTo = "boss";
        bar.setState(away);
        QVERIFY(reason->isVisible());
        click(bar, "decline");
        QCOMPARE(declines.at(0).at(0).toString(), QString());
        QTest::keyClicks(reason, "nearly done ");
        QTest::keyClick(reason, Qt::Key_Return);
        QCOMPARE(declines.size(), 2);
        QCOMPARE(declines.at(1).at(0).toString(), QStringLiteral("nearly done"));
        // What was not sent is not for the next one.
        QTest::keyClicks(reason, "wait");
        bar.setState(at(Mode::held, "a", true));
        QVERIFY(!reason->isVisible() && reason->text().isEmpty());
    }
};

QTEST_MAIN(SiteBarTest)
#include "site_bar_test.moc"
