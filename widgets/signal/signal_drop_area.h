// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/signal/signal_name.h"

#include <QWidget>

#include <vector>

namespace teleta::signal {

/// A place onto which signals can be dropped, whatever it shows. It has a frame while they are over it.
/// Thread: GUI.
class SignalDropArea : public QWidget {
    Q_OBJECT

public:
    explicit SignalDropArea(QWidget* parent = nullptr);

signals:
    void dropped(const std::vector<signal::SignalId>& signalIds);

protected:
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dragLeaveEvent(QDragLeaveEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void setTarget(bool isTarget);

    bool m_isTarget = false;
};

} // namespace teleta::signal
