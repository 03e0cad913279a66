// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/cli/program_run.h"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <sys/wait.h>
#include <unistd.h>

namespace teleta::test {

namespace {

int openOrThrow(const std::string& path, int flags) {
    const int file = ::open(path.c_str(), flags | O_CLOEXEC, 0600);
    if (file < 0)
        throw std::runtime_error("cannot open " + path);
    return file;
}

int openTerminal() {
    const int terminal = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
    if (terminal < 0 || grantpt(terminal) != 0 || unlockpt(terminal) != 0)
        throw std::runtime_error("cannot open a terminal");
    return terminal;
}

} // namespace

RunningProgram::RunningProgram(const std::vector<std::string>& arguments, const ProgramSettings& settings) {
    // Everything that allocates happens before the fork.
    std::vector<std::string> words{TELETA_PROGRAM};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& word : words)
        argv.push_back(word.data());
    argv.push_back(nullptr);

    const int in = openOrThrow("/dev/null", O_RDONLY);
    int out = -1;
    int err = -1;
    if (settings.terminal) {
        m_terminal = openTerminal();
        out = err = openOrThrow(ptsname(m_terminal), O_RDWR | O_NOCTTY);
    } else {
        out = openOrThrow(settings.outPath.empty() ? m_folder.path("out") : settings.outPath,
                          O_WRONLY | O_CREAT | O_TRUNC);
        err = openOrThrow(m_folder.path("err"), O_WRONLY | O_CREAT | O_TRUNC);
    }

    m_process = fork();
    if (m_process < 0)
        throw std::runtime_error("cannot fork");
    if (m_process == 0) {
        unsetenv("LC_ALL");
        unsetenv("LANGUAGE");
        setenv("LANG", "C.UTF-8", 1);
        for (const auto& [name, value] : settings.environment)
            setenv(name.c_str(), value.c_str(), 1);
        dup2(in, STDIN_FILENO);
        dup2(out, STDOUT_FILENO);
        dup2(err, STDERR_FILENO);
        execv(argv.front(), argv.data());
        _exit(127);
    }
    ::close(in);
    ::close(out);
    if (err != out)
        ::close(err);
}

RunningProgram::~RunningProgram() {
    if (!m_ended) {
        kill(m_process, SIGKILL);
        reap(0);
    }
    if (m_terminal >= 0)
        ::close(m_terminal);
}

void RunningProgram::send(int signal) const {
    kill(m_process, signal);
}

bool RunningProgram::ended() {
    reap(WNOHANG);
    return m_ended;
}

namespace {

/// Libraries that are being loaded hold any text.
bool isOpenForWriting(pid_t process, const std::string& descriptor) {
    std::ifstream info("/proc/" + std::to_string(process) + "/fdinfo/" + descriptor);
    for (std::string word; info >> word;) {
        unsigned flags = O_RDONLY;
        if (word == "flags:" && info >> std::oct >> flags)
            return (flags & O_ACCMODE) != O_RDONLY;
    }
    return false;
}

} // namespace

bool RunningProgram::hasWritten(std::string_view text) const {
    // A file that the program closes meanwhile is no error.
    std::error_code gone;
    const std::filesystem::path files = "/proc/" + std::to_string(m_process) + "/fd";
    for (std::filesystem::directory_iterator file(files, gone), end; !gone && file != end;
         file.increment(gone)) {
        if (std::filesystem::is_regular_file(file->path(), gone) &&
            isOpenForWriting(m_process, file->path().filename().string()) &&
            readAll(file->path()).find(text) != std::string::npos)
            return true;
    }
    return false;
}

long RunningProgram::peakMemory_kB() const {
    std::ifstream status("/proc/" + std::to_string(m_process) + "/status");
    for (std::string word; status >> word;) {
        long value_kB = 0;
        if (word == "VmHWM:" && status >> value_kB)
            return value_kB;
    }
    return 0;
}

void RunningProgram::reap(int options) {
    int status = 0;
    if (m_ended || waitpid(m_process, &status, options) != m_process)
        return;
    m_ended = true;
    m_result.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

bool RunningProgram::readTerminalOnce() {
    char buffer[4096];
    ssize_t count = 0;
    do
        count = ::read(m_terminal, buffer, sizeof buffer);
    while (count < 0 && errno == EINTR);
    // Reading fails with EIO when the program has closed its side.
    if (count > 0)
        m_result.out.append(buffer, static_cast<std::size_t>(count));
    return count > 0;
}

const std::string& RunningProgram::readTerminal() {
    readTerminalOnce();
    return m_result.out;
}

ProgramResult RunningProgram::wait() {
    while (m_terminal >= 0 && readTerminalOnce()) {
    }
    reap(0);
    if (m_terminal < 0) {
        m_result.out = readAll(m_folder.path("out"));
        m_result.err = readAll(m_folder.path("err"));
    }
    return m_result;
}

ProgramResult run(const std::vector<std::string>& arguments, const ProgramSettings& settings) {
    return RunningProgram(arguments, settings).wait();
}

std::vector<std::vector<std::string>> splitCsv(const std::string& text) {
    std::vector<std::vector<std::string>> rows;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::vector<std::string>& row = rows.emplace_back();
        std::istringstream fields(line);
        for (std::string field; std::getline(fields, field, ',');)
            row.push_back(field);
    }
    return rows;
}

} // namespace teleta::test
