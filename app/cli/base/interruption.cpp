// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/base/interruption.h"

#include <QCoreApplication>

#include <csignal>
#include <poll.h>
#include <unistd.h>
#include <utility>

namespace teleta::cli {

namespace {

volatile std::sig_atomic_t g_interrupted = 0;

// A signal that arrives just before a read starts to wait would not end that read. The alarm strikes again
// every second until the program has noticed.
void onSignal(int) {
    g_interrupted = 1;
    alarm(1);
}

void handle(int signal, int flags) {
    struct sigaction action = {};
    action.sa_handler = onSignal;
    action.sa_flags = flags; // no SA_RESTART: blocking calls return
    sigemptyset(&action.sa_mask);
    sigaction(signal, &action, nullptr);
}

} // namespace

void catchInterruptions() {
    handle(SIGALRM, 0);
    handle(SIGINT, static_cast<int>(SA_RESETHAND));
    handle(SIGTERM, static_cast<int>(SA_RESETHAND));
    // A terminal that closes may send it twice. nohup has made the program deaf to it.
    struct sigaction hangUp = {};
    sigaction(SIGHUP, nullptr, &hangUp);
    if (hangUp.sa_handler != SIG_IGN)
        handle(SIGHUP, 0);
    // A reader that went away is an error of the write, so that other files are still completed.
    std::signal(SIGPIPE, SIG_IGN);
}

bool interrupted() {
    return g_interrupted != 0;
}

core::Error interruptedInstead(core::Error error) {
    return error.kind == core::ErrorKind::cancelled ? interruption() : std::move(error);
}

core::Error interruption() {
    return {core::ErrorKind::cancelled,
            QCoreApplication::translate("Interruption",
                                        "interrupted; the output ends with what was computed until then")
                .toStdString(),
            {},
            {}};
}

core::Expected<void> unlessCut(core::Expected<void> completed, bool cut) {
    return completed && cut ? core::Unexpected(interruption()) : completed;
}

core::Expected<void> unlessCut(core::Expected<void> completed) {
    return unlessCut(std::move(completed), interrupted());
}

bool readerIsGone() {
    pollfd output{STDOUT_FILENO, 0, 0};
    return poll(&output, 1, 0) == 1 && (output.revents & POLLERR) != 0;
}

void endUnread() {
    std::signal(SIGPIPE, SIG_DFL);
    (void)std::raise(SIGPIPE);
}

} // namespace teleta::cli
