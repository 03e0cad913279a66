// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/tactile/heatmap_view.h"

#include "widgets/base/controls/inline_edit.h"
#include "widgets/base/controls/provenance_stripe.h"
#include "widgets/base/numbers/moment_unit.h"
#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"
#include "widgets/tactile/shear_arrows.h"

#include <QActionGroup>
#include <QKeyEvent>
#include <QLocale>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace teleta::tactile {

namespace {

constexpr double kLargestZoom = 64.0;
constexpr double kZoomStep = 1.25;
/// The colours extend to at least this multiple of the threshold, so that noise stays dark.
constexpr double kRangeOverThreshold = 5.0;
constexpr double kSmallestRange = 1e-15;

} // namespace

HeatmapView::HeatmapView(QWidget* parent)
    : FigureView(parent, {40, 24}, {18, 13})
    , m_range(1.0)
    , m_shearRange(1.0) {
    setMouseTracking(true);
    for (std::size_t i = 0; i < kOverlays; ++i) {
        m_overlayActions[i] = new QAction(this);
        m_overlayActions[i]->setCheckable(true);
        m_overlayActions[i]->setChecked(m_content.overlays[i]);
        connect(m_overlayActions[i], &QAction::toggled, this, [this, i](bool shown) {
            m_content.overlays[i] = shown;
            update();
        });
    }
    base::keepTranslated(this, &HeatmapView::retranslate);
}

void HeatmapView::retranslate() {
    setAccessibleName(tr("Tactile heatmap"));
    setWhatsThis(tr("<p>The load of every taxel of the array, seen from outside the skin: x points to the "
                    "right, y up.</p>"
                    "<p>Coloured outlines are contacts, each with the number under which it is followed. "
                    "× is the centre of pressure, ○ the centre of contact, the line the principal axis. "
                    "Hatched taxels are dead and carry no load. Arrows are the force along the surface, of "
                    "arrays that measure it; zoom in where taxels are too small for them.</p>"
                    "<p>Ctrl+wheel zooms, drag moves, double click shows the whole array. Double-click the "
                    "colour bar to type "
                    "its upper end. The arrow keys read taxel by taxel.</p>"));
    const auto name = [this](Overlay overlay, const QString& text, const QString& tip) {
        QAction* action = overlayAction(overlay);
        action->setText(text);
        action->setToolTip(tip);
    };
    name(Overlay::contacts, tr("&Contacts"), tr("Outline each contact and show its number"));
    name(Overlay::centreOfPressure, tr("Centre of &pressure"), tr("Mark the load-weighted centre with ×"));
    name(Overlay::centreOfContact, tr("Centre of c&ontact"),
         tr("Mark the centre of the touched area with ○"));
    name(Overlay::principalAxis, tr("Principal &axis"),
         tr("Draw the axis along which the touched area is longest"));
    name(Overlay::values, tr("&Numbers"), tr("Write each load into its taxel where there is room"));
    name(Overlay::shear, tr("&Shear"),
         tr("Draw the force along the surface as arrows, of arrays that measure it"));
    update();
}

QAction* HeatmapView::overlayAction(Overlay overlay) const {
    return m_overlayActions[static_cast<std::size_t>(overlay)];
}

void HeatmapView::setSnapshot(const pipeline::TouchSnapshot& snapshot) {
    if (!isConsistent(snapshot)) {
        clear();
        return;
    }
    const bool otherArray = !m_content.valid || snapshot.layout != m_content.snapshot.layout;
    m_content.snapshot = snapshot;
    m_content.valid = true;
    if (otherArray) {
        m_range.reset();
        m_shearRange.reset();
        m_keyboardTaxel.reset();
        m_content.cursor.reset();
        resetZoom();
    }
    m_force.update(snapshot.features.force_N);
    m_content.forceText = m_force.text();
    std::optional<double> shear;
    if (snapshot.features.shear)
        shear = std::hypot(snapshot.features.shear->x_N, snapshot.features.shear->y_N);
    m_shear.update(shear);
    m_content.shearText = m_shear.text();
    std::optional<double> angle_deg;
    if (snapshot.features.alphaZ_rad)
        angle_deg = *snapshot.features.alphaZ_rad * 180.0 / std::numbers::pi;
    m_angle.update(angle_deg);
    constexpr qsizetype kAngleWidth = 3;
    m_content.angleText = m_angle.text().right(kAngleWidth);
    updateRange();
    update();
}

