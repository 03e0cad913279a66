// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/certify/chain_process.h"

#include "backend/core/failure.h"

#include <QCoreApplication>

#include <array>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <spawn.h>
#include <string_view>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <utility>
#include <vector>

namespace teleta::cli {

namespace {

struct ProcessText {
    Q_DECLARE_TR_FUNCTIONS(ProcessText)
};

/// Its signals act as usual, and those of a terminal do not reach it.
class SpawnSettings {
public:
    SpawnSettings(int input, int output) {
        posix_spawn_file_actions_init(&m_files);
        posix_spawn_file_actions_adddup2(&m_files, input, STDIN_FILENO);
        posix_spawn_file_actions_adddup2(&m_files, output, STDOUT_FILENO);
        posix_spawnattr_init(&m_attributes);
        sigset_t usual;
        sigemptyset(&usual);
        for (const int signal : {SIGHUP, SIGINT, SIGTERM, SIGPIPE})
            sigaddset(&usual, signal);
        posix_spawnattr_setsigdefault(&m_attributes, &usual);
        posix_spawnattr_setflags(&m_attributes, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
    }
    ~SpawnSettings() {
        posix_spawn_file_actions_destroy(&m_files);
        posix_spawnattr_destroy(&m_attributes);
    }
    SpawnSettings(const SpawnSettings&) = delete;
    SpawnSettings& operator=(const SpawnSettings&) = delete;

    [[nodiscard]] const posix_spawn_file_actions_t* files() const { return &m_files; }
    [[nodiscard]] const posix_spawnattr_t* attributes() const { return &m_attributes; }

private:
    posix_spawn_file_actions_t m_files{};
    posix_spawnattr_t m_attributes{};
};

core::Unexpected notStarted(int error) {
    return core::failed(
        core::ErrorKind::ioFailed,
        ProcessText::tr("the program cannot be started: %1").arg(QString::fromLocal8Bit(strerror(error))));
}

struct Pipe {
    core::FileDescriptor reading;
    core::FileDescriptor writing;

    [[nodiscard]] static core::Expected<Pipe> open() {
        std::array<int, 2> ends{};
        if (pipe2(ends.data(), O_CLOEXEC) != 0)
            return notStarted(errno);
        return Pipe{core::FileDescriptor(ends[0]), core::FileDescriptor(ends[1])};
    }
};

} // namespace

core::Expected<std::unique_ptr<ChainProcess>> ChainProcess::start(const std::vector<std::string>& arguments,
                                                                  const std::string& recording) {
    TELETA_TRY(Pipe commands, Pipe::open());
    TELETA_TRY(Pipe answers, Pipe::open());
    std::vector<std::string> words{"teleta", "certify"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> ends;
    for (std::string& word : words)
        ends.push_back(word.data());
    ends.push_back(nullptr);
    const SpawnSettings settings(commands.reading.get(), answers.writing.get());
    pid_t process = -1;
    const int error = posix_spawn(&process, "/proc/self/exe", settings.files(), settings.attributes(),
                                  ends.data(), environ);
    if (error != 0)
        return notStarted(error);
    fcntl(answers.reading.get(), F_SETFL, O_NONBLOCK);
    return std::unique_ptr<ChainProcess>(
        new ChainProcess(process, std::move(commands.writing), std::move(answers.reading), recording));
}

ChainProcess::ChainProcess(pid_t process, core::FileDescriptor commands, core::FileDescriptor answers,
                           std::string recording)
    : m_process(process)
    , m_commands(std::move(commands))
    , m_answers(std::move(answers))
    , m_recording(std::move(recording)) {
}

ChainProcess::~ChainProcess() {
    if (!ended()) {
        // Its driver's watchdog stops the motors; a chain that is stopped takes no other signal.
        signal(SIGKILL);
        waitpid(m_process, nullptr, 0);
    }
}

void ChainProcess::say(std::string line) {
    line += '\n';
    (void)!::write(m_commands.get(), line.data(), line.size());
}

void ChainProcess::signal(int signal) const {
    if (!m_ended)
        kill(m_process, signal);
}

const ChainProcess::State& ChainProcess::look() {
    std::array<char, 4096> piece{};
    ssize_t length = 0;
    while ((length = read(m_answers.get(), piece.data(), piece.size())) > 0)
        m_text.append(piece.data(), static_cast<std::size_t>(length));
    for (std::size_t end = 0; (end = m_text.find('\n')) != std::string::npos; m_text.erase(0, end + 1))
        take(std::string_view(m_text).substr(0, end));
    return m_state;
}

void ChainProcess::take(std::string_view line) {
    constexpr std::string_view kSafe = "safe ";
    constexpr std::string_view kProblem = "problem ";
    if (line == "driving") {
        m_state.driving = true;
        m_state.problem.clear();
    } else if (line.starts_with(kProblem)) {
        m_state.problem = line.substr(kProblem.size());
    } else if (line == "idle") {
        m_state.driving = false;
    } else if (line == "recording failed") {
        m_state.recordingFailed = true;
    } else if (line.starts_with(kSafe)) {
        std::from_chars(line.data() + kSafe.size(), line.data() + line.size(), m_state.safeFrames);
    }
}

bool ChainProcess::ended() {
    if (!m_ended)
        m_ended = waitpid(m_process, nullptr, WNOHANG) == m_process;
    return m_ended;
}

bool ChainProcess::waitForEnd(std::chrono::milliseconds longest) {
    const auto end = std::chrono::steady_clock::now() + longest;
    while (!ended()) {
        if (std::chrono::steady_clock::now() >= end)
            return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return true;
}

} // namespace teleta::cli
