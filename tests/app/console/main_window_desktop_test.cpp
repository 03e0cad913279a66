// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/operate/operate_page.h"
#include "app/console/patterns/patterns_page.h"
#include "app/console/start/start_page.h"
#include "app/console/study/forms/protocol_reading.h"
#include "app/console/study/study_page.h"
#include "tests/app/console/window_bench.h"
#include "widgets/base/theme.h"
#include "widgets/chrome/page_rail.h"
#include "widgets/chrome/start/demo_card.h"
#include "widgets/chrome/start/first_steps.h"
#include "widgets/chrome/start/recent_list.h"
#include "widgets/chrome/stop_banner.h"
#include "widgets/chrome/stop_button.h"
#include "widgets/pattern/document/pattern_document.h"
#include "widgets/pattern/pattern_editor.h"
#include "widgets/pattern/timeline/timeline_view.h"
#include "widgets/view3d/scene3d_view.h"
#include "widgets/view3d/vtk/gl_setup.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QDir>
#include <QDockWidget>
#include <QFile>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QScreen>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include <algorithm>

using namespace teleta;
using console::ConsoleOptions;
using console::ConsoleSettings;

namespace {

constexpr int kPatience_ms = 30'000;

} // namespace

/// What the window remembers of the files, of the last session and of what people prefer.
class MainWindowDesktopTest : public QObject, protected test::WindowBench {
    Q_OBJECT

    QTemporaryDir m_folder;
    /// With what the window before has left.
    void openAgain(const ConsoleOptions& options = {}) {
        openWindow(options, false);
        m_window->resize(1200, 800);
        m_window->activateWindow(); // keys go to the active window
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    }