void HeatmapView::setLoads(const std::optional<pipeline::LoadReading>& loads) {
    m_content.loads.clear();
    m_content.extrapolated = loads && loads->at.extrapolated;
    static constexpr std::array kNames{QT_TR_NOOP("load"), QT_TR_NOOP("shear along x"),
                                       QT_TR_NOOP("shear along y"), QT_TR_NOOP("moment")};
    static_assert(kNames.size() == equilibration::kLoadColumns.size());
    for (std::size_t i = 0; loads && i < loads->names.size(); ++i) {
        const auto known = std::ranges::find(equilibration::kLoadColumns, loads->names[i]);
        const auto at = static_cast<std::size_t>(known - equilibration::kLoadColumns.begin());
        if (known == equilibration::kLoadColumns.end())
            continue;
        const double load = loads->at.loads[static_cast<Eigen::Index>(i)];
        const double error = loads->at.errors[static_cast<Eigen::Index>(i)];
        const base::MomentUnit unit = *known == "moment_nm"
                                          ? base::momentUnit(std::fmax(std::abs(load), error))
                                          : base::MomentUnit{1.0, QStringLiteral("N")};
        m_loads[at].update(unit.perNm * load, unit.perNm * error);
        m_content.loads.push_back({tr(kNames[at]), base::withUnit(m_loads[at].text(), unit.name)});
    }
    update();
}

void HeatmapView::updateRange() {
    m_content.rangeFixed = m_fixedTop.has_value();
    if (m_content.valid) {
        const pipeline::TouchSnapshot& snapshot = m_content.snapshot;
        const double least = kRangeOverThreshold * snapshot.threshold_N;
        m_range.setMinimumSpan(std::isfinite(least) ? std::max(least, kSmallestRange) : kSmallestRange);
        const double peak =
            std::isfinite(snapshot.features.peak_N) ? std::max(0.0, snapshot.features.peak_N) : 0.0;
        const double time_s = static_cast<double>(snapshot.time_ns) * 1e-9;
        m_range.update(0.0, peak, time_s);
        if (m_content.hasShear()) {
            m_shearRange.setMinimumSpan(std::isfinite(snapshot.threshold_N)
                                            ? std::max(snapshot.threshold_N, kSmallestRange)
                                            : kSmallestRange);
            m_shearRange.update(0.0, largestShear(snapshot), time_s);
            m_content.shearTop = m_shearRange.high();
        }
    }
    m_content.rangeTop = m_fixedTop.value_or(m_range.high());
}

void HeatmapView::clear() {
    m_content.valid = false;
    m_content.loads.clear();
    m_content.extrapolated = false;
    m_content.cursor.reset();
    m_keyboardTaxel.reset();
    update();
}

void HeatmapView::setEmptyText(const QString& text) {
    m_content.emptyText = text;
    update();
}

void HeatmapView::setProvenance(base::Provenance provenance) {
    if (m_content.provenance == provenance)
        return;
    base::showProvenance(this, provenance);
    m_content.provenance = provenance;
    update();
}

void HeatmapView::setOld(bool old) {
    if (m_content.old == old)
        return;
    m_content.old = old;
    update();
}

void HeatmapView::setFixedRange(std::optional<double> top) {
    if (top && !(std::isfinite(*top) && *top > 0.0))
        return;
    if (top == m_fixedTop)
        return;
    m_fixedTop = top;
    updateRange();
    update();
}

HeatmapLayout HeatmapView::layoutNow() const {
    return HeatmapPainter::layoutOf(m_content, QRectF(rect()), font(), devicePixelRatioF());
}

void HeatmapView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    if (!m_content.valid) {
        painter.setPen(palette().color(QPalette::PlaceholderText));
        painter.drawText(rect().adjusted(base::em(this, 1), 0, -base::em(this, 1), 0),
                         Qt::AlignCenter | Qt::TextWordWrap, m_content.emptyText);
        return;
    }
    m_painter.paint(painter, layoutNow(), m_content, palette(), HeatmapPainter::Medium::screen);
    base::paintFocusFrame(painter, *this);
}

base::Figure HeatmapView::figure() {
    base::Figure figure;
    figure.name = tr("heatmap");
    figure.size_px = QSizeF(size());
    figure.paint = [content = m_content, size = figure.size_px, font = font()](QPainter& painter) {
        painter.setFont(font);
        HeatmapContent paper = content;
        paper.cursor.reset();
        paper.zoom.factor = 1.0; // the whole array, like the data
        const HeatmapLayout layout = HeatmapPainter::layoutOf(paper, QRectF(QPointF(), size), font, 1.0);
        if (paper.valid)
            HeatmapPainter().paint(painter, layout, paper, base::designedPalette(false),
                                   HeatmapPainter::Medium::paper);
    };
    figure.csv = [content = m_content] { return frameCsv(content); };
    return figure;
}

