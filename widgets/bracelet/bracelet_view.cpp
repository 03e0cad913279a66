// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/bracelet/bracelet_view.h"

#include "widgets/base/controls/provenance_stripe.h"
#include "widgets/base/numbers/number_format.h"
#include "widgets/base/numbers/tabular_text.h"
#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::bracelet {

namespace {

constexpr double kDegreesApart = 360.0 / static_cast<double>(core::kTactors);

/// Smaller changes are not visible.
constexpr double kVisibleStep = 0.004;

double shown(double intensity) {
    return intensity > 0.0 ? std::min(intensity, 1.0) : 0.0;
}

int percent(double intensity) {
    return static_cast<int>(std::lround(100.0 * shown(intensity)));
}

} // namespace

BraceletLayout::BraceletLayout(const QRectF& rect, const QFont& font)
    : em(QFontMetricsF(font).height()) {
    const QRectF inside = rect.adjusted(0.5 * em, 0.4 * em, -0.5 * em, -0.4 * em);
    title = QRectF(inside.topLeft(), QSizeF(inside.width(), 1.3 * em));
    note = QRectF(inside.left(), inside.bottom() - 1.2 * em, inside.width(), 1.2 * em);
    arm = QRectF(QPointF(inside.left(), title.bottom() + 0.3 * em),
                 QPointF(inside.right(), note.top() - 0.3 * em));
    const double step = arm.width() / static_cast<double>(core::kTactors);
    // Two rows of discs, each with its number of percent below, and the degrees under the lower one.
    radius = std::max(0.6 * em, std::min({0.44 * step, (arm.height() - 3.4 * em) / 4.0, 2.2 * em}));
    const double upper = arm.top() + 0.3 * em + radius;
    const double lower = std::max(upper + 1.1 * radius, arm.bottom() - 2.5 * em - radius);
    for (std::size_t i = 0; i < core::kTactors; ++i)
        centre[i] = {arm.left() + (static_cast<double>(i) + 0.5) * step, i % 2 == 0 ? upper : lower};
}

std::optional<std::size_t> BraceletLayout::tactorAt(const QPointF& point) const {
    for (std::size_t i = 0; i < core::kTactors; ++i) {
        const QPointF d = point - centre[i];
        if (std::hypot(d.x(), d.y()) <= radius)
            return i;
    }
    return std::nullopt;
}

BraceletView::BraceletView(QWidget* parent)
    : SizedView(parent, {24, 13}, {14, 9}) {
    setFocusPolicy(Qt::StrongFocus);
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::Base);
    base::keepTranslated(this, &BraceletView::retranslate);
}

void BraceletView::retranslate() {
    setAccessibleName(tr("Bracelet"));
    setWhatsThis(tr(
        "<p>What the six motors of the bracelet are doing, on the unrolled forearm: from left to right once "
        "around the arm. The fuller a disc, the stronger the motor vibrates.</p><p>With a bracelet "
        "connected, hold a disc with the mouse, or one of the keys 1 to 6, to feel that motor alone.</p>"));
    describe();
}

void BraceletView::describe() {
    QStringList parts{shownTitle(), m_note};
    for (std::size_t i = 0; i < core::kTactors; ++i)
        if (percent(m_intensities[i]) > 0)
            parts << tr("motor %1: %2 %").arg(i + 1).arg(percent(m_intensities[i]));
    parts.removeAll(QString());
    setAccessibleDescription(parts.join(QStringLiteral("; ")));
}

void BraceletView::setIntensities(const core::Intensities& intensities) {
    bool changed = false;
    for (std::size_t i = 0; i < core::kTactors; ++i)
        changed = changed || std::abs(shown(intensities[i]) - shown(m_intensities[i])) > kVisibleStep ||
                  (shown(intensities[i]) > 0.0) != (shown(m_intensities[i]) > 0.0);
    if (!changed)
        return;
    m_intensities = intensities;
    describe();
    update();
}

void BraceletView::setTitle(const QString& title) {
    if (std::exchange(m_title, title) == title)
        return;
    describe();
    update();
}

void BraceletView::setNote(const QString& note) {
    if (std::exchange(m_note, note) == note)
        return;
    describe();
    update();
}

void BraceletView::setAlarming(bool alarming) {
    if (std::exchange(m_alarming, alarming) != alarming)
        update();
}

void BraceletView::setPreview(bool preview) {
    if (std::exchange(m_preview, preview) == preview)
        return;
    describe();
    update();
}

QString BraceletView::shownTitle() const {
    return m_preview && !m_title.isEmpty() ? tr("%1: preview", "a pattern that is not played").arg(m_title)
                                           : m_title;
}

void BraceletView::setProvenance(base::Provenance provenance) {
    if (std::exchange(m_provenance, provenance) == provenance)
        return;
    base::showProvenance(this, provenance);
    update();
}

void BraceletView::setHoldable(bool holdable) {
    m_holdable = holdable;
    if (!holdable)
        hold(std::nullopt);
}

void BraceletView::hold(std::optional<std::size_t> tactor) {
    if (std::exchange(m_held, tactor) == tactor)
        return;
    emit held(tactor);
    update();
}

BraceletLayout BraceletView::layoutNow() const {
    return {QRectF(rect()), font()};
}

