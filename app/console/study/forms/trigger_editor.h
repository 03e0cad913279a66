// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/trigger_port.h"

#include <QWidget>

class QComboBox;
class QDoubleSpinBox;
class QLineEdit;
class QSpinBox;

namespace teleta::console {

/// Where a protocol sends its triggers, in one line. Thread: GUI.
class TriggerEditor : public QWidget {
    Q_OBJECT

public:
    explicit TriggerEditor(const core::TriggerSettings& settings, QWidget* parent = nullptr);

    [[nodiscard]] core::TriggerSettings settings() const;

signals:
    void changed();

private:
    void showFields();

    core::TriggerSettings m_settings; ///< of the kinds that are not chosen
    QComboBox* m_kind;
    QLineEdit* m_device;
    QDoubleSpinBox* m_pulse_ms;
    QLineEdit* m_host;
    QSpinBox* m_port;
};

} // namespace teleta::console
