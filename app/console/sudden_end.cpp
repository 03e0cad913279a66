// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/sudden_end.h"

#include "devices/site/site_client.h"

#include <QCoreApplication>
#include <QEvent>
#include <QGuiApplication>
#include <QSocketNotifier>
#include <QSqlDatabase>
#include <QThread>

#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <thread>
#include <unistd.h>
#include <utility>

namespace teleta::console {

namespace {

constexpr std::array kSignals{SIGTERM, SIGINT, SIGHUP};
/// For a window that does not close after a signal. The motors have been off for long by then.
constexpr unsigned kGrace_s = 10;

// Signal handlers reach nothing else.
std::atomic<core::StopSwitch*> g_stop = nullptr;
std::array<int, 2> g_pipe{-1, -1};
volatile std::sig_atomic_t g_signalled = 0;

std::atomic<SuddenEnd*> g_end = nullptr;
std::atomic<bool> g_securing = false; ///< secure() was called because the display is gone
std::atomic<bool> g_secured = false;  ///< and has returned
QtMessageHandler g_handlerBefore = nullptr;

void onSignal(int) {
    const int before = errno;
    // A site is not stopped because a console ends.
    site_link::SiteClient::leaveAll();
    if (core::StopSwitch* stop = g_stop)
        stop->engage();
    if (g_signalled == 0)
        alarm(kGrace_s);
    g_signalled = 1;
    (void)!write(g_pipe[1], "", 1);
    errno = before;
}

void onGraceOver(int) {
    _exit(EXIT_FAILURE);
}

void handle(int signal, void (*handler)(int)) {
    struct sigaction before = {};
    sigaction(signal, nullptr, &before);
    if (before.sa_handler == SIG_IGN)
        return; // nohup, or a shell's job in the background
    struct sigaction action = {};
    action.sa_handler = handler;
    action.sa_flags = SA_RESTART;
    sigemptyset(&action.sa_mask);
    sigaction(signal, &action, nullptr);
}

/// What Qt says just before it ends the program, by exit() under X11 and by _exit() under Wayland.
bool tellsOfLostDisplay(QtMsgType type, const QString& text) {
    return type == QtFatalMsg || text.startsWith(QLatin1String("The X11 connection broke")) ||
           text.startsWith(QLatin1String("The Wayland connection "));
}

} // namespace

SuddenEnd::SuddenEnd(core::StopSwitch& stop, Actions actions, QObject* parent)
    : QObject(parent)
    , m_stop(stop)
    , m_actions(std::move(actions)) {
    g_stop = &stop;
    g_end = this;
    if (pipe2(g_pipe.data(), O_CLOEXEC | O_NONBLOCK) == 0) {
        auto* notifier = new QSocketNotifier(g_pipe[0], QSocketNotifier::Read, this);
        connect(notifier, &QSocketNotifier::activated, this, [this, notifier] {
            notifier->setEnabled(false);
            leave();
        });
    }
    handle(SIGALRM, onGraceOver);
    for (const int signal : kSignals)
        handle(signal, onSignal);

    connect(qGuiApp, &QGuiApplication::commitDataRequest, this, &SuddenEnd::secure, Qt::DirectConnection);
    connect(qGuiApp, &QGuiApplication::commitDataRequest, this, [this] { m_sessionEnds = true; });
    qApp->installEventFilter(this);

    // Handlers run in the reverse order of their registration, and so do the ends of Qt's statics: those that
    // a recording needs are made first.
    (void)QSqlDatabase::drivers();
    (void)QSqlDatabase::connectionNames();
    static const bool registered = std::atexit([] {
                                       if (!whenDisplayIsGone())
                                           return;
                                       // Threads still run, and would use what ends next.
                                       std::fflush(nullptr);
                                       _exit(EXIT_FAILURE);
                                   }) == 0;
    (void)registered;
    g_handlerBefore =
        qInstallMessageHandler([](QtMsgType type, const QMessageLogContext& context, const QString& text) {
            if (tellsOfLostDisplay(type, text))
                (void)whenDisplayIsGone();
            if (g_handlerBefore != nullptr)
                g_handlerBefore(type, context, text);
        });
}

SuddenEnd::~SuddenEnd() {
    g_end = nullptr;
    qInstallMessageHandler(g_handlerBefore);
    for (const int signal : kSignals)
        handle(signal, SIG_DFL);
    handle(SIGALRM, SIG_DFL);
    alarm(0);
    g_stop = nullptr;
    for (int& end : g_pipe)
        if (end >= 0)
            ::close(std::exchange(end, -1));
}

void SuddenEnd::leave() {
    if (std::exchange(m_leaves, true))
        return;
    site_link::SiteClient::leaveAll();
    m_stop.engage();
    m_actions.leave();
}

void SuddenEnd::secure() {
    m_stop.engage();
    m_actions.secure();
}

bool SuddenEnd::whenDisplayIsGone() {
    SuddenEnd* end = g_end;
    if (end == nullptr)
        return false;
    site_link::SiteClient::leaveAll();
    end->m_stop.engage();
    if (QThread::currentThread() == end->thread()) {
        if (!g_securing.exchange(true)) {
            end->m_actions.secure();
            g_secured = true;
        }
        return true;
    }
    // What secure() needs belongs to the GUI, which may learn by itself that the display is gone.
    QMetaObject::invokeMethod(
        end, [] { (void)whenDisplayIsGone(); }, Qt::QueuedConnection);
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(kGrace_s);
    while (!g_secured && std::chrono::steady_clock::now() < deadline)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    return true;
}

bool SuddenEnd::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Quit && m_sessionEnds) {
        leave();
        return true;
    }
    return QObject::eventFilter(watched, event);
}

} // namespace teleta::console
