// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/pattern/stroke_pad.h"

#include "backend/core/bracelet/tactors.h"
#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace teleta::pattern {

namespace {

constexpr double kTurn_rad = 2.0 * std::numbers::pi;
constexpr double kTactor_rad = core::kTactorAngle_rad;
constexpr double kShortestStroke_s = 0.05;

} // namespace

StrokePad::StrokePad(PatternDocument* document, QWidget* parent)
    : SizedView(parent, {26, 10}, {12, 6})
    , m_document(document) {
    setFocusPolicy(Qt::StrongFocus);
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::Base);
    setCursor(Qt::CrossCursor);
    connect(m_document, &PatternDocument::patternChanged, this, qOverload<>(&QWidget::update));
    connect(m_document, &PatternDocument::selectionChanged, this, qOverload<>(&QWidget::update));
    base::keepTranslated(this, &StrokePad::retranslate);
}

void StrokePad::retranslate() {
    setAccessibleName(tr("Unrolled forearm"));
    setToolTip(tr("Draw a stroke: it is felt as a point that moves along it"));
    setWhatsThis(tr("<p>The unrolled forearm: from left to right once around it. Draw with the mouse to add "
                    "a stroke that starts at the playhead and moves as fast as you draw. <b>Esc</b> cancels "
                    "it.</p><p>With keys: the arrows move a cursor, <b>Space</b> adds a point a quarter of a "
                    "second after the last one, <b>Backspace</b> removes it, <b>Enter</b> finishes.</p>"));
}

QRectF StrokePad::arm() const {
    const double em = base::em(this, 1.0);
    return QRectF(rect()).adjusted(0.5 * em, 0.5 * em, -0.5 * em, -0.5 * em);
}

QPointF StrokePad::placeOf(double angle_rad, double along) const {
    const QRectF room = arm();
    // Half a tactor of space on either side; the rows are at a quarter and three quarters of the height.
    return {room.left() +
                (angle_rad / kTactor_rad + 0.5) / static_cast<double>(core::kTactors) * room.width(),
            room.top() + (0.25 + 0.5 * along) * room.height()};
}

StrokePoint StrokePad::pointAt(const QPointF& at) const {
    const QRectF room = arm();
    StrokePoint point;
    point.angle_rad =
        ((at.x() - room.left()) / room.width() * static_cast<double>(core::kTactors) - 0.5) * kTactor_rad;
    point.along = std::clamp(((at.y() - room.top()) / room.height() - 0.25) / 0.5, 0.0, 1.0);
    return point;
}

void StrokePad::append(const QPointF& at, quint64 timestamp_ms) {
    StrokePoint point = pointAt(at);
    const double time_s = 1e-3 * static_cast<double>(timestamp_ms - std::min(m_begin_ms, timestamp_ms));
    point.time_s = m_drawn.empty() ? 0.0 : std::max(time_s, m_drawn.back().time_s);
    m_drawn.push_back(point);
    update();
}

void StrokePad::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton)
        return;
    m_drawing = true;
    m_cursorShown = false;
    m_drawn.clear();
    m_begin_ms = event->timestamp();
    append(event->position(), m_begin_ms);
}

void StrokePad::mouseMoveEvent(QMouseEvent* event) {
    if (m_drawing && m_drawn.size() < Pattern::kMostBreakpoints)
        append(event->position(), event->timestamp());
}

void StrokePad::mouseReleaseEvent(QMouseEvent* event) {
    if (!m_drawing || event->button() != Qt::LeftButton)
        return;
    append(event->position(), event->timestamp());
    m_drawing = false;
    finish();
}

void StrokePad::finish() {
    Stroke stroke;
    stroke.start_s = m_start_s;
    stroke.points = std::move(m_drawn);
    m_drawn.clear();
    if (!stroke.points.empty() && stroke.points.back().time_s >= kShortestStroke_s) {
        const double end_s = stroke.start_s + stroke.points.back().time_s;
        m_document->addObject({{}, std::move(stroke), {}});
        emit drawn(m_start_s, end_s);
    }
    update();
}

void StrokePad::giveUp() {
    m_drawing = false;
    m_drawn.clear();
    update();
}

void StrokePad::moveCursor(int key, bool fine) {
    const double angle_rad = (fine ? 0.1 : 0.5) * kTactor_rad;
    const double along = fine ? 0.05 : 0.25;
    if (key == Qt::Key_Left || key == Qt::Key_Right)
        m_cursor.angle_rad += key == Qt::Key_Right ? angle_rad : -angle_rad;
    else
        m_cursor.along = std::clamp(m_cursor.along + (key == Qt::Key_Down ? along : -along), 0.0, 1.0);
    m_cursorShown = true;
    update();
}

