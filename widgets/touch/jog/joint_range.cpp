// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/touch/jog/joint_range.h"

#include "widgets/base/numbers/quantity_text.h"
#include "widgets/base/numbers/tabular_text.h"
#include "widgets/base/theme.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace teleta::touch {

namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr double kMillimetres = 1e3;
constexpr double kNearLimit_rad = 0.01;
constexpr double kText_em = 4.2;
constexpr double kWord_em = 2.6;

} // namespace

JointRange::JointRange(QWidget* parent)
    : QWidget(parent)
    , m_angle_rad(std::numeric_limits<double>::quiet_NaN()) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

double JointRange::scale() const {
    return m_unit == Unit::degree ? kDegrees : kMillimetres;
}

QString JointRange::symbol() const {
    return m_unit == Unit::degree ? QStringLiteral("°") : QStringLiteral("mm");
}

void JointRange::setUnit(Unit unit) {
    m_unit = unit;
    update();
}

void JointRange::setNarrow(bool narrow) {
    m_isNarrow = narrow;
    updateGeometry();
}

void JointRange::setRange(double lowest_rad, double highest_rad) {
    m_endless = !std::isfinite(lowest_rad) || !std::isfinite(highest_rad);
    m_lowest_rad = m_endless ? -std::numbers::pi : lowest_rad;
    m_highest_rad = m_endless ? std::numbers::pi : highest_rad;
    setToolTip(m_endless ? tr("Turns without limits")
                         : tr("Range %1 … %2")
                               .arg(base::withUnit(base::fixedDigits(lowest_rad * scale(), 0), symbol()),
                                    base::withUnit(base::fixedDigits(highest_rad * scale(), 0), symbol())));
    update();
}

void JointRange::setAngle(double angle_rad) {
    const bool wasAtLimit = atLimit();
    m_angle_rad = m_endless ? std::remainder(angle_rad, 2.0 * std::numbers::pi) : angle_rad;
    if (m_shown.update(m_angle_rad * scale()) || wasAtLimit != atLimit()) {
        setAccessibleDescription(text());
        update();
    }
}

bool JointRange::atLimit() const {
    return !m_endless && m_lowest_rad < m_highest_rad &&
           (m_angle_rad <= m_lowest_rad + kNearLimit_rad || m_angle_rad >= m_highest_rad - kNearLimit_rad);
}

QString JointRange::text() const {
    const QString place = base::withUnit(m_shown.text(), symbol());
    return atLimit() ? tr("%1 limit").arg(place) : place;
}

QSize JointRange::sizeHint() const {
    return {base::em(this, 14), base::em(this, 1.5)};
}

QSize JointRange::minimumSizeHint() const {
    return {base::em(this, m_isNarrow ? 8.5 : 10.0), base::em(this, 1.5)};
}

void JointRange::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double em = base::em(this, 1);
    const QColor text = palette().color(QPalette::WindowText);
    const QColor ground = palette().color(QPalette::Window);
    const QColor amber = base::statusColours(palette()).stale;
    const QRectF all = rect();
    const QRectF number(all.right() - (kText_em + kWord_em) * em, all.top(), kText_em * em, all.height());
    painter.setPen(text);
    base::drawTabularText(painter, number, Qt::AlignRight | Qt::AlignVCenter,
                          base::withUnit(m_shown.text(), symbol()));
    if (atLimit()) {
        painter.setPen(amber);
        painter.setFont(base::sized(font(), base::kSmallText));
        painter.drawText(QRectF(number.right() + 0.3 * em, all.top(), kWord_em * em, all.height()),
                         Qt::AlignLeft | Qt::AlignVCenter, tr("limit"));
    }
    const QRectF bar(all.left() + 0.5 * em, all.center().y() - 0.14 * em, number.left() - all.left() - em,
                     0.28 * em);
    painter.setPen(Qt::NoPen);
    painter.setBrush(base::mixed(text, ground, 0.75));
    painter.drawRoundedRect(bar, 0.5 * bar.height(), 0.5 * bar.height());
    const double span = m_highest_rad - m_lowest_rad;
    if (!(span > 0.0))
        return;
    const auto at = [&](double angle) {
        return bar.left() + bar.width() * std::clamp((angle - m_lowest_rad) / span, 0.0, 1.0);
    };
    if (m_lowest_rad < 0.0 && m_highest_rad > 0.0) {
        painter.setPen(QPen(base::mixed(text, ground, 0.4), 1.0));
        painter.drawLine(QPointF(at(0.0), bar.top() - 0.25 * em), QPointF(at(0.0), bar.bottom() + 0.25 * em));
    }
    if (!std::isfinite(m_angle_rad))
        return;
    painter.setPen(Qt::NoPen);
    painter.setBrush(!isEnabled() ? base::mixed(text, ground, 0.5)
                     : atLimit()  ? amber
                                  : palette().color(QPalette::Highlight));
    painter.drawEllipse(QPointF(at(m_angle_rad), bar.center().y()), 0.36 * em, 0.36 * em);
}

} // namespace teleta::touch
