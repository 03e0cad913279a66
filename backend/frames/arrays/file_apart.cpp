// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/frames/arrays/file_apart.h"

#include "backend/core/failure.h"
#include "backend/core/file_descriptor.h"

#include <QCoreApplication>

#include <array>
#include <cerrno>
#include <cfenv>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <functional>
#include <new>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

namespace teleta::frames {

namespace {

struct FileApartText {
    Q_DECLARE_TR_FUNCTIONS(FileApartText)
};

constexpr std::uint32_t kMostMessageText = 1U << 16U;
constexpr std::uint32_t kMostArrays = 4096;
constexpr std::uint32_t kMostHeadDimensions = 64;
constexpr std::uint32_t kMessageValues = 1U << 16U;
constexpr int kMostSilence_ms = 120'000;
constexpr std::uint64_t kMemory_bytes = std::uint64_t{1} << 30U;
constexpr rlim_t kTime_s = 60;

/// What a message of the other process is.
enum class Message : std::uint32_t { values = 1, error = 2, heads = 3, done = 4 };

/// The other process's end of the pipe. It ends when nobody reads any more.
class PipeWriter {
public:
    explicit PipeWriter(int file)
        : m_file(file) {}

    void bytes(const void* data, std::size_t size) const {
        const auto* from = static_cast<const char*>(data);
        while (size > 0) {
            const ssize_t count = ::write(m_file, from, size);
            if (count < 0 && errno == EINTR)
                continue;
            if (count <= 0)
                ::_exit(0);
            from += count;
            size -= static_cast<std::size_t>(count);
        }
    }
    template <typename Number>
    void number(Number value) const {
        bytes(&value, sizeof value);
    }
    void text(const std::string& value) const {
        const auto size = static_cast<std::uint32_t>(std::min<std::size_t>(value.size(), kMostMessageText));
        number(size);
        bytes(value.data(), size);
    }
    void optional(const std::optional<double>& value) const {
        number(std::uint32_t{value.has_value()});
        number(value.value_or(0.0));
    }
    void error(const core::Error& error) const {
        number(Message::error);
        number(static_cast<std::uint32_t>(error.kind));
        text(error.message);
        text(error.expected);
        text(error.where.file);
    }
    void heads(const std::vector<ArrayHead>& heads) const {
        number(Message::heads);
        number(static_cast<std::uint32_t>(heads.size()));
        for (const ArrayHead& head : heads) {
            text(head.name);
            number(static_cast<std::uint32_t>(head.shape.size()));
            bytes(head.shape.data(), head.shape.size() * sizeof head.shape[0]);
            number(std::uint32_t{head.isColumnMajor});
            number(std::uint32_t{head.axisIsOpen});
            text(head.type);
            text(head.problem);
            text(head.unit);
            optional(head.rate_Hz);
            optional(head.pitch_m);
        }
    }
    void values(std::span<const double> values) const {
        while (!values.empty()) {
            const std::span<const double> piece =
                values.first(std::min<std::size_t>(values.size(), kMessageValues));
            number(Message::values);
            number(static_cast<std::uint32_t>(piece.size()));
            bytes(piece.data(), piece.size_bytes());
            values = values.subspan(piece.size());
        }
    }

private:
    int m_file;
};

/// What a message of the other process holds. It is not trusted: its library has read a hostile file.
class PipeReader {
public:
    explicit PipeReader(int file)
        : m_file(file) {}

