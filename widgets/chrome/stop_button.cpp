// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/chrome/stop_button.h"

#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <utility>

namespace teleta::chrome {

namespace {

constexpr int kHoldTick_ms = 33;

QPolygonF octagon(const QRectF& square) {
    const double left = square.left(), right = square.right(), top = square.top(), bottom = square.bottom();
    const double cut = square.width() * 0.29;
    return QPolygonF({{left + cut, top},
                      {right - cut, top},
                      {right, top + cut},
                      {right, bottom - cut},
                      {right - cut, bottom},
                      {left + cut, bottom},
                      {left, bottom - cut},
                      {left, top + cut}});
}

} // namespace

StopButton::StopButton(QWidget* parent)
    : QAbstractButton(parent) {
    setFocusPolicy(Qt::StrongFocus);
    m_holdTimer.setInterval(kHoldTick_ms);
    connect(&m_holdTimer, &QTimer::timeout, this, &StopButton::onHoldTick);
    connect(this, &QAbstractButton::pressed, this, &StopButton::onPressed);
    connect(this, &QAbstractButton::released, this, &StopButton::onReleased);
    base::keepTranslated(this, &StopButton::describe);
    base::onChange(this, &StopButton::updateGeometry, {QEvent::LanguageChange, QEvent::FontChange});
}

void StopButton::setEngaged(bool engaged) {
    if (std::exchange(m_engaged, engaged) == engaged)
        return;
    m_holdTimer.stop();
    describe();
    update();
    emit engagedChanged(engaged);
}

QSize StopButton::sizeHint() const {
    const int height = std::max(kMinimumSide_px, base::em(this, 2.75));
    const QFontMetrics bold(base::bold(base::sized(font(), base::kLargeText)));
    const int wide = std::max(
        {bold.horizontalAdvance(tr("STOP")), bold.horizontalAdvance(tr("STOPPED")),
         QFontMetrics(base::sized(font(), base::kSmallText)).horizontalAdvance(tr("hold to release"))});
    return {wide + height + base::grid(this, 3), height};
}

void StopButton::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor red = base::statusColours(palette()).stop;
    const QRectF box = QRectF(rect()).adjusted(1, 1, -1, -1);
    const double radius = base::grid(this, 0.5);

    painter.setPen(Qt::NoPen);
    if (m_engaged) {
        painter.setBrush(palette().color(QPalette::Base));
        painter.drawRoundedRect(box, radius, radius);
        if (m_holdTimer.isActive()) {
            const double share = std::min(1.0, static_cast<double>(m_held.elapsed()) / kHold_ms);
            QPainterPath clip;
            clip.addRoundedRect(box, radius, radius);
            painter.save();
            painter.setClipPath(clip);
            painter.fillRect(QRectF(box.left(), box.top(), box.width() * share, box.height()),
                             base::mixed(palette().color(QPalette::Base), red, 0.35));
            painter.restore();
        }
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(red, 3.0));
        painter.drawRoundedRect(box.adjusted(1, 1, -1, -1), radius, radius);
    } else {
        painter.setBrush(isDown() ? red.darker(130) : underMouse() ? red.lighter(108) : red);
        painter.drawRoundedRect(box, radius, radius);
    }

    const QColor ink = m_engaged ? palette().color(QPalette::Text) : QColor(Qt::white);
    const double side = box.height() * 0.5;
    const QRectF sign(box.left() + 0.25 * box.height(), box.center().y() - 0.5 * side, side, side);
    painter.setPen(QPen(m_engaged ? red : ink, 2.0));
    painter.setBrush(m_engaged ? QBrush(red) : QBrush(Qt::NoBrush));
    painter.drawPolygon(octagon(sign));

    const QFont bold = base::bold(base::sized(font(), base::kLargeText));
    painter.setPen(ink);
    const QRectF textBox(sign.right() + base::grid(this), box.top(),
                         box.right() - sign.right() - base::grid(this), box.height());
    if (m_engaged) {
        painter.setFont(bold);
        painter.drawText(textBox.adjusted(0, 0, 0, -0.38 * box.height()), Qt::AlignLeft | Qt::AlignVCenter,
                         tr("STOPPED"));
        painter.setFont(base::sized(font(), base::kSmallText));
        painter.drawText(textBox.adjusted(0, 0.52 * box.height(), 0, 0), Qt::AlignLeft | Qt::AlignVCenter,
                         tr("hold to release"));
    } else {
        painter.setFont(bold);
        painter.drawText(textBox, Qt::AlignLeft | Qt::AlignVCenter, tr("STOP"));
    }
    if (hasFocus()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(ink, 1, Qt::DotLine));
        painter.drawRoundedRect(box.adjusted(4, 4, -4, -4), radius, radius);
    }
}

void StopButton::onPressed() {
    if (!m_engaged) {
        emit stopRequested();
        return;
    }
    m_held.start();
    m_holdTimer.start();
    update();
}

void StopButton::onReleased() {
    m_holdTimer.stop();
    update();
}

void StopButton::onHoldTick() {
    if (m_held.elapsed() >= kHold_ms) {
        m_holdTimer.stop();
        emit releaseRequested();
    }
    update();
}

void StopButton::describe() {
    setAccessibleName(m_engaged ? tr("Stopped") : tr("Stop"));
    setAccessibleDescription(m_engaged ? tr("Everything that moves is stopped. Hold for a second to release.")
                                       : tr("Stops everything that moves at once."));
    setToolTip(m_engaged ? tr("Everything that moves is stopped. Hold for a second to release.")
                         : tr("Stop everything that moves at once (Esc Esc, or Ctrl+.)"));
}

} // namespace teleta::chrome
