// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/console_options.h"
#include "app/console/main_window.h"
#include "app/console/operate/operate_page.h"
#include "widgets/base/theme.h"
#include "widgets/chrome/page_rail.h"
#include "widgets/chrome/start/demo_card.h"
#include "widgets/chrome/start/demo_list.h"
#include "widgets/chrome/stop_button.h"

#include <QAbstractButton>
#include <QAccessible>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QSet>
#include <QStackedWidget>
#include <QTabBar>
#include <QTest>

#include <memory>
#include <set>

using namespace teleta;
using console::ConsoleOptions;
using console::ConsoleSettings;
using console::MainWindow;

namespace {

QString describe(const QWidget* widget) {
    QStringList path;
    for (const QWidget* each = widget; each != nullptr && path.size() < 5; each = each->parentWidget())
        path.prepend(QString::fromLatin1(each->metaObject()->className()) +
                     (each->objectName().isEmpty() ? QString() : QLatin1Char(' ') + each->objectName()));
    return path.join(QLatin1String(" > "));
}

QString nameOf(QWidget* widget) {
    QAccessibleInterface* accessible = QAccessible::queryAccessibleInterface(widget);
    return accessible == nullptr ? QString() : accessible->text(QAccessible::Name);
}

/// Qt leaves the tabs of docks out of the chain: the menu View brings a dock forward.
bool isTabsOfDocks(const QWidget* widget) {
    return qobject_cast<const QTabBar*>(widget) != nullptr &&
           qobject_cast<const QMainWindow*>(widget->parentWidget()) != nullptr;
}

/// Of an exclusive group only one button is a stop of Tab; the arrows go to the others.
bool isReachedByArrows(const QWidget* widget) {
    const auto* button = qobject_cast<const QAbstractButton*>(widget);
    return button != nullptr && button->autoExclusive() && !button->isChecked();
}

} // namespace

/// Everything can be reached and is named without a mouse.
class FocusChainTest : public QObject {
    Q_OBJECT

    core::StopSwitch m_stop;
    std::unique_ptr<ConsoleSettings> m_settings;
    std::unique_ptr<MainWindow> m_window;

    /// The widgets of the page that is shown to which Tab is said to go.
    std::set<QWidget*> stops(QWidget* page) const {
        std::set<QWidget*> found;
        for (QWidget* widget : page->findChildren<QWidget*>())
            if (widget->isVisible() && widget->isEnabled() && (widget->focusPolicy() & Qt::TabFocus) != 0 &&
                widget->focusProxy() == nullptr && widget->window() == m_window.get() &&
                !isReachedByArrows(widget) && !isTabsOfDocks(widget))
                found.insert(widget);
        return found;
    }

    static void checkNames(const std::set<QWidget*>& wanted) {
        QStringList nameless;
        for (QWidget* widget : wanted)
            if (nameOf(widget).isEmpty())
                nameless << describe(widget);
        QVERIFY2(nameless.isEmpty(), qPrintable("no accessible name: " + nameless.join("; ")));
    }

    /// Whether it lies in the window: what is in a dock behind another one is far outside.
    bool isShown(const QWidget* widget) const {
        return QRect(QPoint(), m_window->size())
            .intersects(QRect(widget->mapTo(m_window.get(), QPoint()), widget->size()));
    }

