// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/touch/stiffness_gauge.h"

#include "widgets/base/controls/provenance_stripe.h"
#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"

#include <QPainter>

namespace teleta::touch {

StiffnessGauge::StiffnessGauge(QWidget* parent)
    : FigureView(parent, {24, 12.5}, {17, 11.2}) {
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
        m_content.emptyText = tr("Touch an object with the arm's skin: its stiffness appears here.");
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
    base::showProvenance(this, provenance);
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
    return {.name = tr("stiffness"),
            .size_px = QSizeF(size()),
            .paint =
                [content = m_content, size = QSizeF(size()), font = font()](QPainter& painter) {
                    paintGauge(painter, GaugeLayout(QRectF(QPointF(), size), font), font, content,
                               base::designedPalette(false));
                },
            .csv = [content = m_content] { return gaugeCsv(content); }};
}

void StiffnessGauge::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    paintGauge(painter, layoutNow(), font(), m_content, palette());
    base::paintFocusFrame(painter, *this);
}

} // namespace teleta::touch
