// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/operate/docks/operate_docks.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QDataStream>
#include <QDockWidget>
#include <QIODevice>
#include <QLineEdit>
#include <QMainWindow>
#include <QMenu>
#include <QPushButton>
#include <QScreen>
#include <QSignalSpy>
#include <QTabBar>
#include <QTest>
#include <QVBoxLayout>

#include <cstdlib>
#include <utility>

using teleta::console::OperateDocks;

namespace {

constexpr int kPatience_ms = 15'000;

struct Docks {
    Docks() {
        for (std::size_t i = 0; i < OperateDocks::kDocks; ++i)
            docks.add(static_cast<OperateDocks::Dock>(i), new QWidget);
        docks.begin();
        docks.resize(600, 400);
    }
    [[nodiscard]] QDockWidget* charts() const { return docks.findChild<QDockWidget*>("charts"); }

    OperateDocks docks;
};

/// The row that shows the tab of a dock, and the tab's place in it.
std::pair<QTabBar*, int> tabOf(OperateDocks& docks, const char* name) {
    const QString title = docks.findChild<QDockWidget*>(QLatin1String(name))->windowTitle();
    for (auto* bar : docks.findChildren<QTabBar*>(Qt::FindDirectChildrenOnly))
        for (int tab = 0; bar->isVisible() && tab < bar->count(); ++tab)
            if (bar->tabText(tab) == title)
                return {bar, tab};
    return {nullptr, -1};
}

bool isOnAScreen(const QWidget* window) {
    for (const QScreen* screen : QGuiApplication::screens())
        if (screen->geometry().contains(window->geometry().topLeft()))
            return true;
    return false;
}

} // namespace

/// Where docks are.
class OperateDocksTest : public QObject {
    Q_OBJECT

private slots:
    void aFloatingWindowStaysWhereItsTitleCanBeReached_data() {
        QTest::addColumn<QRect>("window");
        QTest::addColumn<QList<QRect>>("screens");
        QTest::addColumn<QRect>("wanted");
        const QRect home(0, 0, 1000, 800);
        const QRect right(1000, 0, 1000, 800);
        const QRect beside(1200, 100, 400, 300);
        QTest::newRow("on the other screen") << beside << QList{home, right} << beside;
        QTest::newRow("the other screen is gone") << beside << QList{home} << QRect(300, 250, 400, 300);
        const QRect corner(940, 790, 400, 300);
        QTest::newRow("a corner of its title") << corner << QList{home} << QRect(300, 250, 400, 300);
        const QRect mostlyOutside(940, 700, 400, 300);
        QTest::newRow("enough of its title") << mostlyOutside << QList{home} << mostlyOutside;
        QTest::newRow("its title above the screen")
            << QRect(100, -50, 400, 300) << QList{home} << QRect(300, 250, 400, 300);
        QTest::newRow("larger than the screen")
            << QRect(5000, 0, 1200, 900) << QList{home} << QRect(0, 0, 1000, 800);
        QTest::newRow("narrower than what is enough")
            << QRect(10, 10, 30, 300) << QList{home} << QRect(10, 10, 30, 300);
        QTest::newRow("across two screens")
            << QRect(900, 10, 300, 300) << QList{home, right} << QRect(900, 10, 300, 300);
        QTest::newRow("no screen is left") << beside << QList<QRect>() << QRect(300, 250, 400, 300);
    }
    void aFloatingWindowStaysWhereItsTitleCanBeReached() {
        QFETCH(QRect, window);
        QFETCH(QList<QRect>, screens);
        QFETCH(QRect, wanted);
        const QRect place =
            OperateDocks::reachablePlace(window, screens, QRect(0, 0, 1000, 800), QSize(60, 20));
        QCOMPARE(place, wanted);
        // Where it came to it can be reached.
        if (!screens.isEmpty())
            QCOMPARE(OperateDocks::reachablePlace(place, screens, QRect(), QSize(60, 20)), place);
    }

