// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/touch/stiffness_gauge.h"

#include "widgets/base/focus_frame.h"
#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>

namespace teleta::touch {

StiffnessGauge::StiffnessGauge(QWidget* parent)
    : FigureView(parent) {
    base::keepTranslated(this, &StiffnessGauge::retranslate);
}

void StiffnessGauge::retranslate() {
    setAccessibleName(tr("Stiffness of the touched object"));
    setWhatsThis(
        tr("<p>How stiff the object is that was touched last, on a logarithmic scale. The dot is the "
           "estimate, the line through it the interval in which the stiffness lies with 95 %.</p>"
           "<p>An object that yields hardly more than the arm itself cannot be told from a rigid one: then "
           "an open arrow shows that its stiffness is at least so large.</p>"
           "<p>Sponge and rubber sponge are safe to touch; rubber, wood and metal are a danger.</p>"));
    if (m_defaultEmptyText)
        m_content.emptyText = tr("Touch an object with the forearm: its stiffness appears here.");
    shown();
}

void StiffnessGauge::shown() {
    setAccessibleDescription(GaugeTexts::spoken(m_content));
    update();
}

void StiffnessGauge::setTouch(const std::optional<stiffness::TouchStiffness>& touch) {
    m_content.touch = touch;
    m_content.refusal.reset();
    shown();
}

void StiffnessGauge::setRefusal(stiffness::Refusal refusal) {
    m_content.touch.reset();
    m_content.refusal = refusal;
    shown();
}

void StiffnessGauge::setProvenance(base::Provenance provenance) {
    m_content.provenance = provenance;
    update();
}

void StiffnessGauge::setEmptyText(const QString& text) {
    m_defaultEmptyText = false;
    m_content.emptyText = text;
    shown();
}

GaugeLayout StiffnessGauge::layoutNow() const {
    return {QRectF(rect()), font()};
}

QString StiffnessGauge::toolTipAt(const QPointF& point) const {
    const GaugeLayout layout = layoutNow();
    if (const auto band = layout.bandAt(point))
        return GaugeTexts::band(stiffness::materialBands()[*band]);
    return GaugeTexts::spoken(m_content);
}

base::Figure StiffnessGauge::figure() {
    base::Figure figure;
    figure.name = tr("stiffness");
    figure.size_px = QSizeF(size());
    figure.paint = [content = m_content, size = figure.size_px, font = font()](QPainter& painter) {
        paintGauge(painter, GaugeLayout(QRectF(QPointF(), size), font), font, content,
                   base::designedPalette(false));
    };
    figure.csv = [content = m_content] { return gaugeCsv(content); };
    return figure;
}

QSize StiffnessGauge::sizeHint() const {
    return {base::em(this, 24), base::em(this, 12.5)};
}

QSize StiffnessGauge::minimumSizeHint() const {
    return {base::em(this, 17), base::em(this, 11.2)};
}

bool StiffnessGauge::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        QToolTip::showText(help->globalPos(), toolTipAt(help->pos()), this);
        return true;
    }
    return QWidget::event(event);
}

void StiffnessGauge::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    paintGauge(painter, layoutNow(), font(), m_content, palette());
    base::paintFocusFrame(painter, *this);
}

} // namespace teleta::touch
