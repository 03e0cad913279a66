// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/start/start_pictures.h"

#include "app/common/scene_file.h"
#include "app/console/start/scene_picture.h"
#include "widgets/base/background.h"
#include "widgets/base/theme.h"

#include <QCryptographicHash>
#include <QDir>
#include <QSaveFile>

#include <utility>

namespace teleta::console {

namespace {

/// Of the way in which pictures are made: kept ones of another version are not used.
constexpr int kVersion = 1;

/// Name of a scene's picture: of its text and of how it is drawn.
QString nameOf(const std::string& text, const QSize& size, bool dark) {
    QCryptographicHash hash(QCryptographicHash::Sha1);
    hash.addData(QByteArray::fromStdString(text));
    hash.addData(QByteArray::number(kVersion) + 'x' + QByteArray::number(size.width()) + 'x' +
                 QByteArray::number(size.height()) + (dark ? 'd' : 'l'));
    return QString::fromLatin1(hash.result().toHex()) + QStringLiteral(".png");
}

/// Null when the scene cannot be read or run.
QImage keptOrMade(const QString& path, const QString& folder, const QSize& size, const QPalette& palette) {
    const std::string file = path.toStdString();
    const QString kept =
        folder.isEmpty()
            ? QString()
            : QDir(folder).filePath(nameOf(app::readSceneText(file), size, base::isDark(palette)));
    if (QImage picture(kept); !kept.isEmpty() && !picture.isNull())
        return picture;
    const auto scene = app::readScene(file);
    if (!scene)
        return {};
    const auto picture = scenePicture(*scene, size, palette);
    if (!picture)
        return {};
    if (!kept.isEmpty() && QDir().mkpath(folder)) {
        QSaveFile saved(kept);
        if (saved.open(QIODevice::WriteOnly) && picture->save(&saved, "PNG"))
            saved.commit();
    }
    return *picture;
}

} // namespace

StartPictures::StartPictures(QString folder, QObject* parent)
    : QObject(parent)
    , m_folder(std::move(folder)) {
    m_thread.setMaxThreadCount(1);
    m_thread.setThreadPriority(QThread::LowestPriority);
}

StartPictures::~StartPictures() {
    m_thread.clear();
    m_thread.waitForDone();
}

void StartPictures::request(const QStringList& paths, const QSize& size, const QPalette& palette) {
    ++m_request;
    m_waiting = paths;
    m_size = size;
    m_palette = palette;
    next();
}

void StartPictures::resume() {
    m_paused = false;
    next();
}

void StartPictures::next() {
    if (m_paused || m_working || m_waiting.isEmpty() || m_size.isEmpty())
        return;
    m_working = true;
    const QString path = m_waiting.takeFirst();
    base::runInBackground(
        m_thread, this,
        [path, folder = m_folder, size = m_size, palette = m_palette] {
            return keptOrMade(path, folder, size, palette);
        },
        [this, path, request = m_request](const QImage& picture) {
            m_working = false;
            if (request == m_request && !picture.isNull())
                emit made(path, picture);
            next();
        });
}

} // namespace teleta::console