    void aFloatingDockComesBackWhenItsScreenIsGone_data() {
        QTest::addColumn<bool>("closed");
        QTest::newRow("shown") << false;
        QTest::newRow("closed") << true;
    }
    void aFloatingDockComesBackWhenItsScreenIsGone() {
        QFETCH(bool, closed);
        Docks d;
        d.docks.show();
        QVERIFY(QTest::qWaitForWindowExposed(&d.docks));
        d.charts()->setFloating(true);
        d.charts()->setGeometry(20'000, 15'000, 300, 200);
        d.charts()->setVisible(!closed);
        QVERIFY(!isOnAScreen(d.charts()));
        // What showing it did is over: the screen goes later.
        QCoreApplication::sendPostedEvents();
        d.charts()->setGeometry(20'000, 15'000, 300, 200);
        emit qGuiApp->screenRemoved(QGuiApplication::primaryScreen());
        d.charts()->show();
        QTRY_VERIFY_WITH_TIMEOUT(isOnAScreen(d.charts()), kPatience_ms);
        QVERIFY(d.charts()->isFloating());
        QCOMPARE(d.charts()->size(), QSize(300, 200));
        QVERIFY2(!d.docks.findChild<QDockWidget*>("heatmap")->isFloating(), "the others stay");
    }

    void aDockThatFloatedOnAScreenThatIsNotThereComesOntoOne() {
        QByteArray layouts;
        {
            Docks before;
            before.docks.show();
            before.charts()->setFloating(true);
            before.charts()->setGeometry(20'000, 15'000, 300, 200);
            layouts = before.docks.saveLayouts();
        }
        Docks d;
        QVERIFY(d.docks.restoreLayouts(layouts));
        d.docks.show();
        QVERIFY(d.charts()->isFloating());
        QTRY_VERIFY_WITH_TIMEOUT(isOnAScreen(d.charts()), kPatience_ms);
    }

    void layoutsOfAnotherVersionAreNotRestored_data() {
        QTest::addColumn<qint32>("difference");
        QTest::newRow("older") << qint32(-1);
        QTest::newRow("newer") << qint32(1);
    }
    void layoutsOfAnotherVersionAreNotRestored() {
        QFETCH(qint32, difference);
        Docks d;
        d.charts()->close();
        QByteArray layouts = d.docks.saveLayouts();
        qint32 version = 0;
        QDataStream(layouts) >> version;
        QDataStream(&layouts, QIODevice::ReadWrite) << version + difference;
        QVERIFY(!d.docks.restoreLayouts(layouts));
        QVERIFY2(!d.charts()->isHidden(), "the default layout");
        QDataStream(&layouts, QIODevice::ReadWrite) << version;
        QVERIFY(d.docks.restoreLayouts(layouts));
        QVERIFY(d.charts()->isHidden());
    }

    void aDoubleClickOnATitleShowsADockAloneAndAllAgain() {
        Docks d;
        d.docks.show();
        QVERIFY(QTest::qWaitForWindowExposed(&d.docks));
        QSignalSpy changed(&d.docks, &OperateDocks::maximisedChanged);
        auto* heatmap = d.docks.findChild<QDockWidget*>("heatmap");
        auto* processing = d.docks.findChild<QDockWidget*>("processing");
        QCoreApplication::sendPostedEvents(); // the room is shared once it is shown
        const QSize before = heatmap->size();
        const QPoint title(heatmap->width() / 2, heatmap->widget()->y() / 2);
        QTest::mouseDClick(heatmap, Qt::LeftButton, {}, title);
        QCOMPARE(d.docks.maximised(), QString("heatmap"));
        QVERIFY(!heatmap->isFloating());
        QVERIFY(!processing->isVisible());
        QVERIFY(!d.charts()->isVisible());
        QTRY_VERIFY(heatmap->width() > before.width() && heatmap->height() > before.height());
        QTest::mouseDClick(heatmap, Qt::LeftButton, {},
                           QPoint(heatmap->width() / 2, heatmap->widget()->y() / 2));
        QCOMPARE(d.docks.maximised(), QString());
        QVERIFY(processing->isVisible());
        QTRY_COMPARE(heatmap->size(), before);
        QCOMPARE(changed.count(), 2);
    }

    void aDoubleClickOnATabMaximisesItsDock() {
        Docks d;
        d.docks.show();
        QVERIFY(QTest::qWaitForWindowExposed(&d.docks));
        // Charts and marks lie upon each other.
        QTabBar* tabs = nullptr;
        for (auto* bar : d.docks.findChildren<QTabBar*>(Qt::FindDirectChildrenOnly))
            if (bar->isVisible())
                tabs = bar;
        QVERIFY(tabs != nullptr);
        int marks = 0;
        while (marks < tabs->count() &&
               tabs->tabText(marks) != d.docks.findChild<QDockWidget*>("marks")->windowTitle())
            ++marks;
        QVERIFY(marks < tabs->count());
        QTest::mouseClick(tabs, Qt::LeftButton, {}, tabs->tabRect(marks).center());
        QTest::mouseDClick(tabs, Qt::LeftButton, {}, tabs->tabRect(marks).center());
        QCOMPARE(d.docks.maximised(), QString("marks"));
        d.docks.toggleMaximised();
        QCOMPARE(d.docks.maximised(), QString());
    }

