// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/process_times.h"

#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <sys/resource.h>
#include <time.h>
#include <unistd.h>

namespace teleta::console {

double processorTime_s() {
    rusage used{};
    getrusage(RUSAGE_SELF, &used);
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    return seconds(used.ru_utime) + seconds(used.ru_stime);
}

double processAge_s() {
    // proc(5): the name in brackets may hold anything; the begin is the 20th number after it.
    constexpr int kBegin = 20;
    std::ifstream file("/proc/self/stat");
    std::string text;
    std::getline(file, text);
    std::istringstream numbers(text.substr(text.rfind(')') + 1));
    std::string word;
    for (int i = 0; i < kBegin; ++i)
        numbers >> word;
    timespec now{};
    if (!numbers || clock_gettime(CLOCK_BOOTTIME, &now) != 0)
        return std::numeric_limits<double>::quiet_NaN();
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec) -
           std::stod(word) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

} // namespace teleta::console
