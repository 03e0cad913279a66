// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/scene_file.h"
#include "app/console/main_window.h"
#include "app/console/operate/operate_page.h"
#include "app/console/operate/recording_controls.h"
#include "backend/core/device/device_state.h"
#include "backend/core/steady_time.h"
#include "backend/pipeline/camera_channel.h"
#include "backend/recording/csv_export.h"
#include "backend/recording/recording_database.h"
#include "backend/simulation/array/simulated_array.h"
#include "tests/app/console/operate/recorded_frames.h"
#include "widgets/base/theme.h"
#include "widgets/charts/strip_chart_view.h"
#include "widgets/chrome/playback_bar.h"
#include "widgets/chrome/recording_indicator.h"

#include <QDropEvent>
#include <QFile>
#include <QLineEdit>
#include <QMimeData>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <memory>
#include <sys/resource.h>

using namespace teleta;
using console::ConsoleOptions;
using console::ConsoleSettings;
using console::MainWindow;
using console::RecordingMark;
using console::RecordingService;
using test::Frames;
using test::framesOf;
using test::referencesIn;

namespace {

constexpr int kPatience_ms = 60'000;

std::vector<std::string> marksOf(const recording::Recording& recording) {
    std::vector<std::string> marks;
    for (const recording::RecordingEvent& event : recording.events())
        if (event.kind == recording::kMark)
            marks.push_back(event.text);
    return marks;
}

} // namespace

