// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QObject>
#include <QPalette>
#include <QSize>
#include <QStringList>
#include <QThreadPool>

#include <cstdint>
#include <stop_token>

namespace teleta::console {

/// Pictures for the start page (startPicture()): made one after the other on a thread of their own, for a
/// scene by running it, and kept in a folder, so that a scene is run once for each of its versions and for
/// each theme. A picture that cannot be made or kept is left out: the page then shows an icon. Thread: GUI;
/// nothing waits for a whole scene.
class StartPictures : public QObject {
    Q_OBJECT

public:
    /// folder: of the pictures, made when it is needed; empty: none are kept.
    explicit StartPictures(QString folder, QObject* parent = nullptr);
    /// Stops the scene that is run.
    ~StartPictures() override;

    /// Asks for pictures, in this order; forgets what was asked before.
    void request(const QStringList& paths, const QSize& size, const QPalette& palette);
    /// Makes no pictures until resume(), since something else needs the processor: stops the scene that is
    /// run, which is then run again.
    void pause();
    void resume();

signals:
    void made(const QString& path, const QImage& picture);

private:
    void next();

    QString m_folder;
    QThreadPool m_thread;
    QStringList m_waiting;
    QSize m_size;
    QPalette m_palette;
    std::stop_source m_stop; ///< of the scene that is run
    bool m_paused = false;
    bool m_working = false;
    std::uint64_t m_request = 0;
};

} // namespace teleta::console
