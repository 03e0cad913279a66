// SPDX-License-Identifier: GPL-3.0-or-later
// The whole loop for an hour: arm, array, camera, bracelet, recording and all views. TELETA_SOAK_S: seconds
// in place of the hour.
#include "app/console/main_window.h"
#include "app/console/operate/operate_page.h"
#include "app/console/operate/recording_controls.h"
#include "backend/core/quantile.h"
#include "backend/pipeline/arm_channel.h"
#include "widgets/base/theme.h"
#include "widgets/view3d/vtk/gl_setup.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <future>
#include <malloc.h>
#include <map>
#include <memory>
#include <optional>
#include <unistd.h>
#include <utility>
#include <vector>

using namespace teleta;
using console::ConsoleOptions;
using console::ConsoleSettings;
using console::MainWindow;
using console::RecordingService;

namespace {

constexpr double kHour_s = 3600.0;
constexpr int kPatience_ms = 120'000;
constexpr int kLook_ms = 1000;
/// Each source is looked at so long, one after the other; TELETA_SOAK_SHOWN_S is another time, to see what a
/// change of the source costs.
constexpr double kShown_s = 20.0;
/// Pictures fill a disk: a recording ends after so long, and the next one begins.
constexpr int kRecording_s = 30;
/// Until the histories of the views are full, which are 5 min at 200 Hz of a source that is shown a third of
/// the time. Memory is judged afterwards only.
constexpr double kWarmUp_s = 1000.0;
constexpr double kMemoryGrowth = 0.05;

double seconds(const char* variable, double usual_s) {
    bool isNumber = false;
    const double wanted_s = qEnvironmentVariable(variable).toDouble(&isNumber);
    return isNumber && wanted_s > 0.0 ? wanted_s : usual_s;
}

double residentMemory_MB() {
    QFile file(QStringLiteral("/proc/self/statm"));
    if (!file.open(QIODevice::ReadOnly))
        return 0.0;
    const QList<QByteArray> pages = file.readAll().split(' ');
    return pages.size() > 1 ? 1e-6 * pages[1].toDouble() * static_cast<double>(sysconf(_SC_PAGESIZE)) : 0.0;
}

/// What the program holds, without what it has given back to the allocator and the allocator keeps.
double heldMemory_MB() {
    const struct mallinfo2 info = mallinfo2();
    return 1e-6 * static_cast<double>(info.uordblks + info.hblkhd);
}

double quantileOf(std::vector<double> values, double probability) {
    if (values.empty())
        return 0.0;
    std::ranges::sort(values);
    return core::quantileOf(values, probability);
}

/// Tells what the event loop was longest busy with, to find what holds it up.
class TimedApplication : public QApplication {
public:
    TimedApplication(int& argc, char** argv)
        : QApplication(argc, argv) {
        m_running.start();
    }

    bool notify(QObject* receiver, QEvent* event) override {
        if (m_depth > 0)
            return QApplication::notify(receiver, event);
        ++m_depth;
        const QByteArray name = receiver->metaObject()->className() + (' ' + receiver->objectName().toUtf8());
        const QEvent::Type type = event->type();
        const double begin_s = threadTime_s();
        QElapsedTimer wall;
        wall.start();
        const bool taken = QApplication::notify(receiver, event);
        const double wall_s = 1e-9 * static_cast<double>(wall.nsecsElapsed());
        --m_depth;
        if (wall_s > kNoted_s)
            m_longest.push_back({wall_s, threadTime_s() - begin_s,
                                 1e-3 * static_cast<double>(m_running.elapsed()), name, type});
        return taken;
    }

    void tell() {
        std::ranges::sort(m_longest, {}, [](const Busy& busy) { return -busy.wall_s; });
        for (std::size_t i = 0; i < std::min<std::size_t>(m_longest.size(), 15); ++i)
            std::printf("busy for %.1f ms, of the processor %.1f, %.0f s after the start: %s, event %d\n",
                        1e3 * m_longest[i].wall_s, 1e3 * m_longest[i].thread_s, m_longest[i].ended_s,
                        m_longest[i].receiver.constData(), m_longest[i].type);
    }

private:
    static constexpr double kNoted_s = 0.02;
    struct Busy {
        double wall_s;
        double thread_s;
        double ended_s;
        QByteArray receiver;
        QEvent::Type type;
    };
    static double threadTime_s() {
        timespec time{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
        return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
    }

    std::vector<Busy> m_longest;
    QElapsedTimer m_running;
    int m_depth = 0;
};

} // namespace

class LoopSoakTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;
    std::unique_ptr<core::StopSwitch> m_stop;
    std::unique_ptr<ConsoleSettings> m_settings;
    std::unique_ptr<MainWindow> m_window;

