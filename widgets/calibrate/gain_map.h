// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/equilibration/taxel_gains.h"
#include "widgets/base/figure/figure_view.h"

#include <QPointF>
#include <QRectF>
#include <QString>

#include <cstddef>
#include <memory>
#include <optional>

namespace teleta::calibrate {

/// The gains of an array's taxels as a picture, seen from outside the skin: x to the right, y up. Blue taxels
/// are lowered, red ones raised, hatched ones not used; numbers where they fit. Mouse and arrow keys read a
/// taxel. Thread: GUI.
class GainMap : public base::FigureView {
    Q_OBJECT
public:
    explicit GainMap(QWidget* parent = nullptr);

    /// Null: all gains are 1.
    void setGains(std::shared_ptr<const equilibration::TaxelGains> gains);
    /// Text for the taxel being read; empty without one.
    [[nodiscard]] QString readout() const;
    /// Place of a taxel.
    [[nodiscard]] QRectF taxelRect(std::size_t taxel) const;
    /// With the table of gains.
    [[nodiscard]] base::Figure figure() override;

signals:
    void readoutChanged(const QString& text);

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    void setCursorTaxel(std::optional<std::size_t> taxel);
    [[nodiscard]] std::optional<std::size_t> taxelAt(const QPointF& pixel) const;

    std::shared_ptr<const equilibration::TaxelGains> m_gains;
    std::optional<std::size_t> m_cursor;
};

} // namespace teleta::calibrate
