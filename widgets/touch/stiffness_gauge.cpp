// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/touch/stiffness_gauge.h"

#include "widgets/base/controls/provenance_stripe.h"
#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"

#include <QPainter>

namespace teleta::touch {

namespace {

/// A picture is looked at later.
GaugeContent withoutAge(GaugeContent content) {
    content.age_s.reset();
    return content;
}

} // namespace

StiffnessGauge::StiffnessGauge(QWidget* parent)
    : FigureView(parent, {24, 12.5}, {17, 5.2}) {
    base::keepTranslated(this, &StiffnessGauge::retranslate);
}

void StiffnessGauge::retranslate() {
    setAccessibleName(tr("Stiffness of the touched object"));
    setWhatsThis(
        tr("<p>How stiff the object is that was touched last, on a logarithmic scale. The dot is the "
           "estimate, the line through it the interval in which the stiffness lies with 95 %.</p>"
           "<p>An object that yields hardly more than the arm itself cannot be told from a rigid one: then "
           "an open arrow shows that its stiffness is at least so large.</p>"
           "<p>Sponge and rubber sponge are safe to touch; rubber, wood and metal are a danger.</p>") +
        tr("<p>Below the word stands how long ago the touch was. After half a minute it is stale: the arm "
           "may be elsewhere by then.</p>"));
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
    m_content.age_s.reset();
    shown();
}

void StiffnessGauge::setRefusal(stiffness::Refusal refusal) {
    m_content.touch.reset();
    m_content.refusal = refusal;
    m_content.age_s.reset();
    shown();
}

void StiffnessGauge::setAge(std::optional<double> age_s) {
    const QString before = GaugeTexts::age(m_content);
    m_content.age_s = age_s;
    if (before != GaugeTexts::age(m_content))
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
                [content = withoutAge(m_content), size = QSizeF(size()), font = font()](QPainter& painter) {
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
