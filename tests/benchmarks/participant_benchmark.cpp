// SPDX-License-Identifier: GPL-3.0-or-later
// Time from a participant's key to the repainted participant's window, and until the console is idle again,
// in a session of the Study page with its store and a simulated bracelet on Qt's offscreen platform, compared
// with a frame at 60 Hz timed in the same run.
#include "tests/app/console/study/study_bench.h"

#include <QApplication>
#include <QKeyEvent>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace {

using namespace teleta;
using Clock = std::chrono::steady_clock;

constexpr double kFrame_s = 1.0 / 60.0;
constexpr int kTrials = 200;
const QSize kScreen(1920, 1080);

double secondsSince(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

void report(benchmark::State& state, const std::string& what, std::vector<double> times_s) {
    std::sort(times_s.begin(), times_s.end());
    const auto frames = [&](double share) {
        return times_s[static_cast<std::size_t>(share * static_cast<double>(times_s.size() - 1))] / kFrame_s;
    };
    state.counters[what + "_frames_p50"] = frames(0.5);
    state.counters[what + "_frames_p99"] = frames(0.99);
    state.counters[what + "_frames_max"] = frames(1.0);
}

/// Records when the last part of a window was painted.
class Application : public QApplication {
public:
    using QApplication::QApplication;
    bool notify(QObject* receiver, QEvent* event) override {
        const bool paints = event->type() == QEvent::Paint && receiver->isWidgetType() &&
                            static_cast<QWidget*>(receiver)->window() == m_window;
        const bool handled = QApplication::notify(receiver, event);
        if (paints)
            m_painted = Clock::now();
        return handled;
    }
    void watch(QWidget* window) {
        m_window = window;
        m_painted.reset();
    }
    [[nodiscard]] std::optional<Clock::time_point> painted() const { return m_painted; }

private:
    QWidget* m_window = nullptr;
    std::optional<Clock::time_point> m_painted;
};

/// The paper's six shapes with their pictures, practised without end.
class Session : public test::StudyBench {
public:
    Session() {
        setUp();
        openPage();
        study::StudyHead head;
        head.protocol = study::paperProtocol().value();
        head.protocol.stimulus_s = 0.1;
        head.protocol.practice.repetitions = 1000;
        head.protocol.source = study::protocolText(head.protocol);
        head.mode = study::Mode::pilot;
        head.created = QDateTime::currentDateTimeUtc();
        controller().create(studyFolder().toStdString(), head);
        until([this] { return controller().overview().has_value() && !controller().isBusy(); });
        controller().enrol(QStringLiteral("P01"));
        until([this] { return controller().chosenSession() != nullptr && !controller().isBusy(); });
        controller().setNoiseConfirmed(true);
        until([this] { return study::allPassed(controller().checks()); });
        controller().begin();
        until([this] { return runner().isActive(); });
        window()->resize(kScreen);
        window()->show();
    }
    ~Session() { tearDown(); }

    /// From an answer on.
    struct Times {
        double painted_s; ///< until the window that shows whether it was right is painted
        double quiet_s;   ///< until everything else that the answer changed is
    };

    /// A trial.
    Times answer(Application& application) {
        until([this] { return !runner().isKeeping(); });
        key(QEvent::KeyPress, Qt::Key_Space);
        key(QEvent::KeyRelease, Qt::Key_Space);
        until([this] { return stage() == Stage::stimulus || stage() == Stage::answering; });
        QApplication::processEvents();
        const Qt::Key digit = static_cast<Qt::Key>(Qt::Key_1 + static_cast<int>(current().stimulus));
        application.watch(window());
        const Clock::time_point begin = Clock::now();
        key(QEvent::KeyPress, digit);
        while (!application.painted() || window()->scene().state != study::ParticipantScene::State::feedback)
            QApplication::processEvents();
        QApplication::processEvents();
        const Times times{std::chrono::duration<double>(*application.painted() - begin).count(),
                          secondsSince(begin)};
        application.watch(nullptr);
        key(QEvent::KeyRelease, digit);
        return times;
    }

private:
    template <typename Condition>
    void until(const Condition& condition) {
        while (!condition())
            QApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }
    void key(QEvent::Type type, Qt::Key code) {
        QKeyEvent event(type, code, Qt::NoModifier, QString(QChar(static_cast<char16_t>(code))));
        event.setTimestamp(static_cast<quint64>(core::steadyNow_ns() / 1'000'000));
        QApplication::sendEvent(window(), &event);
    }
};

void answerUntilItIsPainted(benchmark::State& state) {
    auto& application = *static_cast<Application*>(QCoreApplication::instance());
    Session session;
    std::vector<double> painted_s;
    std::vector<double> quiet_s;
    for (auto _ : state) {
        const Session::Times times = session.answer(application);
        painted_s.push_back(times.painted_s);
        quiet_s.push_back(times.quiet_s);
        state.SetIterationTime(times.painted_s);
    }
    report(state, "painted", painted_s);
    report(state, "quiet", quiet_s);
}

void frameAt60Hz(benchmark::State& state) {
    std::vector<double> times_s;
    for (auto _ : state) {
        const Clock::time_point begin = Clock::now();
        std::this_thread::sleep_until(
            begin + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(kFrame_s)));
        times_s.push_back(secondsSince(begin));
        state.SetIterationTime(times_s.back());
    }
    report(state, "waited", times_s);
}

BENCHMARK(frameAt60Hz)->Iterations(kTrials)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(answerUntilItIsPainted)->Iterations(kTrials)->UseManualTime()->Unit(benchmark::kMillisecond);

} // namespace

int main(int argc, char** argv) {
    if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
    Application application(argc, argv);
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv))
        return 1;
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
