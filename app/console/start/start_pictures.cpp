// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/start/start_pictures.h"

#include "app/console/start/file_picture.h"
#include "widgets/base/background.h"
#include "widgets/base/theme.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDir>
#include <QSaveFile>

#include <utility>

namespace teleta::console {

namespace {

/// Counts changes of how pictures are made, between two versions of the program.
constexpr int kVersion = 2;

/// Name of a picture: of what it is made of and of how it is drawn.
QString nameOf(const QByteArray& key, const QSize& size, bool dark) {
    QCryptographicHash hash(QCryptographicHash::Sha1);
    hash.addData(key);
    // The program may simulate or draw differently in another version.
    hash.addData(QCoreApplication::applicationVersion().toUtf8() + 'v' + QByteArray::number(kVersion) + 'x' +
                 QByteArray::number(size.width()) + 'x' + QByteArray::number(size.height()) +
                 (dark ? 'd' : 'l'));
    return QString::fromLatin1(hash.result().toHex()) + QStringLiteral(".png");
}

struct Made {
    QImage picture; ///< null when none can be made
    bool stopped = false;
};

Made keptOrMade(const QString& path, const QString& folder, const QSize& size, const QPalette& palette,
                const std::stop_token& stop) {
    if (stop.stop_requested())
        return {.picture = {}, .stopped = true};
    const QString kept =
        folder.isEmpty() ? QString()
                         : QDir(folder).filePath(nameOf(startPictureKey(path), size, base::isDark(palette)));
    if (QImage picture(kept); !kept.isEmpty() && !picture.isNull())
        return {picture};
    const auto picture = startPicture(path, size, palette, stop);
    if (!picture)
        return {.picture = {}, .stopped = picture.error().kind == core::ErrorKind::cancelled};
    if (!kept.isEmpty() && QDir().mkpath(folder)) {
        QSaveFile saved(kept);
        if (saved.open(QIODevice::WriteOnly) && picture->save(&saved, "PNG"))
            saved.commit();
    }
    return {*picture};
}

} // namespace

StartPictures::StartPictures(QString folder, QObject* parent)
    : QObject(parent)
    , m_folder(std::move(folder)) {
    m_thread.setMaxThreadCount(1);
    // The others are of no effect among ordinary threads of Linux.
    m_thread.setThreadPriority(QThread::IdlePriority);
}

StartPictures::~StartPictures() {
    m_stop.request_stop();
    m_thread.waitForDone();
}

void StartPictures::request(const QStringList& paths, const QSize& size, const QPalette& palette) {
    ++m_request;
    m_waiting = paths;
    m_size = size;
    m_palette = palette;
    next();
}

void StartPictures::pause() {
    m_paused = true;
    m_stop.request_stop();
}

void StartPictures::resume() {
    m_paused = false;
    next();
}

void StartPictures::next() {
    if (m_paused || m_working || m_waiting.isEmpty() || m_size.isEmpty())
        return;
    m_working = true;
    m_stop = std::stop_source();
    const QString path = m_waiting.takeFirst();
    base::runInBackground(
        m_thread, this,
        [path, folder = m_folder, size = m_size, palette = m_palette, stop = m_stop.get_token()] {
            return keptOrMade(path, folder, size, palette, stop);
        },
        [this, path, request = m_request](const Made& result) {
            m_working = false;
            if (request == m_request && result.stopped)
                m_waiting.prepend(path);
            else if (request == m_request && !result.picture.isNull())
                emit made(path, result.picture);
            next();
        });
}

} // namespace teleta::console
