// SPDX-License-Identifier: GPL-3.0-or-later
// The console at a site with a simulated arm, over the loopback interface: connected by its file, moved by
// keys. Another console, which only looks, says what the site thinks of it.
#include "app/console/console_options.h"
#include "app/console/operate/docks/operate_docks.h"
#include "app/console/operate/operate_page.h"
#include "app/console/operate/site/site_views.h"
#include "tests/app/console/window_bench.h"
#include "tests/peer/site/site_process.h"
#include "widgets/base/theme.h"
#include "widgets/camera/scene/scene_panel.h"
#include "widgets/camera/scene/scene_tile.h"
#include "widgets/chrome/message_bar.h"
#include "widgets/site/site_bar.h"
#include "widgets/touch/jog/jog_panel.h"
#include "widgets/view3d/vtk/gl_setup.h"

#include <QAction>
#include <QApplication>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <memory>

using namespace teleta;
using console::ConsoleOptions;
using console::OperateDocks;
using site::Mode;

namespace {

constexpr int kPatience_ms = 30'000;
const std::string kPractice = "[[device]]\nid = \"practice\"\nscene = \":/scenes/teleoperation.toml\"\n";

} // namespace

class ConsoleSiteTest : public QObject, protected test::WindowBench {
    Q_OBJECT

    std::unique_ptr<test::SiteProcess> m_site;
    std::unique_ptr<test::TestConsole> m_viewer;
    touch::JogPanel* m_jog = nullptr;
    site_view::SiteBar* m_bar = nullptr;

    void connectToSite(int domain, const std::string& devices = {}) {
        m_site = std::make_unique<test::SiteProcess>(domain, kPractice + devices);
        m_site->start();
        m_viewer = std::make_unique<test::TestConsole>(*m_site, "v", true);
        ConsoleOptions options;
        options.sites = {QString::fromStdString(m_site->fileOf("a"))};
        openWindow(options);
        QTRY_VERIFY_WITH_TIMEOUT(m_window->operatePage().armViews().joints() != nullptr, kPatience_ms);
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
        m_jog = m_window->findChild<touch::JogPanel*>();
        m_bar = m_window->findChild<site_view::SiteBar*>();
    }
    [[nodiscard]] bool panelSays(const QString& text) const {
        return std::ranges::any_of(m_jog->findChildren<QLabel*>(),
                                   [&](const QLabel* label) { return label->text().contains(text); });
    }
    [[nodiscard]] bool messagesSay(const QString& text) const {
        const auto* messages = m_window->operatePage().findChild<chrome::MessageBar*>();
        return std::ranges::any_of(messages->findChildren<QLabel*>(),
                                   [&](const QLabel* label) { return label->text().contains(text); });
    }
    [[nodiscard]] QAction* armAction(const QString& begin) const {
        for (QAction* action : m_window->findChildren<QAction*>())
            if (action->text().remove(QLatin1Char('&')).startsWith(begin) && action->text().contains("site"))
                return action;
        return nullptr;
    }
    void click(const char* button) {
        QTest::mouseClick(m_bar->findChild<QPushButton*>(QLatin1String(button)), Qt::LeftButton);
    }
    void press() {
        m_jog->setFocus();
        QTest::keyPress(m_jog, Qt::Key_Shift);
        QTest::keyPress(m_jog, Qt::Key_W, Qt::ShiftModifier);
    }
    /// Presses until the arm moves, and leaves the keys down. On a busy machine the window may be so late
    /// that the arm is held, and the keys have to be pressed anew.
    [[nodiscard]] bool moveByKeys() {
        constexpr int kOnePress_ms = 3000;
        for (int presses = 0; presses < kPatience_ms / kOnePress_ms; ++presses) {
            press();
            if (QTest::qWaitFor([this] { return mode() == Mode::moving; }, kOnePress_ms))
                return true;
            letGo();
        }
        return false;
    }
    void letGo() {
        QTest::keyRelease(m_jog, Qt::Key_W, Qt::ShiftModifier);
        QTest::keyRelease(m_jog, Qt::Key_Shift);
    }
    [[nodiscard]] Mode mode() const { return m_viewer->view().mode; }

private slots:
    void initTestCase() { base::applyTheme(base::ThemeChoice::light); }
    void cleanup() {
        m_window.reset();
        m_viewer.reset();
        m_site.reset();
    }