    void theTabIsTheTitleOfADock() {
        Docks d;
        d.docks.show();
        QVERIFY(QTest::qWaitForWindowExposed(&d.docks));
        auto* marks = d.docks.findChild<QDockWidget*>("marks");
        auto* heatmap = d.docks.findChild<QDockWidget*>("heatmap");
        QTRY_VERIFY(d.charts()->titleBarWidget() != nullptr);
        QCOMPARE(d.charts()->titleBarWidget()->height(), 0);
        QVERIFY(marks->titleBarWidget() != nullptr);
        QVERIFY2(heatmap->titleBarWidget() == nullptr, "it has no tab");
        marks->close();
        QTRY_VERIFY2(d.charts()->titleBarWidget() == nullptr, "the last one of its row has a title again");
        QTRY_VERIFY(d.charts()->widget()->y() > 0);
        marks->show();
        QTRY_VERIFY(d.charts()->titleBarWidget() != nullptr);
    }

    void aTabIsDraggedOutOfItsRow() {
        Docks d;
        d.docks.show();
        QVERIFY(QTest::qWaitForWindowExposed(&d.docks));
        const auto [tabs, tab] = tabOf(d.docks, "marks");
        QVERIFY(tabs != nullptr);
        auto* marks = d.docks.findChild<QDockWidget*>("marks");
        const QPoint start = tabs->tabRect(tab).center();
        QTest::mousePress(tabs, Qt::LeftButton, {}, start);
        QTest::mouseMove(tabs, start + QPoint(3, 0));
        QVERIFY2(!marks->isFloating(), "it is only moved in its row");
        QTest::mouseMove(tabs, start + QPoint(3, -200));
        QVERIFY(marks->isFloating());
        QVERIFY(marks->isVisible());
        QTRY_VERIFY2(marks->titleBarWidget() == nullptr, "a window of its own has a title");
        QTRY_VERIFY(d.charts()->titleBarWidget() == nullptr);
    }

    void theMenuFromTheKeyboardIsThatOfTheTabThatIsShown() {
        Docks d;
        d.docks.show();
        QVERIFY(QTest::qWaitForWindowExposed(&d.docks));
        const auto [tabs, tab] = tabOf(d.docks, "marks");
        QVERIFY(tabs->count() > 1);
        tabs->setCurrentIndex(tab);
        const QPoint elsewhere = tabs->tabRect(tab == 0 ? 1 : 0).center();
        QContextMenuEvent event(QContextMenuEvent::Keyboard, elsewhere, tabs->mapToGlobal(elsewhere));
        QCoreApplication::sendEvent(tabs, &event);
        auto* menu = d.docks.findChild<QMenu*>();
        QVERIFY(menu != nullptr);
        for (QAction* action : menu->actions())
            if (action->text() == QLatin1String("&Close"))
                action->trigger();
        menu->close();
        QVERIFY(d.docks.findChild<QDockWidget*>("marks")->isHidden());
    }

