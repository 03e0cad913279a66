// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/console_options.h"
#include "app/console/help/handbook_window.h"
#include "app/console/operate/operate_page.h"
#include "app/console/start/start_page.h"
#include "tests/app/console/window_bench.h"
#include "widgets/base/theme.h"
#include "widgets/charts/strip_chart_view.h"
#include "widgets/chrome/page_rail.h"
#include "widgets/chrome/start/demo_card.h"
#include "widgets/chrome/start/demo_list.h"
#include "widgets/chrome/start/first_steps.h"
#include "widgets/chrome/start/recent_list.h"
#include "widgets/chrome/stop_button.h"
#include "widgets/touch/jog/jog_panel.h"
#include "widgets/touch/stiffness_gauge.h"
#include "widgets/view3d/vtk/gl_setup.h"

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QMenu>
#include <QScrollArea>
#include <QScrollBar>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <functional>

using namespace teleta;
using console::ConsoleOptions;

namespace {

/// The smallest screen on which all of the window, STOP too, has room.
constexpr QSize kSmallScreen{1024, 700};
/// A screen of 1600 x 1000 pixels at scale 1.5, as the window sees it.
constexpr QSize kScaledScreen{1066, 666};
/// The same less the frame of the window.
constexpr QSize kFramedWindow{1050, 618};
/// A screen of 1600 x 1000 pixels at scale 2.
constexpr QSize kScaledTwice{800, 500};
/// Of the first start on a screen of 1600 x 1000 pixels.
constexpr QSize kUsualSize{1342, 860};

} // namespace

/// What has room in the window.
class MainWindowRoomTest : public QObject, protected test::WindowBench {
    Q_OBJECT

    template <typename Widget>
    Widget* child() const {
        return m_window->findChild<Widget*>();
    }

    QTemporaryDir m_folder;

    QWidget& dock(const char* name) const { return *m_window->findChild<QDockWidget*>(QLatin1String(name)); }

    /// Docks are laid out by events that others have posted.
    static void settle() {
        for (int i = 0; i < 10; ++i)
            QCoreApplication::processEvents();
    }

    bool showsData() const {
        auto* item = m_window->sources().active();
        return item != nullptr && item->displayed > 0;
    }

    /// Checks in each language, the last one first, until a check fails.
    void inEachLanguage(const std::function<void(const QString& name)>& check) {
        // The menus are made anew in each language.
        const auto languages = [this] { return m_window->findChild<QMenu*>("languages")->actions(); };
        for (auto i = languages().size() - 1; i >= 0 && !QTest::currentTestFailed(); --i) {
            if (languages()[i]->isSeparator())
                continue;
            const QString name = languages()[i]->text();
            languages()[i]->trigger();
            QCoreApplication::processEvents();
            check(name);
        }
        languages().front()->trigger();
    }

    bool isInWindow(const QWidget* widget) const {
        return m_window->rect().contains(QRect(widget->mapTo(m_window.get(), QPoint()), widget->size()));
    }
    bool isWhole(const QWidget* widget) const { return widget->isVisible() && isInWindow(widget); }

    bool operatePageFits() const {
        const auto& page = m_window->operatePage();
        const QSize room = page.parentWidget()->size();
        return page.width() <= room.width() && page.height() <= room.height();
    }

private slots:
    void initTestCase() {
        base::applyTheme(base::ThemeChoice::light);
        qputenv("XDG_CONFIG_HOME", m_folder.path().toUtf8());
    }
    void cleanup() { m_window.reset(); }