    void anArmIsMovedByWhoAskedForControl() {
        connectToSite(120);
        QCOMPARE(m_window->operatePage().docks().kind(), OperateDocks::Kind::arm);
        QVERIFY(m_bar->isVisible());
        QTRY_COMPARE_WITH_TIMEOUT(m_bar->headline(), QStringLiteral("lab: nobody controls"), kPatience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(panelSays("request control first"), kPatience_ms);
        press();
        QTRY_VERIFY_WITH_TIMEOUT(m_viewer->view().refused > 3, kPatience_ms);
        QCOMPARE(m_viewer->view().accepted, std::uint64_t{0});
        letGo();

        click("requestControl");
        QTRY_COMPARE_WITH_TIMEOUT(m_bar->headline(), QStringLiteral("lab: you control"), kPatience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(!panelSays("request control first"), kPatience_ms);
        QVERIFY(moveByKeys());
        letGo();
        QTRY_COMPARE_WITH_TIMEOUT(mode(), Mode::held, kPatience_ms);

        // STOP here stops the site, and a press from before it moves nothing afterwards.
        QVERIFY(moveByKeys());
        m_stop->engage();
        QTRY_COMPARE_WITH_TIMEOUT(mode(), Mode::stopped, kPatience_ms);
        m_stop->release();
        QTRY_COMPARE_WITH_TIMEOUT(mode(), Mode::held, kPatience_ms);
        const std::uint64_t accepted = m_viewer->view().accepted;
        QVERIFY2(!QTest::qWaitFor([this] { return mode() == Mode::moving; }, 500), "the keys are still down");
        // It may have been told that the switch was let go.
        QVERIFY(m_viewer->view().accepted <= accepted + site::OperatorHand::kHolds);
        letGo();

        click("releaseControl");
        QTRY_COMPARE_WITH_TIMEOUT(mode(), Mode::free, kPatience_ms);
        QTRY_COMPARE_WITH_TIMEOUT(m_bar->headline(), QStringLiteral("lab: nobody controls"), kPatience_ms);
    }

    void stopOfAnotherIsSaidAndAClosedWindowStopsNobody() {
        connectToSite(122);
        QTRY_COMPARE_WITH_TIMEOUT(m_bar->headline(), QStringLiteral("lab: nobody controls"), kPatience_ms);
        m_viewer->stop().engage();
        QTRY_COMPARE_WITH_TIMEOUT(m_bar->headline(), QStringLiteral("lab: STOP is held by v"), kPatience_ms);
        QVERIFY2(!m_stop->engaged(), "STOP of a site is not that of the devices here");
        m_viewer->stop().release();
        QTRY_COMPARE_WITH_TIMEOUT(m_bar->headline(), QStringLiteral("lab: nobody controls"), kPatience_ms);
        click("requestControl");
        QTRY_COMPARE_WITH_TIMEOUT(m_bar->headline(), QStringLiteral("lab: you control"), kPatience_ms);
        m_window->close();
        QTRY_COMPARE_WITH_TIMEOUT(mode(), Mode::free, kPatience_ms);
        QVERIFY(m_viewer->view().stopHolders.empty());
    }

    void aCameraOfTheSiteIsInTheDockScene() {
        QTemporaryDir folder;
        for (int i = 0; i < 4; ++i) {
            QImage picture(64, 48, QImage::Format_RGB888);
            picture.fill(QColor(200, 40 + 50 * i, 30));
            QVERIFY(picture.save(folder.filePath(QStringLiteral("%1.png").arg(i))));
        }
        connectToSite(138, "[[device]]\nid = \"overview\"\ncamera = \"" +
                               folder.filePath(QStringLiteral("%01d.png")).toStdString() + "\"\n");
        auto* panel = m_window->findChild<camera::ScenePanel*>();
        QVERIFY(panel != nullptr);
        const auto tile = [panel]() -> camera::SceneTile* { return panel->findChild<camera::SceneTile*>(); };
        QTRY_VERIFY_WITH_TIMEOUT(tile() != nullptr && !tile()->picture().isEmpty(), kPatience_ms);
        QCOMPARE(tile()->picture().image.width_px, 64);
        // The arm stays the source that is shown.
        QCOMPARE(m_window->operatePage().docks().kind(), OperateDocks::Kind::arm);
        QTRY_VERIFY_WITH_TIMEOUT(tile()->picture().problem.isEmpty(), kPatience_ms);
        m_site->kill();
        QTRY_VERIFY_WITH_TIMEOUT(tile()->picture().problem.startsWith("No picture for"), kPatience_ms);
        QTRY_COMPARE_WITH_TIMEOUT(tile()->picture().reason, QStringLiteral("lab does not answer"),
                                  kPatience_ms);
        m_site->start();
        QTRY_VERIFY_WITH_TIMEOUT(tile()->picture().problem.isEmpty(), kPatience_ms);
    }

    void whoIsAtTheSiteAndWhatHappensThereIsSaid() {
        connectToSite(143);
        QTRY_COMPARE_WITH_TIMEOUT(m_bar->headline(), QStringLiteral("lab: nobody controls"), kPatience_ms);
        QVERIFY(armAction("Request")->isEnabled() && !armAction("Take over")->isEnabled());
        test::TestConsole boss(m_site->fileOf("boss", false, "B. Name"));
        QCOMPARE(boss.ask(site::RequestKind::request), site::RequestAnswer::done);
        QTRY_COMPARE_WITH_TIMEOUT(m_bar->headline(), QStringLiteral("lab: B. Name controls"), kPatience_ms);
        QVERIFY(!armAction("Request")->isEnabled() && armAction("Take over")->isEnabled());
        QVERIFY(m_bar->findChild<QLabel*>("details")->accessibleDescription().contains("boss (B. Name)"));

        // An offer is declined with a reason, which the other one is shown.
        boss.request(site::RequestKind::offer, "a");
        QTRY_COMPARE_WITH_TIMEOUT(m_bar->headline(), QStringLiteral("lab: B. Name offers you control"),
                                  kPatience_ms);
        QTest::keyClicks(m_bar->findChild<QLineEdit*>("reason"), "not now");
        click("decline");
        QTRY_VERIFY_WITH_TIMEOUT(boss.view().request && boss.view().request->declined, kPatience_ms);
        QCOMPARE(*boss.view().request->declined, std::string("not now"));
        QCOMPARE(boss.view().request->answer, site::RequestAnswer::expired);

        // Control comes, and is handed on from the menu.
        boss.request(site::RequestKind::offer, "a");
        QTRY_VERIFY_WITH_TIMEOUT(m_bar->findChild<QPushButton*>("accept")->isVisible(), kPatience_ms);
        click("accept");
        QTRY_COMPARE_WITH_TIMEOUT(m_bar->headline(), QStringLiteral("lab: you control"), kPatience_ms);
        auto* successors = m_window->findChild<QMenu*>("handOver");
        QTRY_VERIFY_WITH_TIMEOUT(successors->isEnabled() && armAction("Release")->isEnabled(), kPatience_ms);
        QCOMPARE(successors->actions().size(), 1);
        QCOMPARE(successors->actions().front()->text(), QStringLiteral("boss (B. Name)"));
        successors->actions().front()->trigger();
        QTRY_COMPARE_WITH_TIMEOUT(boss.view().offeredTo, std::string("boss"), kPatience_ms);

        // A second program of a name that is taken.
        const test::TestConsole twin(*m_site, "v", true);
        QTRY_VERIFY_WITH_TIMEOUT(messagesSay("lab: another program named v is connected; it is ignored."),
                                 kPatience_ms);
    }

    /// Never two secure participants in one process: the viewer would have the permissions of the console.
    void keysThatComeToTheirEndMeanwhileAreTold() {
        m_site = std::make_unique<test::SiteProcess>(148, kPractice);
        m_site->secure({"a"}, {});
        m_site->setDevices(kPractice);
        m_site->start();
        ConsoleOptions options;
        options.sites = {QString::fromStdString(m_site->fileOf("a"))};
        openWindow(options);
        QTRY_VERIFY_WITH_TIMEOUT(m_window->operatePage().armViews().joints() != nullptr, kPatience_ms);
        console::SiteViews& views = m_window->operatePage().siteViews();
        QTRY_VERIFY_WITH_TIMEOUT(views.mayRequest(), kPatience_ms);
        QVERIFY(!messagesSay("The certificate ends on"));
        m_site->renew("a", 9);
        views.setKeyPeriod(std::chrono::milliseconds(50));
        QTRY_VERIFY_WITH_TIMEOUT(messagesSay("The certificate ends on"), kPatience_ms);
        // It is told once.
        const auto* messages = m_window->operatePage().findChild<chrome::MessageBar*>();
        QVERIFY(!QTest::qWaitFor([messages] { return messages->repeats() > 1; }, 500));
    }

    void aSiteThatIsGoneIsSaid() {
        connectToSite(124);
        QTRY_COMPARE_WITH_TIMEOUT(m_bar->headline(), QStringLiteral("lab: nobody controls"), kPatience_ms);
        m_site->kill();
        QTRY_VERIFY_WITH_TIMEOUT(m_bar->headline().startsWith("lab does not answer"), kPatience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(panelSays("the site does not answer") || !m_jog->refusal().isEmpty(),
                                 kPatience_ms);
        m_site->start();
        QTRY_COMPARE_WITH_TIMEOUT(m_bar->headline(), QStringLiteral("lab: nobody controls"), kPatience_ms);
    }
};

int main(int argc, char* argv[]) {
    view3d::configureOpenGlBeforeApplication();
    QApplication application(argc, argv);
    ConsoleSiteTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "console_site_test.moc"
