// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/motors/wearer_limits.h"

#include <QObject>
#include <QThreadPool>
#include <QTimer>

namespace teleta::console {

/// Keeps how strong a wearer wants a bracelet in the file of that bracelet, on another thread and not at each
/// step of a slider. Thread: GUI; no call waits but the destructor, for the file.
class LimitsKeeper : public QObject {
    Q_OBJECT

public:
    explicit LimitsKeeper(QObject* parent = nullptr);
    ~LimitsKeeper() override;

    /// In place of what was to be kept before.
    void keepSoon(const motors::WearerLimits& limits);
    /// What was to be kept soon is kept now.
    void flush();

signals:
    void failed(const core::Error& error);

private:
    void keep();

    motors::WearerLimits m_limits;
    QTimer m_soon;
    QThreadPool m_thread; ///< one: the last limits are the ones that stay
};

} // namespace teleta::console
