// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/bracelet/bracelet_service.h"
#include "app/console/sources/source_manager.h"
#include "devices/foxglove/live_view.h"

#include <QObject>
#include <QString>

#include <future>
#include <memory>

class QAction;
class QMenu;

namespace teleta::console {

/// Shows all open sources and the bracelet to Foxglove while it is switched on. Sources opened later join.
/// Thread: GUI; only the destructor waits, for the last live view to end.
class LiveViewService : public QObject {
    Q_OBJECT

public:
    LiveViewService(SourceManager& sources, BraceletService& bracelet, QObject* parent = nullptr);
    ~LiveViewService() override;

    /// Where it listens from the next start on.
    void setOptions(const foxglove::LiveViewOptions& options) { m_options = options; }
    void start();
    void stop();
    [[nodiscard]] bool isRunning() const { return m_view != nullptr; }
    [[nodiscard]] foxglove::LiveViewStatus status() const;

    /// Adds the action that switches it.
    void fill(QMenu& menu);
    /// Looks how it goes; called by the GUI's timer.
    void tick();

signals:
    /// address: for Foxglove, "ws://127.0.0.1:8765".
    void listening(const QString& address);
    /// It has ended by itself. why: translated.
    void failed(const QString& why);

private:
    void watch(SourceManager::Item& item);
    void watchBracelet();
    void showState();

    SourceManager& m_sources;
    BraceletService& m_bracelet;
    foxglove::LiveViewOptions m_options;
    std::shared_ptr<foxglove::LiveView> m_view;
    std::weak_ptr<BraceletSession> m_braceletSession; ///< that is shown
    bool m_isTold = false;
    std::future<void> m_ending; ///< of the last live view
    QAction* m_action;
};

} // namespace teleta::console
