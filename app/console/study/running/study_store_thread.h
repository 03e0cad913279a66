// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/store/study_store.h"

#include <QObject>
#include <QPointer>
#include <QThread>

#include <memory>
#include <optional>
#include <utility>

namespace teleta::console {

/// The thread of the open study's store, so that the GUI never waits for a disk. Requests are done in order.
/// Thread: GUI; only waitForAll() and the destructor wait, until all requests are done.
class StudyStoreThread : public QObject {
    Q_OBJECT

public:
    using Store = std::optional<study::StudyStore>;

    explicit StudyStoreThread(QObject* parent = nullptr);
    ~StudyStoreThread() override;

    /// Waits until all requests are done; their results are told later.
    void waitForAll();

    /// work(Store&) runs on the store's thread; done(result) follows on the GUI's, unless this object is
    /// gone.
    template <typename Work, typename Done>
    void ask(Work work, Done done) {
        QMetaObject::invokeMethod(
            m_worker,
            [store = m_store, guard = QPointer<StudyStoreThread>(this), context = m_context,
             work = std::move(work), done = std::move(done)]() mutable {
                auto result = std::make_shared<decltype(work(*store))>(work(*store));
                QMetaObject::invokeMethod(
                    context.get(),
                    [guard, result, done = std::move(done)]() mutable {
                        if (guard)
                            done(std::move(*result));
                    },
                    Qt::QueuedConnection);
            },
            Qt::QueuedConnection);
    }

private:
    QThread m_thread;
    QObject* m_worker;                  ///< lives on m_thread
    std::shared_ptr<Store> m_store;     ///< used on m_thread only
    std::shared_ptr<QObject> m_context; ///< on the GUI's thread; outlives pending results
};

} // namespace teleta::console
