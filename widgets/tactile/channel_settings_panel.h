// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pipeline/touch/touch_snapshot.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QPushButton;
class QSpinBox;
class QTabWidget;

namespace teleta::tactile {

/// The settings by which frames of the shown array become contacts and features. Every change takes effect at
/// once, also on a paused picture; "Defaults" resets everything but the tare and the taxel gains. Thread:
/// GUI.
class ChannelSettingsPanel : public QWidget {
    Q_OBJECT

public:
    explicit ChannelSettingsPanel(QWidget* parent = nullptr);

    /// Shows the settings in use for an array of this layout. Emits nothing.
    void setSettings(const pipeline::ChannelSettings& settings, const core::TaxelLayout& layout);
    /// The settings as shown, with the tare of the last setSettings().
    [[nodiscard]] pipeline::ChannelSettings settings() const;

signals:
    void settingsChanged(const pipeline::ChannelSettings& settings);
    void tareRequested();
    void clearTareRequested();

private:
    void changed();
    void showUnits();
    void showTare();
    void retranslate();

    pipeline::ChannelSettings m_settings;
    core::TaxelLayout m_layout;
    bool m_showing = false;

    QTabWidget* m_parts;
    QFormLayout* m_loads;    ///< from raw values to loads
    QFormLayout* m_contacts; ///< what is found in them
    QPushButton* m_tare;
    QPushButton* m_clearTare;
    QLabel* m_tareState;
    QDoubleSpinBox* m_gain;
    QCheckBox* m_inverted;
    QDoubleSpinBox* m_threshold;
    QCheckBox* m_automatic;
    QDoubleSpinBox* m_noiseHeight;
    QSpinBox* m_minimumTaxels;
    QComboBox* m_orientation;
    QComboBox* m_range;
    QDoubleSpinBox* m_edgeRatio;
    QDoubleSpinBox* m_pointRatio;
    QPushButton* m_defaults;
};

} // namespace teleta::tactile
