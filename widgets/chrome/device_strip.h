// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/device.h"
#include "widgets/base/controls/badge.h"
#include "widgets/base/numbers/number_format.h"

#include <QString>
#include <QWidget>

#include <cstdint>
#include <optional>
#include <vector>

namespace teleta::chrome {

/// State of one device for the status bar.
struct DeviceReading {
    QString name;
    base::Provenance provenance = base::Provenance::live;
    core::DeviceState state = core::DeviceState::closed; ///< as observed now, including stale
    double age_s = 0.0;                                  ///< of the newest data
    double rate_Hz = 0.0;                                ///< achieved
    std::uint64_t lost = 0;
    bool countsLosses = true; ///< false: the sensor cannot tell how many frames it lost
    std::uint64_t displayed = 0;
    std::optional<double> latency_s;     ///< from sensor read to screen
    std::optional<double> touchToSkin_s; ///< of a bracelet: from the last touch to its pattern
    QString remark;                      ///< short, after the losses
    QString details;                     ///< why it is lost; shown in the tool tip
    bool active = false;                 ///< the views show its data
};

/// The devices in the status bar: symbol, name, state, rate and losses of each. When space is short the texts
/// are reduced step by step: first without latencies, then with a short word for what is not live, then
/// without devices' normal states, then long names are cut in the middle, then the rates go, finally the
/// longest are cut shorter still; the tool tip and assistive tools always
/// have the full text. A click asks for the device's views. Numbers change only by visible steps. Thread:
/// GUI.
class DeviceStrip : public QWidget {
    Q_OBJECT

public:
    explicit DeviceStrip(QWidget* parent = nullptr);

    void setReadings(const std::vector<DeviceReading>& readings);

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;
    /// Full text for one device.
    [[nodiscard]] QString text(int index) const;
    /// The part of it that fits.
    [[nodiscard]] QString shownText(int index) const;

signals:
    void deviceActivated(int index);

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    bool event(QEvent* event) override;

private:
    /// Of the full text.
    enum class Detail { all, withoutLatencies, shortWords, nameAndRate, cutNames, troubles, cutShort };
    struct Cell {
        DeviceReading reading;
        base::SteadyNumber rate{1.0};
        base::SteadyNumber latency_ms{0.1};
        base::SteadyNumber touchToSkin_ms{0.1};
        QString text;
        QString shown;
        QString word; ///< that its data are not live, as shown
        QRect rect;
    };
    [[nodiscard]] QString compose(const Cell& cell, Detail detail, const QString& name) const;
    /// What else is told of the device, after as much of its name as fits.
    [[nodiscard]] QString cutShort(const Cell& cell, Detail detail, double room_px) const;
    /// Whether so little room would leave less of a name than tells it from others.
    [[nodiscard]] bool cutsTooMuch(const Cell& cell, double room_px) const;
    [[nodiscard]] QFont smallFont() const;
    /// Width of a cell without its text.
    [[nodiscard]] double besideText(const Cell& cell) const;
    /// Sets the level of detail of every cell; returns the total width.
    int place(Detail detail);
    void arrange();
    [[nodiscard]] int cellAt(const QPoint& point) const;
    [[nodiscard]] QString toolTipText(const Cell& cell) const;

    std::vector<Cell> m_cells;
    int m_wanted_px = 0; ///< width of the full texts
};

} // namespace teleta::chrome
