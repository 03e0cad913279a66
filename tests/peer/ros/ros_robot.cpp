// SPDX-License-Identifier: GPL-3.0-or-later
// A robot for tests of ROS 2: see --help. It says "ready" when its topics exist, and "ended" last.
#include "robot.h"

#include <atomic>
#include <csignal>
#include <fcntl.h>
#include <fstream>
#include <iostream>
#include <poll.h>
#include <sched.h>
#include <sstream>
#include <sys/prctl.h>
#include <unistd.h>

using namespace teleta::peer;

namespace {

std::atomic<bool> s_ends = false;

/// Lines of standard input, without waiting.
class CommandLines {
public:
    /// False at the end of the input and after the line "end".
    bool read(Robot& robot) {
        pollfd input{STDIN_FILENO, POLLIN, 0};
        while (poll(&input, 1, 0) > 0) {
            char bytes[512];
            const ssize_t count = ::read(STDIN_FILENO, bytes, sizeof(bytes));
            if (count <= 0)
                return false;
            m_text.append(bytes, static_cast<std::size_t>(count));
            for (std::size_t end = m_text.find('\n'); end != std::string::npos; end = m_text.find('\n')) {
                const std::string line = m_text.substr(0, end);
                m_text.erase(0, end + 1);
                if (line == "end")
                    return false;
                std::cout << robot.command(line) << std::endl;
            }
        }
        return true;
    }

private:
    std::string m_text;
};

void run(Robot& robot, const RobotOptions& options) {
    // Others of the machine may be busy: with the right to it, the steps keep their time.
    sched_param priority{};
    priority.sched_priority = 20;
    sched_setscheduler(0, SCHED_FIFO, &priority);

    CommandLines lines;
    constexpr std::int64_t kStep_ns = 1'000'000;
    std::int64_t next_ns = clock_ns(CLOCK_MONOTONIC);
    const auto last = static_cast<std::int64_t>(options.seconds * 1000);
    for (std::int64_t step = 0; step < last && !s_ends; ++step, next_ns += kStep_ns) {
        const timespec until{next_ns / 1'000'000'000, next_ns % 1'000'000'000};
        clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr);
        const std::int64_t late_ns = clock_ns(CLOCK_MONOTONIC) - next_ns;
        // After a long pause (a signal stopped it) it goes on from now instead of hurrying after the clock.
        if (late_ns > 200'000'000)
            next_ns += late_ns;
        robot.step(step, 1e-9 * static_cast<double>(late_ns));
        if (options.commands && step % 10 == 0 && !lines.read(robot))
            break;
    }
    robot.finish();
}

} // namespace

int main(int argc, char** argv) {
    const RobotOptions options = readOptions(argc, argv);
    // It ends with the test that started it.
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    for (const int number : {SIGTERM, SIGINT})
        std::signal(number, [](int) { s_ends = true; });
    try {
        std::ostringstream urdf;
        urdf << std::ifstream(options.urdf).rdbuf();
        Robot robot(options, urdf.str());
        std::cout << "ready" << std::endl;
        run(robot, options);
        std::cout << "ended" << std::endl;
    } catch (const std::exception& error) {
        std::cerr << "ros_robot: " << error.what() << '\n';
        return 1;
    }
    return 0;
}