    /// False at the end of the pipe, and after a long silence.
    bool bytes(void* data, std::size_t size) const {
        auto* to = static_cast<char*>(data);
        while (size > 0) {
            pollfd waiting{m_file, POLLIN, 0};
            const int ready = ::poll(&waiting, 1, kMostSilence_ms);
            if (ready < 0 && errno == EINTR)
                continue;
            const ssize_t count = ready > 0 ? ::read(m_file, to, size) : 0;
            if (count < 0 && errno == EINTR)
                continue;
            if (count <= 0)
                return false;
            to += count;
            size -= static_cast<std::size_t>(count);
        }
        return true;
    }
    template <typename Number>
    bool number(Number& value) const {
        return bytes(&value, sizeof value);
    }
    bool flag(bool& value) const {
        std::uint32_t number = 0;
        const bool isRead = bytes(&number, sizeof number);
        value = number != 0;
        return isRead;
    }
    bool text(std::string& value) const {
        std::uint32_t size = 0;
        if (!number(size) || size > kMostMessageText)
            return false;
        value.resize(size);
        return bytes(value.data(), size);
    }
    bool optional(std::optional<double>& value) const {
        bool isThere = false;
        double number = 0.0;
        if (!flag(isThere) || !bytes(&number, sizeof number))
            return false;
        value = isThere ? std::optional(number) : std::nullopt;
        return true;
    }
    bool error(core::Error& error) const {
        std::uint32_t kind = 0;
        if (!number(kind) || !text(error.message) || !text(error.expected) || !text(error.where.file))
            return false;
        error.kind = core::ErrorKind::badInput;
        for (const core::ErrorKind other : {core::ErrorKind::ioFailed, core::ErrorKind::unavailable})
            if (kind == static_cast<std::uint32_t>(other))
                error.kind = other;
        return !error.message.empty();
    }
    bool heads(std::vector<ArrayHead>& heads) const {
        std::uint32_t count = 0;
        if (!number(count) || count > kMostArrays)
            return false;
        for (std::uint32_t i = 0; i < count; ++i) {
            ArrayHead head;
            std::uint32_t dimensions = 0;
            if (!text(head.name) || !number(dimensions) || dimensions > kMostHeadDimensions)
                return false;
            head.shape.resize(dimensions);
            if (!bytes(head.shape.data(), dimensions * sizeof(std::uint64_t)) || !flag(head.isColumnMajor) ||
                !flag(head.axisIsOpen) || !text(head.type) || !text(head.problem) || !text(head.unit) ||
                !optional(head.rate_Hz) || !optional(head.pitch_m))
                return false;
            heads.push_back(std::move(head));
        }
        return true;
    }

private:
    int m_file;
};

/// How much address space this process has taken.
std::uint64_t takenMemory() {
    unsigned long long pages = 0;
    if (std::FILE* file = std::fopen("/proc/self/statm", "re")) {
        if (std::fscanf(file, "%llu", &pages) != 1)
            pages = 0;
        std::fclose(file);
    }
    return pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

/// What a process needs that a library may end at any time.
void liveApart(std::uint64_t values) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    std::fesetenv(FE_DFL_ENV);
    for (const int signal : {SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT, SIGTERM, SIGHUP, SIGXCPU, SIGPIPE})
        std::signal(signal, SIG_DFL);
    std::signal(SIGINT, SIG_IGN); // the reader is interrupted, and ends this process
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
    const int nothing = ::open("/dev/null", O_RDWR | O_CLOEXEC);
    if (nothing >= 0)
        for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
            ::dup2(nothing, stream);
    const auto limit = [](int what, rlim_t most) {
        const rlimit both{most, most};
        ::setrlimit(static_cast<__rlimit_resource_t>(what), &both);
    };
    limit(RLIMIT_CORE, 1); // no core file; 0 would not keep it from a program that collects them
    limit(RLIMIT_CPU, kTime_s + values / 1'000'000);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    limit(RLIMIT_AS, takenMemory() + kMemory_bytes + 24 * values);
#endif
}

/// A process that does a work and tells by a pipe.
class Process {
public:
    Process() = default;
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;
    ~Process() {
        m_pipe = core::FileDescriptor(-1); // it ends when nobody reads
        if (m_id > 0)
            end();
    }

    /// values: how many it will read, which decides its limits.
    bool start(std::uint64_t values, const std::function<void(const PipeWriter&)>& work) {
        std::array<int, 2> pipe{};
        if (::pipe2(pipe.data(), O_CLOEXEC) != 0)
            return false;
        m_pipe = core::FileDescriptor(pipe[0]);
        const core::FileDescriptor writing(pipe[1]);
        m_id = ::fork();
        if (m_id == 0) {
            liveApart(values);
            try {
                work(PipeWriter(writing.get()));
            } catch (const std::bad_alloc&) {
                ::_exit(kNoMemory);
            }
            ::_exit(0);
        }
        return m_id > 0;
    }

    [[nodiscard]] PipeReader reader() const { return PipeReader(m_pipe.get()); }

