// SPDX-License-Identifier: GPL-3.0-or-later
// Mouse and keyboard input of the timeline.
#include "widgets/base/controls/inline_edit.h"
#include "widgets/base/redo_keys.h"
#include "widgets/pattern/timeline/timeline_menu.h"
#include "widgets/pattern/timeline/timeline_view.h"

#include <QApplication>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QToolTip>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::pattern {

namespace {

constexpr double kWheelZoom = 1.2;
constexpr double kWheelScroll = 0.1; ///< of the span, a notch
constexpr double kNotch = 120.0;
constexpr double kCoarseNudge = 0.05;
constexpr double kFineNudge = 0.01;
constexpr int kLongNudge = 10;

} // namespace

std::optional<PointRef> TimelineView::pointAt(const QPointF& at) const {
    const TimelineGeometry geometry = geometryNow();
    const double reach = geometry.handle + 3.0;
    std::optional<PointRef> nearest;
    double best = reach;
    for (std::size_t track = 0; track < core::kTactors; ++track) {
        if (at.y() < geometry.lane[track].top() - reach || at.y() > geometry.lane[track].bottom() + reach)
            continue;
        const Track& points = m_document->pattern().tracks[track];
        const double end_s = geometry.timeAt(at.x() + reach);
        for (std::size_t i = firstFrom(points, geometry.timeAt(at.x() - reach));
             i < points.size() && points[i].time_s <= end_s; ++i) {
            const double distance = std::hypot(geometry.xOf(points[i].time_s) - at.x(),
                                               geometry.yOf(track, points[i].intensity) - at.y());
            if (distance < best) {
                best = distance;
                nearest = PointRef{track, i};
            }
        }
    }
    return nearest;
}

std::optional<std::size_t> TimelineView::objectAt(const QPointF& at) const {
    const TimelineGeometry geometry = geometryNow();
    const auto lane = geometry.laneAt(at.y());
    if (!lane || !geometry.plot.contains(at))
        return std::nullopt;
    const double time_s = geometry.timeAt(at.x());
    const auto& objects = m_document->pattern().objects;
    for (std::size_t k = objects.size(); k-- > 0;) { // the last one is on top
        const Span span = spanOf(objects[k].form);
        if (time_s < span.begin_s || time_s > span.end_s)
            continue;
        const auto tactors = tactorsOf(objects[k].form);
        if (std::find(tactors.begin(), tactors.end(), *lane) != tactors.end())
            return k;
    }
    return std::nullopt;
}

void TimelineView::setCurrentLane(std::size_t lane) {
    if (std::exchange(m_lane, lane) != lane)
        invalidate();
}

void TimelineView::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) {
        QWidget::mousePressEvent(event);
        return;
    }
    const TimelineGeometry geometry = geometryNow();
    const QPointF at = event->position();
    const bool toggles = event->modifiers().testFlag(Qt::ControlModifier);
    const bool shift = event->modifiers().testFlag(Qt::ShiftModifier);
    m_press = m_now = at;
    m_moved = false;
    m_grab = Grab::none;
    if (at.y() < geometry.ruler.bottom()) {
        m_grab = shift ? Grab::loop : Grab::playhead;
        dragTo(at, event->modifiers());
        return;
    }
    if (const auto lane = geometry.laneAt(at.y()))
        setCurrentLane(*lane);
    const auto point = pointAt(at);
    if (point) {
        PointRefs points = m_document->selection().points;
        const auto found = std::find(points.begin(), points.end(), *point);
        if (toggles || shift) {
            if (found == points.end())
                points.push_back(*point);
            else
                points.erase(found);
            m_document->select({std::move(points), {}});
            return;
        }
        if (found == points.end())
            m_document->select({{*point}, {}});
        m_grab = Grab::points;
        m_grabbed = *point;
        m_grabbed_s = m_document->pattern().tracks[point->track][point->index].time_s;
        return;
    }
    if (m_pen && !toggles && !shift && geometry.plot.contains(at)) {
        const std::size_t lane = *geometry.laneAt(at.y());
        m_document->addPoint(
            lane, {m_document->snapped(geometry.timeAt(at.x())), geometry.intensityAt(lane, at.y())});
        if (!m_document->selection().points.empty()) {
            m_grab = Grab::points;
            m_grabbed = m_document->selection().points.front();
            m_grabbed_s = m_document->pattern().tracks[m_grabbed.track][m_grabbed.index].time_s;
        }
        return;
    }
    const auto object = shift || toggles ? std::nullopt : objectAt(at);
    if (object) {
        m_document->select({{}, *object});
        m_grab = Grab::object;
        m_grabbed_s = spanOf(m_document->pattern().objects[*object].form).begin_s;
        return;
    }
    m_beforeBox = shift || toggles ? m_document->selection() : Selection{};
    m_grab = Grab::box;
}

