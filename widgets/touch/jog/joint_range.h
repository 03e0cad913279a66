// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/base/numbers/number_format.h"

#include <QWidget>

namespace teleta::touch {

/// Angle of a joint within its range: a bar with a marker, and the number. At an end of the range the marker
/// turns amber and the word "limit" stands beside it. A joint that turns without limits is shown from -180°
/// to 180°; one that slides has m for rad. Thread: GUI.
class JointRange : public QWidget {
    Q_OBJECT
public:
    enum class Unit { degree, millimetre };

    explicit JointRange(QWidget* parent = nullptr);

    void setUnit(Unit unit);
    /// Needs less room, with a shorter bar.
    void setNarrow(bool narrow);
    /// Infinite: it has no limits.
    void setRange(double lowest_rad, double highest_rad);
    /// NaN: unknown.
    void setAngle(double angle_rad);
    [[nodiscard]] bool atLimit() const;
    [[nodiscard]] QString text() const;

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    [[nodiscard]] double scale() const;
    [[nodiscard]] QString symbol() const;

    Unit m_unit = Unit::degree;
    bool m_endless = false;
    bool m_isNarrow = false;
    double m_lowest_rad = 0.0, m_highest_rad = 0.0;
    double m_angle_rad;
    base::SteadyNumber m_shown{0.1};
};

} // namespace teleta::touch