    /// A scene in a file of its own.
    QString sceneFile(const QString& name) const {
        const QString path = QDir(m_folder.path()).filePath(name);
        QFile::copy(QStringLiteral(":/scenes/tactile-two-contacts.toml"), path);
        return path;
    }
    bool isOpen(const QString& name) const {
        for (const auto& item : m_window->sources().items())
            if (item.name == name && item.isOpen())
                return true;
        return false;
    }
    QMenu* menu(const char* name) const { return m_window->findChild<QMenu*>(QLatin1String(name)); }
    QList<QToolButton*> startButtons(const char* name) const {
        auto buttons =
            m_window->operatePage().startPage().recent().findChildren<QToolButton*>(QLatin1String(name));
        erase_if(buttons, [](const QToolButton* button) { return button->isHidden(); });
        return buttons;
    }

private slots:
    void initTestCase() { base::applyTheme(base::ThemeChoice::light); }
    void init() { QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, m_folder.path()); }
    void cleanup() {
        m_window.reset();
        m_settings.reset();
        QFile::remove(m_folder.filePath("teleta/console.ini"));
    }

    void aFileThatWasOpenedIsInTheMenuAndOnTheStartPage() {
        openAgain();
        QVERIFY(!menu("recent")->isEnabled());
        QVERIFY(!m_window->operatePage().startPage().recent().isVisible());
        const QString scene = sceneFile("a & b.toml");
        ConsoleOptions options;
        options.files = {scene};
        openAgain(options);
        QTRY_VERIFY_WITH_TIMEOUT(isOpen("a & b"), kPatience_ms);
        m_window->close();
        openAgain();
        QVERIFY(menu("recent")->isEnabled());
        const QAction* recent = menu("recent")->actions().at(1); // below the name of the kind
        QCOMPARE(recent->text(), QString("a && b.toml"));
        QCOMPARE(recent->toolTip(), scene);
        const auto buttons = startButtons("recentFile");
        QCOMPARE(buttons.size(), 1);
        QCOMPARE(buttons.first()->accessibleName(), QString("a & b.toml"));
        buttons.first()->setFocus();
        QTest::keyClick(buttons.first(), Qt::Key_Space);
        QTRY_VERIFY_WITH_TIMEOUT(isOpen("a & b"), kPatience_ms);
        // The list can be emptied.
        menu("recent")->actions().last()->trigger();
        QTRY_VERIFY(!menu("recent")->isEnabled()); // the menus are made anew
        QVERIFY(ConsoleSettings(false).recentFiles().isEmpty());
    }

    void whatWasOpenAtTheEndIsOfferedAndReopened() {
        ConsoleOptions options;
        options.scenes = {":/scenes/tactile-indenter.toml", ":/scenes/tactile-two-contacts.toml"};
        openAgain(options);
        QTRY_VERIFY_WITH_TIMEOUT(isOpen("tactile-indenter") && isOpen("tactile-two-contacts"), kPatience_ms);
        m_window->close();
        openAgain();
        QVERIFY(m_window->sources().items().empty());
        const auto buttons = startButtons("reopenSession");
        QCOMPARE(buttons.size(), 1);
        QVERIFY(buttons.first()->accessibleName().contains("tactile-indenter, tactile-two-contacts"));
        QTest::mouseClick(buttons.first(), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(isOpen("tactile-indenter") && isOpen("tactile-two-contacts"), kPatience_ms);
    }

    void whatWasOpenIsOpenedByItselfWhereThatIsPreferred() {
        ConsoleOptions options;
        options.scenes = {":/scenes/tactile-indenter.toml"};
        openAgain(options);
        QTRY_VERIFY_WITH_TIMEOUT(isOpen("tactile-indenter"), kPatience_ms);
        m_settings->setAtStart(console::AtStart::open);
        m_window->close();
        openAgain();
        QTRY_VERIFY_WITH_TIMEOUT(isOpen("tactile-indenter"), kPatience_ms);
        m_window->close();
        // What the command line names comes instead.
        options.scenes = {":/scenes/tactile-two-contacts.toml"};
        openAgain(options);
        QTRY_VERIFY_WITH_TIMEOUT(isOpen("tactile-two-contacts"), kPatience_ms);
        QVERIFY(!isOpen("tactile-indenter"));
        m_settings->setAtStart(console::AtStart::nothing);
        m_window->close();
        openAgain();
        QVERIFY(startButtons("reopenSession").isEmpty());
        QVERIFY(m_window->sources().items().empty());
    }

    void stopIsOnTheScreenWhateverTheWindowWasBefore_data() {
        QTest::addColumn<QSize>("asked");
        QTest::newRow("as it was left") << QSize();
        QTest::newRow("as large as the screen") << QGuiApplication::primaryScreen()->size();
        QTest::newRow("larger") << QGuiApplication::primaryScreen()->size() + QSize(300, 200);
    }
    void stopIsOnTheScreenWhateverTheWindowWasBefore() {
        QFETCH(QSize, asked);
        openWindow();
        const QRect room = m_window->screen()->availableGeometry();
        m_window->move(room.topLeft() + QPoint(60, 40));
        m_window->resize(room.size());
        QTRY_COMPARE(m_window->size(), room.size());
        m_settings = std::make_unique<ConsoleSettings>(false);
        m_settings->setGeometry(m_window->saveGeometry());
        ConsoleOptions options;
        options.size = asked;
        openWindow(options, false);
        const auto* stop = m_window->findChild<chrome::StopButton*>();
        const auto isWhole = [stop, room] {
            return room.contains(QRect(stop->mapToGlobal(QPoint()), stop->size()));
        };
        QTRY_VERIFY(isWhole());
        QVERIFY(room.contains(m_window->geometry()));
    }

    /// STOP had the keys: it was pressed and released by the mouse.
    void afterStopSpaceIsForThePageAgain() {
        openAgain();
        auto* stop = m_window->findChild<chrome::StopButton*>();
        QTest::mouseClick(stop, Qt::LeftButton);
        QVERIFY(m_stop->engaged());
        QTest::mousePress(stop, Qt::LeftButton);
        QTRY_VERIFY(!m_stop->engaged());
        QTest::mouseRelease(stop, Qt::LeftButton);
        QVERIFY(!stop->hasFocus());
        // A page that is chosen by the mouse takes the keys as well.
        stop->setFocus();
        const auto rail = m_window->findChild<chrome::PageRail*>()->findChildren<QToolButton*>();
        QTest::mouseClick(rail.at(1), Qt::LeftButton);
        QTRY_VERIFY(m_window->patternsPage().isVisible());
        auto* timeline = m_window->patternsPage().editor().timeline();
        QCOMPARE(QApplication::focusWidget(), timeline);
        // The page is told with its next tick that STOP was released.
        QTRY_VERIFY(m_window->patternsPage().editor().findChild<QAction*>("playPattern")->isEnabled());
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
        QVERIFY(!m_stop->engaged());
        QVERIFY(m_window->patternsPage().editor().isPlaying());
    }

    void aFileThatIsNotMcapIsReportedAndNotImported() {
        const QString path = m_folder.filePath("text.mcap");
        QFile text(path);
        QVERIFY(text.open(QIODevice::WriteOnly));
        text.write("time_s,t0\n");
        text.close();
        ConsoleOptions options;
        options.files = {path};
        openAgain(options);
        QTRY_VERIFY_WITH_TIMEOUT(m_window->anyFailure(), kPatience_ms);
        QVERIFY(!QFile::exists(m_folder.filePath("text.teleta")));
    }

    void preferencesAreAskedForByKeyAndKept() {
        openAgain();
        QTest::keyClick(m_window.get(), Qt::Key_Comma, Qt::ControlModifier);
        auto* dialog = m_window->findChild<QDialog*>();
        QVERIFY(dialog != nullptr);
        QVERIFY(QTest::qWaitForWindowExposed(dialog));
        auto* theme = dialog->findChild<QComboBox*>("theme");
        theme->setFocus();
        QTest::keyClick(theme, Qt::Key_End);
        QTest::keyClick(theme, Qt::Key_Return);
        QTRY_COMPARE(m_settings->theme(), QString("dark"));
        QCOMPARE(ConsoleSettings(false).theme(), QString("dark"));
        QTRY_VERIFY(m_window->palette().color(QPalette::Window).lightness() < 128);
        base::applyTheme(base::ThemeChoice::light);
    }

    void firstStepsTickThemselvesOffAndAreRemembered() {
        openAgain();
        auto& steps = m_window->operatePage().startPage().firstSteps();
        QVERIFY(steps.isVisible());
        const auto step = [this](const char* name) {
            return m_window->operatePage()
                .startPage()
                .firstSteps()
                .findChild<chrome::DemoCard*>(QLatin1String(name))
                ->step();
        };
        for (const QString& name : chrome::FirstSteps::names())
            QCOMPARE(step(qPrintable(name)), chrome::DemoCard::Step::open);
        // The card leads to the place; playing does the step.
        QTest::mouseClick(steps.findChild<chrome::DemoCard*>("pattern"), Qt::LeftButton);
        QTRY_VERIFY(m_window->patternsPage().isVisible());
        QTRY_COMPARE(m_window->patternsPage().editor().document()->pattern().id, "shape.A.dynamic");
        QCOMPARE(step("pattern"), chrome::DemoCard::Step::open);
        QTest::keyClick(m_window->patternsPage().editor().timeline(), Qt::Key_Space);
        QTRY_COMPARE(step("pattern"), chrome::DemoCard::Step::done);
        QTest::keyClick(m_window.get(), Qt::Key_1, Qt::ControlModifier);
        auto* touch = steps.findChild<chrome::DemoCard*>("touch");
        QTRY_VERIFY(touch->isVisible());
        QTest::mouseClick(touch, Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(step("touch"), chrome::DemoCard::Step::done, kPatience_ms);
        m_window->close();

        openAgain();
        QVERIFY(m_window->operatePage().startPage().firstSteps().isVisible());
        QCOMPARE(step("touch"), chrome::DemoCard::Step::done);
        QCOMPARE(step("study"), chrome::DemoCard::Step::open);
        QTest::mouseClick(m_window->findChild<QToolButton*>("hideFirstSteps"), Qt::LeftButton);
        QVERIFY(!m_window->operatePage().startPage().firstSteps().isVisible());
        m_window->close();
        openAgain();
        QVERIFY(!m_window->operatePage().startPage().firstSteps().isVisible());
    }

    void firstStepsThatAreAllDoneAreNotShownAtTheNextStart() {
        ConsoleSettings(false).setFirstStepsDone(chrome::FirstSteps::names());
        openAgain();
        QVERIFY(!m_window->operatePage().startPage().firstSteps().isVisible());
    }

    void cardsOfStudiesAndPatternsOpenThem() {
        openAgain();
        const auto card = [this](const QString& title) -> chrome::DemoCard* {
            for (auto* each : m_window->findChildren<chrome::DemoCard*>())
                if (each->text() == title)
                    return each;
            return nullptr;
        };
        QVERIFY(card("Triangle, static") != nullptr);
        QTest::mouseClick(card("Triangle, static"), Qt::LeftButton);
        QTRY_VERIFY(m_window->patternsPage().isVisible());
        QTRY_COMPARE(m_window->patternsPage().editor().document()->pattern().id, "shape.C.static");
        QTest::keyClick(m_window.get(), Qt::Key_1, Qt::ControlModifier);
        QVERIFY(card("The published protocol") != nullptr);
        QTest::mouseClick(card("The published protocol"), Qt::LeftButton);
        QTRY_VERIFY(m_window->studyPage().isVisible());
        QTRY_VERIFY(m_window->studyPage().findChild<console::ProtocolReading*>() != nullptr);
    }

    void recentFilesHaveAPictureOfWhatIsInThem() {
        const QString scene = sceneFile("pictured.toml");
        ConsoleSettings(false).addRecentFile(scene);
        openAgain();
        QCOMPARE(startButtons("recentFile").size(), 1);
        const QSize icon = startButtons("recentFile").first()->iconSize();
        QTRY_VERIFY_WITH_TIMEOUT(startButtons("recentFile").first()->iconSize().width() > icon.width(),
                                 kPatience_ms);
    }

    void aLayerOfTheReconstructionThatWasSwitchedOffStaysOff() {
        openAgain();
        auto& view = m_window->operatePage().reconstruction();
        QVERIFY(view.hiddenLayers().isEmpty());
        QMenu menu;
        view.fillMenu(menu);
        for (const char* name : {"trail", "jointLimits", "forces", "moments"}) {
            auto* layer = view.findChild<QAction*>(QLatin1String(name));
            QVERIFY(menu.actions().contains(layer));
            QVERIFY2(layer->isChecked() && !layer->text().isEmpty(), name);
        }
        menu.popup(view.mapToGlobal(QPoint()));
        QTest::mouseClick(&menu, Qt::LeftButton, {},
                          menu.actionGeometry(view.findChild<QAction*>("trail")).center());
        QCOMPARE(view.hiddenLayers(), QStringList{"trail"});
        m_window->close();
        openAgain();
        QCOMPARE(m_window->operatePage().reconstruction().hiddenLayers(), QStringList{"trail"});
        QVERIFY(!m_window->findChild<QAction*>("trail")->isChecked());
    }

    /// They may have been meant for the menu, and stop nevertheless: the banner says so.
    void twoEscapesOutOfAMenuStopAndAreNamed() {
        openAgain();
        QAction* view = nullptr;
        for (QAction* action : m_window->menuBar()->actions())
            if (action->menu() != nullptr && !action->menu()->actions().isEmpty())
                view = action;
        QVERIFY(view != nullptr);
        view->menu()->popup(m_window->mapToGlobal(QPoint(40, 40)));
        QVERIFY(QTest::qWaitForWindowExposed(view->menu()));
        QTest::keyClick(view->menu(), Qt::Key_Escape);
        QTRY_VERIFY(!view->menu()->isVisible());
        QVERIFY2(!m_stop->engaged(), "one closes the menu");
        QTest::keyClick(m_window.get(), Qt::Key_Escape);
        QVERIFY(m_stop->engaged());
        const auto labels = m_window->findChild<chrome::StopBanner*>()->findChildren<QLabel*>();
        QVERIFY(std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
            return label->isVisible() && label->text().contains("Esc was pressed twice.");
        }));
    }

    void twoArmsHaveTwoNamesForTheirJoints() {
        ConsoleOptions options;
        options.scenes = {":/scenes/teleta-touch.toml", ":/scenes/teleta-contour-circle.toml"};
        openAgain(options);
        const auto names = [this] {
            QStringList all;
            for (const chrome::DeviceReading& reading : m_window->operatePage().readings())
                all << reading.name;
            return all;
        };
        QTRY_COMPARE_WITH_TIMEOUT(names().filter("joints").size(), 2, kPatience_ms);
        QVERIFY2(names().removeDuplicates() == 0, qPrintable(names().join(", ")));
    }

    void aViewIsMaximisedByKey() {
        ConsoleOptions options;
        options.scenes = {":/scenes/tactile-two-contacts.toml"};
        openAgain(options);
        QTRY_VERIFY_WITH_TIMEOUT(isOpen("tactile-two-contacts"), kPatience_ms);
        auto& docks = m_window->operatePage().docks();
        QTRY_VERIFY(docks.findChild<QDockWidget*>("charts")->isVisible());
        QTest::keyClick(m_window.get(), Qt::Key_M, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(docks.maximised(), QString("heatmap"));
        QVERIFY(m_window->findChild<QAction*>("maximise")->isChecked());
        QVERIFY(!docks.findChild<QDockWidget*>("charts")->isVisible());
        QTest::keyClick(m_window.get(), Qt::Key_M, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(docks.maximised(), QString());
        QVERIFY(docks.findChild<QDockWidget*>("charts")->isVisible());
    }
};

int main(int argc, char** argv) {
    view3d::configureOpenGlBeforeApplication();
    QApplication application(argc, argv);
    QCoreApplication::setOrganizationName(QStringLiteral("TeleTA"));
    MainWindowDesktopTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "main_window_desktop_test.moc"
