// SPDX-License-Identifier: GPL-3.0-or-later
// A library to be loaded before the C library's file functions. It counts the operations that change files
// below a folder, makes chosen ones fail, and writes down all of them, for a test that cuts the power.
//   FAULTY_ROOT   the folder; nothing else is touched
//   FAULTY_LOG    file that gets what was done, see fault_log.h; none: nothing is written down
//   FAULTY_AT     number of the operation that fails, counted from 0; none: all succeed
//   FAULTY_KIND   "eio": that one fails; "enospc": that one and all later ones that need room fail;
//                 "short": that one writes half of what it should
//   FAULTY_COUNT  file that gets the number of operations at the end
#include "tests/faults/fault_log.h"

#include <array>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <fcntl.h>
#include <mutex>
#include <string>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

namespace {

using teleta::test::FileOp;

template <typename Function>
Function libc(const char* name) {
    return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

std::string fromEnvironment(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? std::string() : std::string(value);
}

/// All that the library knows.
class Faults {
public:
    Faults() {
        const std::string log = fromEnvironment("FAULTY_LOG");
        if (!log.empty())
            m_log = libc<int (*)(const char*, int, ...)>("open")(
                log.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
        const std::string at = fromEnvironment("FAULTY_AT");
        m_at = at.empty() ? -1 : std::atoll(at.c_str());
    }
    ~Faults() {
        const std::string count = fromEnvironment("FAULTY_COUNT");
        if (count.empty())
            return;
        if (FILE* file = std::fopen(count.c_str(), "w")) {
            std::fprintf(file, "%lld\n", m_next);
            std::fclose(file);
        }
    }

    /// The path of a name; empty: it is not below the folder.
    [[nodiscard]] std::string below(const char* name) const {
        std::string path = name;
        if (!path.starts_with('/')) {
            std::array<char, 4096> folder{};
            if (getcwd(folder.data(), folder.size()) != nullptr)
                path = std::string(folder.data()) + "/" + path;
        }
        return !m_root.empty() && (path == m_root || path.starts_with(m_root + "/")) ? path : std::string();
    }

    /// The path of an open file; a file without a name has one by its number.
    [[nodiscard]] std::string below(int file) const {
        const std::string link = "/proc/self/fd/" + std::to_string(file);
        std::array<char, 4096> name{};
        const ssize_t length = readlink(link.c_str(), name.data(), name.size());
        if (length <= 0)
            return {};
        std::string path(name.data(), static_cast<std::size_t>(length));
        const std::string deleted = " (deleted)";
        if (path.ends_with(deleted))
            path.resize(path.size() - deleted.size());
        return below(path.c_str());
    }

    enum class Verdict { go, fail, half };
    /// Counts an operation. needsRoom: a full disk refuses it.
    [[nodiscard]] Verdict next(bool needsRoom) {
        const long long number = m_next++;
        if (m_at < 0)
            return Verdict::go;
        if (m_kind == "enospc" && number >= m_at && needsRoom) {
            errno = ENOSPC;
            return Verdict::fail;
        }
        if (number != m_at || m_kind == "enospc")
            return Verdict::go;
        if (m_kind == "short")
            return Verdict::half;
        errno = EIO;
        return Verdict::fail;
    }

    void note(FileOp::Kind kind, const std::string& path, const std::string& other = {}, long long offset = 0,
              const void* data = nullptr, std::size_t size = 0) {
        if (m_log < 0)
            return;
        FileOp op;
        op.kind = kind;
        op.path = path;
        op.other = other;
        op.offset = offset;
        if (data != nullptr)
            op.data.assign(static_cast<const char*>(data), size);
        const std::string bytes = teleta::test::encoded(op);
        static const auto kWrite = libc<ssize_t (*)(int, const void*, size_t)>("write");
        (void)!kWrite(m_log, bytes.data(), bytes.size());
    }

    std::recursive_mutex mutex; ///< of everything

private:
    std::string m_root = fromEnvironment("FAULTY_ROOT");
    std::string m_kind = fromEnvironment("FAULTY_KIND");
    long long m_at = -1;
    long long m_next = 0;
    int m_log = -1;
};

Faults& faults() {
    static Faults all;
    return all;
}

/// Runs an operation on a file below the folder: counted, failed if its turn has come, written down if it
/// went well. other: runs it as it is.
template <typename Result, typename Run, typename Note>
Result change(const std::string& path, bool needsRoom, const Run& run, const Note& note) {
    const std::lock_guard lock(faults().mutex);
    if (path.empty())
        return run(false);
    const Faults::Verdict verdict = faults().next(needsRoom);
    if (verdict == Faults::Verdict::fail)
        return Result(-1);
    const Result result = run(verdict == Faults::Verdict::half);
    const int error = errno;
    if (result >= 0)
        note(result);
    errno = error;
    return result;
}

int openAt(int folder, const char* name, int flags, mode_t mode) {
    static const auto kOpen = libc<int (*)(int, const char*, int, ...)>("openat");
    const std::lock_guard lock(faults().mutex);
    const std::string path = faults().below(name);
    struct stat before = {};
    const bool creates = (flags & O_CREAT) != 0 && !path.empty() && lstat(name, &before) != 0;
    const bool empties = (flags & O_TRUNC) != 0 && !path.empty();
    const bool nameless = (flags & O_TMPFILE) == O_TMPFILE && !path.empty();
    if (!creates && !empties && !nameless)
        return kOpen(folder, name, flags, mode);
    return change<int>(
        path, true, [&](bool) { return kOpen(folder, name, flags, mode); },
        [&](int file) {
            if (nameless)
                faults().note(FileOp::Kind::create, faults().below(file), "nameless");
            else if (creates)
                faults().note(FileOp::Kind::create, path);
            else
                faults().note(FileOp::Kind::truncate, path);
        });
}

ssize_t writeAt(const char* function, int file, const void* data, size_t size, long long offset) {
    const std::lock_guard lock(faults().mutex);
    const std::string path = faults().below(file);
    struct stat status = {};
    if (path.empty() || fstat(file, &status) != 0 || !S_ISREG(status.st_mode)) {
        if (offset < 0)
            return libc<ssize_t (*)(int, const void*, size_t)>("write")(file, data, size);
        return libc<ssize_t (*)(int, const void*, size_t, off64_t)>(function)(file, data, size, offset);
    }
    const bool appends = (fcntl(file, F_GETFL) & O_APPEND) != 0;
    const long long where = offset >= 0 ? offset : appends ? status.st_size : lseek64(file, 0, SEEK_CUR);
    return change<ssize_t>(
        path, true,
        [&](bool half) {
            const size_t count = half && size > 1 ? size / 2 : size;
            if (offset < 0)
                return libc<ssize_t (*)(int, const void*, size_t)>("write")(file, data, count);
            return libc<ssize_t (*)(int, const void*, size_t, off64_t)>(function)(file, data, count, offset);
        },
        [&](ssize_t count) {
            faults().note(FileOp::Kind::write, path, {}, where, data, static_cast<std::size_t>(count));
        });
}

int sync(const char* function, int file) {
    const std::string path = faults().below(file);
    return change<int>(
        path, false, [&](bool) { return libc<int (*)(int)>(function)(file); },
        [&](int) { faults().note(FileOp::Kind::sync, path); });
}

int resize(int file, long long size) {
    const std::string path = faults().below(file);
    return change<int>(
        path, true, [&](bool) { return libc<int (*)(int, off64_t)>("ftruncate64")(file, size); },
        [&](int) { faults().note(FileOp::Kind::truncate, path, {}, size); });
}

} // namespace

extern "C" {

int open(const char* name, int flags, ...) {
    va_list rest;
    va_start(rest, flags);
    const mode_t mode = (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(rest, mode_t) : 0;
    va_end(rest);
    return openAt(AT_FDCWD, name, flags, mode);
}
int open64(const char* name, int flags, ...) {
    va_list rest;
    va_start(rest, flags);
    const mode_t mode = (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(rest, mode_t) : 0;
    va_end(rest);
    return openAt(AT_FDCWD, name, flags, mode);
}
ssize_t write(int file, const void* data, size_t size) {
    return writeAt("write", file, data, size, -1);
}
ssize_t pwrite(int file, const void* data, size_t size, off_t offset) {
    return writeAt("pwrite64", file, data, size, offset);
}
ssize_t pwrite64(int file, const void* data, size_t size, off64_t offset) {
    return writeAt("pwrite64", file, data, size, offset);
}
int fsync(int file) {
    return sync("fsync", file);
}
int fdatasync(int file) {
    return sync("fdatasync", file);
}
int ftruncate(int file, off_t size) noexcept {
    return resize(file, size);
}
int ftruncate64(int file, off64_t size) noexcept {
    return resize(file, size);
}
int rename(const char* from, const char* to) noexcept {
    const std::string path = faults().below(to);
    return change<int>(
        path, true, [&](bool) { return libc<int (*)(const char*, const char*)>("rename")(from, to); },
        [&](int) { faults().note(FileOp::Kind::rename, faults().below(from), path); });
}
int renameat2(int fromFolder, const char* from, int toFolder, const char* to, unsigned int flags) noexcept {
    const std::string path = faults().below(to);
    return change<int>(
        path, true,
        [&](bool) {
            return libc<int (*)(int, const char*, int, const char*, unsigned int)>("renameat2")(
                fromFolder, from, toFolder, to, flags);
        },
        [&](int) { faults().note(FileOp::Kind::rename, faults().below(from), path); });
}
int linkat(int fromFolder, const char* from, int toFolder, const char* to, int flags) noexcept {
    const std::string path = faults().below(to);
    std::array<char, 4096> name{};
    std::string source = from;
    if (const ssize_t length = readlink(from, name.data(), name.size()); length > 0)
        source.assign(name.data(), static_cast<std::size_t>(length));
    const std::string deleted = " (deleted)";
    if (source.ends_with(deleted))
        source.resize(source.size() - deleted.size());
    return change<int>(
        path, true,
        [&](bool) {
            return libc<int (*)(int, const char*, int, const char*, int)>("linkat")(fromFolder, from,
                                                                                    toFolder, to, flags);
        },
        [&](int) { faults().note(FileOp::Kind::link, faults().below(source.c_str()), path); });
}
int unlink(const char* name) noexcept {
    const std::string path = faults().below(name);
    return change<int>(
        path, false, [&](bool) { return libc<int (*)(const char*)>("unlink")(name); },
        [&](int) { faults().note(FileOp::Kind::unlink, path); });
}
int mkdir(const char* name, mode_t mode) noexcept {
    const std::string path = faults().below(name);
    return change<int>(
        path, true, [&](bool) { return libc<int (*)(const char*, mode_t)>("mkdir")(name, mode); },
        [&](int) { faults().note(FileOp::Kind::folder, path); });
}

} // extern "C"
