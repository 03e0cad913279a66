// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/help/handbook_window.h"
#include "app/console/operate/operate_page.h"
#include "app/console/study/study_page.h"
#include "backend/study/store/study_store.h"
#include "tests/app/console/window_bench.h"
#include "widgets/base/numbers/quantity_text.h"
#include "widgets/base/theme.h"
#include "widgets/charts/strip_chart_view.h"
#include "widgets/chrome/device_strip.h"
#include "widgets/chrome/message_log.h"
#include "widgets/chrome/page_rail.h"
#include "widgets/chrome/playback_bar.h"
#include "widgets/chrome/stop_banner.h"
#include "widgets/chrome/stop_button.h"
#include "widgets/servo/servo_panel.h"
#include "widgets/servo/servo_runs_view.h"
#include "widgets/tactile/heatmap_view.h"
#include "widgets/touch/jog/jog_panel.h"
#include "widgets/view3d/vtk/gl_setup.h"

#include <QApplication>
#include <QDialog>
#include <QDir>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QScreen>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <memory>

using namespace teleta;
using console::ConsoleOptions;
using console::ConsoleSettings;
using console::MainWindow;
using console::RecordingArguments;

/// The window as a whole, on a real display.
class MainWindowTest : public QObject, protected test::WindowBench {
    Q_OBJECT

