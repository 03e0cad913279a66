// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/certify/fault_injector.h"

#include "app/cli/base/interruption.h"
#include "backend/core/failure.h"
#include "backend/core/steady_time.h"
#include "backend/recording/recording.h"

#include <QCoreApplication>
#include <QFile>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <fstream>
#include <optional>
#include <sys/resource.h>
#include <thread>
#include <time.h>
#include <unistd.h>
#include <utility>

namespace teleta::cli {

namespace {

using certificate::FaultKind;
using certificate::FaultOutcome;
using namespace std::chrono_literals;

struct InjectorText {
    Q_DECLARE_TR_FUNCTIONS(FaultInjector)
};

constexpr std::int64_t kLongestStart_ns = 30'000'000'000;
constexpr std::int64_t kLongestStill_ns = 500'000'000;
constexpr auto kAskAgain = 100ms;
/// From a fault that the program outlives to STOP.
constexpr auto kUntilStop = 100ms;
/// How long the watching goes on beyond the bound.
constexpr double kBeyond_s = 0.1;
/// And once the fault is over.
constexpr auto kAfter = 150ms;
constexpr auto kEnd = 10s;
/// For STOP to be withdrawn everywhere.
constexpr auto kRelease = 200ms;
constexpr std::int64_t kClockStep_s = 3600;

/// The limit that only root may raise again stays as it is.
void limit(pid_t process, __rlimit_resource resource, rlim_t most) {
    rlimit limits{};
    prlimit(process, resource, nullptr, &limits);
    limits.rlim_cur = std::min(most, limits.rlim_max);
    prlimit(process, resource, &limits, nullptr);
}

/// Address space that a process uses now.
rlim_t addressSpaceOf(pid_t process) {
    std::ifstream file("/proc/" + std::to_string(process) + "/statm");
    rlim_t pages = 0;
    file >> pages;
    return pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
}

void stepClock(std::int64_t seconds) {
    timespec now{};
    clock_gettime(CLOCK_REALTIME, &now);
    now.tv_sec += seconds;
    clock_settime(CLOCK_REALTIME, &now);
}

/// Frames of all streams that can be read; empty: the file cannot.
std::optional<std::uint64_t> framesIn(const recording::Recording& recording) {
    std::uint64_t frames = 0;
    for (std::size_t stream = 0; stream < recording.streams().size(); ++stream) {
        recording::StreamReader reader = recording.reader(stream);
        core::TappedFrames block;
        for (;;) {
            const core::Expected<bool> read = reader.next(block);
            if (!read)
                return std::nullopt;
            if (!*read)
                break;
            frames += block.frames();
        }
    }
    return frames;
}

} // namespace

FaultInjector::FaultInjector(Setup setup, LineRelay* relay, const ActuatorWatch& watch)
    : m_setup(std::move(setup))
    , m_relay(relay)
    , m_watch(watch)
    , m_random(m_setup.seed) {
}

core::Expected<void> FaultInjector::driveAgain() {
    if (m_chain && m_chain->ended())
        m_chain.reset();
    if (!m_chain) {
        ++m_chains;
        const std::string recording =
            m_setup.folder.empty() ? "" : m_setup.folder + "/" + std::to_string(m_chains) + ".teleta";
        TELETA_TRY(m_chain, ChainProcess::start(m_setup.chain(recording), recording));
    }
    const std::int64_t begin_ns = core::steadyNow_ns();
    std::int64_t idle_ns = begin_ns;
    m_chain->say("release");
    for (;;) {
        const ChainProcess::State& state = m_chain->look();
        if (state.driving && m_watch.newest().on)
            return {};
        if (!state.driving) {
            idle_ns = core::steadyNow_ns();
        } else if (core::steadyNow_ns() - idle_ns > kLongestStill_ns) {
            // What holds an arm wants the switch to be let go first.
            m_chain->say("pause");
            idle_ns = core::steadyNow_ns();
        }
        if (interrupted())
            return core::Unexpected(interruption());
        if (m_chain->ended())
            return core::failed(core::ErrorKind::unavailable,
                                InjectorText::tr("the program under test ended by itself"));
        if (core::steadyNow_ns() - begin_ns > kLongestStart_ns)
            return core::failed(core::ErrorKind::unavailable,
                                state.problem.empty() ? InjectorText::tr("nothing moved within 30 s")
                                                      : InjectorText::tr("nothing moved within 30 s: %1")
                                                            .arg(QString::fromStdString(state.problem)));
        if (m_watch.failed())
            return core::failed(core::ErrorKind::unavailable,
                                InjectorText::tr("the device does not answer any more"));
        if (!state.driving)
            m_chain->say("go");
        std::this_thread::sleep_for(state.driving ? 2ms : kAskAgain);
    }
}

core::Expected<void> FaultInjector::waitForMotion() {
    std::uniform_int_distribution<int> phase_us(0, 100'000);
    do {
        TELETA_CHECK(driveAgain());
        std::this_thread::sleep_for(std::chrono::microseconds(phase_us(m_random)));
        // Between two touches motors are off for a moment; an arm is at rest for one where it turns back.
    } while (!m_watch.newest().on || !m_chain->look().driving);
    return {};
}

core::Expected<void> FaultInjector::waitForFullDisk() {
    const std::int64_t begin_ns = core::steadyNow_ns();
    while (!m_chain->look().recordingFailed) {
        if (core::steadyNow_ns() - begin_ns > kLongestStart_ns)
            return core::failed(core::ErrorKind::unavailable,
                                InjectorText::tr("the recording did not fail on a full disk"));
        std::this_thread::sleep_for(2ms);
    }
    return {};
}

LineFault FaultInjector::anyLie() {
    constexpr std::array kLies{LineFault::garbage, LineFault::refused, LineFault::strange};
    return kLies.at(m_random() % kLies.size());
}

void FaultInjector::begin(FaultKind kind) {
    switch (kind) {
    case FaultKind::kill:
        return m_chain->signal(SIGKILL);
    case FaultKind::terminate:
        return m_chain->signal(SIGTERM);
    case FaultKind::interrupt:
        return m_chain->signal(SIGINT);
    case FaultKind::hangUp:
        return m_chain->signal(SIGHUP);
    case FaultKind::sleep:
        return m_chain->signal(SIGSTOP);
    case FaultKind::unplug:
        return m_relay->set(LineFault::cut);
    case FaultKind::lateAnswers:
        return m_relay->set(LineFault::late);
    case FaultKind::lostRequests:
        return m_relay->set(LineFault::lost);
    case FaultKind::lies:
        return m_relay->set(anyLie());
    case FaultKind::stop:
        return;
    case FaultKind::diskFull:
        return limit(m_chain->process(), RLIMIT_FSIZE, 0);
    case FaultKind::memoryRefused:
        return limit(m_chain->process(), RLIMIT_AS, addressSpaceOf(m_chain->process()));
    case FaultKind::clockStep:
        m_clockStep_s = m_random() % 2 == 0 ? kClockStep_s : -kClockStep_s;
        return stepClock(m_clockStep_s);
    }
}

void FaultInjector::end(FaultKind kind) {
    if (m_relay != nullptr)
        m_relay->set(LineFault::none);
    if (kind == FaultKind::sleep)
        m_chain->signal(SIGCONT);
    if (m_clockStep_s != 0)
        stepClock(-std::exchange(m_clockStep_s, 0));
}

core::Expected<FaultOutcome> FaultInjector::inject(FaultKind kind) {
    TELETA_CHECK(waitForMotion());
    FaultOutcome outcome{.kind = kind};
    std::int64_t fault_ns = core::steadyNow_ns();
    begin(kind);
    if (isFollowedByStop(kind)) {
        std::this_thread::sleep_for(kUntilStop);
        if (kind == FaultKind::diskFull)
            TELETA_CHECK(waitForFullDisk());
        fault_ns = core::steadyNow_ns();
    }
    if (isFollowedByStop(kind) || kind == FaultKind::stop)
        m_chain->say("stop");
    const double watching_s =
        std::max(m_setup.bound_s + kBeyond_s, kind == FaultKind::sleep ? m_setup.leastSleep_s : 0.0);
    std::this_thread::sleep_for(std::chrono::duration<double>(watching_s));
    const std::int64_t watched_ns = core::steadyNow_ns();
    if (const auto off = m_watch.offSince(fault_ns))
        outcome.zero_s = static_cast<double>(off->answered_ns - fault_ns) * 1e-9;
    m_longestGap_ns = std::max(m_longestGap_ns, m_watch.longestGap_ns(fault_ns));
    end(kind);
    if (endsProgram(kind)) {
        endChain(kind, outcome);
    } else {
        std::this_thread::sleep_for(kAfter);
        outcome.restarted = outcome.zero_s && m_watch.wasOnAfter(watched_ns);
    }
    return outcome;
}

void FaultInjector::releaseStop() {
    // A site keeps the STOP of a program that is killed, until a person withdraws it.
    limit(m_chain->process(), RLIMIT_AS, RLIM_INFINITY);
    m_chain->say("release");
    std::this_thread::sleep_for(kRelease);
}

void FaultInjector::finish() {
    if (!m_chain || m_chain->ended())
        return;
    m_chain->say("pause");
    releaseStop();
    m_chain->signal(SIGTERM);
    (void)m_chain->waitForEnd(kEnd);
}

void FaultInjector::endChain(FaultKind kind, FaultOutcome& outcome) {
    if (isFollowedByStop(kind))
        releaseStop();
    if (kind == FaultKind::diskFull)
        m_chain->signal(SIGTERM);
    if (kind == FaultKind::memoryRefused || !m_chain->waitForEnd(kEnd)) {
        m_chain->signal(SIGKILL);
        (void)m_chain->waitForEnd(kEnd);
    }
    if (!m_chain->recording().empty())
        lookAtRecording(kind, outcome);
    m_chain.reset();
}

void FaultInjector::lookAtRecording(FaultKind kind, FaultOutcome& outcome) {
    const std::string path = m_chain->recording();
    const std::uint64_t safe = m_chain->look().safeFrames;
    const bool shouldBeComplete =
        kind == FaultKind::terminate || kind == FaultKind::interrupt || kind == FaultKind::hangUp;
    {
        const auto recording = recording::Recording::open(path);
        const std::optional<std::uint64_t> frames = recording ? framesIn(*recording) : std::nullopt;
        // One that was ended before it wrote anything has nothing to lose.
        outcome.fileDamaged =
            (!frames && safe > 0) || (shouldBeComplete && !(recording && recording->isComplete()));
        outcome.framesLost = frames && *frames >= safe ? 0 : safe - frames.value_or(0);
    }
    const bool isKept = outcome.fileDamaged || outcome.framesLost > 0;
    const std::string name = m_setup.keptAs + std::to_string(m_chains) + ".teleta";
    // What SQLite has beside the file belongs to it.
    for (const char* end : {"", "-wal", "-shm", "-journal"}) {
        const QString file = QString::fromStdString(path + end);
        if (isKept)
            QFile::rename(file, QString::fromStdString(name + end));
        else
            QFile::remove(file);
    }
    if (isKept)
        m_kept.push_back(name);
}

} // namespace teleta::cli