QString HeatmapView::readout() const {
    return m_content.valid && m_content.cursor ? taxelText(m_content, *m_content.cursor) : QString();
}

void HeatmapView::setCursorTaxel(std::optional<Taxel> taxel) {
    if (taxel == m_content.cursor)
        return;
    m_content.cursor = taxel;
    setAccessibleDescription(readout());
    update();
}

void HeatmapView::moveCursor(int rows, int columns) {
    if (!m_content.valid)
        return;
    const core::ArrayLayout& array = m_content.snapshot.layout.grid();
    if (m_content.cursor) {
        m_keyboardTaxel = Taxel{std::clamp(m_content.cursor->row + rows, 0, array.rows - 1),
                                std::clamp(m_content.cursor->column + columns, 0, array.columns - 1)};
    } else {
        m_keyboardTaxel = Taxel{array.rows / 2, array.columns / 2};
    }
    setCursorTaxel(m_keyboardTaxel);
}

void HeatmapView::resetZoom() {
    const core::ArrayLayout array = cellsOf(m_content.snapshot.layout);
    m_content.zoom = {1.0, QPointF(0.5 * array.columns, 0.5 * array.rows)};
    unsetCursor();
    update();
}

void HeatmapView::zoomBy(double factor, const QPointF& pixel) {
    if (!m_content.valid)
        return;
    const double before = m_content.zoom.factor;
    const double after = std::clamp(before * factor, 1.0, kLargestZoom);
    if (after == before)
        return;
    if (after == 1.0) {
        resetZoom();
        return;
    }
    // The point under the mouse stays in place.
    const QPointF grid = layoutNow().gridAt(pixel);
    m_content.zoom.factor = after;
    const QPointF moved = layoutNow().gridAt(pixel);
    m_content.zoom.centre = layoutNow().clampedCentre(m_content.zoom.centre + grid - moved);
    setCursor(Qt::OpenHandCursor);
    update();
}

void HeatmapView::panBy(const QPointF& taxels) {
    m_content.zoom.centre = layoutNow().clampedCentre(m_content.zoom.centre + taxels);
    update();
}

void HeatmapView::wheelEvent(QWheelEvent* event) {
    constexpr double kNotch = 120.0;
    const QPoint delta = event->angleDelta();
    const double notches =
        (delta.y() != 0 ? delta.y() : delta.x()) / kNotch; // Alt and Shift may swap the axes
    if (event->modifiers().testFlag(Qt::ControlModifier)) {
        zoomBy(std::pow(kZoomStep, notches), event->position());
        event->accept();
    } else if (event->modifiers().testFlag(Qt::ShiftModifier) && m_content.zoom.factor > 1.0) {
        panBy(QPointF(-notches * 0.1 * cellsOf(m_content.snapshot.layout).columns / m_content.zoom.factor,
                      0.0));
        event->accept();
    } else {
        event->ignore();
    }
}

void HeatmapView::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton && m_content.zoom.factor > 1.0) {
        m_dragFrom = event->position();
        setCursor(Qt::ClosedHandCursor);
    }
    QWidget::mousePressEvent(event);
    event->accept();
}

void HeatmapView::mouseMoveEvent(QMouseEvent* event) {
    if (!m_content.valid)
        return;
    const HeatmapLayout layout = layoutNow();
    if (m_dragFrom && event->buttons().testFlag(Qt::LeftButton)) {
        panBy(layout.gridAt(*m_dragFrom) - layout.gridAt(event->position()));
        m_dragFrom = event->position();
    }
    const std::optional<Taxel> under = layoutNow().taxelAt(event->position());
    setCursorTaxel(under ? under : m_keyboardTaxel);
}

void HeatmapView::mouseReleaseEvent(QMouseEvent*) {
    if (m_dragFrom)
        setCursor(Qt::OpenHandCursor);
    m_dragFrom.reset();
}

void HeatmapView::mouseDoubleClickEvent(QMouseEvent* event) {
    if (!m_content.valid || event->button() != Qt::LeftButton)
        return;
    if (rangeEditArea().contains(event->position()))
        editRange();
    else
        resetZoom();
}

void HeatmapView::leaveEvent(QEvent*) {
    setCursorTaxel(m_keyboardTaxel);
}