    std::vector<double> m_memory_MB;  ///< resident, one a look
    std::vector<double> m_held_MB;    ///< of it, what is not free
    std::vector<double> m_time_s;     ///< of the look
    std::map<QString, int> m_notLive; ///< looks at which a device was not live
    std::map<QString, std::vector<double>> m_latency_s;
    std::uint64_t m_recorded = 0;
    std::uint64_t m_notRecorded = 0;
    int m_recordings = 0;
    std::future<bool> m_removing; ///< of the file before

    /// The camera of the scene with a quarter of its pixels, so that two cores follow at 40 Hz.
    QString cameraScene() {
        QFile shipped(QStringLiteral(TELETA_SOURCE_DIR "/resources/scenes/vtacarm-multicontact.toml"));
        if (!shipped.open(QIODevice::ReadOnly))
            qFatal("the camera scene is missing");
        QByteArray text = shipped.readAll();
        text.replace("width_px = 1640", "width_px = 820");
        text.replace("height_px = 1232", "height_px = 616");
        text.replace("focal_length_px = 587.0", "focal_length_px = 293.5");
        QFile file(m_folder.filePath(QStringLiteral("camera.toml")));
        if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size())
            qFatal("cannot write the scene");
        return file.fileName();
    }

    [[nodiscard]] RecordingService& station() const { return m_window->recorder(); }

    void beginRecording() {
        station().start(m_folder.filePath(QStringLiteral("run%1.teleta").arg(m_recordings++)));
        QTRY_VERIFY_WITH_TIMEOUT(station().isRecording(), kPatience_ms);
    }
    void endRecording() {
        QVERIFY(!m_removing.valid() || m_removing.get());
        station().stop();
        QTRY_COMPARE_WITH_TIMEOUT(station().state(), RecordingService::State::idle, kPatience_ms);
        QVERIFY2(station().status().state == recording::RecorderStatus::State::stopped,
                 core::describe(station().status().error).c_str());
        QVERIFY(station().status().frames > 0);
        m_recorded += station().status().frames;
        m_notRecorded += station().status().dropped;
        // Half a gigabyte takes its time to remove, which is no work of the console's.
        m_removing =
            std::async(std::launch::async, [path = station().path()] { return QFile::remove(path); });
    }

    void look(double time_s) {
        m_time_s.push_back(time_s);
        m_memory_MB.push_back(residentMemory_MB());
        m_held_MB.push_back(heldMemory_MB());
        for (const chrome::DeviceReading& reading : m_window->operatePage().readings()) {
            m_notLive[reading.name] += reading.state == core::DeviceState::live ? 0 : 1;
            if (reading.active && reading.latency_s)
                m_latency_s[reading.name].push_back(*reading.latency_s);
        }
        // An arm that has come to the end of its program begins anew.
        for (const auto& item : m_window->sources().items())
            if (item.arm() && item.arm()->device().drive() == core::ArmDrive::held)
                item.arm()->device().restartProgram();
    }

    void showNext(std::size_t turn) {
        const auto& items = m_window->sources().items();
        m_window->sources().activate(items[turn % items.size()].key);
    }

    void tell(double duration_s) const {
        const console::GuiClock::Report loop = m_window->clock().report();
        std::printf("%.0f s, %d recordings of %d s\n", duration_s, m_recordings, kRecording_s);
        for (const auto& [name, memory_MB] :
             {std::pair{"resident", &m_memory_MB}, std::pair{"held", &m_held_MB}})
            std::printf("%s memory: %.0f MB at first, %.0f in the middle, %.0f at the end\n", name,
                        memory_MB->front(), (*memory_MB)[memory_MB->size() / 2], memory_MB->back());
        std::printf("event loop: work p50 %.1f, p99 %.1f, most %.1f ms; late p99 %.1f, most %.1f ms\n",
                    1e3 * loop.work_p50_s, 1e3 * loop.work_p99_s, 1e3 * loop.work_max_s,
                    1e3 * loop.stall_p99_s, 1e3 * loop.stall_max_s);
        std::printf("recorded %llu frames, not in time %llu\n", static_cast<unsigned long long>(m_recorded),
                    static_cast<unsigned long long>(m_notRecorded));
        for (const chrome::DeviceReading& reading : m_window->operatePage().readings())
            std::printf("%s: %.1f Hz, %llu lost, not live at %d of %zu looks\n", qPrintable(reading.name),
                        reading.rate_Hz, static_cast<unsigned long long>(reading.lost),
                        m_notLive.contains(reading.name) ? m_notLive.at(reading.name) : 0, m_time_s.size());
        for (const auto& item : m_window->sources().items())
            if (item.camera())
                std::printf("pictures passed over for newer ones: %llu\n",
                            static_cast<unsigned long long>(item.camera()->snapshot().passedOver));
        for (const auto& [name, latency_s] : m_latency_s)
            std::printf("%s to screen: p50 %.1f, p99 %.1f ms of %zu\n", qPrintable(name),
                        1e3 * quantileOf(latency_s, 0.5), 1e3 * quantileOf(latency_s, 0.99),
                        latency_s.size());
        if (const auto felt = m_window->bracelet().touchToSkin())
            std::printf("touch to bracelet: p50 %.1f, p99 %.1f ms\n", 1e3 * felt->median_s,
                        1e3 * felt->p99_s);
        for (const console::TouchReceipt& receipt : m_window->bracelet().receipts())
            if (receipt.begin_s)
                std::printf("touch %llu: evaluated after %.2f ms, on the bracelet after %.2f ms\n",
                            static_cast<unsigned long long>(receipt.sent.touch), 1e3 * receipt.evaluated_s(),
                            1e3 * *receipt.begin_s);
        std::fflush(stdout);
    }