void TimelineView::dragTo(const QPointF& at, Qt::KeyboardModifiers modifiers) {
    const TimelineGeometry geometry = geometryNow();
    m_now = at;
    if (!m_moved && (at - m_press).manhattanLength() < QApplication::startDragDistance() &&
        m_grab != Grab::playhead)
        return;
    const bool begins = !m_moved;
    m_moved = true;
    const bool free = modifiers.testFlag(Qt::AltModifier);
    const auto snap = [&](double time_s) { return free ? time_s : m_document->snapped(time_s); };
    switch (m_grab) {
    case Grab::none:
        break;
    case Grab::playhead:
        movePlayhead(snap(geometry.timeAt(at.x())));
        break;
    case Grab::loop: {
        const double from_s = snap(geometry.timeAt(m_press.x()));
        const double to_s = snap(geometry.timeAt(at.x()));
        setLoop(Span{std::min(from_s, to_s), std::max(from_s, to_s)});
        break;
    }
    case Grab::points:
    case Grab::object: {
        if (begins)
            m_document->beginDrag();
        const double time_s =
            snap(m_grabbed_s + (at.x() - m_press.x()) * geometry.secondsPerPixel()) - m_grabbed_s;
        m_document->moveSelection(time_s, (m_press.y() - at.y()) * geometry.intensityPerPixel());
        if (m_grab == Grab::points)
            QToolTip::showText(mapToGlobal(at.toPoint()),
                               describePoint(m_document->selection().points.empty()
                                                 ? m_grabbed
                                                 : m_document->selection().points.front()),
                               this);
        break;
    }
    case Grab::box:
        finishBox();
        update();
        break;
    }
}

void TimelineView::finishBox() {
    const TimelineGeometry geometry = geometryNow();
    const QRectF box = QRectF(m_press, m_now).normalized();
    Selection selection{m_beforeBox.points, {}};
    for (std::size_t lane = 0; lane < core::kTactors; ++lane) {
        if (box.bottom() < geometry.lane[lane].top() || box.top() > geometry.lane[lane].bottom())
            continue;
        const PointRefs inside =
            pointsIn(m_document->pattern(), lane, {geometry.timeAt(box.left()), geometry.timeAt(box.right())},
                     geometry.intensityAt(lane, box.bottom()), geometry.intensityAt(lane, box.top()));
        selection.points.insert(selection.points.end(), inside.begin(), inside.end());
    }
    m_document->select(std::move(selection));
}

void TimelineView::mouseMoveEvent(QMouseEvent* event) {
    if (event->buttons().testFlag(Qt::LeftButton) && m_grab != Grab::none) {
        dragTo(event->position(), event->modifiers());
        return;
    }
    if (!m_pen)
        setCursor(pointAt(event->position()) ? Qt::SizeAllCursor : Qt::ArrowCursor);
}

void TimelineView::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton)
        return;
    if (m_grab == Grab::box && !m_moved && m_beforeBox.empty())
        m_document->select({});
    if (m_grab == Grab::points && !m_moved && m_document->selection().points.size() > 1)
        m_document->select({{m_grabbed}, {}}); // a click on one of many
    if (m_document->dragging())
        m_document->endDrag();
    m_grab = Grab::none;
    update();
}

void TimelineView::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton)
        return;
    const TimelineGeometry geometry = geometryNow();
    const QPointF at = event->position();
    m_grab = Grab::none;
    if (const auto point = pointAt(at)) {
        editPoint(*point);
        return;
    }
    const auto lane = geometry.laneAt(at.y());
    if (!lane || !geometry.plot.contains(at))
        return;
    if (const auto object = objectAt(at))
        emit objectActivated(*object);
    else if (!m_pen)
        m_document->addPoint(
            *lane, {m_document->snapped(geometry.timeAt(at.x())), geometry.intensityAt(*lane, at.y())});
}

