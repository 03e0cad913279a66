// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <csignal>
#include <cstdlib>
#include <string>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

namespace teleta::dds {

/// A program of its own in the domain: this test program once more, which runs one function that is written
/// as a disabled test and is killed with this object. A mere copy of this process would lack the threads of
/// the domains that it has open.
class DdsChild {
public:
    /// test: "Suite.DISABLED_name"; argument: what childArgument() returns there.
    DdsChild(const std::string& test, const std::string& argument)
        : m_process(fork()) {
        if (m_process != 0)
            return;
        setenv(kVariable, argument.c_str(), 1);
        const std::string filter = "--gtest_filter=" + test;
        alarm(60);
        execl("/proc/self/exe", "child", filter.c_str(), "--gtest_also_run_disabled_tests",
              static_cast<const char*>(nullptr));
        std::_Exit(1);
    }
    ~DdsChild() {
        (void)kill(m_process, SIGKILL);
        (void)waitpid(m_process, nullptr, 0);
    }
    DdsChild(const DdsChild&) = delete;
    DdsChild& operator=(const DdsChild&) = delete;

    /// Empty where nobody started this process as a child.
    [[nodiscard]] static std::string childArgument() {
        const char* argument = std::getenv(kVariable);
        return argument == nullptr ? "" : argument;
    }

private:
    static constexpr const char* kVariable = "TELETA_DDS_CHILD";
    pid_t m_process;
};

} // namespace teleta::dds