private slots:
    void initTestCase() {
        qputenv("HOME", m_folder.path().toUtf8());
        qputenv("XDG_CONFIG_HOME", m_folder.filePath("config").toUtf8());
        base::applyTheme(base::ThemeChoice::light);
    }

    void runsWithoutLossAndWithFlatMemory() {
        const double duration_s = seconds("TELETA_SOAK_S", kHour_s);
        const int shown_s = static_cast<int>(std::ceil(seconds("TELETA_SOAK_SHOWN_S", kShown_s)));
        m_stop = std::make_unique<core::StopSwitch>();
        m_settings = std::make_unique<ConsoleSettings>(true);
        ConsoleOptions options;
        options.scenes = {QStringLiteral("teleta-touch"), QStringLiteral("tactile-indenter"), cameraScene()};
        options.bracelet = QStringLiteral("simulated");
        m_window = std::make_unique<MainWindow>(options, *m_settings, *m_stop);
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        m_window->openRequested(options);
        const auto& items = m_window->sources().items();
        const auto allOpen = [&] {
            return items.size() == 3 && std::ranges::all_of(items, [](const auto& i) { return i.isOpen(); });
        };
        QTRY_VERIFY_WITH_TIMEOUT(allOpen(), kPatience_ms);
        m_window->clock().resetReport();

        QElapsedTimer run;
        run.start();
        QElapsedTimer recording;
        std::size_t turn = 0;
        for (int second = 0; 1e-3 * static_cast<double>(run.elapsed()) < duration_s; ++second) {
            if (second % shown_s == 0)
                showNext(turn++);
            if (!recording.isValid()) {
                beginRecording();
                recording.start();
            }
            QTest::qWait(kLook_ms);
            look(1e-3 * static_cast<double>(run.elapsed()));
            if (recording.elapsed() > 1000 * kRecording_s) {
                endRecording();
                recording.invalidate();
            }
        }
        if (recording.isValid())
            endRecording();
        QVERIFY(!m_removing.valid() || m_removing.get());
        tell(1e-3 * static_cast<double>(run.elapsed()));

        for (const chrome::DeviceReading& reading : m_window->operatePage().readings()) {
            QVERIFY2(reading.lost == 0, qPrintable(reading.name));
            QVERIFY2(reading.state == core::DeviceState::live, qPrintable(reading.name));
        }
        QVERIFY(m_recorded > 0);
        QCOMPARE(m_notRecorded, std::uint64_t(0));
        for (const auto& item : items)
            if (item.arm())
                QCOMPARE(item.arm()->samplesNotShown() + item.arm()->touchesNotShown(), std::uint64_t(0));
        if (duration_s < 2.0 * kWarmUp_s)
            QSKIP("Nothing was lost; memory is judged in a run of at least 2000 s only.");
        const auto warm =
            m_held_MB.begin() + (std::ranges::upper_bound(m_time_s, kWarmUp_s) - m_time_s.begin());
        QVERIFY(m_held_MB.end() - warm >= 30);
        const auto part = (m_held_MB.end() - warm) / 3;
        const double before_MB = quantileOf({warm, warm + part}, 0.5);
        const double after_MB = quantileOf({m_held_MB.end() - part, m_held_MB.end()}, 0.5);
        QVERIFY2(after_MB < (1.0 + kMemoryGrowth) * before_MB,
                 qPrintable(QStringLiteral("%1 MB, then %2 MB").arg(before_MB).arg(after_MB)));
    }

    void cleanupTestCase() { m_window.reset(); }
};

int main(int argc, char* argv[]) {
    view3d::configureOpenGlBeforeApplication();
    TimedApplication application(argc, argv);
    // The hour is one function of the test.
    qputenv("QTEST_FUNCTION_TIMEOUT", "5400000");
    LoopSoakTest test;
    const int failures = QTest::qExec(&test, argc, argv);
    application.tell();
    return failures;
}
#include "loop_soak_test.moc"
