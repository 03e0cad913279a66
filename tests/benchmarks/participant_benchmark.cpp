// SPDX-License-Identifier: GPL-3.0-or-later
// From a participant's key until the participant's window is painted anew, in a session of the Study page
// with its store and a simulated bracelet, on Qt's platform without a screen; in comparison with a frame of a
// screen at 60 Hz, waited for in the same run.
#include "tests/app/console/study/study_bench.h"

#include <QApplication>
#include <QKeyEvent>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
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

void report(benchmark::State& state, std::vector<double> times_s) {
    std::sort(times_s.begin(), times_s.end());
    const auto frames = [&](double share) {
        return times_s[static_cast<std::size_t>(share * static_cast<double>(times_s.size() - 1))] / kFrame_s;
    };
    state.counters["frames_p50"] = frames(0.5);
    state.counters["frames_p99"] = frames(0.99);
    state.counters["frames_max"] = frames(1.0);
}

/// Paints of a window are seen before they are done; they are done when the event loop comes back.
class PaintWatch : public QObject {
public:
    explicit PaintWatch(QWidget& window) { window.installEventFilter(this); }
    bool eventFilter(QObject* /*watched*/, QEvent* event) override {
        m_painted = m_painted || event->type() == QEvent::Paint;
        return false;
    }
    bool m_painted = false;
};

/// The paper's six shapes with their pictures, practised without an end.
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

    /// A trial; the time from its answer to the window that shows whether it was right.
    double answer_s() {
        until([this] { return !runner().isKeeping(); });
        key(QEvent::KeyPress, Qt::Key_Space);
        key(QEvent::KeyRelease, Qt::Key_Space);
        until([this] { return stage() == Stage::stimulus || stage() == Stage::answering; });
        QApplication::processEvents();
        const Qt::Key digit = static_cast<Qt::Key>(Qt::Key_1 + static_cast<int>(current().stimulus));
        PaintWatch watch(*window());
        const Clock::time_point begin = Clock::now();
        key(QEvent::KeyPress, digit);
        while (!watch.m_painted || window()->scene().state != studyview::ParticipantScene::State::feedback)
            QApplication::processEvents();
        const double took_s = secondsSince(begin);
        key(QEvent::KeyRelease, digit);
        return took_s;
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
    Session session;
    std::vector<double> times_s;
    for (auto _ : state) {
        times_s.push_back(session.answer_s());
        state.SetIterationTime(times_s.back());
    }
    report(state, times_s);
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
    report(state, times_s);
}

BENCHMARK(frameAt60Hz)->Iterations(kTrials)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(answerUntilItIsPainted)->Iterations(kTrials)->UseManualTime()->Unit(benchmark::kMillisecond);

} // namespace

int main(int argc, char** argv) {
    if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
    const QApplication application(argc, argv);
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv))
        return 1;
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
