// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/chrome/time_slider.h"

#include "widgets/base/theme.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QStyle>
#include <QStyleOptionSlider>
#include <QToolTip>

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::chrome {

namespace {

/// Largest distance of the pointer from a mark.
constexpr double kReach_px = 5.0;

} // namespace

void TimeSlider::setDuration(double duration_s) {
    if (std::exchange(m_duration_s, duration_s) != duration_s && !m_marks.empty())
        update();
}

void TimeSlider::setMarks(std::vector<core::PlaybackMark> marks) {
    m_marks = std::move(marks);
    update();
}

TimeSlider::Run TimeSlider::run() const {
    QStyleOptionSlider option;
    initStyleOption(&option);
    const int handle = style()->pixelMetric(QStyle::PM_SliderLength, &option, this);
    return {0.5 * handle, std::max(1.0, static_cast<double>(width() - handle))};
}

int TimeSlider::valueAt(double x_px) const {
    const auto [first_px, length_px] = run();
    const double share = std::clamp((x_px - first_px) / length_px, 0.0, 1.0);
    return minimum() + static_cast<int>(std::lround(share * (maximum() - minimum())));
}

bool TimeSlider::isShown(const core::PlaybackMark& mark) const {
    return m_duration_s > 0.0 && mark.time_s >= 0.0 && mark.time_s <= m_duration_s;
}

double TimeSlider::x_px(const core::PlaybackMark& mark) const {
    const auto [first_px, length_px] = run();
    return first_px + mark.time_s / m_duration_s * length_px;
}

bool TimeSlider::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip)
        return QSlider::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    for (const core::PlaybackMark& mark : m_marks) {
        if (!isShown(mark) || std::abs(x_px(mark) - help->pos().x()) > kReach_px)
            continue;
        const QString text = QString::fromStdString(mark.text);
        QToolTip::showText(help->globalPos(), text.isEmpty() ? tr("Mark") : text.toHtmlEscaped(), this);
        return true;
    }
    return QSlider::event(event);
}

void TimeSlider::keyPressEvent(QKeyEvent* event) {
    event->ignore();
}

void TimeSlider::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton && width() > 1) {
        setSliderDown(true);
        setSliderPosition(valueAt(event->position().x()));
        event->accept();
        return;
    }
    QSlider::mousePressEvent(event);
}

void TimeSlider::mouseMoveEvent(QMouseEvent* event) {
    if (isSliderDown())
        setSliderPosition(valueAt(event->position().x()));
}

void TimeSlider::mouseReleaseEvent(QMouseEvent* /*event*/) {
    setSliderDown(false);
}

void TimeSlider::paintEvent(QPaintEvent* event) {
    QSlider::paintEvent(event);
    if (m_marks.empty())
        return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette().color(QPalette::WindowText));
    // A flag hanging from above leaves the groove and the handle visible.
    const double size_px = base::grid(this, 0.5);
    for (const core::PlaybackMark& mark : m_marks) {
        if (!isShown(mark))
            continue;
        const double x = x_px(mark);
        painter.drawRect(QRectF(x - 0.75, 0.0, 1.5, height() / 2.0));
        painter.drawPolygon(QPolygonF{{x - size_px, 0.0}, {x + size_px, 0.0}, {x, 1.5 * size_px}});
    }
}

} // namespace teleta::chrome
