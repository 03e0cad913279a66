// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/store/file_claim.h"

#include <QDir>
#include <QString>

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace teleta::study {

namespace {

/// An open file description lock: closing another descriptor of the file in this program does not release it.
struct flock wholeFile() {
    struct flock lock = {};
    lock.l_type = F_WRLCK;
    lock.l_whence = SEEK_SET;
    return lock;
}

/// The last holder may have removed the file between open and lock; then nobody else can find the locked
/// file.
bool isStillThere(int descriptor, const std::string& path) {
    struct stat opened = {};
    struct stat named = {};
    return fstat(descriptor, &opened) == 0 && stat(path.c_str(), &named) == 0 &&
           opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

} // namespace

core::Expected<std::unique_ptr<FileClaim>> FileClaim::take(const std::string& path,
                                                           const std::string& holder) {
    int descriptor = -1;
    do {
        if (descriptor >= 0)
            ::close(descriptor);
        descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
        struct flock lock = wholeFile();
        if (descriptor < 0 || fcntl(descriptor, F_OFD_SETLK, &lock) != 0) {
            const int reason = errno;
            if (descriptor >= 0)
                ::close(descriptor);
            if (descriptor >= 0 && (reason == EAGAIN || reason == EACCES))
                return std::unique_ptr<FileClaim>();
            return core::Unexpected(
                core::Error{core::ErrorKind::ioFailed, std::strerror(reason), {}, {path}});
        }
    } while (!isStillThere(descriptor, path));
    std::unique_ptr<FileClaim> claim(new FileClaim(descriptor, path));
    const auto length = static_cast<ssize_t>(holder.size());
    // Only the lock matters, not the name: a full disk is no reason to fail.
    if (ftruncate(descriptor, 0) == 0 && pwrite(descriptor, holder.data(), holder.size(), 0) != length)
        (void)!ftruncate(descriptor, 0);
    return claim;
}

std::optional<std::string> FileClaim::holderOf(const std::string& path) {
    const int descriptor = ::open(path.c_str(), O_RDWR | O_CLOEXEC);
    if (descriptor < 0)
        return std::nullopt;
    std::optional<std::string> holder;
    struct flock lock = wholeFile();
    if (fcntl(descriptor, F_OFD_GETLK, &lock) == 0 && lock.l_type != F_UNLCK) {
        char text[256];
        const ssize_t length = pread(descriptor, text, sizeof text, 0);
        holder = std::string(text, static_cast<std::size_t>(length > 0 ? length : 0));
    }
    ::close(descriptor);
    return holder;
}

void FileClaim::removeUnheld(const std::string& folder, const char* namePattern) {
    const QDir dir(QString::fromStdString(folder));
    for (const QString& name : dir.entryList({QString::fromLatin1(namePattern)}, QDir::Files))
        (void)take(dir.filePath(name).toStdString(), {});
}

FileClaim::~FileClaim() {
    // While still locked, so that nobody else can hold it.
    ::unlink(m_path.c_str());
    ::close(m_descriptor);
}

} // namespace teleta::study
