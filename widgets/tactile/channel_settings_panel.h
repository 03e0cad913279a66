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

namespace teleta::tactile {

/// How the frames of the shown array are turned into contacts and features. Every change takes effect at
/// once, on a paused picture too; "Defaults" takes all back but the tare and the gains of the
/// taxels. Thread: GUI.
class ChannelSettingsPanel : public QWidget {
    Q_OBJECT

public:
    explicit ChannelSettingsPanel(QWidget* parent = nullptr);

    /// Shows the settings in use. Emits nothing.
    void setSettings(const pipeline::ChannelSettings& settings);
    /// The settings as shown, with the tare of the last setSettings().
    [[nodiscard]] pipeline::ChannelSettings settings() const;

signals:
    void settingsChanged(const pipeline::ChannelSettings& settings);
    void tareRequested();
    void clearTareRequested();

protected:
    void changeEvent(QEvent* event) override;

private:
    void changed();
    void showUnits();
    void showTare();
    void retranslate();
    QLabel* addRow(QFormLayout* form, QWidget* field);

    pipeline::ChannelSettings m_settings;
    bool m_showing = false;

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
    QLabel* m_gainLabel;
    QLabel* m_thresholdLabel;
    QLabel* m_noiseLabel;
    QLabel* m_minimumLabel;
    QLabel* m_orientationLabel;
    QLabel* m_rangeLabel;
    QLabel* m_edgeLabel;
    QLabel* m_pointLabel;
};

} // namespace teleta::tactile
