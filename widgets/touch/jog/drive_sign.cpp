// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/touch/jog/drive_sign.h"

#include "widgets/base/icons.h"
#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"
#include "widgets/touch/touch_texts.h"

#include <QPainter>
#include <QPolygonF>

#include <cmath>
#include <numbers>

namespace teleta::touch {

using core::ArmDrive;

namespace {

void paintOctagon(QPainter& painter, const QRectF& square, const QColor& colour) {
    QPolygonF corners;
    for (int i = 0; i < 8; ++i) {
        const double angle = (i + 0.5) * std::numbers::pi / 4.0;
        corners << square.center() + 0.5 * square.width() * QPointF(std::cos(angle), std::sin(angle));
    }
    painter.setBrush(colour);
    painter.drawPolygon(corners);
}

void paintArrows(QPainter& painter, const QRectF& square, const QColor& colour) {
    painter.setBrush(colour);
    const double r = 0.5 * square.width();
    for (int i = 0; i < 4; ++i) {
        painter.save();
        painter.translate(square.center());
        painter.rotate(90.0 * i);
        painter.drawPolygon(QPolygonF({{r, 0.0}, {0.4 * r, -0.42 * r}, {0.4 * r, 0.42 * r}}));
        painter.restore();
    }
}

} // namespace

DriveSign::DriveSign(QWidget* parent)
    : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setDrive(std::nullopt);
    base::onChange(this, [this] { setDrive(m_drive); }, {QEvent::LanguageChange});
}

void DriveSign::setDrive(std::optional<ArmDrive> drive) {
    m_drive = drive;
    setAccessibleName(tr("Drive of the arm"));
    setAccessibleDescription(text());
    update();
}

QString DriveSign::text() const {
    return m_drive ? TouchTexts::drive(*m_drive) : tr("no arm");
}

QSize DriveSign::sizeHint() const {
    return {base::em(this, 8), base::em(this, 1.8)};
}

void DriveSign::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    const double em = base::em(this, 1);
    const QRectF square(0.2 * em, 0.5 * height() - 0.55 * em, 1.1 * em, 1.1 * em);
    const base::StatusColours& colours = base::statusColours(palette());
    QColor colour = colours.neutral;
    if (m_drive == ArmDrive::stopped) {
        colour = colours.lost;
        paintOctagon(painter, square, colour);
    } else if (m_drive == ArmDrive::held) {
        base::paintIcon(painter, square, base::Icon::pause, colour);
    } else if (m_drive == ArmDrive::program) {
        colour = colours.live;
        base::paintIcon(painter, square, base::Icon::play, colour);
    } else if (m_drive == ArmDrive::jog) {
        colour = palette().color(QPalette::Link);
        paintArrows(painter, square, colour);
    }
    painter.setFont(base::bold(font()));
    painter.setPen(colour);
    const double left = m_drive ? square.right() + 0.5 * em : square.left();
    painter.drawText(QRectF(left, 0.0, width() - left, height()), Qt::AlignLeft | Qt::AlignVCenter, text());
}

} // namespace teleta::touch
