// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/threads/urgent_thread.h"

#include <pthread.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <thread>
#include <unistd.h>

namespace teleta::core {

namespace {

/// Above default real-time work, below the threads that keep the system alive.
constexpr int kPriority = 10;
constexpr int kNice = -10;
constexpr unsigned long kSlack_ns = 1;

} // namespace

ThreadUrgency makeThreadUrgent() {
    (void)prctl(PR_SET_TIMERSLACK, kSlack_ns, 0, 0, 0);
    sched_param parameters{};
    parameters.sched_priority = kPriority;
    if (pthread_setschedparam(pthread_self(), SCHED_RR | SCHED_RESET_ON_FORK, &parameters) == 0)
        return ThreadUrgency::realTime;
    return raiseThread();
}

ThreadUrgency raiseThread() {
    // On Linux a nice value is a thread's own.
    return setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), kNice) == 0 ? ThreadUrgency::raised
                                                                              : ThreadUrgency::ordinary;
}

std::optional<int> libraryThreadPriority() {
    static const bool isAllowed = [] {
        bool reached = false;
        std::thread([&reached] { reached = makeThreadUrgent() == ThreadUrgency::realTime; }).join();
        return reached;
    }();
    return isAllowed ? std::optional(kPriority - 1) : std::nullopt;
}

} // namespace teleta::core