    void everyPageFitsASmallScreenInEveryLanguage_data() {
        QTest::addColumn<QString>("scene");
        QTest::newRow("no source") << QString();
        QTest::newRow("arm") << QStringLiteral(":/scenes/teleta-touch.toml");
    }
    void everyPageFitsASmallScreenInEveryLanguage() {
        QFETCH(QString, scene);
        ConsoleOptions options;
        options.size = kSmallScreen;
        if (!scene.isEmpty())
            options.scenes = {scene};
        openWindow(options);
        if (!scene.isEmpty())
            QTRY_VERIFY_WITH_TIMEOUT(showsData(), 20'000);
        auto* stop = child<chrome::StopButton>();
        inEachLanguage([&](const QString& name) {
            m_window->activateWindow();
            QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
            QStringList pages;
            for (int page = 0; page < console::pageNames().size(); ++page) {
                QTest::keyClick(m_window.get(), static_cast<Qt::Key>(Qt::Key_1 + page), Qt::ControlModifier);
                QCoreApplication::processEvents();
                const QSize least = m_window->minimumSizeHint();
                const QString where = name + ' ' + child<chrome::PageRail>()->currentPage();
                pages << child<chrome::PageRail>()->currentPage();
                QVERIFY2(least.width() <= kSmallScreen.width() && least.height() <= kSmallScreen.height(),
                         qPrintable(where));
                QCOMPARE(m_window->size(), kSmallScreen);
                const auto scrolls = [this] {
                    const auto areas = m_window->findChildren<QScrollArea*>();
                    return std::ranges::any_of(areas, [](const QScrollArea* area) {
                        return area->isVisible() && area->horizontalScrollBar()->isVisible();
                    });
                };
                QTRY_VERIFY2(!scrolls(), qPrintable(where));
                QVERIFY2(isWhole(stop), qPrintable(where));
            }
            QCOMPARE(pages, console::pageNames());
        });
    }

    void everyDemoIsSeenOnTheStartPageAtTheUsualSize() {
        openWindow();
        inEachLanguage([&](const QString& name) {
            const auto* demos = child<chrome::DemoList>();
            const auto isSeen = [demos] {
                return demos->height() >= demos->sizeHint().height() &&
                       !demos->verticalScrollBar()->isVisible();
            };
            QTRY_VERIFY2(isSeen(), qPrintable(name));
        });
    }

    void theCardsKeepTheirDescriptionsBesideTheLastSession() {
        openWindow();
        const auto* demos = child<chrome::DemoList>();
        QTRY_VERIFY(demos->height() >= demos->sizeHint().height());
        child<chrome::RecentList>()->setSession(QStringLiteral("teleoperation"));
        QTRY_VERIFY(child<chrome::RecentList>()->isVisible());
        QTRY_VERIFY2(demos->height() >= demos->sizeHint().height(), "the headline goes first");
        child<chrome::RecentList>()->setSession({});
    }

    void theStartPageIsWholeOnASmallScreenInEveryLanguage() {
        ConsoleOptions options;
        options.size = kSmallScreen;
        openWindow(options);
        inEachLanguage([&](const QString& name) {
            const auto* demos = child<chrome::DemoList>();
            QVERIFY(child<chrome::FirstSteps>()->isVisible());
            QTRY_VERIFY2(!demos->verticalScrollBar()->isVisible(), qPrintable(name));
            for (const auto* card : m_window->findChildren<chrome::DemoCard*>())
                QVERIFY2(isInWindow(card), qPrintable(name + ": " + card->text()));
        });
    }

    void withRecentFilesTheStartPageIsWholeOnAScaledScreen() {
        ConsoleOptions options;
        options.size = kFramedWindow;
        openWindow(options);
        const auto* demos = child<chrome::DemoList>();
        QTRY_VERIFY(!demos->verticalScrollBar()->isVisible());
        m_window->operatePage().startPage().setRecent(
            {QStringLiteral("/a/one.mcap"), QStringLiteral("/a/two.mcap"), QStringLiteral("/a/three.mcap")});
        QTRY_VERIFY(child<chrome::RecentList>()->isVisible());
        QTRY_VERIFY(!demos->verticalScrollBar()->isVisible());
        QVERIFY(child<chrome::FirstSteps>()->isVisible());
        for (const auto* card : m_window->findChildren<chrome::DemoCard*>())
            QTRY_VERIFY2(
                m_window->rect().contains(QRect(card->mapTo(m_window.get(), QPoint()), card->size())),
                qPrintable(card->text()));
    }

    void nothingOfOperateScrollsOnASmallScreen_data() {
        QTest::addColumn<QString>("scene");
        QTest::newRow("arm") << QStringLiteral(":/scenes/teleta-touch.toml");
        QTest::newRow("array") << QStringLiteral(":/scenes/tactile-two-contacts.toml");
        QTest::newRow("array of vectors") << QStringLiteral(":/scenes/tactile-two-contacts.toml");
        QTest::newRow("servo") << QStringLiteral(":/scenes/servo-bent-bar.toml");
        QTest::newRow("camera") << QStringLiteral(":/scenes/vtacarm-multicontact.toml");
        QTest::newRow("nothing") << QString();
    }
    void nothingOfOperateScrollsOnASmallScreen() {
        QFETCH(QString, scene);
        ConsoleOptions options;
        options.size = kSmallScreen.boundedTo(kScaledScreen);
        if (!scene.isEmpty())
            options.scenes = {scene};
        openWindow(options);
        if (!scene.isEmpty())
            QTRY_VERIFY_WITH_TIMEOUT(showsData(), 60'000);
        // No scene has one: its charts have a strip more.
        if (QLatin1String(QTest::currentDataTag()) == QLatin1String("array of vectors"))
            child<charts::StripChartView>()->setVectors(true);
        inEachLanguage([&](const QString& name) { QTRY_VERIFY2(operatePageFits(), qPrintable(name)); });
    }

    void aSmallWindowShowsWhatMatters_data() {
        QTest::addColumn<QString>("scene");
        QTest::addColumn<QStringList>("seen");
        QTest::newRow("arm") << QStringLiteral(":/scenes/teleta-touch.toml")
                             << QStringList{"stiffness", "reconstruction", "jog"};
        QTest::newRow("array") << QStringLiteral(":/scenes/tactile-two-contacts.toml")
                               << QStringList{"heatmap", "processing"};
        QTest::newRow("servo") << QStringLiteral(":/scenes/servo-bent-bar.toml")
                               << QStringList{"reconstruction", "servo"};
        QTest::newRow("camera") << QStringLiteral(":/scenes/vtacarm-multicontact.toml")
                                << QStringList{"camera", "reconstruction"};
        QTest::newRow("gel") << QStringLiteral(":/scenes/gel-press.toml")
                             << QStringList{"gel", "reconstruction"};
    }
    void aSmallWindowShowsWhatMatters() {
        QFETCH(QString, scene);
        QFETCH(QStringList, seen);
        ConsoleOptions options;
        options.size = kScaledTwice;
        options.scenes = {scene};
        openWindow(options);
        QTRY_VERIFY_WITH_TIMEOUT(showsData(), 60'000);
        inEachLanguage([&](const QString& name) {
            QTRY_VERIFY2(operatePageFits(), qPrintable(name));
            for (const QString& view : seen)
                QTRY_VERIFY2(isWhole(m_window->findChild<QDockWidget*>(view)), qPrintable(name + ' ' + view));
            QVERIFY2(isWhole(child<chrome::StopButton>()), qPrintable(name));
            if (!seen.contains("jog"))
                return;
            const auto* gauge = child<touch::StiffnessGauge>();
            QVERIFY2(QRectF(gauge->rect()).contains(gauge->layoutNow().headline), qPrintable(name));
            const QWidget& jog = *child<touch::JogPanel>();
            const auto* hold = jog.findChild<QWidget*>("deadMan");
            const QWidget& room = *jog.parentWidget()->parentWidget();
            QVERIFY2(room.rect().contains(QRect(hold->mapTo(&room, QPoint()), hold->size())),
                     qPrintable(name));
        });
    }

    void whatWasClosedStaysClosedInASmallWindow() {
        ConsoleOptions options;
        options.size = kUsualSize;
        options.scenes = {QStringLiteral(":/scenes/tactile-two-contacts.toml")};
        openWindow(options);
        QTRY_VERIFY_WITH_TIMEOUT(showsData(), 20'000);
        const auto closed = {m_window->findChild<QDockWidget*>("charts"),
                             m_window->findChild<QDockWidget*>("marks")};
        for (QDockWidget* each : closed)
            each->close();
        settle();
        const QSize heatmap = dock("heatmap").size();
        m_window->resize(kScaledTwice);
        auto& docks = m_window->operatePage().docks();
        auto* picture = m_window->findChild<QDockWidget*>("heatmap");
        auto* behind = m_window->findChild<QDockWidget*>("reconstruction");
        QTRY_VERIFY(docks.tabifiedDockWidgets(picture).contains(behind));
        QVERIFY(std::ranges::all_of(closed, &QDockWidget::isHidden));
        m_window->resize(kUsualSize);
        QTRY_VERIFY(docks.tabifiedDockWidgets(picture).isEmpty());
        QTRY_COMPARE(picture->size(), heatmap);
        QVERIFY(std::ranges::all_of(closed, &QDockWidget::isHidden));
        QVERIFY(dock("reconstruction").isVisible());
    }

    void nothingOfJogScrollsInALowWindow() {
        ConsoleOptions options;
        options.size = kSmallScreen;
        options.scenes = {QStringLiteral(":/scenes/teleta-touch.toml")};
        openWindow(options);
        QTRY_VERIFY_WITH_TIMEOUT(showsData(), 20'000);
        inEachLanguage([&](const QString& name) {
            const QWidget& jog = *child<touch::JogPanel>();
            const auto fits = [&jog] {
                return jog.parentWidget()->parentWidget()->height() >= jog.parentWidget()->height();
            };
            QTRY_VERIFY2(fits(), qPrintable(name));
        });
    }

    void theDocksOfAnArmKeepTheirShares_data() {
        QTest::addColumn<QString>("meanwhile");
        QTest::addColumn<bool>("moved");
        for (const char* meanwhile : {"one alone", "another source", "another start"})
            for (const bool moved : {false, true})
                QTest::addRow("%s, %s", meanwhile, moved ? "moved" : "as at first")
                    << QString::fromLatin1(meanwhile) << moved;
    }
    void theDocksOfAnArmKeepTheirShares() {
        QFETCH(QString, meanwhile);
        QFETCH(bool, moved);
        ConsoleOptions options;
        options.size = kUsualSize;
        options.scenes = {QStringLiteral(":/scenes/teleta-touch.toml")};
        if (meanwhile == "another source")
            options.scenes << QStringLiteral(":/scenes/tactile-two-contacts.toml");
        const auto choose = [&](std::size_t i) {
            m_window->sources().activate(m_window->sources().items()[i].key);
        };
        const auto begin = [&] {
            openWindow(options, false);
            const auto& items = m_window->sources().items();
            // One that opens later would be shown instead.
            const auto isReady = [&] {
                return std::ssize(items) == options.scenes.size() &&
                       std::ranges::all_of(items, [](const auto& item) { return item.isOpen(); }) &&
                       showsData();
            };
            QTRY_VERIFY_WITH_TIMEOUT(isReady(), 20'000);
            choose(0);
            QTRY_VERIFY(dock("stiffness").isVisible());
        };
        const auto sizes = [this] {
            QList<QSize> all;
            for (const char* name : {"heatmap", "reconstruction", "joints", "stiffness", "bracelet", "jog"})
                all << dock(name).size();
            return all;
        };
        begin();
        // The picture is what the view is for.
        const auto isNarrow = [this] { return dock("stiffness").width() < m_window->width() * 35 / 100; };
        QTRY_VERIFY(isNarrow());
        m_window->operatePage().docks().resetLayout();
        settle();
        QList<QSize> before = sizes();
        if (moved) {
            QWidget& docks = m_window->operatePage().docks();
            const QPoint between = dock("stiffness").geometry().topLeft() + QPoint(-2, 100);
            QTest::mousePress(&docks, Qt::LeftButton, {}, between);
            QTest::mouseMove(&docks, between - QPoint(40, 0));
            QTRY_VERIFY(sizes() != before); // Qt drags by a timer
            QTest::mouseRelease(&docks, Qt::LeftButton, {}, between - QPoint(40, 0));
            settle();
            before = sizes();
        }
        for (int round = 0; round < 2; ++round) {
            if (meanwhile == "another source") {
                choose(1);
                QTRY_VERIFY(dock("charts").isVisible());
                choose(0);
            } else if (meanwhile == "one alone") {
                m_window->operatePage().docks().toggleMaximised();
                QTRY_VERIFY(!dock("jog").isVisible());
                m_window->operatePage().docks().toggleMaximised();
            } else {
                m_window->close();
                begin();
            }
            QTRY_VERIFY(dock("jog").isVisible());
            settle();
            QTRY_COMPARE(sizes(), before);
        }
        m_window->operatePage().docks().resetLayout(); // for the next window
        m_window->close();
    }

    void helpLeavesStopInReach_data() {
        QTest::addColumn<QSize>("size");
        for (const QSize& size : {kScaledTwice, kSmallScreen, kUsualSize})
            QTest::newRow(qPrintable(QStringLiteral("%1 x %2").arg(size.width()).arg(size.height()))) << size;
    }
    void helpLeavesStopInReach() {
        QFETCH(QSize, size);
        openWindow();
        m_window->resize(size);
        settle();
        const auto* stop = child<chrome::StopButton>();
        const auto isClear = [stop](const QWidget* window) {
            return !window->frameGeometry().intersects(QRect(stop->mapToGlobal(QPoint()), stop->size()));
        };
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
        QTest::keyClick(m_window.get(), Qt::Key_F1);
        QTRY_VERIFY(child<console::HandbookWindow>() != nullptr &&
                    child<console::HandbookWindow>()->isVisible());
        QTRY_VERIFY(isClear(child<console::HandbookWindow>()));
    }
};

int main(int argc, char* argv[]) {
    view3d::configureOpenGlBeforeApplication();
    QApplication application(argc, argv);
    MainWindowRoomTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "main_window_room_test.moc"
