// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>
#include <QThreadPool>

#include <utility>

namespace teleta::console {

/// Runs work on a pool thread and hands its result to done on the receiver's thread; when the receiver is
/// gone by then, the result is dropped. For files that the GUI asks for: its own thread never reads one.
template <typename Work, typename Done>
void runInBackground(QObject* receiver, Work work, Done done) {
    QThreadPool::globalInstance()->start([guard = QPointer<QObject>(receiver), context = receiver->thread(),
                                          work = std::move(work), done = std::move(done)]() mutable {
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

} // namespace teleta::console