/// Recording and playing in the window as a whole.
class RecordingTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;
    std::unique_ptr<core::StopSwitch> m_stop;
    std::unique_ptr<ConsoleSettings> m_settings;
    std::unique_ptr<MainWindow> m_window;

    void openWindow(const ConsoleOptions& options) {
        m_window.reset();
        m_stop = std::make_unique<core::StopSwitch>();
        m_settings = std::make_unique<ConsoleSettings>(true);
        m_window = std::make_unique<MainWindow>(options, *m_settings, *m_stop);
        m_window->show();
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get(), kPatience_ms));
        m_window->openRequested(options);
    }

    void openScene(const QString& name) {
        ConsoleOptions options;
        options.scenes << name;
        openWindow(options);
        QTRY_VERIFY_WITH_TIMEOUT(showsData(), kPatience_ms);
    }

    bool showsData() const {
        auto* item = m_window->sources().active();
        return item != nullptr && item->displayed > 0;
    }
    bool shows(const std::string& stream) const {
        auto* item = m_window->sources().active();
        const auto* playback = item != nullptr ? std::get_if<app::RecordingRequest>(&item->request) : nullptr;
        return playback != nullptr && playback->stream == stream;
    }
    RecordingService& station() const { return m_window->recorder(); }
    console::OperatePage& page() const { return m_window->operatePage(); }

    void waitForFrames(std::uint64_t frames) {
        QTRY_VERIFY_WITH_TIMEOUT(station().status().frames >= frames, kPatience_ms);
    }
    void end() {
        QTest::keyClick(m_window.get(), Qt::Key_R, Qt::ControlModifier);
        QTRY_COMPARE_WITH_TIMEOUT(station().state(), RecordingService::State::idle, kPatience_ms);
    }

    void drop(const QString& path) {
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(path)});
        QDragEnterEvent enter(QPoint(10, 10), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(m_window.get(), &enter);
        QVERIFY(enter.isAccepted());
        QDropEvent event(QPointF(10, 10), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(m_window.get(), &event);
    }

private slots:
    void initTestCase() {
        qputenv("HOME", m_folder.path().toUtf8());
        qputenv("XDG_CONFIG_HOME", m_folder.filePath("config").toUtf8());
        base::applyTheme(base::ThemeChoice::light);
    }
    void cleanup() { m_window.reset(); }

    void whatWasRecordedIsWhatTheSceneGaveAndIsPlayedAgain() {
        openScene("tactile-indenter");
        QTest::keyClick(m_window.get(), Qt::Key_R, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(station().isRecording(), kPatience_ms);
        const QString path = station().path();
        QVERIFY2(path.startsWith(m_folder.filePath("Documents/TeleTA")), qPrintable(path));
        QVERIFY2(path.endsWith("-tactile-indenter.teleta"), qPrintable(path));
        auto* indicator = m_window->findChild<chrome::RecordingIndicator*>();
        QTRY_VERIFY(indicator->text().contains("Recording 0:"));
        waitForFrames(600); // so far from the first frame that a mark is another place than the beginning

        // Three marks by key and button; the second one is taken back, the third gets a text.
        QTest::keyClick(m_window.get(), Qt::Key_M);
        QTest::mouseClick(indicator->findChild<QToolButton*>("mark"), Qt::LeftButton);
        QCOMPARE(station().marks().all().size(), std::size_t(2));
        page().docks().bringForward("marks");
        auto* table = page().marks().list().findChild<QTableWidget*>();
        QCOMPARE(table->rowCount(), 2);
        table->setFocus();
        QTest::keyClick(table, Qt::Key_Z, Qt::ControlModifier);
        QTRY_COMPARE(station().marks().all().size(), std::size_t(1));
        QTest::keyClick(m_window.get(), Qt::Key_M);
        page().marks().list().edit(station().marks().all().back().number);
        auto* editor = table->findChild<QLineEdit*>();
        QVERIFY(editor != nullptr);
        QTest::keyClicks(editor, "it moved");
        QTest::keyClick(editor, Qt::Key_Return);
        QTRY_COMPARE(station().marks().all().back().text, QString("it moved"));
        auto* charts = m_window->findChild<charts::StripChartView*>();
        QTRY_COMPARE_WITH_TIMEOUT(charts->marks(), std::size_t(2), kPatience_ms);

        // A source that opens meanwhile joins.
        m_window->sources().open(app::SceneRequest{"tactile-two-contacts", 1});
        QTRY_VERIFY_WITH_TIMEOUT(m_window->sources().items().back().isOpen(), kPatience_ms);
        waitForFrames(station().status().frames + 1000);
        end();

        const auto recording = recording::Recording::open(path.toStdString());
        QVERIFY2(recording, recording ? "" : core::describe(recording.error()).c_str());
        QVERIFY(recording->isComplete());
        QCOMPARE(recording->head().scene, std::string("tactile-indenter"));
        QVERIFY(recording->head().sceneText.find("rate_Hz") != std::string::npos);
        QCOMPARE(marksOf(*recording), (std::vector<std::string>{"", "it moved"}));
        const Frames other = framesOf(*recording, "tactile-two-contacts-frames");
        QVERIFY(!other.sourceTime_s.empty());

        // The same scene with the same seed gives the same frames.
        const Frames frames = framesOf(*recording, "tactile-indenter-frames");
        QVERIFY(frames.sourceTime_s.size() >= 100);
        auto scene = app::readScene("tactile-indenter");
        auto array = simulation::SimulatedArray::make(*scene, 1);
        QVERIFY(array);
        const std::size_t taxels = (*array)->description().layout.taxels();
        std::vector<float> expected(taxels);
        const auto* values = reinterpret_cast<const float*>(frames.values.data());
        std::size_t compared = 0;
        for (std::size_t i = 0; i < frames.sourceTime_s.size(); ++i, values += taxels) {
            while ((*array)->time_s() < frames.sourceTime_s[i] - 1e-9)
                (*array)->next(expected, false);
            if ((*array)->time_s() > frames.sourceTime_s[i] + 1e-9)
                break; // the scene began anew
            QVERIFY2(std::equal(expected.begin(), expected.end(), values), qPrintable(QString::number(i)));
            ++compared;
        }
        QVERIFY(compared >= 100);

        // What is exported by the window is what the recording holds.
        QSignalSpy exported(&m_window->recording().csv(), &console::RecordingExport::finished);
        m_window->recording().csv().start(path, m_folder.filePath("csv"));
        const auto isOffered = [&] {
            return std::ranges::any_of(m_window->findChildren<QAction*>(), [](const QAction* action) {
                return action->text().contains("recording as CSV") && action->isEnabled();
            });
        };
        QVERIFY2(!isOffered(), "one export at a time");
        QTRY_COMPARE_WITH_TIMEOUT(exported.size(), 1, kPatience_ms);
        QVERIFY(isOffered());
        QFile csv(m_folder.filePath("csv/tactile-indenter-frames.csv"));
        QVERIFY(csv.open(QIODevice::ReadOnly));
        QCOMPARE(csv.readAll().count('\n'), static_cast<int>(frames.sourceTime_s.size()) + 1);
        QVERIFY(QFile::exists(m_folder.filePath("csv/events.csv")));

        // Dropped on the window it is played, with its marks, and says what it is.
        m_window->sources().closeAll();
        drop(path);
        QTRY_VERIFY_WITH_TIMEOUT(shows("tactile-indenter-frames") && showsData(), kPatience_ms);
        QCOMPARE(m_window->sources().items().size(), std::size_t(2));
        auto* item = m_window->sources().active();
        QVERIFY(item->channel->summary().recorded);
        auto* playback = item->channel->playback();
        QCOMPARE(playback->marks().size(), std::size_t(2));
        auto* bar = m_window->findChild<chrome::PlaybackBar*>();
        QVERIFY(bar->isVisible());
        playback->setLoop(true);
        playback->play();
        // A key does what the bar offers.
        const auto offers = [bar](const char* what) {
            return bar->findChild<QToolButton*>("play")->toolTip().startsWith(QLatin1String(what));
        };
        QTRY_VERIFY(offers("Pause"));
        QTest::keyClick(bar, Qt::Key_Space);
        QTRY_VERIFY(playback->position().paused);
        QTest::keyClick(bar, Qt::Key_Home);
        QTRY_COMPARE_WITH_TIMEOUT(item->array()->snapshot().sourceTime_s,
                                  recording->time_s(firstTime(*recording, "tactile-indenter-frames")),
                                  kPatience_ms);
        const Frames features = framesOf(*recording, "tactile-indenter-features");
        const auto* first = reinterpret_cast<const double*>(features.values.data());
        QCOMPARE(item->array()->snapshot().features.force_N, first[1]);
        QTest::keyClick(bar, Qt::Key_PageDown);
        QTRY_VERIFY(std::abs(playback->position().time_s - playback->marks()[0].time_s) < 0.1);
        // From its end it is played again.
        playback->setLoop(false);
        playback->setSpeed(0.1);
        QTest::keyClick(bar, Qt::Key_End);
        QTRY_COMPARE(playback->position().time_s, playback->position().duration_s);
        QTRY_VERIFY(offers("Play"));
        QTest::keyClick(bar, Qt::Key_Space);
        QTRY_VERIFY(!playback->position().paused &&
                    playback->position().time_s < playback->position().duration_s);
    }

    static std::int64_t firstTime(const recording::Recording& recording, const std::string& name) {
        for (std::size_t i = 0; i < recording.streams().size(); ++i)
            if (recording.streams()[i].name == name)
                return (*recording.extent(i))->first_ns;
        return 0;
    }

    void anArmIsPlayedWithItsSkinAndTheBraceletIsInTheFile() {
        openScene("teleta-touch");
        const QString path = m_folder.filePath("arm.teleta");
        QTRY_VERIFY_WITH_TIMEOUT(m_window->bracelet().session() != nullptr, kPatience_ms);
        station().start(path);
        waitForFrames(2000);
        m_stop->engage();
        end();
        m_stop->release();
        const auto recording = recording::Recording::open(path.toStdString());
        QVERIFY(recording);
        std::vector<std::string> names;
        for (const recording::StreamInfo& stream : recording->streams())
            names.push_back(stream.name);
        for (const char* name : {"teleta-touch-frames", "teleta-touch-features", "teleta-touch-joints",
                                 "teleta-touch-touches", "bracelet"})
            QVERIFY2(std::ranges::find(names, name) != names.end(), name);
        QVERIFY(std::ranges::any_of(recording->events(), [](const recording::RecordingEvent& event) {
            return event.kind == "stop_engaged";
        }));
        m_window->sources().closeAll();
        drop(path);
        QTRY_VERIFY_WITH_TIMEOUT(showsData() && m_window->sources().active()->arm() != nullptr, kPatience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(m_window->sources().active()->arm()->samplesProcessed() > 100, kPatience_ms);
        // However slowly it is played, its joints are not stale.
        auto* item = m_window->sources().active();
        item->playback()->setLoop(true);
        item->playback()->setSpeed(0.01);
        item->playback()->play();
        const auto isOld = [&] {
            const core::DeviceStatus status = item->arm()->jointStatus();
            return status.state == core::DeviceState::live &&
                   core::steadyNow_ns() - status.lastData_ns >
                       core::staleAfter_ns(item->arm()->description().nominalRate_Hz);
        };
        QTRY_VERIFY_WITH_TIMEOUT(isOld(), kPatience_ms);
        const auto readings = page().readings();
        const auto joints = std::ranges::find(readings, QString("joints"), &chrome::DeviceReading::name);
        QVERIFY(joints != readings.end() && joints->state == core::DeviceState::live);
    }

    void settingsThatChangeWhileItIsRecordedAreInTheFileAndAreTold() {
        openScene("tactile-indenter");
        const QString path = m_folder.filePath("tared.teleta");
        station().start(path);
        waitForFrames(50);
        const auto channel = m_window->sources().active()->array();
        const std::uint64_t revision = channel->settingsRevision();
        channel->requestTare(0.0);
        QTRY_VERIFY_WITH_TIMEOUT(channel->settingsRevision() > revision, kPatience_ms);
        end();
        const auto recording = recording::Recording::open(path.toStdString());
        QVERIFY(recording);
        const auto& events = recording->events();
        const auto told =
            std::ranges::find(events, std::string("settings"), &recording::RecordingEvent::kind);
        QVERIFY(told != events.end());
        QVERIFY(told->text.find("\"stream\":\"tactile-indenter-frames\"") != std::string::npos);
        QVERIFY2(told->text.find("\"tare\":[]") == std::string::npos, "there is one now");
        m_window->sources().closeAll();
        page().messages().clear();
        drop(path);
        QTRY_COMPARE_WITH_TIMEOUT(page().messages().count(), 1, kPatience_ms);
    }

    void damageAndAnEndThatWasCutOffAreTold() {
        openScene("tactile-indenter");
        const QString path = m_folder.filePath("damaged.teleta");
        station().start(path);
        waitForFrames(400);
        end();
        {
            recording::RecordingDatabase file(path.toStdString());
            QVERIFY(file.openForWriting());
            QVERIFY(file.run("UPDATE block SET data = x'00' WHERE key = (SELECT MIN(key) FROM block WHERE "
                             "stream = (SELECT key FROM stream WHERE kind = 'array'))"));
            QVERIFY(file.run("DELETE FROM event WHERE kind = 'stopped'"));
        }
        m_window->sources().closeAll();
        page().messages().clear();
        drop(path);
        QTRY_COMPARE_WITH_TIMEOUT(page().messages().count(), 1, kPatience_ms);
        auto* playback = m_window->sources().active()->playback();
        const std::uint64_t damaged = playback->position().damagedBlocks;
        QVERIFY(damaged > 0);
        playback->seek(0.0);
        QTRY_VERIFY_WITH_TIMEOUT(playback->position().damagedBlocks > damaged, kPatience_ms);
        page().tick();
        QCOMPARE(page().messages().count(), 1);
        QCOMPARE(page().messages().repeats(), 1);
        QSignalSpy exported(&m_window->recording().csv(), &console::RecordingExport::finished);
        m_window->recording().csv().start(path, m_folder.filePath("damaged"));
        QTRY_COMPARE_WITH_TIMEOUT(exported.size(), 1, kPatience_ms);
        QCOMPARE(exported[0].mid(2), (QVariantList{1, false}));
        QCOMPARE(page().messages().count(), 2);
    }

    void aCameraIsPlayedWithTheReferenceThatItHad() {
        openScene("vtacarm-bump");
        auto* item = m_window->sources().active();
        QTRY_VERIFY_WITH_TIMEOUT(item->camera()->framesProcessed() > 3, kPatience_ms);
        const QString path = m_folder.filePath("camera.teleta");
        station().start(path);
        waitForFrames(8);
        item->camera()->renewReference();
        QTRY_VERIFY_WITH_TIMEOUT(referencesIn(path) >= 2, kPatience_ms);
        waitForFrames(station().status().frames + 4);
        end();
        m_window->sources().closeAll();
        drop(path);
        QTRY_VERIFY_WITH_TIMEOUT(showsData(), kPatience_ms);
        item = m_window->sources().active();
        QVERIFY(item->camera() != nullptr && item->camera()->description().recorded);
        QTRY_VERIFY_WITH_TIMEOUT(item->camera()->snapshot().hasReference, kPatience_ms);
        QVERIFY(m_window->findChild<chrome::PlaybackBar*>()->isVisible());
        QCOMPARE(page().messages().count(), 1); // that it was recorded
        // Whoever records it again gets the renewed one as well.
        item->playback()->setLoop(true);
        item->playback()->play();
        const QString again = m_folder.filePath("again.teleta");
        station().start(again);
        QTRY_VERIFY_WITH_TIMEOUT(referencesIn(again) >= 2, kPatience_ms);
        end();
    }

    void aGelIsPlayedWithTheRestThatItHad() {
        openScene("gel-press");
        auto* item = m_window->sources().active();
        QTRY_VERIFY_WITH_TIMEOUT(item->gel()->framesProcessed() > 9, kPatience_ms);
        const QString path = m_folder.filePath("gel.teleta");
        station().start(path);
        waitForFrames(30);
        end();
        m_window->sources().closeAll();
        drop(path);
        QTRY_VERIFY_WITH_TIMEOUT(showsData(), kPatience_ms);
        item = m_window->sources().active();
        QVERIFY(item->gel()->description().recorded);
        // From its first picture on, and not after 8 of them.
        QTRY_COMPARE_WITH_TIMEOUT(item->gel()->snapshot().markers.size(), std::size_t{165}, kPatience_ms);
        QVERIFY(item->gel()->framesProcessed() < 8);
    }

    void aFullDiskEndsTheRecordingWithAMessageAndTheFileOpens() {
        openScene("tactile-indenter");
        const QString path = m_folder.filePath("full.teleta");
        station().start(path);
        waitForFrames(200);
        const auto ignored = std::signal(SIGXFSZ, SIG_IGN);
        rlimit before{};
        QCOMPARE(getrlimit(RLIMIT_FSIZE, &before), 0);
        rlimit full = before;
        full.rlim_cur = std::filesystem::file_size(path.toStdString() + "-wal");
        QCOMPARE(setrlimit(RLIMIT_FSIZE, &full), 0);
        QTRY_COMPARE_WITH_TIMEOUT(station().state(), RecordingService::State::idle, kPatience_ms);
        QCOMPARE(setrlimit(RLIMIT_FSIZE, &before), 0);
        std::signal(SIGXFSZ, ignored);
        QCOMPARE(page().messages().count(), 1);
        // The status bar, which is below every page, tells it until there is another recording.
        auto* indicator = m_window->findChild<chrome::RecordingIndicator*>();
        QTRY_COMPARE(indicator->text(), QStringLiteral("Recording failed"));
        QVERIFY(indicator->isVisible());
        QVERIFY(!indicator->findChild<QToolButton*>("record")->toolTip().startsWith("Record all"));
        const std::uint64_t processed = m_window->sources().active()->channel->framesProcessed();
        QTRY_VERIFY(m_window->sources().active()->channel->framesProcessed() > processed);
        const auto recording = recording::Recording::open(path.toStdString());
        QVERIFY2(recording, recording ? "" : core::describe(recording.error()).c_str());
        QVERIFY(!recording->isComplete());
        QVERIFY(framesOf(*recording, "tactile-indenter-frames").sourceTime_s.size() >= 50);
        station().start(m_folder.filePath("after.teleta"));
        waitForFrames(10);
        end();
        QTRY_COMPARE(indicator->text(), QStringLiteral("Record"));
    }

    void aFolderThatCannotBeMadeIsToldAndNothingIsLost() {
        openScene("tactile-indenter");
        station().start("/proc/nowhere/run.teleta");
        QTRY_COMPARE_WITH_TIMEOUT(page().messages().count(), 1, kPatience_ms);
        QCOMPARE(station().state(), RecordingService::State::idle);
        QVERIFY(m_window->sources().active() != nullptr);
    }

    void whatIsNoRecordingIsToldInABar() {
        openScene("tactile-indenter");
        QFile file(m_folder.filePath("foreign.teleta"));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("no database at all") > 0);
        file.close();
        drop(file.fileName());
        QTRY_COMPARE_WITH_TIMEOUT(page().messages().count(), 1, kPatience_ms);
        QCOMPARE(m_window->sources().items().size(), std::size_t(1));
        QVERIFY(QApplication::activeModalWidget() == nullptr);
    }

    void aTextThatIsBeingTypedIsKeptByAMarkTheEndAndTheClosing() {
        openScene("tactile-indenter");
        const auto type = [&](const RecordingMark& mark, const char* text) {
            page().docks().bringForward("marks");
            page().marks().list().edit(mark.number);
            auto* editor = qobject_cast<QLineEdit*>(QApplication::focusWidget());
            QVERIFY(editor != nullptr && page().marks().list().isAncestorOf(editor));
            QTest::keyClicks(editor, text);
        };
        const auto begin = [&](const QString& path) {
            station().start(path);
            QTRY_VERIFY_WITH_TIMEOUT(station().isRecording(), kPatience_ms);
            QTest::keyClick(m_window.get(), Qt::Key_M);
            QCOMPARE(station().marks().all().size(), std::size_t(1));
        };
        const auto inFile = [](const QString& path) {
            const auto recording = recording::Recording::open(path.toStdString());
            return recording ? marksOf(*recording) : std::vector<std::string>{};
        };
        const QString ended = m_folder.filePath("typed.teleta");
        begin(ended);
        type(station().marks().all()[0], "it slipped");
        auto* indicator = m_window->findChild<chrome::RecordingIndicator*>();
        QTRY_VERIFY(indicator->findChild<QToolButton*>("mark")->isVisible());
        QTest::mouseClick(indicator->findChild<QToolButton*>("mark"), Qt::LeftButton);
        QCOMPARE(station().marks().all().size(), std::size_t(2));
        QCOMPARE(station().marks().all()[0].text, QString("it slipped"));
        QCOMPARE(station().marks().all()[1].text, QString());
        type(station().marks().all()[1], "it fell");
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_R, Qt::ControlModifier);
        QTRY_COMPARE_WITH_TIMEOUT(station().state(), RecordingService::State::idle, kPatience_ms);
        QCOMPARE(inFile(ended), (std::vector<std::string>{"it slipped", "it fell"}));

        const QString closed = m_folder.filePath("typed-closed.teleta");
        begin(closed);
        type(station().marks().all()[0], "the last word");
        m_window->close();
        m_window.reset();
        QCOMPARE(inFile(closed), std::vector<std::string>{"the last word"});
    }

    void theTextOfAMarkIsTypedWhileItIsRecordedAndAfterwards() {
        QTest::failOnWarning(QRegularExpression("edit"));
        openScene("tactile-indenter");
        const QString path = m_folder.filePath("afterwards.teleta");
        station().start(path);
        QTRY_VERIFY_WITH_TIMEOUT(station().isRecording(), kPatience_ms);
        QTest::keyClick(m_window.get(), Qt::Key_M);
        QTest::keyClick(m_window.get(), Qt::Key_M);
        page().docks().bringForward("marks");
        auto* table = page().marks().list().findChild<QTableWidget*>();
        QTRY_VERIFY(table->isVisible());
        const auto type = [&](int row, const char* text) {
            const QPoint cell = table->visualItemRect(table->item(row, 1)).center();
            QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, cell);
            QTest::mouseDClick(table->viewport(), Qt::LeftButton, {}, cell);
            QTRY_VERIFY(table->findChild<QLineEdit*>() != nullptr);
            auto* editor = table->findChild<QLineEdit*>();
            editor->selectAll();
            QTest::keyClicks(editor, text);
            QTest::keyClick(editor, Qt::Key_Return);
            QTRY_COMPARE(station().marks().all()[static_cast<std::size_t>(row)].text, QString(text));
            QTRY_VERIFY(table->findChild<QLineEdit*>() == nullptr);
        };
        const auto inFile = [&] {
            const auto recording = recording::Recording::open(path.toStdString());
            return recording ? marksOf(*recording) : std::vector<std::string>{};
        };
        type(0, "it slipped");
        station().stop();
        QTRY_COMPARE_WITH_TIMEOUT(station().state(), RecordingService::State::idle, kPatience_ms);
        QCOMPARE(inFile(), (std::vector<std::string>{"it slipped", ""}));
        type(1, "it fell");
        type(0, "it held");
        QTRY_COMPARE(inFile(), (std::vector<std::string>{"it held", "it fell"}));
        station().marks().remove(station().marks().all()[0].number);
        QTRY_COMPARE(inFile(), std::vector<std::string>{"it fell"});
        station().marks().undoStack().undo();
        QTRY_COMPARE(inFile(), (std::vector<std::string>{"it held", "it fell"}));
        QCOMPARE(page().messages().count(), 1); // that it was recorded
        // A file that is away is told, and gets what it missed with the next change.
        const QString away = path + ".away";
        QVERIFY(QFile::rename(path, away));
        type(1, "too late");
        QTRY_COMPARE(page().messages().count(), 2);
        QVERIFY(QFile::rename(away, path));
        type(0, "it is back");
        QTRY_COMPARE(inFile(), (std::vector<std::string>{"it is back", "too late"}));
        // Or at the end.
        QVERIFY(QFile::rename(path, away));
        station().marks().remove(station().marks().all()[0].number);
        QTRY_VERIFY(page().messages().count() > 2 || page().messages().repeats() > 1);
        QVERIFY(QFile::rename(away, path));
        m_window.reset(); // which is the end
        QCOMPARE(inFile(), std::vector<std::string>{"too late"});
    }

    void theSourcesOfARecordingBeginTogetherWhenAllAreOpen() {
        openScene("tactile-indenter");
        m_window->sources().open(app::SceneRequest{"tactile-two-contacts", 1});
        QTRY_VERIFY_WITH_TIMEOUT(m_window->sources().items().back().isOpen(), kPatience_ms);
        const QString path = m_folder.filePath("together.teleta");
        station().start(path);
        waitForFrames(
            2400); // of four streams at 200 Hz: longer than a second, also when some come in a burst
        end();
        console::SourceManager& sources = m_window->sources();
        sources.closeAll();
        std::vector<bool> waited;
        connect(&sources, &console::SourceManager::opened, this, [&](pipeline::ChannelKey key) {
            waited.push_back(sources.find(key)->playback()->position().paused);
            if (waited.size() == 1) { // the bar can be used already
                sources.find(key)->playback()->setSpeed(0.5);
                sources.find(key)->playback()->seek(0.5);
            }
        });
        drop(path);
        QTRY_COMPARE_WITH_TIMEOUT(waited.size(), std::size_t(2), kPatience_ms);
        QCOMPARE(waited, (std::vector<bool>{true, true}));
        for (const console::SourceManager::Item& item : sources.items())
            QTRY_VERIFY_WITH_TIMEOUT(!item.waits, kPatience_ms);
        for (const console::SourceManager::Item& item : sources.items()) {
            QCOMPARE(item.playback()->position().speed, 0.5);
            QVERIFY(item.playback()->position().duration_s > 1.0);
            QVERIFY(item.playback()->position().target_s >= 0.5);
            QTRY_VERIFY_WITH_TIMEOUT(item.playback()->position().time_s > 0.6, kPatience_ms);
        }

        // One that is not opened after all holds up no other.
        const auto request = std::get<app::RecordingRequest>(sources.items().front().request);
        const auto other = std::get<app::RecordingRequest>(sources.items().back().request);
        sources.closeAll();
        sources.open(request);
        sources.close(sources.open(other));
        QTRY_VERIFY_WITH_TIMEOUT(sources.items().front().isOpen(), kPatience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(!sources.items().front().waits, kPatience_ms);
    }

    void closingTheWindowCompletesTheFile() {
        openScene("tactile-indenter");
        const QString path = m_folder.filePath("closed.teleta");
        station().start(path);
        waitForFrames(50);
        m_window->close();
        m_window.reset();
        QVERIFY(!QFile::exists(path + "-wal"));
        const auto recording = recording::Recording::open(path.toStdString());
        QVERIFY(recording);
        QVERIFY(recording->isComplete());
    }
};

QTEST_MAIN(RecordingTest)
#include "console_recording_test.moc"