void BraceletView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const BraceletLayout layout = layoutNow();
    const QColor text = palette().color(QPalette::Text);
    const QColor faint = palette().color(QPalette::PlaceholderText);
    const QColor ground = palette().color(QPalette::Base);
    const QColor accent = palette().color(QPalette::Highlight);
    const QFont small = base::sized(font(), base::kSmallText);
    const QFontMetricsF metrics(font());

    const QRectF title =
        base::paintProvenance(painter, layout.title, m_provenance, palette(), 0.5 * layout.em);
    painter.setPen(m_title.isEmpty() ? faint : text);
    painter.drawText(title, Qt::AlignLeft | Qt::AlignVCenter,
                     metrics.elidedText(m_title.isEmpty() ? tr("Nothing is playing") : shownTitle(),
                                        Qt::ElideRight, title.width()));

    painter.setPen(Qt::NoPen);
    painter.setBrush(base::mixed(ground, text, 0.05));
    painter.drawRoundedRect(layout.arm, 0.6 * layout.em, 0.6 * layout.em);

    painter.setFont(small);
    const double line = QFontMetricsF(small).height();
    for (std::size_t i = 0; i < core::kTactors; ++i) {
        const QPointF centre = layout.centre[i];
        const double intensity = shown(m_intensities[i]);
        painter.setPen(QPen(m_held == i ? accent : base::mixed(ground, text, 0.45), m_held == i ? 3.0 : 1.5));
        painter.setBrush(base::mixed(ground, text, 0.02));
        painter.drawEllipse(centre, layout.radius, layout.radius);
        const double filled = layout.radius * std::sqrt(intensity);
        if (intensity > 0.0) {
            painter.setPen(m_preview ? QPen(accent, 1.5, Qt::DashLine) : QPen(Qt::NoPen));
            painter.setBrush(m_preview ? base::mixed(ground, accent, 0.12) : accent);
            painter.drawEllipse(centre, filled, filled);
        }
        const QRectF digit(centre.x() - layout.radius, centre.y() - 0.5 * line, 2.0 * layout.radius, line);
        painter.setPen(text);
        painter.drawText(digit, Qt::AlignCenter, QString::number(i + 1));
        if (intensity > 0.0 && !m_preview) {
            // The part of it on the disc, which may be smaller.
            QPainterPath disc;
            disc.addEllipse(centre, filled, filled);
            painter.save();
            painter.setClipPath(disc);
            painter.fillPath(disc, accent);
            painter.setPen(base::readableOn(accent));
            painter.drawText(digit, Qt::AlignCenter, QString::number(i + 1));
            painter.restore();
        }
        const QRectF below(centre.x() - 2.0 * layout.em, centre.y() + layout.radius + 0.1 * line,
                           4.0 * layout.em, line);
        painter.setPen(intensity > 0.0 && !m_preview ? text : faint);
        base::drawTabularText(painter, below, Qt::AlignCenter,
                              base::withUnit(QString::number(percent(intensity)), QStringLiteral("%")));
        painter.setPen(faint);
        painter.drawText(QRectF(below.left(), layout.arm.bottom() - 1.1 * line, below.width(), line),
                         Qt::AlignCenter,
                         base::withUnit(QString::number(kDegreesApart * static_cast<double>(i)),
                                        QStringLiteral("\u00b0")));
    }
    const QFont noted = m_alarming ? base::bold(small) : small;
    painter.setFont(noted);
    painter.setPen(m_alarming ? base::statusColours(palette()).lost : faint);
    painter.drawText(layout.note, Qt::AlignLeft | Qt::AlignVCenter,
                     QFontMetricsF(noted).elidedText(m_note, Qt::ElideRight, layout.note.width()));
    base::paintFocusFrame(painter, *this);
}

bool BraceletView::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        const auto tactor = layoutNow().tactorAt(help->pos());
        QToolTip::showText(help->globalPos(),
                           tactor ? tr("Motor %1 at %2\u00b0: %3 %")
                                        .arg(*tactor + 1)
                                        .arg(kDegreesApart * static_cast<double>(*tactor))
                                        .arg(percent(m_intensities[*tactor]))
                                  : m_note,
                           this);
        return true;
    }
    if (event->type() == QEvent::WindowDeactivate || (event->type() == QEvent::EnabledChange && !isEnabled()))
        hold(std::nullopt);
    return QWidget::event(event);
}

void BraceletView::mousePressEvent(QMouseEvent* event) {
    if (m_holdable && event->button() == Qt::LeftButton)
        hold(layoutNow().tactorAt(event->position()));
    QWidget::mousePressEvent(event);
}

void BraceletView::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton)
        hold(std::nullopt);
    QWidget::mouseReleaseEvent(event);
}

void BraceletView::keyPressEvent(QKeyEvent* event) {
    const int tactor = event->key() - Qt::Key_1;
    if (!m_holdable || tactor < 0 || tactor >= static_cast<int>(core::kTactors)) {
        QWidget::keyPressEvent(event);
        return;
    }
    if (!event->isAutoRepeat())
        hold(static_cast<std::size_t>(tactor));
}

void BraceletView::keyReleaseEvent(QKeyEvent* event) {
    if (event->isAutoRepeat())
        return;
    if (m_held && event->key() == Qt::Key_1 + static_cast<int>(*m_held))
        hold(std::nullopt);
    else
        QWidget::keyReleaseEvent(event);
}

void BraceletView::focusOutEvent(QFocusEvent* event) {
    hold(std::nullopt);
    QWidget::focusOutEvent(event);
}

void BraceletView::hideEvent(QHideEvent* event) {
    hold(std::nullopt);
    QWidget::hideEvent(event);
}

} // namespace teleta::bracelet
