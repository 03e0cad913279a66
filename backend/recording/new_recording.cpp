// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/recording/new_recording.h"

#include "backend/core/failure.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>
#include <QString>

namespace teleta::recording {

namespace {

struct NewRecordingText {
    Q_DECLARE_TR_FUNCTIONS(NewRecordingText)
};

constexpr char kPart[] = ".part";

void removeRecording(const std::string& path) {
    for (const char* suffix : {"", "-wal", "-shm"})
        QFile::remove(QString::fromStdString(path + suffix));
}

} // namespace

core::Expected<void> makeRecording(const std::string& path,
                                   const std::function<core::Expected<void>(const std::string&)>& write) {
    const QString wanted = QString::fromStdString(path);
    if (QFileInfo::exists(wanted))
        return core::failed(core::ErrorKind::refused,
                            NewRecordingText::tr("a file of this name already exists"),
                            NewRecordingText::tr("another name"), {path});
    // What somebody who was killed has left.
    const std::string part = path + kPart;
    removeRecording(part);
    core::Expected<void> done = write(part);
    if (done && !QFile::rename(QString::fromStdString(part), wanted))
        done = core::failed(core::ErrorKind::ioFailed,
                            NewRecordingText::tr("the file cannot be given its name"), {}, {path});
    if (!done)
        removeRecording(part);
    return done;
}

} // namespace teleta::recording
