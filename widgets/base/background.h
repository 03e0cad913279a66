// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>
#include <QThreadPool>

#include <utility>

namespace teleta::base {

/// The pool for work without a pool of its own. It is not Qt's global pool: Qt's painter fills large areas
/// there and waits for them, so long computations would stop windows from being painted. Thread: any.
[[nodiscard]] QThreadPool& backgroundPool();

/// Runs work on a thread of a pool and passes its result to done on the receiver's thread; drops the result
/// if the receiver is gone by then. A pool with one thread keeps the order.
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