void StrokePad::setPointAtCursor() {
    m_cursorShown = true;
    if (m_drawing || m_drawn.size() >= Pattern::kMostBreakpoints)
        return;
    StrokePoint point = m_cursor;
    point.time_s = kKeyStep_s * static_cast<double>(m_drawn.size());
    m_drawn.push_back(point);
    update();
}

void StrokePad::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Up:
    case Qt::Key_Down:
        moveCursor(event->key(), event->modifiers().testFlag(Qt::ShiftModifier));
        return;
    case Qt::Key_Space:
        setPointAtCursor();
        return;
    case Qt::Key_Backspace:
        if (!m_drawing && !m_drawn.empty()) {
            m_drawn.pop_back();
            update();
            return;
        }
        break;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (!m_drawing && !m_drawn.empty()) {
            finish();
            return;
        }
        break;
    case Qt::Key_Escape:
        if (m_drawing || !m_drawn.empty()) {
            giveUp();
            return;
        }
        break;
    default:
        break;
    }
    QWidget::keyPressEvent(event);
}

void StrokePad::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double em = base::em(this, 1.0);
    const QColor ground = palette().color(QPalette::Base);
    const QColor text = palette().color(QPalette::Text);
    const QColor faint = palette().color(QPalette::PlaceholderText);
    const QColor accent = palette().color(QPalette::Highlight);
    painter.setPen(Qt::NoPen);
    painter.setBrush(base::mixed(ground, text, 0.05));
    painter.drawRoundedRect(arm(), 0.6 * em, 0.6 * em);
    painter.setPen(QPen(base::mixed(ground, text, 0.15), 1.0, Qt::DashLine));
    for (int i = 0; i + 1 < static_cast<int>(core::kTactors); ++i)
        painter.drawLine(placeOf(kTactor_rad * i, i % 2), placeOf(kTactor_rad * (i + 1), (i + 1) % 2));
    painter.setFont(base::sized(font(), base::kSmallText));
    const double radius = std::min(0.8 * em, 0.12 * arm().height());
    for (int i = 0; i < static_cast<int>(core::kTactors); ++i) {
        const QPointF centre = placeOf(kTactor_rad * i, i % 2);
        painter.setPen(QPen(base::mixed(ground, text, 0.45), 1.2));
        painter.setBrush(ground);
        painter.drawEllipse(centre, radius, radius);
        painter.setPen(text);
        painter.drawText(QRectF(centre.x() - em, centre.y() - em, 2.0 * em, 2.0 * em), Qt::AlignCenter,
                         QString::number(i + 1));
    }
    const auto draw = [&](const std::vector<StrokePoint>& points, const QColor& colour, double width) {
        QPolygonF line;
        for (const StrokePoint& point : points)
            line << placeOf(point.angle_rad, point.along);
        if (line.isEmpty())
            return;
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        // A stroke that continues around the arm re-enters on the other side.
        for (const double turns : {-1.0, 0.0, 1.0})
            painter.drawPolyline(line.translated(turns * arm().width(), 0.0));
        painter.setPen(Qt::NoPen);
        painter.setBrush(colour);
        painter.drawEllipse(line.first(), 1.8 * width, 1.8 * width);
    };
    painter.setClipRect(arm());
    bool any = m_drawing || !m_drawn.empty() || m_cursorShown;
    const auto& objects = m_document->pattern().objects;
    for (std::size_t k = 0; k < objects.size(); ++k)
        if (const auto* stroke = std::get_if<Stroke>(&objects[k].form)) {
            const bool selected = m_document->selection().object == k;
            draw(stroke->points, selected ? accent : base::mixed(ground, accent, 0.45), selected ? 3.0 : 2.0);
            any = true;
        }
    draw(m_drawn, accent, 3.0);
    if (m_cursorShown && hasFocus()) {
        painter.setPen(QPen(accent, 1.5));
        painter.setBrush(Qt::NoBrush);
        for (const double turns : {-1.0, 0.0, 1.0}) {
            const QPointF at = placeOf(std::remainder(m_cursor.angle_rad, kTurn_rad), m_cursor.along) +
                               QPointF(turns * arm().width(), 0.0);
            painter.drawEllipse(at, 0.45 * em, 0.45 * em);
            painter.drawLine(at - QPointF(0.8 * em, 0.0), at + QPointF(0.8 * em, 0.0));
            painter.drawLine(at - QPointF(0.0, 0.8 * em), at + QPointF(0.0, 0.8 * em));
        }
    }
    painter.setClipping(false);
    base::paintFocusFrame(painter, *this);
    if (!any) {
        painter.setPen(faint);
        painter.drawText(arm().adjusted(0.0, 0.0, 0.0, -0.2 * em), Qt::AlignHCenter | Qt::AlignBottom,
                         tr("Draw a stroke here"));
    }
}

} // namespace teleta::pattern
