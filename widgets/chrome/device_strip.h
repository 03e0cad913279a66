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

/// What the status bar says of one device.
struct DeviceReading {
    QString name;
    base::Provenance provenance = base::Provenance::live;
    core::DeviceState state = core::DeviceState::closed; ///< as observed now, stale included
    double age_s = 0.0;                                  ///< of the newest data
    double rate_Hz = 0.0;                                ///< achieved
    std::uint64_t lost = 0;
    std::uint64_t displayed = 0;
    std::optional<double> latency_s;     ///< from the read of a frame to its picture
    std::optional<double> touchToSkin_s; ///< of a bracelet: from the touch that was felt last to its pattern
    QString details;                     ///< why it is lost; shown in the tool tip
    bool active = false;                 ///< its data are what the views show
};

/// The devices in the status bar: glyph, name, word, rate and losses of each. Where there is little room for
/// them all, each says less: first without latencies, then without what is as it should be, at last the
/// longest with their names cut short; the tool tip and assistive tools always have all of it. A click asks
/// for the device's views. Thread: GUI. Numbers change only by what can be seen, so nothing flickers.
class DeviceStrip : public QWidget {
    Q_OBJECT

public:
    explicit DeviceStrip(QWidget* parent = nullptr);

    void setReadings(const std::vector<DeviceReading>& readings);

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;
    /// All that is said of one device, for tests and assistive tools.
    [[nodiscard]] QString text(int index) const;
    /// As much of it as there is room for.
    [[nodiscard]] QString shownText(int index) const;

signals:
    void deviceActivated(int index);

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    bool event(QEvent* event) override;

private:
    /// Of all that there is to say.
    enum class Detail { all, withoutLatencies, nameAndState, troubles, cutShort };
    struct Cell {
        DeviceReading reading;
        base::SteadyNumber rate{1.0};
        base::SteadyNumber latency_ms{0.5};
        base::SteadyNumber touchToSkin_ms{0.1};
        QString text;
        QString shown;
        QRect rect;
    };
    [[nodiscard]] QString compose(const Cell& cell, Detail detail, const QString& name) const;
    /// What is wrong with the device, behind as much of its name as there is room for.
    [[nodiscard]] QString cutShort(const Cell& cell, double room_px) const;
    /// What a cell takes beside its text.
    [[nodiscard]] double besideText(const Cell& cell) const;
    /// Says so much in each cell; returns the width that all take.
    int place(Detail detail);
    void arrange();
    [[nodiscard]] int cellAt(const QPoint& point) const;
    [[nodiscard]] QString toolTipText(const Cell& cell) const;

    std::vector<Cell> m_cells;
    int m_wanted_px = 0; ///< width in which all is said
};

} // namespace teleta::chrome