    void theMenuOfATabFloatsAndClosesItsDock() {
        Docks d;
        d.docks.show();
        QVERIFY(QTest::qWaitForWindowExposed(&d.docks));
        auto* marks = d.docks.findChild<QDockWidget*>("marks");
        const auto choose = [&](const char* text) {
            const auto [tabs, tab] = tabOf(d.docks, "marks");
            const QPoint place = tabs->tabRect(tab).center();
            QContextMenuEvent event(QContextMenuEvent::Mouse, place, tabs->mapToGlobal(place));
            QCoreApplication::sendEvent(tabs, &event);
            auto* menu = d.docks.findChild<QMenu*>();
            for (QAction* action : menu->actions())
                if (action->text() == QLatin1String(text))
                    QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(action).center());
            QTRY_VERIFY(d.docks.findChild<QMenu*>() == nullptr);
        };
        choose("&Float");
        QVERIFY(marks->isFloating());
        marks->setFloating(false);
        QTRY_VERIFY(marks->titleBarWidget() != nullptr);
        choose("&Close");
        QVERIFY(marks->isHidden());
        marks->show();
        QTRY_VERIFY(marks->titleBarWidget() != nullptr);
        choose("&Maximise");
        QCOMPARE(d.docks.maximised(), QString("marks"));
    }

    void aLargerWindowGivesItsRoomToThePictures() {
        Docks d;
        d.docks.setKind(OperateDocks::Kind::arm);
        d.docks.resize(1000, 700);
        d.docks.show();
        QVERIFY(QTest::qWaitForWindowExposed(&d.docks));
        QCoreApplication::sendPostedEvents();
        const auto* jog = d.docks.findChild<QDockWidget*>("jog");
        const auto* view = d.docks.findChild<QDockWidget*>("reconstruction");
        const int form = jog->width();
        const int picture = view->width();
        d.docks.resize(1600, 1000);
        QTRY_COMPARE_WITH_TIMEOUT(jog->width(), form, kPatience_ms);
        QVERIFY2(view->width() > picture + 250, qPrintable(QString::number(view->width())));
        d.docks.resize(1000, 700);
        QTRY_COMPARE_WITH_TIMEOUT(view->width(), picture, kPatience_ms);
    }

    void sizesThatWereDraggedStayWhenTheWindowIsResizedAndShownAgain() {
        Docks d;
        d.docks.setKind(OperateDocks::Kind::arm);
        d.docks.resize(1200, 800);
        d.docks.show();
        QVERIFY(QTest::qWaitForWindowExposed(&d.docks));
        QCoreApplication::sendPostedEvents();
        const auto* jog = d.docks.findChild<QDockWidget*>("jog");
        const auto* heatmap = d.docks.findChild<QDockWidget*>("heatmap");
        const int before = jog->width();
        // The separator between the pictures and the column.
        const QPoint at(jog->x() - 2, jog->geometry().center().y());
        QTest::mousePress(&d.docks, Qt::LeftButton, {}, at);
        QTest::mouseMove(&d.docks, at + QPoint(60, 0));
        QTRY_COMPARE_WITH_TIMEOUT(jog->width(), before - 60, kPatience_ms); // Qt drags by a timer
        QTest::mouseRelease(&d.docks, Qt::LeftButton, {}, at + QPoint(60, 0));
        QTRY_COMPARE_WITH_TIMEOUT(jog->width(), before - 60, kPatience_ms);
        // Qt shares out what the separators take.
        constexpr int kRest = 5;
        const auto isAsDragged = [&] { return std::abs(jog->width() - (before - 60)) <= kRest; };
        const int share = 1000 * heatmap->width() / (d.docks.width() - jog->width());
        d.docks.resize(1700, 1000);
        QTRY_VERIFY_WITH_TIMEOUT(isAsDragged(), kPatience_ms);
        QVERIFY(std::abs(1000 * heatmap->width() / (d.docks.width() - jog->width()) - share) <= 5);
        d.docks.hide(); // another page
        d.docks.show();
        QCoreApplication::sendPostedEvents();
        QVERIFY2(isAsDragged(), qPrintable(QString::number(jog->width())));
    }

    void aRestoredLayoutGivesItsRoomToThePicturesToo() {
        QByteArray layouts;
        int form = 0;
        {
            Docks before;
            before.docks.setKind(OperateDocks::Kind::arm);
            before.docks.resize(1500, 900);
            before.docks.show();
            QVERIFY(QTest::qWaitForWindowExposed(&before.docks));
            QCoreApplication::sendPostedEvents();
            before.docks.findChild<QDockWidget*>("heatmap")->close();
            QCoreApplication::sendPostedEvents();
            form = before.docks.findChild<QDockWidget*>("jog")->width();
            layouts = before.docks.saveLayouts();
        }
        Docks d;
        QVERIFY(d.docks.restoreLayouts(layouts));
        d.docks.resize(1100, 700);
        d.docks.show();
        QVERIFY(QTest::qWaitForWindowExposed(&d.docks));
        QCoreApplication::sendPostedEvents();
        d.docks.setKind(OperateDocks::Kind::arm); // only now is a source open
        const auto* jog = d.docks.findChild<QDockWidget*>("jog");
        QVERIFY(d.docks.findChild<QDockWidget*>("heatmap")->isHidden());
        constexpr int kRest = 5;
        const auto isAsBefore = [&] { return std::abs(jog->width() - form) <= kRest; };
        QTRY_VERIFY2_WITH_TIMEOUT(
            isAsBefore(), qPrintable(QStringLiteral("%1, not %2").arg(jog->width()).arg(form)), kPatience_ms);
        d.docks.resize(1600, 1000);
        QTRY_VERIFY2_WITH_TIMEOUT(
            isAsBefore(), qPrintable(QStringLiteral("%1, not %2").arg(jog->width()).arg(form)), kPatience_ms);
    }

    void aMaximisedDockKeepsTheKeyboard() {
        QMainWindow window;
        auto* docks = new OperateDocks;
        QList<QLineEdit*> fields;
        for (std::size_t i = 0; i < OperateDocks::kDocks; ++i)
            docks->add(static_cast<OperateDocks::Dock>(i), fields.emplaceBack(new QLineEdit));
        docks->begin();
        auto* content = new QWidget;
        auto* layout = new QVBoxLayout(content);
        layout->addWidget(docks, 1);
        layout->addWidget(new QPushButton(QStringLiteral("Record")));
        window.setCentralWidget(content);
        window.resize(900, 700);
        window.show();
        window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        QLineEdit* const used = fields[OperateDocks::reconstruction];
        QTest::mouseClick(used, Qt::LeftButton);
        QCOMPARE(QApplication::focusWidget(), used);
        docks->toggleMaximised();
        QCOMPARE(docks->maximised(), QString("reconstruction"));
        QCOMPARE(QApplication::focusWidget(), used);
        docks->toggleMaximised();
        QCOMPARE(docks->maximised(), QString());
        QCoreApplication::sendPostedEvents();
        QCOMPARE(QApplication::focusWidget(), used);
        // What had it is hidden: the dock that is alone gets it.
        docks->setMaximised("heatmap");
        QCOMPARE(QApplication::focusWidget(), fields[OperateDocks::heatmap]);
    }

    void whatIsSavedAndWhatAnotherSourceShowsKnowsOfNoMaximisedDock() {
        Docks d;
        d.docks.show();
        QVERIFY(QTest::qWaitForWindowExposed(&d.docks));
        d.docks.setMaximised("charts");
        const QByteArray saved = d.docks.saveLayouts();
        d.docks.setKind(OperateDocks::Kind::arm);
        QCOMPARE(d.docks.maximised(), QString());
        QVERIFY(d.docks.findChild<QDockWidget*>("stiffness")->isVisible());
        d.docks.setKind(OperateDocks::Kind::array);
        QVERIFY(d.docks.findChild<QDockWidget*>("heatmap")->isVisible());
        d.docks.setMaximised("charts");
        QVERIFY(d.docks.restoreLayouts(saved));
        QCOMPARE(d.docks.maximised(), QString());
        QVERIFY(d.docks.findChild<QDockWidget*>("heatmap")->isVisible());
        d.docks.setMaximised("stiffness"); // an array shows none
        QCOMPARE(d.docks.maximised(), QString());
        d.docks.setMaximised("charts");
        d.docks.resetLayout();
        QVERIFY(d.docks.findChild<QDockWidget*>("heatmap")->isVisible());
        d.docks.setMaximised("charts");
        d.docks.bringForward("heatmap");
        QVERIFY(d.docks.findChild<QDockWidget*>("processing")->isVisible());
    }

    void aLayoutWithADockThatIsGoneIsRestoredWithTheOthers() {
        QByteArray stored;
        {
            // As saveLayouts() writes it, by a program that has one dock more.
            Docks d;
            auto* later = new QDockWidget(&d.docks);
            later->setObjectName("of a later version");
            d.docks.addDockWidget(Qt::RightDockWidgetArea, later);
            d.docks.show();
            QVERIFY(QTest::qWaitForWindowExposed(&d.docks));
            d.docks.findChild<QDockWidget*>("processing")->close();
            stored = d.docks.saveLayouts();
        }
        Docks d;
        d.docks.show();
        QVERIFY(QTest::qWaitForWindowExposed(&d.docks));
        QVERIFY(d.docks.restoreLayouts(stored));
        QVERIFY(!d.docks.findChild<QDockWidget*>("processing")->isVisible());
        QVERIFY(d.charts()->isVisible());
    }
};

QTEST_MAIN(OperateDocksTest)
#include "operate_docks_test.moc"
