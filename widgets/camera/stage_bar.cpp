// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/camera/stage_bar.h"

#include "widgets/base/colour_maps.h"
#include "widgets/base/numbers/quantity_text.h"
#include "widgets/base/numbers/tabular_text.h"
#include "widgets/base/theme.h"

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <numeric>

namespace teleta::camera {

namespace {

constexpr double kAveraging = 0.05; ///< weight of the newest frame
constexpr double kBar_em = 0.6;
constexpr double kHeight_em = 2.4;

} // namespace

StageBar::StageBar(QWidget* parent)
    : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void StageBar::setSnapshot(const pipeline::CameraSnapshot* snapshot, double nominalRate_Hz) {
    if (snapshot == nullptr) {
        m_rung.reset();
        update();
        return;
    }
    const bool first = m_rung != std::string(snapshot->rung);
    const auto average = [&](double& average_ms, std::int64_t time_ns) {
        const double time_ms = 1e-6 * static_cast<double>(time_ns);
        average_ms = first ? time_ms : average_ms + kAveraging * (time_ms - average_ms);
    };
    // Taking a reference does not find contacts.
    if (snapshot->usable && snapshot->whole_ns > 0) {
        m_rung = std::string(snapshot->rung);
        for (std::size_t i = 0; i < m_stage_ms.size(); ++i)
            average(m_stage_ms[i], snapshot->stage_ns[i]);
        average(m_whole_ms, snapshot->whole_ns);
    }
    const double rate_Hz = nominalRate_Hz > 0.0 ? nominalRate_Hz : snapshot->processed_Hz;
    m_period_ms = rate_Hz > 0.0 ? 1e3 / rate_Hz : 0.0;
    m_passedOver = snapshot->passedOver;
    m_unusable = snapshot->unusable;
    m_wholeShown.update(m_whole_ms);
    m_rateShown.update(snapshot->processed_Hz);
    setAccessibleName(text());
    update();
}

QString StageBar::nameOf(std::size_t stage) {
    static constexpr std::array<const char*, vision::kFinderStages> kNames{
        QT_TR_NOOP("prepare"), QT_TR_NOOP("displacement"), QT_TR_NOOP("segment"), QT_TR_NOOP("locate")};
    return tr(kNames[stage]);
}

QStringList StageBar::parts() const {
    if (!m_rung)
        return {};
    QStringList parts{
        tr("%1 ms per frame, %2 frames/s").arg(m_wholeShown.text().trimmed(), m_rateShown.text().trimmed())};
    parts << tr("%n skipped", nullptr, static_cast<int>(m_passedOver));
    if (m_unusable > 0)
        parts << tr("%n unusable", nullptr, static_cast<int>(m_unusable));
    return parts;
}

QString StageBar::text() const {
    return parts().join(QStringLiteral(" \u00b7 "));
}

QString StageBar::shownText() const {
    const QFontMetricsF metrics(base::sized(font(), base::kSmallText));
    QStringList shown = parts();
    while (shown.size() > 1 &&
           base::tabularWidth(metrics, shown.join(QStringLiteral(" \u00b7 "))) + 2.0 > width())
        shown.removeLast();
    return shown.join(QStringLiteral(" \u00b7 "));
}

QSize StageBar::sizeHint() const {
    return {base::em(this, 24), base::em(this, kHeight_em)};
}

bool StageBar::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip)
        return QWidget::event(event);
    QStringList lines;
    if (m_rung)
        lines << text();
    for (std::size_t i = 0; i < m_stage_ms.size() && m_rung; ++i)
        lines << tr("%1: %2 ms", "stage of a computation and its time")
                     .arg(nameOf(i))
                     .arg(base::fixedDigits(m_stage_ms[i], 2));
    QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), lines.join(QLatin1Char('\n')), this);
    return true;
}

void StageBar::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const bool dark = base::isDark(palette());
    const double bar = base::em(this, kBar_em);
    const QRectF all(0.0, 0.0, width(), bar);
    painter.fillRect(all,
                     base::mixed(palette().color(QPalette::Base), palette().color(QPalette::Text), 0.12));
    if (!m_rung)
        return;
    const double sum_ms = std::accumulate(m_stage_ms.begin(), m_stage_ms.end(), 0.0);
    const double full_ms = std::max({m_period_ms, sum_ms, 1e-6});
    double left = 0.0;
    QFont small = base::sized(font(), base::kSmallText);
    const QFontMetricsF metrics(small);
    double legendLeft = 0.0;
    painter.setFont(small);
    const double line = base::em(this, kHeight_em) - bar;
    // The important text keeps its place at the right end.
    const QString summary = shownText();
    const double summaryWidth = base::tabularWidth(metrics, summary);
    const QRectF summaryRect(std::max(0.0, width() - summaryWidth - 2.0), bar, summaryWidth + 2.0, line);
    for (std::size_t i = 0; i < m_stage_ms.size(); ++i) {
        const double width_px = m_stage_ms[i] / full_ms * width();
        const QColor colour = base::identityColour(static_cast<int>(i) + 1, dark);
        painter.fillRect(QRectF(left, 0.0, width_px, bar), colour);
        left += width_px;
        const QString name = nameOf(i);
        const double nameWidth = metrics.horizontalAdvance(name) + 1.8 * metrics.height();
        if (legendLeft + nameWidth < summaryRect.left()) {
            const double dot = 0.5 * metrics.height();
            painter.fillRect(QRectF(legendLeft, bar + 0.5 * (line - dot), dot, dot), colour);
            painter.setPen(palette().color(QPalette::WindowText));
            painter.drawText(QRectF(legendLeft + 1.5 * dot, bar, nameWidth, line), Qt::AlignVCenter, name);
            legendLeft += nameWidth;
        }
    }
    painter.setPen(palette().color(QPalette::WindowText));
    base::drawTabularText(painter, summaryRect, Qt::AlignVCenter | Qt::AlignLeft, summary);
}

} // namespace teleta::camera