    /// Why it stopped before it was done. It does not run any more.
    QString whyItStopped() {
        const int status = end();
        if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU)
            return FileApartText::tr("reading it takes too long");
        if (WIFEXITED(status) && WEXITSTATUS(status) == kNoMemory)
            return FileApartText::tr("reading it takes too much memory");
        return FileApartText::tr("the library that reads it stopped unexpectedly");
    }

private:
    static constexpr int kNoMemory = 3;

    int end() {
        // It may have ended by itself, and then tells how.
        int status = 0;
        pid_t ended = ::waitpid(m_id, &status, WNOHANG);
        for (int i = 0; ended == 0 && i < 100; ++i) {
            ::poll(nullptr, 0, i == 0 ? 0 : 1);
            ended = ::waitpid(m_id, &status, WNOHANG);
        }
        if (ended == 0) {
            ::kill(m_id, SIGKILL);
            while (::waitpid(m_id, &status, 0) < 0 && errno == EINTR) {
            }
        }
        m_id = -1;
        return status;
    }

    core::FileDescriptor m_pipe{-1};
    pid_t m_id = -1;
};

class FileApart : public ArrayFile {
public:
    FileApart(const std::string& path, OpenArrays opener)
        : ArrayFile(path)
        , m_open(opener) {}

    core::Expected<void> open() {
        Process process;
        const bool isStarted = process.start(0, [this](const PipeWriter& to) {
            const auto file = m_open(m_path);
            if (file)
                to.heads((*file)->arrays());
            else
                to.error(file.error());
        });
        if (!isStarted)
            return noProcess();
        const PipeReader from = process.reader();
        Message message{};
        if (from.number(message)) {
            if (message == Message::heads && from.heads(m_arrays))
                return {};
            if (core::Error error; message == Message::error && from.error(error))
                return core::Unexpected(std::move(error));
        }
        return stopped(process);
    }

    core::Expected<void> read(std::size_t array, const Take& take) override {
        const std::uint64_t count = valuesOf(m_arrays[array].shape).value_or(0);
        Process process;
        const bool isStarted = process.start(count, [&](const PipeWriter& to) {
            const auto file = m_open(m_path);
            if (!file)
                return to.error(file.error());
            if (array >= (*file)->arrays().size() || (*file)->arrays()[array].shape != m_arrays[array].shape)
                return to.error({core::ErrorKind::badInput,
                                 FileApartText::tr("the file changed while it was read").toStdString(),
                                 {},
                                 {m_path}});
            const auto done = (*file)->read(array, [&](std::span<const double> values) {
                to.values(values);
                return true;
            });
            if (done)
                to.number(Message::done);
            else
                to.error(done.error());
        });
        if (!isStarted)
            return noProcess();
        const PipeReader from = process.reader();
        std::vector<double> values;
        for (Message message{}; from.number(message);) {
            if (message == Message::done)
                return {};
            if (message == Message::error) {
                core::Error error;
                if (!from.error(error))
                    break;
                return core::Unexpected(std::move(error));
            }
            std::uint32_t size = 0;
            if (message != Message::values || !from.number(size) || size > kMessageValues)
                break;
            values.resize(size);
            if (!from.bytes(values.data(), size * sizeof(double)))
                break;
            if (!take(values))
                return core::Unexpected(core::Error{core::ErrorKind::cancelled, {}, {}, {}});
        }
        return stopped(process);
    }

private:
    core::Unexpected noProcess() const {
        return core::failed(core::ErrorKind::ioFailed,
                            FileApartText::tr("no process can be started to read the file: %1")
                                .arg(QString::fromLocal8Bit(std::strerror(errno))),
                            {}, {m_path});
    }
    core::Unexpected stopped(Process& process) const {
        return core::failed(core::ErrorKind::badInput,
                            FileApartText::tr("the file is damaged: %1").arg(process.whyItStopped()),
                            FileApartText::tr("a whole file"), {m_path});
    }

    OpenArrays m_open;
};

} // namespace

core::Expected<std::unique_ptr<ArrayFile>> openApart(const std::string& path, OpenArrays open) {
    auto file = std::make_unique<FileApart>(path, open);
    TELETA_CHECK(file->open());
    return file;
}

} // namespace teleta::frames