    QTemporaryDir m_folder;
    QString write(const QString& name, const QByteArray& content) {
        QFile file(QDir(m_folder.path()).filePath(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size())
            qFatal("cannot write %s", qPrintable(name));
        return file.fileName();
    }

    /// 50 frames at 10 Hz of a 2 x 3 array whose last taxel carries the frame's number.
    QString writeRecording(const QString& name) {
        QByteArray text = "time_s,t0,t1,t2,t3,t4,t5\n";
        for (int frame = 0; frame < 50; ++frame)
            text += QByteArray::number(frame * 0.1, 'f', 1) + ",0,0,0,0,0," + QByteArray::number(frame + 1) +
                    "\n";
        return write(name, text);
    }

    static ConsoleOptions replay(const QString& path) {
        ConsoleOptions options;
        RecordingArguments recording;
        recording.path = path;
        recording.rows = 2;
        recording.columns = 3;
        options.recordings.push_back(recording);
        return options;
    }

    template <typename Widget>
    Widget* child() const {
        return m_window->findChild<Widget*>();
    }

    /// Each once, of numbers that are painted and of those in fields.
    QString decimalSigns() const {
        QString signs = base::fixedDigits(0.5, 1).mid(1, 1);
        for (const auto* field : m_window->findChildren<QDoubleSpinBox*>()) {
            for (const QChar sign : field->text())
                if ((sign == u'.' || sign == u',') && field->decimals() > 0 && !signs.contains(sign))
                    signs += sign;
        }
        return signs;
    }

    bool showsData() const {
        auto* item = m_window->sources().active();
        return item != nullptr && item->displayed > 0;
    }

private slots:
    void theLanguageIsChosenWhileItRuns() {
        openWindow();
        const auto choose = [this](const QString& name) {
            const auto* menu = m_window->findChild<QMenu*>("languages");
            for (QAction* action : menu->actions())
                if (action->text() == name)
                    action->trigger();
        };
        const auto firstMenu = [this] { return m_window->menuBar()->actions().front()->text(); };
        choose(QStringLiteral("Fran\u00e7ais"));
        QTRY_COMPARE(firstMenu(), QStringLiteral("&Fichier"));
        for (const QAction* action : m_window->findChild<QMenu*>("languages")->actions())
            QCOMPARE(action->isChecked(), action->text() == QStringLiteral("Fran\u00e7ais"));
        QCOMPARE(decimalSigns(), QStringLiteral(","));
        choose(QStringLiteral("English"));
        QTRY_COMPARE(firstMenu(), QStringLiteral("&File"));
        QCOMPARE(decimalSigns(), QStringLiteral("."));
    }

    void aProgramIsRestartedByOneWord() {
        openWindow();
        QStringList words;
        for (const auto* button : child<touch::JogPanel>()->findChildren<QPushButton*>())
            words << button->text().remove(u'&');
        for (const auto* action : m_window->findChildren<QAction*>())
            if (action->shortcut() == QKeySequence(Qt::CTRL | Qt::Key_F5))
                QVERIFY2(words.contains(action->text().remove(u'&')), qPrintable(action->text()));
    }

    void theHandbookOpensAtThePageThatIsShown() {
        openWindow();
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
        auto* rail = child<chrome::PageRail>();
        for (const auto& [key, page] :
             {std::pair(Qt::Key_3, "study"), std::pair(Qt::Key_5, "cost"), std::pair(Qt::Key_1, "operate"),
              std::pair(Qt::Key_2, "patterns"), std::pair(Qt::Key_4, "calibrate")}) {
            m_window->activateWindow();
            QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
            QTest::keyClick(m_window.get(), key, Qt::ControlModifier);
            QCOMPARE(rail->currentPage(), QString(page));
            QTest::keyClick(m_window.get(), Qt::Key_F1);
            auto* handbook = child<console::HandbookWindow>();
            QVERIFY(handbook != nullptr && handbook->isVisible());
            QCOMPARE(handbook->page(), QString(page));
        }
    }

    void initTestCase() { base::applyTheme(base::ThemeChoice::light); }
    void cleanup() { m_window.reset(); }

    void startsEmptyAndOffersADemoThatRuns() {
        openWindow();
        auto* demo = m_window->findChild<QPushButton*>("openDemo");
        QVERIFY(demo != nullptr && demo->isVisible());
        QTest::mouseClick(demo, Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(showsData(), 20'000);
        QVERIFY(!demo->isVisible());
        QTRY_VERIFY(child<chrome::DeviceStrip>()->text(0).contains("teleta-touch"));
        QVERIFY(!child<chrome::PlaybackBar>()->isVisible());
    }

    void playsARecordingWithATimeBarAndSteps() {
        openWindow(replay(writeRecording("run.csv")));
        QTRY_VERIFY_WITH_TIMEOUT(showsData(), 20'000);
        auto* bar = child<chrome::PlaybackBar>();
        QVERIFY(bar->isVisible());
        auto* item = m_window->sources().active();
        QTest::keyClick(bar, Qt::Key_Home);
        QTest::keyClick(bar, Qt::Key_Right);
        auto* playback = item->channel->playback();
        QVERIFY(playback != nullptr);
        QTRY_VERIFY(playback->position().paused);
        QTRY_COMPARE(item->array()->snapshot().features.force_N, 2.0);
        QTest::keyClick(bar, Qt::Key_Right);
        QTRY_COMPARE(item->array()->snapshot().features.force_N, 3.0);
        QTest::keyClick(bar, Qt::Key_Left);
        QTRY_COMPARE(item->array()->snapshot().features.force_N, 2.0);
    }

    void saysWhatIsWrongWithAFileWithoutAModalDialog_data() {
        QTest::addColumn<QByteArray>("content");
        QTest::newRow("text instead of a number")
            << QByteArray("time_s,t0,t1,t2,t3,t4,t5\n0,1,2,3,4,5,six\n");
        QTest::newRow("row too short") << QByteArray("time_s,t0,t1,t2,t3,t4,t5\n0,1,2\n");
        QTest::newRow("columns missing") << QByteArray("time_s,t0,t1\n0,1,2\n");
        QTest::newRow("empty") << QByteArray();
    }
    void saysWhatIsWrongWithAFileWithoutAModalDialog() {
        QFETCH(QByteArray, content);
        openWindow(replay(write("wrong.csv", content)));
        auto& messages = m_window->operatePage().messages();
        QTRY_COMPARE_WITH_TIMEOUT(messages.count(), 1, 20'000);
        QVERIFY(messages.isVisible());
        QVERIFY(QApplication::activeModalWidget() == nullptr);
        QVERIFY(m_window->anyFailure());
    }

    void keepsWhatCameBeforeADamagedRowAndSaysWhereItIs() {
        QByteArray text = "time_s,t0,t1,t2,t3,t4,t5\n";
        for (int frame = 0; frame < 20; ++frame)
            text += QByteArray::number(frame * 0.01, 'f', 2) + ",0,0,0,0,0,1\n";
        openWindow(replay(write("damaged.csv", text + "0.2,0,0,oops,0,0,1\n")));
        auto& messages = m_window->operatePage().messages();
        QTRY_COMPARE_WITH_TIMEOUT(messages.count(), 1, 20'000);
        auto* item = m_window->sources().active();
        QVERIFY(item != nullptr);
        QTRY_COMPARE(item->channel->framesProcessed(), std::uint64_t(20));
        QVERIFY(QString::fromStdString(item->channel->status().message).contains("damaged.csv:22"));
    }

    void anUnknownKeyInASceneIsSaidWithItsPlace() {
        ConsoleOptions options;
        options.scenes << write("scene.toml", "name = \"x\"\nfrobnicate = 1\n");
        openWindow(options);
        QTRY_COMPARE_WITH_TIMEOUT(m_window->operatePage().messages().count(), 1, 20'000);
        QVERIFY(QApplication::activeModalWidget() == nullptr);
    }

    void aSourceListWithAMistakeIsNotTakenForAScene() {
        ConsoleOptions options;
        options.files << write("lab.toml", "[[source]]\nscene = \"demo.toml\"\nspeeed = 2\n");
        openWindow(options);
        auto& messages = m_window->operatePage().messages();
        QTRY_COMPARE_WITH_TIMEOUT(messages.count(), 1, 20'000);
        const auto labels = messages.findChildren<QLabel*>();
        QVERIFY(std::any_of(labels.begin(), labels.end(),
                            [](const QLabel* label) { return label->text().contains("speeed"); }));
        QVERIFY(m_window->anyFailure());
        QVERIFY(m_window->sources().items().empty());
    }

    void aReleaseOfEscapeThatIsLostTakesNoStopAway() {
        openWindow();
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
        QTest::keyPress(m_window.get(), Qt::Key_Escape);
        emit qApp->applicationStateChanged(Qt::ApplicationInactive); // the release goes elsewhere
        QVERIFY(!m_stop->engaged());
        QTest::keyPress(m_window.get(), Qt::Key_Escape);
        QVERIFY(m_stop->engaged());
        QTest::keyRelease(m_window.get(), Qt::Key_Escape);
    }

    void stopsByButtonByKeyAndByTwoEscapesAndReleasesOnlyByHolding() {
        openWindow();
        auto* button = child<chrome::StopButton>();
        QTest::mouseClick(button, Qt::LeftButton);
        QVERIFY(m_stop->engaged());
        QVERIFY(button->engaged());
        QTest::mouseClick(button, Qt::LeftButton);
        QVERIFY(m_stop->engaged());
        QTest::mousePress(button, Qt::LeftButton);
        QTRY_VERIFY(!m_stop->engaged());
        QTest::mouseRelease(button, Qt::LeftButton);

        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
        QTest::keyClick(m_window.get(), Qt::Key_Period, Qt::ControlModifier);
        QVERIFY(m_stop->engaged());
        m_stop->release();
        QTest::keyClick(m_window.get(), Qt::Key_Escape);
        QVERIFY(!m_stop->engaged());
        QTest::keyClick(m_window.get(), Qt::Key_Escape);
        QVERIFY(m_stop->engaged());

        // Also over a dialog, whose parent takes no input.
        QDialog dialog(m_window.get());
        dialog.setWindowModality(Qt::WindowModal);
        dialog.show();
        QVERIFY(QTest::qWaitForWindowActive(&dialog));
        m_stop->release();
        QTest::keyClick(&dialog, Qt::Key_Period, Qt::ControlModifier);
        QVERIFY(m_stop->engaged());
    }

    void saysOnEachPageWhatStoppedAndLogsIt() {
        openWindow();
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
        auto* banner = child<chrome::StopBanner>();
        QVERIFY(!banner->isVisible());
        const auto says = [banner](const char* words) {
            const auto labels = banner->findChildren<QLabel*>();
            return std::any_of(labels.begin(), labels.end(), [&](const QLabel* label) {
                return label->isVisible() && label->text().contains(QLatin1String(words));
            });
        };
        QTest::keyClick(m_window.get(), Qt::Key_Escape);
        QTest::keyClick(m_window.get(), Qt::Key_Escape);
        QVERIFY(banner->isVisible());
        QVERIFY(says("Esc was pressed twice."));
        QVERIFY(says("hold the STOPPED button"));
        // The first cause remains.
        QTest::keyClick(m_window.get(), Qt::Key_Period, Qt::ControlModifier);
        QVERIFY(says("Esc was pressed twice."));
        for (const Qt::Key page : {Qt::Key_2, Qt::Key_5}) {
            QTest::keyClick(m_window.get(), page, Qt::ControlModifier);
            QVERIFY(banner->isVisible());
        }
        m_stop->release();
        QTRY_VERIFY(!banner->isVisible());
        // Something else than this window.
        m_stop->engage();
        QTRY_VERIFY(says("The program engaged STOP."));
        m_stop->release();
        QTRY_VERIFY(!banner->isVisible());
        QTRY_VERIFY(chrome::MessageLog::instance().asText().contains("STOP. Esc was pressed twice."));
        QTRY_VERIFY(chrome::MessageLog::instance().asText().contains("STOP was released after"));
    }

    void aSceneThatStopHoldsOffersToRun() {
        ConsoleOptions options;
        options.scenes = {":/scenes/tactile-two-contacts.toml"};
        openWindow(options);
        QTRY_VERIFY(showsData());
        m_stop->engage();
        QTRY_VERIFY(child<chrome::StopBanner>()->isVisible());
        m_stop->release();
        const auto button = [this] {
            for (auto* action : m_window->findChildren<QAbstractButton*>("action"))
                if (action->isVisible() && action->text().remove(u'&') == QStringLiteral("Run"))
                    return action;
            return static_cast<QAbstractButton*>(nullptr);
        };
        QTRY_VERIFY(button() != nullptr);
        const auto load_N = [this] {
            auto& channel = *m_window->sources().active()->channel;
            return dynamic_cast<pipeline::TouchChannel&>(channel).snapshot().features.force_N;
        };
        const double held_N = load_N();
        QTest::mouseClick(button(), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(std::abs(load_N() - held_N) > 0.5, 20'000);
        QTRY_VERIFY(button() == nullptr);
    }

    void opensNoLargerThanItsScreen() {
        openWindow();
        const QRect room = m_window->screen()->availableGeometry();
        QVERIFY(m_window->frameGeometry().width() <= room.width());
        QVERIFY(m_window->frameGeometry().height() <= room.height());
    }

    void restoresALayoutAndFallsBackFromADamagedOne() {
        openWindow();
        auto& page = m_window->operatePage().docks();
        auto* charts = m_window->findChild<QDockWidget*>("charts");
        QVERIFY(charts != nullptr);
        charts->close();
        const QByteArray closed = page.saveLayouts();
        page.resetLayout();
        QVERIFY(!charts->isHidden());
        QVERIFY(page.restoreLayouts(closed));
        QVERIFY(charts->isHidden());
        QVERIFY(!page.restoreLayouts("damaged"));
        QVERIFY(!charts->isHidden());
        for (QAction* action : page.actions())
            QVERIFY(!action->text().isEmpty());
    }

    void floatsEveryDockAndTakesItBackWhileDataRuns() {
        openWindow();
        m_window->openDemo();
        QTRY_VERIFY_WITH_TIMEOUT(showsData(), 20'000);
        for (auto* dock : m_window->findChildren<QDockWidget*>()) {
            if (!dock->toggleViewAction()->isEnabled()) // of another kind of source
                continue;
            dock->setFloating(true);
            QVERIFY(QTest::qWaitForWindowExposed(dock));
            const auto before = m_window->sources().active()->displayed;
            QTRY_VERIFY(m_window->sources().active()->displayed > before);
            dock->setFloating(false);
        }
        QVERIFY(!m_window->grab().isNull());
    }

    void changesThemeWhileDataRuns() {
        openWindow();
        m_window->openDemo();
        QTRY_VERIFY_WITH_TIMEOUT(showsData(), 20'000);
        base::applyTheme(base::ThemeChoice::dark);
        const auto before = m_window->sources().active()->displayed;
        QTRY_VERIFY(m_window->sources().active()->displayed > before + 2);
        const QColor dark = m_window->grab().toImage().pixelColor(3, m_window->height() - 3);
        QVERIFY2(dark.lightness() < 128, qPrintable(dark.name()));
        base::applyTheme(base::ThemeChoice::light);
    }

    void showsTwoSourcesInTurnAndClosesThem() {
        ConsoleOptions options = replay(writeRecording("two.csv"));
        options.scenes << QStringLiteral(":/scenes/tactile-two-contacts.toml");
        openWindow(options);
        QTRY_COMPARE_WITH_TIMEOUT(m_window->sources().items().size(), std::size_t(2), 20'000);
        QTRY_VERIFY_WITH_TIMEOUT(
            m_window->sources().items()[0].channel && m_window->sources().items()[1].channel, 20'000);
        const auto first = m_window->sources().items()[0].key;
        const auto second = m_window->sources().items()[1].key;
        m_window->sources().activate(first);
        QTRY_VERIFY(showsData());
        m_window->sources().activate(second);
        QTRY_VERIFY(showsData());
        m_window->sources().close(second);
        QCOMPARE(m_window->sources().active()->key, first);
        m_window->sources().close(first);
        QVERIFY(m_window->sources().active() == nullptr);
        QVERIFY(m_window->findChild<QPushButton*>("openDemo")->isVisible());
    }

    void aChangeOfTheSourceLeavesNoMenusBehind() {
        ConsoleOptions options;
        options.scenes = {QStringLiteral("tactile-indenter"), QStringLiteral("tactile-two-contacts")};
        openWindow(options);
        auto& sources = m_window->sources();
        QTRY_VERIFY(sources.items().size() == 2 && sources.items()[0].isOpen() &&
                    sources.items()[1].isOpen());
        const auto menus = [this] {
            return m_window->menuBar()->findChildren<QMenu*>(Qt::FindDirectChildrenOnly).size();
        };
        for (std::size_t turn = 0; turn < 6; ++turn)
            sources.activate(sources.items()[turn % 2].key);
        // All but "Open", which is the chooser's, are the bar's.
        QTRY_COMPARE(menus(), m_window->menuBar()->actions().size());
    }

    void aPausedRecordingIsAsItWasLeftAfterALookAtAnotherSource() {
        ConsoleOptions options = replay(writeRecording("paused.csv"));
        options.scenes << QStringLiteral(":/scenes/tactile-two-contacts.toml");
        openWindow(options);
        const auto& items = m_window->sources().items();
        QTRY_VERIFY_WITH_TIMEOUT(items.size() == 2 && items[0].isOpen() && items[1].isOpen(), 60'000);
        const std::size_t played = items[0].playback() != nullptr ? 0 : 1;
        const auto recording = items[played].key;
        const auto other = items[1 - played].key;
        m_window->sources().activate(recording);
        auto* playback = items[played].playback();
        playback->setLoop(true);
        playback->play();
        const charts::FeatureHistory& history = child<charts::StripChartView>()->history();
        QTRY_VERIFY_WITH_TIMEOUT(history.size() > 3, 60'000);
        playback->pause();
        QTRY_VERIFY_WITH_TIMEOUT(playback->position().paused, 60'000);
        const auto before = history.size();
        m_window->sources().activate(other);
        const auto displayed = items[1 - played].displayed;
        QTRY_VERIFY_WITH_TIMEOUT(items[1 - played].displayed > displayed, 60'000);
        m_window->sources().activate(recording);
        QVERIFY(history.size() >= before);
        QVERIFY(items[played].array()->generation() > 0);
    }

    void aStudyIsOpenedOnceWhateverIsAskedForWithIt_data() {
        QTest::addColumn<QStringList>("scenes");
        QTest::addColumn<bool>("rehearse");
        QTest::addColumn<bool>("isOfScene");
        const QString study = QStringLiteral("study-rehearsal");
        const QString touch = QStringLiteral("tactile-two-contacts");
        QTest::newRow("a scene of a study is a rehearsal already") << QStringList(study) << true << true;
        QTest::newRow("the same beside a source") << QStringList{touch, study} << true << true;
        QTest::newRow("a rehearsal beside a source") << QStringList(touch) << true << false;
        QTest::newRow("a study beside a source") << QStringList(touch) << false << false;
    }
    void aStudyIsOpenedOnceWhateverIsAskedForWithIt() {
        QFETCH(QStringList, scenes);
        QFETCH(bool, rehearse);
        QFETCH(bool, isOfScene);
        ConsoleOptions options;
        options.scenes = scenes;
        options.rehearse = rehearse;
        options.study = m_folder.filePath(QTest::currentDataTag());
        if (!rehearse) {
            study::StudyHead head;
            head.protocol = *study::paperProtocol();
            head.created = QDateTime::currentDateTimeUtc();
            QVERIFY(study::StudyStore::create(options.study.toStdString(), head));
        }
        openWindow(options);
        auto& page = m_window->studyPage();
        QSignalSpy opened(&page.controller(), &console::StudyController::opened);
        QTRY_VERIFY_WITH_TIMEOUT(page.controller().overview().has_value(), 60'000);
        QTRY_VERIFY_WITH_TIMEOUT(rehearse == page.controller().isRehearsing(), 60'000);
        const auto& head = page.controller().overview()->head;
        QCOMPARE(head.plannedParticipants == 1, isOfScene); // as the scene has it
        QCOMPARE(head.mode, rehearse ? study::Mode::simulated : study::Mode::run);
        QTRY_COMPARE_WITH_TIMEOUT(m_window->sources().items().size(),
                                  std::size_t(scenes.contains("tactile-two-contacts") ? 1 : 0), 60'000);
        QCOMPARE(opened.size(), 1);
        QCOMPARE(page.messages().count(), 0);
        QVERIFY(!m_window->anyFailure());
        page.controller().stopRehearsal();
    }

    void tellsOfASettingsFileThatIsNotUsedAsItIs_data() {
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<QString>("kept"); ///< whose path is told; none: nothing is
        QTest::newRow("as it should be") << QByteArray("[General]\nversion=1\n") << QString();
        QTest::newRow("damaged") << QByteArray("[General]\npage=study\n\xff[[[garbage\n")
                                 << QString("console.ini.damaged");
        QTest::newRow("of a newer version")
            << QByteArray("[General]\nversion=99\npage=study\n") << QString("console.ini");
    }
    void tellsOfASettingsFileThatIsNotUsedAsItIs() {
        QFETCH(QByteArray, content);
        QFETCH(QString, kept);
        const QTemporaryDir folder;
        QVERIFY(QDir(folder.path()).mkpath("teleta"));
        const QString file = folder.filePath("teleta/console.ini");
        write(file, content);
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder.path());
        m_stop = std::make_unique<core::StopSwitch>();
        m_settings = std::make_unique<ConsoleSettings>(false);
        m_window = std::make_unique<MainWindow>(ConsoleOptions(), *m_settings, *m_stop);
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        auto& messages = m_window->operatePage().messages();
        QCOMPARE(messages.count(), kept.isEmpty() ? 0 : 1);
        if (!kept.isEmpty()) {
            const QString path = folder.filePath("teleta/" + kept);
            QVERIFY(QFile::exists(path));
            const auto labels = messages.findChildren<QLabel*>();
            QVERIFY(std::any_of(labels.begin(), labels.end(), [&](const QLabel* label) {
                return label->text().contains(QDir::toNativeSeparators(path));
            }));
        }
        m_window.reset();
        m_settings.reset();
        // What is written afterwards is whole again.
        QCOMPARE(int(ConsoleSettings(false).found()),
                 int(kept == "console.ini" ? ConsoleSettings::Found::newer : ConsoleSettings::Found::usable));
    }

    void aServoSceneIsHeldAndBegunAnewInItsOwnSource() {
        ConsoleOptions options;
        options.scenes = {QStringLiteral(":/scenes/servo-bent-bar.toml")};
        openWindow(options);
        const auto* runs = child<servo::ServoRunsView>();
        const auto* state = child<servo::ServoPanel>()->findChild<QLabel*>("servoState");
        QTRY_VERIFY_WITH_TIMEOUT(!runs->runs().runs().empty(), 60'000);
        const auto key = m_window->sources().active()->key;
        m_window->activateWindow();
        QTRY_VERIFY(m_window->isActiveWindow());
        QTest::keyClick(m_window.get(), Qt::Key_F5, Qt::ShiftModifier);
        QTRY_COMPARE(state->text(), QStringLiteral("The scene is held"));
        m_stop->engage();
        QTRY_COMPARE(state->text(), QStringLiteral("STOP: the arm is held"));
        m_stop->release();
        QTest::keyClick(m_window.get(), Qt::Key_F5);
        QTRY_VERIFY(state->text() != QStringLiteral("The scene is held"));
        const std::size_t before = runs->runs().runs().front().time_s.size();
        QTest::keyClick(m_window.get(), Qt::Key_F5, Qt::ControlModifier);
        QTRY_COMPARE(runs->runs().runs().size(), std::size_t{2});
        QVERIFY(runs->runs().runs().front().time_s.size() >= before);
        QVERIFY(runs->runs().runs().back().time_s.front() < runs->runs().runs().front().time_s.back());
        QCOMPARE(m_window->sources().items().size(), std::size_t{1});
        QCOMPARE(m_window->sources().active()->key, key);
    }

    void recordingsAreOpenedFromWhereTheyAre() {
        const QTemporaryDir kept; // settings that are kept
        const QDir folder(m_folder.path());
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, kept.path());
        m_window.reset();
        m_stop = std::make_unique<core::StopSwitch>();
        m_settings = std::make_unique<ConsoleSettings>(false);
        m_window = std::make_unique<MainWindow>(ConsoleOptions(), *m_settings, *m_stop);
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        const auto shown = [this] {
            m_window->operatePage().findChild<QPushButton*>("openRecording")->click();
            auto* dialog = m_window->findChild<QFileDialog*>();
            const QString path = dialog != nullptr ? dialog->directory().canonicalPath() : QString();
            delete dialog;
            return path;
        };
        QVERIFY(folder.mkdir("kept") && folder.mkdir("used"));
        m_settings->setRecordingFolder(folder.filePath("kept"));
        QCOMPARE(shown(), QDir(folder.filePath("kept")).canonicalPath());
        // One that is not made yet.
        m_settings->setRecordingFolder(folder.filePath("none/of/these"));
        QCOMPARE(shown(), folder.canonicalPath());
        m_settings->addRecentFile(folder.filePath("used/run.teleta"));
        m_settings->addRecentFile(folder.filePath("sources.toml"));
        QCOMPARE(shown(), QDir(folder.filePath("used")).canonicalPath());
        m_window.reset();
        m_settings.reset();
    }

    void closingTheWindowStopsWhateverMoves() {
        openWindow();
        m_window->close();
        QVERIFY(m_stop->engaged());
    }
};

int main(int argc, char* argv[]) {
    view3d::configureOpenGlBeforeApplication();
    QApplication application(argc, argv);
    MainWindowTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "main_window_test.moc"