void TimelineView::editPoint(PointRef point) {
    const Track& track = m_document->pattern().tracks[point.track];
    if (point.index >= track.size())
        return;
    m_document->select({{point}, {}});
    const TimelineGeometry geometry = geometryNow();
    const Breakpoint before = track[point.index];
    const QPointF at(geometry.xOf(before.time_s), geometry.yOf(point.track, before.intensity));
    const QSizeF size(9.0 * geometry.em, 1.7 * geometry.em);
    const QLocale locale;
    auto* edit = new base::InlineEdit(
        this, QRectF(at + QPointF(0.6 * geometry.em, -0.5 * size.height()), size).toRect(),
        QStringLiteral("%1 s; %2 %")
            .arg(locale.toString(before.time_s, 'g', 7), locale.toString(100.0 * before.intensity, 'g', 5)));
    edit->setObjectName(QStringLiteral("pointEdit"));
    edit->setAccessibleName(tr("Time in s; intensity in %"));
    connect(edit, &base::InlineEdit::committed, this, [this, point, before](const QString& typed) {
        const auto numbers = numbersIn(typed);
        if (numbers.empty())
            return;
        Breakpoint after = before;
        after.time_s = numbers[0];
        if (numbers.size() > 1)
            after.intensity = 0.01 * numbers[1];
        m_document->replacePoint(point, after);
    });
}

void TimelineView::wheelEvent(QWheelEvent* event) {
    const QPoint turned = event->angleDelta();
    const double notches = (turned.y() != 0 ? turned.y() : turned.x()) / kNotch;
    const TimelineGeometry geometry = geometryNow();
    if (event->modifiers().testFlag(Qt::ControlModifier))
        zoomAround(geometry.timeAt(event->position().x()), std::pow(kWheelZoom, notches));
    else if (event->modifiers().testFlag(Qt::ShiftModifier) || turned.x() != 0)
        showSpan(m_begin_s - notches * kWheelScroll * m_span_s, m_span_s);
    else {
        event->ignore();
        return;
    }
    event->accept();
}

void TimelineView::stepPoint(int direction, bool extends) {
    const Track& track = m_document->pattern().tracks[m_lane];
    if (track.empty())
        return;
    const auto last = static_cast<std::ptrdiff_t>(track.size()) - 1;
    PointRefs chosen = m_document->selection().points;
    std::erase_if(chosen, [this](const PointRef& point) { return point.track != m_lane; });
    std::ptrdiff_t index = direction > 0 ? static_cast<std::ptrdiff_t>(firstFrom(track, m_playhead_s))
                                         : static_cast<std::ptrdiff_t>(firstFrom(track, m_playhead_s)) - 1;
    if (!chosen.empty())
        index =
            static_cast<std::ptrdiff_t>((direction > 0 ? chosen.back() : chosen.front()).index) + direction;
    index = std::clamp<std::ptrdiff_t>(index, 0, last);
    PointRefs points = extends ? m_document->selection().points : PointRefs{};
    points.push_back({m_lane, static_cast<std::size_t>(index)});
    m_document->select({std::move(points), {}});
    const double time_s = track[static_cast<std::size_t>(index)].time_s;
    reveal({time_s, time_s});
}

void TimelineView::stepObject(int direction) {
    const auto& objects = m_document->pattern().objects;
    if (objects.empty())
        return;
    const std::size_t count = objects.size();
    const auto& chosen = m_document->selection().object;
    const std::size_t next = chosen          ? (*chosen + (direction > 0 ? 1 : count - 1)) % count
                             : direction > 0 ? 0
                                             : count - 1;
    m_document->select({{}, next});
    reveal(spanOf(objects[next].form));
}

void TimelineView::nudge(int key, Qt::KeyboardModifiers modifiers) {
    const bool shift = modifiers.testFlag(Qt::ShiftModifier);
    const double time_s = m_document->snapStep_s() * (shift ? kLongNudge : 1);
    const double intensity = shift ? kFineNudge : kCoarseNudge;
    const bool none = m_document->selection().empty();
    if (key == Qt::Key_Left || key == Qt::Key_Right) {
        const double signedTime_s = key == Qt::Key_Left ? -time_s : time_s;
        if (none)
            movePlayhead(m_playhead_s + signedTime_s);
        else
            m_document->moveSelection(signedTime_s, 0.0);
    } else if (none) {
        setCurrentLane(key == Qt::Key_Up ? (m_lane + core::kTactors - 1) % core::kTactors
                                         : (m_lane + 1) % core::kTactors);
    } else {
        m_document->moveSelection(0.0, key == Qt::Key_Up ? intensity : -intensity);
    }
}

