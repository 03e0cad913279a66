// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>
#include <QThreadPool>

#include <utility>

namespace teleta::base {

/// Where work runs that nobody has a pool of its own for. Not the pool of Qt: its painter fills large areas
/// there and waits for that, so that a window whose pool is full of long computations is not painted.
/// Thread: any.
[[nodiscard]] QThreadPool& backgroundPool();

/// Runs work on a thread of a pool and hands its result to done on the receiver's thread; when the receiver
/// is gone by then, the result is dropped. For files and long computations that the GUI asks for: its own
/// thread never waits for one. A pool of one thread keeps the order.
template <typename Work, typename Done>
void runInBackground(QThreadPool& pool, QObject* receiver, Work work, Done done) {
    pool.start([guard = QPointer<QObject>(receiver), context = receiver->thread(), work = std::move(work),
                done = std::move(done)]() mutable {
        auto result = work();
        auto* messenger = new QObject;
        messenger->moveToThread(context);
        QMetaObject::invokeMethod(
            messenger,
            [guard, messenger, result = std::move(result), done = std::move(done)]() mutable {
                if (guard)
                    done(std::move(result));
                messenger->deleteLater();
            },
            Qt::QueuedConnection);
    });
}

/// The same on backgroundPool(), in any order.
template <typename Work, typename Done>
void runInBackground(QObject* receiver, Work work, Done done) {
    runInBackground(backgroundPool(), receiver, std::move(work), std::move(done));
}

} // namespace teleta::base
