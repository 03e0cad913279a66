// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/study/running/study_store_thread.h"

namespace teleta::console {

StudyStoreThread::StudyStoreThread(QObject* parent)
    : QObject(parent)
    , m_worker(new QObject)
    , m_store(std::make_shared<Store>())
    , m_context(new QObject, [](QObject* object) { object->deleteLater(); }) {
    m_worker->moveToThread(&m_thread);
    connect(&m_thread, &QThread::finished, m_worker, &QObject::deleteLater);
    m_thread.setObjectName(QStringLiteral("study"));
    m_thread.start();
}

void StudyStoreThread::waitForAll() {
    QMetaObject::invokeMethod(
        m_worker, [] {}, Qt::BlockingQueuedConnection);
}

StudyStoreThread::~StudyStoreThread() {
    // The connection belongs to its thread; earlier requests are done first.
    QMetaObject::invokeMethod(
        m_worker, [store = m_store] { store->reset(); }, Qt::BlockingQueuedConnection);
    m_thread.quit();
    m_thread.wait();
}

} // namespace teleta::console
