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
    Q_DECLARE_TR_FUNCTIONS(ChainProcess)
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

} // namespace

core::Expected<std::unique_ptr<ChainProcess>> ChainProcess::start(const ChainOptions& options) {
    const auto failed = [](int error) {
        return core::failed(core::ErrorKind::ioFailed, ProcessText::tr("the program cannot be started: %1")
                                                           .arg(QString::fromLocal8Bit(strerror(error))));
    };
    std::array<int, 2> commands{};
    std::array<int, 2> answers{};
    if (pipe2(commands.data(), O_CLOEXEC) != 0)
        return failed(errno);
    if (pipe2(answers.data(), O_CLOEXEC) != 0) {
        const int error = errno;
        close(commands[0]);
        close(commands[1]);
        return failed(error);
    }
    std::vector<std::string> words{"teleta",     "certify",      "--chain", options.recording,
                                   "--bracelet", options.driver, "--port",  std::to_string(options.port)};
    std::vector<char*> arguments;
    for (std::string& word : words)
        arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const SpawnSettings settings(commands[0], answers[1]);
    pid_t process = -1;
    const int error = posix_spawn(&process, "/proc/self/exe", settings.files(), settings.attributes(),
                                  arguments.data(), environ);
    close(commands[0]);
    close(answers[1]);
    if (error != 0) {
        close(commands[1]);
        close(answers[0]);
        return failed(error);
    }
    fcntl(answers[0], F_SETFL, O_NONBLOCK);
    return std::unique_ptr<ChainProcess>(
        new ChainProcess(process, commands[1], answers[0], options.recording));
}

ChainProcess::ChainProcess(pid_t process, int commands, int answers, std::string recording)
    : m_process(process)
    , m_commands(commands)
    , m_answers(answers)
    , m_recording(std::move(recording)) {
}

ChainProcess::~ChainProcess() {
    if (!ended()) {
        // Its driver's watchdog stops the motors; a chain that is stopped takes no other signal.
        signal(SIGKILL);
        waitpid(m_process, nullptr, 0);
    }
    close(m_commands);
    close(m_answers);
}

void ChainProcess::say(std::string line) {
    line += '\n';
    (void)!write(m_commands, line.data(), line.size());
}

void ChainProcess::signal(int signal) const {
    if (!m_ended)
        kill(m_process, signal);
}

const ChainProcess::State& ChainProcess::look() {
    std::array<char, 4096> piece{};
    ssize_t length = 0;
    while ((length = read(m_answers, piece.data(), piece.size())) > 0)
        m_text.append(piece.data(), static_cast<std::size_t>(length));
    for (std::size_t end = 0; (end = m_text.find('\n')) != std::string::npos; m_text.erase(0, end + 1))
        take(std::string_view(m_text).substr(0, end));
    return m_state;
}

void ChainProcess::take(std::string_view line) {
    constexpr std::string_view kSafe = "safe ";
    if (line == "connected")
        ++m_state.connections;
    else if (line == "driving")
        m_state.driving = true;
    else if (line.starts_with("idle "))
        m_state.driving = false;
    else if (line == "recording failed")
        m_state.recordingFailed = true;
    else if (line.starts_with(kSafe))
        std::from_chars(line.data() + kSafe.size(), line.data() + line.size(), m_state.safeFrames);
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
