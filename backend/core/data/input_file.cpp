// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/data/input_file.h"

#include "backend/core/failure.h"

#include <QCoreApplication>
#include <QFile>

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>

namespace teleta::core {

namespace {

struct InputFileText {
    Q_DECLARE_TR_FUNCTIONS(InputFileText)
};

Unexpected cannotOpen(const std::string& path, int code) {
    return failed(code == ENOENT || code == ENOTDIR ? ErrorKind::notFound : ErrorKind::ioFailed,
                  InputFileText::tr("cannot open the file: %1").arg(qt_error_string(code)), {}, {path});
}

Expected<void> requireRegular(const struct stat& status, const std::string& path) {
    const QString expected = InputFileText::tr("a file");
    if (S_ISDIR(status.st_mode))
        return failed(ErrorKind::badInput, InputFileText::tr("this is a folder"), expected, {path});
    if (!S_ISREG(status.st_mode))
        return failed(ErrorKind::badInput, InputFileText::tr("this is a pipe or a device"), expected, {path});
    return {};
}

/// Opens the file for reading unless it is something else.
Expected<void> openFile(QFile& file, const std::string& path) {
    if (path.starts_with(":/")) {
        if (!file.open(QIODevice::ReadOnly))
            return failed(ErrorKind::notFound, file.errorString(), {}, {path});
        return {};
    }
    // A pipe that nobody writes to is opened at once this way, and a device is not set in motion.
    const int descriptor =
        ::open(QFile::encodeName(file.fileName()).constData(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
    if (descriptor < 0)
        return cannotOpen(path, errno);
    if (!file.open(descriptor, QIODevice::ReadOnly, QFileDevice::AutoCloseHandle))
        return failed(ErrorKind::ioFailed, file.errorString(), {}, {path});
    struct stat status = {};
    if (::fstat(descriptor, &status) != 0)
        return cannotOpen(path, errno);
    return requireRegular(status, path);
}

} // namespace

Expected<void> requireFile(const std::string& path) {
    struct stat status = {};
    if (::stat(path.c_str(), &status) != 0)
        return cannotOpen(path, errno);
    return requireRegular(status, path);
}

Expected<std::string> readFile(const std::string& path, std::size_t most) {
    QFile file(QString::fromStdString(path));
    TELETA_CHECK(openFile(file, path));
    // The size is not trusted: files grow, and those of /proc say 0.
    std::string text;
    text.reserve(std::min<std::size_t>(most, static_cast<std::size_t>(std::max<qint64>(0, file.size()))));
    char chunk[64U << 10U];
    for (;;) {
        const qint64 count = file.read(chunk, sizeof chunk);
        if (count < 0)
            return failed(ErrorKind::ioFailed,
                          InputFileText::tr("cannot read the file: %1").arg(file.errorString()), {}, {path});
        if (count == 0)
            return text;
        if (text.size() + static_cast<std::size_t>(count) > most)
            return failed(ErrorKind::badInput, InputFileText::tr("the file is too large"),
                          InputFileText::tr("at most %1 MiB").arg(most >> 20U), {path});
        text.append(chunk, static_cast<std::size_t>(count));
    }
}

} // namespace teleta::core