void HeatmapView::keyPressEvent(QKeyEvent* event) {
    const QPointF middle = layoutNow().visible().center();
    const bool pan = event->modifiers().testFlag(Qt::ShiftModifier) && m_content.zoom.factor > 1.0;
    const auto move = [&](int rows, int columns) {
        if (pan)
            panBy(QPointF(columns, rows));
        else
            moveCursor(rows, columns);
    };
    switch (event->key()) {
    case Qt::Key_Left:
        move(0, -1);
        break;
    case Qt::Key_Right:
        move(0, 1);
        break;
    case Qt::Key_Up:
        move(1, 0);
        break;
    case Qt::Key_Down:
        move(-1, 0);
        break;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        zoomBy(kZoomStep, middle);
        break;
    case Qt::Key_Minus:
        zoomBy(1.0 / kZoomStep, middle);
        break;
    case Qt::Key_0:
        resetZoom();
        break;
    default:
        FigureView::keyPressEvent(event);
    }
}

void HeatmapView::addOwnActions(QMenu& menu, const QPoint& /*position*/) {
    menu.setToolTipsVisible(true);
    for (QAction* action : m_overlayActions)
        menu.addAction(action);
    menu.addSeparator();

    QMenu* range = menu.addMenu(tr("Colour &range"));
    auto* group = new QActionGroup(range);
    const auto choice = [&](const QString& text, bool checked, auto&& chosen) {
        QAction* action = range->addAction(text);
        action->setCheckable(true);
        action->setChecked(checked);
        group->addAction(action);
        connect(action, &QAction::triggered, this, chosen);
    };
    const QString top = base::withUnit(QLocale().toString(m_content.rangeTop, 'g', 4), m_content.unit());
    choice(tr("&Automatic"), !m_fixedTop, [this] { setFixedRange(std::nullopt); });
    choice(tr("&Fixed at %1").arg(top), m_fixedTop.has_value(),
           [this] { setFixedRange(m_content.rangeTop); });
    range->addSeparator();
    range->addAction(tr("&Type upper end…"), this, &HeatmapView::editRange);

    QAction* reset = menu.addAction(tr("Show &whole array"), this, &HeatmapView::resetZoom);
    reset->setEnabled(m_content.zoom.factor > 1.0);
}

QRectF HeatmapView::rangeEditArea() const {
    const int em = base::em(this, 1);
    return layoutNow().colourBar().adjusted(-0.5 * em, -1.5 * em, 4.0 * em, 1.5 * em);
}

void HeatmapView::editRange() {
    if (!m_content.valid || m_rangeEdit)
        return;
    const QRectF bar = layoutNow().colourBar();
    const QRect place(static_cast<int>(bar.left()), static_cast<int>(bar.top()), base::em(this, 5), 0);
    m_rangeEdit = new base::InlineEdit(this, place, QLocale().toString(m_content.rangeTop, 'g', 4));
    m_rangeEdit->setAccessibleName(tr("Upper end of the colours"));
    m_rangeEdit->setToolTip(tr("Load at the upper end of the colours. Empty: automatic."));
    m_rangeEdit->setPlaceholderText(tr("auto"));
    connect(m_rangeEdit, &base::InlineEdit::committed, this, [this](const QString& text) {
        bool ok = false;
        const double top = QLocale().toDouble(text, &ok);
        if (ok)
            setFixedRange(top);
        else if (text.trimmed().isEmpty())
            setFixedRange(std::nullopt);
    });
}

QString HeatmapView::toolTipAt(const QPointF& pixel) const {
    if (!m_content.valid)
        return {};
    if (rangeEditArea().contains(pixel))
        return tr("Loads from 0 to %1. Taxels below the threshold of %2 are not in contact.\nDouble-click to "
                  "type the upper end.")
            .arg(
                base::withUnit(QLocale().toString(m_content.rangeTop, 'g', 4), m_content.unit()),
                base::withUnit(QLocale().toString(m_content.snapshot.threshold_N, 'g', 4), m_content.unit()));
    const std::optional<Taxel> taxel = layoutNow().taxelAt(pixel);
    if (taxel && m_content.snapshot.layout.isAbsent(m_content.index(*taxel)))
        return {};
    if (taxel && m_content.isDead(m_content.index(*taxel)))
        return tr("Dead taxel: its value is not used.");
    return {};
}

void HeatmapView::resizeEvent(QResizeEvent* event) {
    m_content.zoom.centre = layoutNow().clampedCentre(m_content.zoom.centre);
    QWidget::resizeEvent(event);
}

} // namespace teleta::tactile