void TimelineView::keyPressEvent(QKeyEvent* event) {
    const bool control = event->modifiers().testFlag(Qt::ControlModifier);
    const bool shift = event->modifiers().testFlag(Qt::ShiftModifier);
    if (event->matches(QKeySequence::Copy))
        m_document->copy();
    else if (event->matches(QKeySequence::Cut))
        m_document->cut();
    else if (event->matches(QKeySequence::Paste))
        m_document->paste();
    else if (event->matches(QKeySequence::SelectAll))
        m_document->selectAll();
    else if (event->matches(QKeySequence::Undo))
        m_document->undoStack()->undo();
    else if (base::isRedo(*event))
        m_document->undoStack()->redo();
    else if (event->key() == Qt::Key_V && event->modifiers() == (Qt::ControlModifier | Qt::ShiftModifier))
        m_document->paste(m_playhead_s);
    else if (event->key() == Qt::Key_D && event->modifiers() == Qt::ControlModifier)
        m_document->duplicate();
    else if (control && (event->key() == Qt::Key_Plus || event->key() == Qt::Key_Equal))
        zoomAround(m_playhead_s, kWheelZoom);
    else if (control && event->key() == Qt::Key_Minus)
        zoomAround(m_playhead_s, 1.0 / kWheelZoom);
    else if (control && event->key() == Qt::Key_0)
        zoomToFit();
    else if (control)
        QWidget::keyPressEvent(event);
    else {
        switch (event->key()) {
        case Qt::Key_Left:
        case Qt::Key_Right:
        case Qt::Key_Up:
        case Qt::Key_Down:
            nudge(event->key(), event->modifiers());
            break;
        case Qt::Key_Delete:
        case Qt::Key_Backspace:
            m_document->deleteSelection();
            break;
        case Qt::Key_Home:
            movePlayhead(0.0);
            break;
        case Qt::Key_End:
            movePlayhead(m_document->pattern().duration_s);
            break;
        case Qt::Key_PageUp:
            setCurrentLane((m_lane + core::kTactors - 1) % core::kTactors);
            break;
        case Qt::Key_PageDown:
            setCurrentLane((m_lane + 1) % core::kTactors);
            break;
        case Qt::Key_Comma:
        case Qt::Key_Less:
            stepPoint(-1, shift);
            break;
        case Qt::Key_Period:
        case Qt::Key_Greater:
            stepPoint(1, shift);
            break;
        case Qt::Key_N:
            stepObject(shift ? -1 : 1);
            break;
        case Qt::Key_BracketLeft:
            setLoop(Span{m_playhead_s, m_loop ? m_loop->end_s : m_document->pattern().duration_s});
            break;
        case Qt::Key_BracketRight:
            setLoop(Span{m_loop ? m_loop->begin_s : 0.0, m_playhead_s});
            break;
        case Qt::Key_Backslash:
            setLoop(std::nullopt);
            break;
        case Qt::Key_Insert:
            m_document->addPoint(m_lane,
                                 {m_playhead_s, m_document->compiled().evaluate(m_playhead_s)[m_lane]});
            break;
        case Qt::Key_P:
            setPen(!m_pen);
            break;
        case Qt::Key_Space:
            emit playToggled();
            break;
        case Qt::Key_Return:
        case Qt::Key_Enter:
            if (!m_document->selection().points.empty())
                editPoint(m_document->selection().points.front());
            else if (m_document->selection().object)
                emit objectActivated(*m_document->selection().object);
            break;
        default:
            QWidget::keyPressEvent(event);
        }
    }
}

QString TimelineView::describePoint(PointRef point) const {
    const Track& track = m_document->pattern().tracks[point.track];
    if (point.index >= track.size())
        return {};
    return pointText(point.track, track[point.index], m_document->motors()[point.track]);
}

QString TimelineView::describe(const QPointF& at) const {
    const TimelineGeometry geometry = geometryNow();
    if (const auto point = pointAt(at))
        return describePoint(*point);
    const auto lane = geometry.laneAt(at.y());
    if (!lane || !geometry.plot.contains(at))
        return {};
    const double time_s = geometry.timeAt(at.x());
    QString text =
        valueText(*lane, time_s, m_document->compiled().evaluate(time_s)[*lane], m_document->motors()[*lane]);
    if (const auto object = objectAt(at))
        text = objectText(m_document->pattern().objects[*object]) + QLatin1Char('\n') + text;
    return text;
}

bool TimelineView::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        QToolTip::showText(help->globalPos(), describe(help->pos()), this);
        return true;
    }
    // While the timeline has the focus it handles Space and similar keys, not the window.
    if (event->type() == QEvent::ShortcutOverride) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (key->matches(QKeySequence::Copy) || key->matches(QKeySequence::Cut) ||
            key->matches(QKeySequence::Paste) || key->matches(QKeySequence::SelectAll) ||
            (key->modifiers() == Qt::NoModifier && key->key() == Qt::Key_Space)) {
            event->accept();
            return true;
        }
    }
    return QWidget::event(event);
}

} // namespace teleta::pattern
