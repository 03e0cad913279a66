// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/main_window.h"
#include "app/console/operate/operate_page.h"
#include "app/console/operate/recording_controls.h"
#include "backend/pipeline/arm_channel.h"
#include "backend/recording/recording.h"
#include "widgets/base/shown_path.h"
#include "widgets/base/theme.h"
#include "widgets/chrome/message_bar.h"
#include "widgets/chrome/playback_bar.h"
#include "widgets/chrome/source_chooser.h"
#include "widgets/touch/run_sheet.h"
#include "widgets/touch/touch_table.h"
#include "widgets/view3d/vtk/gl_setup.h"

#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QSettings>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

using namespace teleta;
using console::ConsoleOptions;
using console::ConsoleSettings;
using console::MainWindow;
using console::RecordingService;

namespace {

constexpr int kPatience_ms = 60'000;

} // namespace

/// A recording that the command line asks for, and one that is played.
class MainWindowRecordingTest : public QObject {
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<core::StopSwitch> m_stop;
    std::unique_ptr<ConsoleSettings> m_settings;
    std::unique_ptr<MainWindow> m_window;

    void openWindow(const ConsoleOptions& options) {
        m_window = std::make_unique<MainWindow>(options, *m_settings, *m_stop);
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        m_window->openRequested(options);
    }

private slots:
    void initTestCase() { base::applyTheme(base::ThemeChoice::light); }
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        m_stop = std::make_unique<core::StopSwitch>();
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, m_folder->path());
        m_settings = std::make_unique<ConsoleSettings>(false);
    }
    void cleanup() { m_window.reset(); }

    void aRecordingFromTheStartTellsOfWhatWasAskedForWithIt_data() {
        QTest::addColumn<QStringList>("scenes");
        QTest::addColumn<QStringList>("files");
        QTest::addColumn<bool>("asList");
        const QString scene = QStringLiteral("tactile-indenter");
        QTest::newRow("a scene") << QStringList{scene} << QStringList() << false;
        QTest::newRow("beside some that cannot be opened")
            << QStringList{scene} << QStringList{"/nowhere/scene.toml", "/nowhere/run.teleta"} << false;
        QTest::newRow("a source list") << QStringList() << QStringList() << true;
    }
    void aRecordingFromTheStartTellsOfWhatWasAskedForWithIt() {
        QFETCH(QStringList, scenes);
        QFETCH(QStringList, files);
        QFETCH(bool, asList);
        ConsoleOptions options;
        options.scenes = scenes;
        options.files = files;
        options.bracelet = QStringLiteral("simulated");
        options.record = m_folder->filePath("new.teleta");
        if (asList) {
            QFile list(m_folder->filePath("list.toml"));
            QVERIFY(list.open(QIODevice::WriteOnly));
            QVERIFY(list.write("[[source]]\nscene = \":/scenes/tactile-indenter.toml\"\n") > 0);
            options.sourceList = list.fileName();
        }
        openWindow(options);
        RecordingService& station = m_window->recorder();
        QTRY_VERIFY_WITH_TIMEOUT(station.status().frames >= 200, kPatience_ms);
        QCOMPARE(station.path(), options.record);
        QCOMPARE(m_window->anyFailure(), !files.isEmpty());
        m_window->recording().stop();
        QTRY_COMPARE_WITH_TIMEOUT(station.state(), RecordingService::State::idle, kPatience_ms);
        QTRY_COMPARE_WITH_TIMEOUT(m_settings->recentFiles().value(0), options.record, kPatience_ms);
        const auto recording = recording::Recording::open(options.record.toStdString());
        QVERIFY2(recording, recording ? "" : core::describe(recording.error()).c_str());
        QCOMPARE(recording->head().scene, std::string("tactile-indenter"));
        QVERIFY(recording->head().sceneText.find("rate_Hz") != std::string::npos);
        const std::string& configuration = recording->head().configuration;
        QVERIFY2(configuration.find("\"scene\":") != std::string::npos, configuration.c_str());
        QVERIFY2(configuration.find("\"bracelet\":") != std::string::npos, configuration.c_str());
        QVERIFY2(configuration.find("nowhere") == std::string::npos, configuration.c_str());
        QVERIFY(std::ranges::any_of(recording->streams(), [](const recording::StreamInfo& stream) {
            return stream.name == "tactile-indenter-frames";
        }));
    }

    /// A touch that is played again is the same touch.
    void playingAgainMultipliesNoTouches() {
        ConsoleOptions options;
        options.scenes << QStringLiteral("teleta-touch");
        options.record = m_folder->filePath("touch.teleta");
        openWindow(options);
        auto& touches = *m_window->operatePage().findChild<touch::TouchTable*>();
        auto& sheet = m_window->operatePage().findChild<touch::RunSheet*>()->model();
        QTRY_VERIFY_WITH_TIMEOUT(touches.touches() > 0 && sheet.rowCount() > 0, kPatience_ms);
        // Whoever plays it may find the touch a little later than it was found live.
        const std::uint64_t found = m_window->recorder().status().frames;
        QTRY_VERIFY_WITH_TIMEOUT(m_window->recorder().status().frames >= found + 1000, kPatience_ms);
        m_window->recording().stop();
        QTRY_COMPARE_WITH_TIMEOUT(m_window->recorder().state(), RecordingService::State::idle, kPatience_ms);
        m_window->sources().closeAll();
        ConsoleOptions again;
        again.files << options.record;
        m_window->openRequested(again);
        const auto playsAnArm = [this] {
            const auto* item = m_window->sources().active();
            return item != nullptr && item->displayed > 0 && item->arm() != nullptr;
        };
        QTRY_VERIFY_WITH_TIMEOUT(playsAnArm(), kPatience_ms);
        auto* playback = m_window->sources().active()->playback();
        auto* bar = m_window->findChild<chrome::PlaybackBar*>();
        playback->setSpeed(4.0);
        playback->play();
        // It stops a little after it has come there.
        const auto isAtItsEnd = [&] {
            const core::PlaybackPosition now = playback->position();
            return now.paused && now.time_s == now.duration_s;
        };
        QTRY_VERIFY_WITH_TIMEOUT(isAtItsEnd() && touches.touches() > 0 && sheet.rowCount() > 0, kPatience_ms);
        const int played = touches.touches();
        const int objects = sheet.rowCount();
        const std::size_t onFirst = sheet.object(0).touches;
        const auto timeIn = [](const QAbstractItemModel& model, int row, int column) {
            return model.index(row, column).data().toString();
        };
        QCOMPARE(timeIn(sheet, 0, touch::RunSheetModel::time),
                 timeIn(*touches.view()->model(), played - 1, touch::TouchModel::time));
        for (int round = 0; round < 3; ++round) {
            QTest::keyClick(bar, Qt::Key_Home);
            QTRY_VERIFY_WITH_TIMEOUT(playback->position().time_s < 1.0, kPatience_ms);
            // The key does what the bar offers.
            QTRY_VERIFY(bar->findChild<QToolButton*>("play")->toolTip().startsWith(QLatin1String("Play")));
            QTest::keyClick(bar, Qt::Key_Space);
            QTRY_VERIFY_WITH_TIMEOUT(isAtItsEnd() && touches.touches() > 0, kPatience_ms);
            QTRY_COMPARE_WITH_TIMEOUT(sheet.rowCount(), objects, kPatience_ms);
            QCOMPARE(touches.touches(), played);
            QCOMPARE(sheet.object(0).touches, onFirst);
        }
    }

    void anExportSaysToWhichFolderItWrote() {
        ConsoleOptions options;
        options.scenes << QStringLiteral("tactile-indenter");
        options.record = m_folder->filePath("short.teleta");
        openWindow(options);
        QTRY_VERIFY_WITH_TIMEOUT(m_window->recorder().status().frames >= 100, kPatience_ms);
        m_window->recording().stop();
        QTRY_COMPARE_WITH_TIMEOUT(m_window->recorder().state(), RecordingService::State::idle, kPatience_ms);
        const QString folder = m_folder->filePath("short");
        QSignalSpy exported(&m_window->recording().csv(), &console::RecordingExport::finished);
        m_window->recording().csv().start(options.record, folder);
        QTRY_COMPARE_WITH_TIMEOUT(exported.size(), 1, kPatience_ms);
        const auto labels = m_window->operatePage().messages().findChildren<QLabel*>();
        const QString where = base::fromHome(folder) + QLatin1Char('.');
        const auto said =
            std::ranges::find_if(labels, [&](const QLabel* label) { return label->text().endsWith(where); });
        QVERIFY(said != labels.end());
        const auto files = QDir(folder).entryList(QDir::Files);
        QVERIFY2((*said)->text().startsWith(QString::number(files.size())), qPrintable((*said)->text()));
    }

    /// Whoever plays a recording does not hinder the console that made it.
    void aMarkIsEditedWhileItsRecordingIsPlayed() {
        ConsoleOptions options;
        options.scenes << QStringLiteral("tactile-indenter");
        options.record = m_folder->filePath("marked.teleta");
        openWindow(options);
        RecordingService& station = m_window->recorder();
        QTRY_VERIFY_WITH_TIMEOUT(station.status().frames >= 200, kPatience_ms);
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get(), kPatience_ms));
        QTest::keyClick(m_window.get(), Qt::Key_M);
        QTRY_VERIFY_WITH_TIMEOUT(station.status().frames >= 400, kPatience_ms);
        m_window->recording().stop();
        QTRY_COMPARE_WITH_TIMEOUT(station.state(), RecordingService::State::idle, kPatience_ms);

        ConsoleOptions again;
        again.files << options.record;
        m_window->openRequested(again);
        const auto played = [this] {
            auto* item = m_window->sources().active();
            return item != nullptr && item->displayed > 0 ? item->playback() : nullptr;
        };
        QTRY_VERIFY_WITH_TIMEOUT(played() != nullptr, kPatience_ms);
        auto* playback = played();
        playback->setLoop(true);
        playback->pause();
        QTest::keyClick(m_window->findChild<chrome::PlaybackBar*>(), Qt::Key_Home);
        const double mark_s = playback->marks().front().time_s;
        QVERIFY(mark_s > 0.2);
        QTRY_VERIFY_WITH_TIMEOUT(playback->position().time_s < 0.1, kPatience_ms);

        // In the list of what is played, a double click goes to the mark.
        auto& page = m_window->operatePage();
        page.docks().bringForward(QStringLiteral("marks"));
        auto* table = page.marks().list().findChild<QTableWidget*>();
        QTRY_VERIFY_WITH_TIMEOUT(table->isVisible() && table->rowCount() == 1, kPatience_ms);
        const auto doubleClick = [table](int column) {
            const QPoint at = table->visualItemRect(table->item(0, column)).center();
            QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, at);
            QTest::mouseDClick(table->viewport(), Qt::LeftButton, {}, at);
        };
        doubleClick(1);
        QVERIFY(table->findChild<QLineEdit*>() == nullptr);
        QTRY_VERIFY_WITH_TIMEOUT(std::abs(playback->position().time_s - mark_s) < 0.1, kPatience_ms);
        playback->play();

        // In that of the source that was recorded, it begins the text.
        QSignalSpy notKept(&station.marks(), &console::RecordingMarks::notKept);
        const int messages = page.messages().count();
        auto* sources = m_window->findChild<chrome::SourceChooser*>()->findChild<QComboBox*>();
        QTest::keyClick(sources, Qt::Key_Home);
        QTRY_VERIFY_WITH_TIMEOUT(played() == nullptr, kPatience_ms);
        doubleClick(1);
        QTRY_VERIFY(table->findChild<QLineEdit*>() != nullptr);
        QTest::keyClicks(table->findChild<QLineEdit*>(), QStringLiteral("it slipped"));
        QTest::keyClick(table->findChild<QLineEdit*>(), Qt::Key_Return);
        const auto textInFile = [&] {
            const auto recording = recording::Recording::open(options.record.toStdString());
            if (!recording)
                return QString();
            const auto& events = recording->events();
            const auto mark = std::ranges::find(events, recording::kMark, &recording::RecordingEvent::kind);
            return mark != events.end() ? QString::fromStdString(mark->text) : QString();
        };
        QTRY_COMPARE_WITH_TIMEOUT(textInFile(), QStringLiteral("it slipped"), kPatience_ms);
        QCOMPARE(notKept.size(), 0);
        QCOMPARE(page.messages().count(), messages);
        // It is played all the while.
        QVERIFY(!playback->position().paused);
    }
};

int main(int argc, char* argv[]) {
    view3d::configureOpenGlBeforeApplication();
    QApplication application(argc, argv);
    MainWindowRecordingTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "main_window_recording_test.moc"
