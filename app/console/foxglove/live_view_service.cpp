// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/foxglove/live_view_service.h"

#include "app/console/bracelet/bracelet_session.h"
#include "backend/pipeline/recorded/recorded_streams.h"

#include <QAction>
#include <QMenu>

#include <string>
#include <utility>

namespace teleta::console {

LiveViewService::LiveViewService(SourceManager& sources, BraceletService& bracelet, QObject* parent)
    : QObject(parent)
    , m_sources(sources)
    , m_bracelet(bracelet)
    , m_action(new QAction(this)) {
    m_action->setCheckable(true);
    connect(m_action, &QAction::triggered, this, [this](bool on) {
        if (on)
            start();
        else
            stop();
    });
    connect(&m_sources, &SourceManager::opened, this, [this](pipeline::ChannelKey key) {
        SourceManager::Item* item = m_sources.find(key);
        if (isRunning() && item != nullptr)
            watch(*item);
    });
}

LiveViewService::~LiveViewService() {
    stop();
    if (m_ending.valid())
        m_ending.wait();
}

void LiveViewService::start() {
    if (isRunning())
        return;
    m_isTold = false;
    m_view = std::make_shared<foxglove::LiveView>(m_options);
    for (SourceManager::Item& item : m_sources.items())
        watch(item);
    watchBracelet();
    showState();
}

void LiveViewService::stop() {
    if (!isRunning())
        return;
    for (SourceManager::Item& item : m_sources.items()) {
        if (item.channel)
            item.channel->watch(pipeline::Watcher::liveView, nullptr, {});
    }
    if (const auto session = m_braceletSession.lock())
        session->watch(nullptr);
    m_braceletSession.reset();
    // Its thread may be about to send a picture.
    m_ending =
        std::async(std::launch::async, [view = std::exchange(m_view, nullptr)]() mutable { view.reset(); });
    showState();
}

foxglove::LiveViewStatus LiveViewService::status() const {
    return m_view ? m_view->status() : foxglove::LiveViewStatus();
}

void LiveViewService::watch(SourceManager::Item& item) {
    if (item.channel)
        item.channel->watch(pipeline::Watcher::liveView, m_view, item.name.toStdString());
}

void LiveViewService::watchBracelet() {
    const std::shared_ptr<BraceletSession>& session = m_bracelet.session();
    if (session == m_braceletSession.lock())
        return;
    m_braceletSession = session;
    if (session)
        session->watch(m_view->addStream(pipeline::tactorStream("bracelet", session->source().description(),
                                                                session->player().rate_Hz())));
}

void LiveViewService::fill(QMenu& menu) {
    showState();
    menu.addAction(m_action);
}

void LiveViewService::tick() {
    if (!isRunning())
        return;
    const foxglove::LiveViewStatus now = status();
    if (now.state == foxglove::LiveViewStatus::State::failed) {
        stop();
        emit failed(QString::fromStdString(now.error));
        return;
    }
    watchBracelet();
    if (now.state == foxglove::LiveViewStatus::State::listening && !std::exchange(m_isTold, true))
        emit listening(
            QStringLiteral("ws://%1:%2").arg(QString::fromStdString(m_options.address)).arg(now.port));
    showState();
}

void LiveViewService::showState() {
    m_action->setChecked(isRunning());
    const foxglove::LiveViewStatus now = status();
    QString text = tr("Li&ve view for Foxglove");
    if (now.clients > 0)
        text += QStringLiteral(" \u2013 ") + tr("%n viewer(s)", nullptr, static_cast<int>(now.clients));
    if (now.dropped > 0)
        text += QStringLiteral(", ") + tr("%n message(s) missed", nullptr, static_cast<int>(now.dropped));
    if (m_action->text() != text)
        m_action->setText(text);
}

} // namespace teleta::console
