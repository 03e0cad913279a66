// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/data/output_file.h"

#include "backend/core/failure.h"
#include "backend/core/file_descriptor.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSaveFile>

#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <filesystem>
#include <unistd.h>
#include <utility>
#include <vector>

namespace teleta::core {

namespace {

struct OutputFileText {
    Q_DECLARE_TR_FUNCTIONS(OutputFileText)
};

Error writeError(const QFileDevice& device, const std::string& name) {
    const bool readerIsGone = device.errorString() == qt_error_string(EPIPE);
    return {readerIsGone ? ErrorKind::cancelled : ErrorKind::ioFailed,
            OutputFileText::tr("cannot write: %1").arg(device.errorString()).toStdString(),
            {},
            {name}};
}

} // namespace

OutputFile::OutputFile(std::unique_ptr<QFileDevice> device, std::string name)
    : m_device(std::move(device))
    , m_name(std::move(name)) {
}

OutputFile::~OutputFile() = default;
OutputFile::OutputFile(OutputFile&&) noexcept = default;
OutputFile& OutputFile::operator=(OutputFile&&) noexcept = default;

Expected<OutputFile> OutputFile::create(const std::string& path) {
    // Redirected to a file it must not be replaced by another one.
    if (path == "/dev/stdout")
        return standardOutput();
    std::error_code ignored;
    const std::filesystem::file_status status = std::filesystem::status(path, ignored);
    const QString name = QString::fromStdString(path);
    std::unique_ptr<QFileDevice> device;
    // Renaming a file over a device or a pipe would replace it.
    if (std::filesystem::is_other(status))
        device = std::make_unique<QFile>(name);
    else
        device = std::make_unique<QSaveFile>(name);
    if (!device->open(QIODevice::WriteOnly | QIODevice::Unbuffered))
        return Unexpected(writeError(*device, path));
    return OutputFile(std::move(device), path);
}

OutputFile OutputFile::standardOutput() {
    auto device = std::make_unique<QFile>();
    const bool opened = device->open(STDOUT_FILENO, QIODevice::WriteOnly | QIODevice::Unbuffered);
    OutputFile output(std::move(device), OutputFileText::tr("standard output").toStdString());
    if (!opened)
        output.keepError();
    return output;
}

void OutputFile::keepError() {
    m_state = Unexpected(writeError(*m_device, m_name));
    if (auto* file = qobject_cast<QSaveFile*>(m_device.get()))
        file->cancelWriting();
}

void OutputFile::flush() {
    // A device that takes a part tells why only when the rest is written.
    const char* rest = m_buffer.data();
    auto left = static_cast<qint64>(m_buffer.size());
    while (m_state && left > 0) {
        const qint64 taken = m_device->write(rest, left);
        if (taken > 0) {
            rest += taken;
            left -= taken;
        } else {
            keepError();
        }
    }
    m_buffer.clear();
}

Expected<void> OutputFile::finish() {
    flush();
    if (m_state) {
        auto* file = qobject_cast<QSaveFile*>(m_device.get());
        if (file != nullptr && !file->commit())
            keepError();
        else if (file != nullptr)
            m_state = syncFolder(QFileInfo(file->fileName()).absolutePath().toStdString());
    }
    return m_state;
}

Expected<void> syncFolder(const std::string& path) {
    const FileDescriptor folder(open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    // A folder that may only be entered, and file systems that keep names in their own way.
    if (!folder.isOpen() || fsync(folder.get()) == 0 || errno == EINVAL || errno == ENOTSUP)
        return {};
    return failed(ErrorKind::ioFailed, OutputFileText::tr("cannot write: %1").arg(qt_error_string(errno)), {},
                  {path});
}

Expected<void> writeFile(const std::string& path, std::string_view content) {
    TELETA_TRY(OutputFile file, OutputFile::create(path));
    file.write(content);
    return file.finish();
}

Expected<void> makeFolder(const std::string& path) {
    // Each folder that is new has its name in the one above it.
    std::vector<std::string> above;
    QDir folder(QDir::cleanPath(QDir(QString::fromStdString(path)).absolutePath()));
    while (!folder.exists() && !folder.isRoot()) {
        folder.setPath(QFileInfo(folder.path()).path());
        above.push_back(folder.path().toStdString());
    }
    if (!QDir().mkpath(QString::fromStdString(path)))
        return failed(ErrorKind::ioFailed, OutputFileText::tr("cannot make the folder"), {}, {path});
    for (const std::string& one : above)
        TELETA_CHECK(syncFolder(one));
    return {};
}

} // namespace teleta::core