    /// Tab goes from the first of these to all of them and back to it, and each that it goes to is seen.
    void walk(const std::set<QWidget*>& wanted) const {
        (*wanted.begin())->setFocus(Qt::TabFocusReason);
        std::set<QWidget*> reached;
        QWidget* last = nullptr;
        constexpr int kMostStops = 400;
        for (int i = 0; i < kMostStops; ++i) {
            QWidget* focus = QApplication::focusWidget();
            QVERIFY(focus != nullptr);
            if (focus == last) {
                // An editor or table may keep Tab for itself: Ctrl+Tab leaves it.
                QTest::keyClick(focus, Qt::Key_Tab, Qt::ControlModifier);
                QVERIFY2(QApplication::focusWidget() != focus, qPrintable("a trap: " + describe(focus)));
                focus = QApplication::focusWidget();
            }
            if (reached.contains(focus) && focus == *wanted.begin())
                break;
            QTRY_VERIFY2_WITH_TIMEOUT(isShown(focus), qPrintable("not seen: " + describe(focus)), 15'000);
            reached.insert(focus);
            last = focus;
            QTest::keyClick(focus, Qt::Key_Tab);
        }
        QStringList missed;
        for (QWidget* widget : wanted)
            if (!reached.contains(widget) && widget->isVisible() && widget->isEnabled())
                missed << describe(widget);
        QVERIFY2(missed.isEmpty(), qPrintable("not reached by Tab: " + missed.join("; ")));
    }

private slots:
    void initTestCase() {
        base::applyTheme(base::ThemeChoice::light);
        m_settings = std::make_unique<ConsoleSettings>(true);
        ConsoleOptions options;
        options.scenes << "teleta-touch";
        m_window = std::make_unique<MainWindow>(options, *m_settings, m_stop);
        m_window->resize(1500, 950);
        m_window->show();
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
        m_window->openRequested(options);
        QTRY_VERIFY_WITH_TIMEOUT(
            m_window->sources().active() != nullptr && m_window->sources().active()->displayed > 0, 60'000);
    }
    void cleanupTestCase() { m_window.reset(); }

    void everythingIsNamedAndTabGoesThere_data() {
        QTest::addColumn<int>("key");
        int key = Qt::Key_1;
        for (const QString& page : console::pageNames())
            QTest::newRow(qPrintable(page)) << key++;
    }
    void everythingIsNamedAndTabGoesThere() {
        QFETCH(int, key);
        QTest::keyClick(m_window.get(), static_cast<Qt::Key>(key), Qt::ControlModifier);
        auto* rail = m_window->findChild<chrome::PageRail*>();
        QCOMPARE(rail->currentPage(), QString::fromLatin1(QTest::currentDataTag()));
        QWidget* page = m_window->findChild<QStackedWidget*>()->currentWidget();
        const std::set<QWidget*> wanted = stops(page);
        QVERIFY(wanted.size() > 3);
        checkNames(wanted);
        if (QTest::currentTestFailed())
            return;
        walk(wanted);
    }

    void everyDockOfOperateIsNamedAndTabGoesThereAndBringsItForward() {
        QTest::keyClick(m_window.get(), Qt::Key_1, Qt::ControlModifier);
        int docks = 0;
        for (auto* dock : m_window->operatePage().docks().findChildren<QDockWidget*>()) {
            if (!dock->toggleViewAction()->isVisible()) // of another kind of source
                continue;
            dock->show();
            dock->raise();
            ++docks;
            const std::set<QWidget*> wanted = stops(dock);
            checkNames(wanted);
            if (!wanted.empty())
                walk(wanted);
            if (QTest::currentTestFailed())
                return;
        }
        QVERIFY(docks > 5);
    }

    void aFocusThatIsDrivenOutBringsNothingForward() {
        QTest::keyClick(m_window.get(), Qt::Key_1, Qt::ControlModifier);
        auto& docks = m_window->operatePage().docks();
        auto* front = docks.findChild<QDockWidget*>("jog");
        auto* behind = docks.findChild<QDockWidget*>("feedback");
        front->raise();
        QTRY_VERIFY_WITH_TIMEOUT(isShown(front) && !isShown(behind), 30'000);
        auto* field = new QLineEdit(front->widget());
        auto* next = behind->findChild<QComboBox*>();
        QWidget::setTabOrder(field, next);
        field->show();
        field->setFocus(Qt::TabFocusReason);
        QVERIFY(field->hasFocus());
        field->setEnabled(false);
        QVERIFY(next->hasFocus());
        QVERIFY(isShown(front) && !isShown(behind));
        field->setEnabled(true);
        field->setFocus(Qt::TabFocusReason);
        QTest::keyClick(field, Qt::Key_Tab);
        QVERIFY(next->hasFocus());
        QTRY_VERIFY_WITH_TIMEOUT(isShown(behind) && !isShown(front), 30'000);
        delete field;
    }

    void everyMenuOpensByItsLetter() {
        QSet<QString> letters;
        for (const QAction* action : m_window->menuBar()->actions()) {
            const QString letter = QKeySequence::mnemonic(action->text()).toString();
            QVERIFY2(!letter.isEmpty() && !letters.contains(letter), qPrintable(action->text()));
            letters.insert(letter);
        }
    }

    void aMenuOpensThoughAFieldOfThePageHasItsLetter() {
        QTest::keyClick(m_window.get(), Qt::Key_1, Qt::ControlModifier);
        auto* processing = m_window->operatePage().docks().findChild<QDockWidget*>("processing");
        processing->show();
        processing->raise();
        QTRY_VERIFY_WITH_TIMEOUT(isShown(processing), 30'000);
        auto* field = new QLineEdit(processing->widget());
        auto* label = new QLabel(QStringLiteral("&Force"), processing->widget());
        label->setBuddy(field);
        field->show();
        label->show();
        for (const QAction* action : m_window->menuBar()->actions()) {
            const QKeySequence letter = QKeySequence::mnemonic(action->text());
            auto* menu = action->menu<QMenu*>();
            QTest::keyClick(m_window.get(), letter[0].key(), Qt::AltModifier);
            QTRY_COMPARE_WITH_TIMEOUT(QApplication::activePopupWidget(), menu, 30'000);
            menu->close(); // two Esc would be STOP
            QVERIFY(!field->hasFocus());
        }
        delete label;
        delete field;
    }

    // The last one: its window takes the keyboard away from the other.
    void theCardsOfTheStartPageAreReachedByTab() {
        ConsoleSettings settings(true);
        MainWindow window(ConsoleOptions(), settings, m_stop);
        window.resize(1500, 950);
        window.show();
        window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        const auto cards = window.operatePage().findChildren<chrome::DemoCard*>();
        QVERIFY(cards.size() > 10);
        std::set<QWidget*> left(cards.begin(), cards.end());
        cards.first()->setFocus(Qt::TabFocusReason); // of the first steps
        left.erase(cards.first());
        constexpr int kMostStops = 200;
        for (int i = 0; i < kMostStops && !left.empty(); ++i) {
            QTest::keyClick(QApplication::focusWidget() != nullptr ? QApplication::focusWidget() : &window,
                            Qt::Key_Tab);
            QWidget* focus = QApplication::focusWidget();
            left.erase(focus);
            // It could not show that it has the keyboard.
            QVERIFY(qobject_cast<chrome::DemoList*>(focus) == nullptr);
            QVERIFY2(qobject_cast<chrome::StopButton*>(focus) == nullptr || left.empty(), "after the cards");
        }
        QVERIFY2(left.empty(), qPrintable(QString::number(left.size())));
    }
};

QTEST_MAIN(FocusChainTest)
#include "focus_chain_test.moc"
