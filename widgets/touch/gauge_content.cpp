// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/touch/gauge_content.h"

#include "widgets/base/controls/status_glyph.h"
#include "widgets/touch/touch_texts.h"

#include <QStringList>

#include <algorithm>
#include <cmath>

namespace teleta::touch {

QString GaugeTexts::headline(const GaugeContent& content) {
    return content.touch ? TouchTexts::estimate(content.touch->object) : tr("no stiffness");
}

QString GaugeTexts::material(const stiffness::TouchStiffness& touch) {
    if (!touch.materialKnown())
        return tr("cannot tell");
    const QString name = TouchTexts::material(touch.material);
    const int level = stiffness::level(touch.material);
    if (touch.materialCertain)
        return tr("%1, level %2").arg(name).arg(level);
    if (touch.object.onlyBound())
        return tr("taken as %1, level %2").arg(name).arg(level);
    return tr("%1, level %2, not certain").arg(name).arg(level);
}

QString GaugeTexts::details(const GaugeContent& content) {
    if (content.refusal)
        return TouchTexts::refusal(*content.refusal);
    if (!content.touch)
        return {};
    const stiffness::TouchStiffness& touch = *content.touch;
    const QString samples = tr("%n sample(s)", nullptr, static_cast<int>(touch.samples));
    const QString basis = tr("%1, %2").arg(TouchTexts::method(touch.method), samples);
    const QString interval = TouchTexts::interval(touch.object);
    if (!interval.isEmpty())
        return tr("95 %: %1   %2").arg(interval, basis);
    if (touch.object.onlyBound())
        return tr("not told from rigid   %1").arg(basis);
    return tr("no interval known   %1").arg(basis);
}

QString GaugeTexts::warning(const GaugeContent& content) {
    if (!content.touch)
        return {};
    if (!content.touch->stifferThanLink)
        return TouchTexts::warnings(*content.touch);
    return tr("Stiffer than the link allows: check contact distance and link stiffness.");
}

QString GaugeTexts::band(const stiffness::MaterialBand& band) {
    const QString name = TouchTexts::material(band.material);
    const QString safety = TouchTexts::safety(stiffness::isSafe(band.material));
    const QString typical = TouchTexts::newtonPerMetre(band.typical_NPerM);
    const QString last = tr("level %1, %2, the paper's object %3")
                             .arg(stiffness::level(band.material))
                             .arg(safety, band.upper_NPerM ? typical : tr("rigid"));
    if (!band.upper_NPerM)
        return tr("%1: from %2\n%3").arg(name, TouchTexts::newtonPerMetre(band.lower_NPerM), last);
    const QString upper = TouchTexts::newtonPerMetre(*band.upper_NPerM);
    if (band.lower_NPerM <= 0.0)
        return tr("%1: under %2\n%3").arg(name, upper, last);
    return tr("%1: %2 to %3\n%4").arg(name, TouchTexts::newtonPerMetre(band.lower_NPerM), upper, last);
}

bool GaugeTexts::isStale(const GaugeContent& content) {
    return (content.touch || content.refusal) && content.age_s && *content.age_s >= kStale_s;
}

QString GaugeTexts::age(const GaugeContent& content) {
    if ((!content.touch && !content.refusal) || !content.age_s)
        return {};
    const double seconds = std::floor(std::max(0.0, *content.age_s));
    const QString age = seconds < 10.0 ? tr("%1 s").arg(seconds, 0, 'f', 0) : base::ageText(seconds);
    return isStale(content) ? tr("stale, %1 ago").arg(age) : tr("%1 ago").arg(age);
}

QString GaugeTexts::spoken(const GaugeContent& content) {
    if (!content.touch)
        return content.refusal ? tr("No stiffness. %1").arg(TouchTexts::refusal(*content.refusal))
                               : content.emptyText;
    QStringList parts{headline(content), material(*content.touch), details(content)};
    if (const QString old = age(content); !old.isEmpty())
        parts.prepend(old);
    if (content.touch->materialKnown())
        parts.prepend(TouchTexts::safety(stiffness::isSafe(content.touch->material)));
    if (const QString suspicious = warning(content); !suspicious.isEmpty())
        parts << suspicious;
    return parts.join(QStringLiteral("; "));
}

QString gaugeCsv(const GaugeContent& content) {
    if (!content.touch)
        return {};
    const stiffness::TouchStiffness& t = *content.touch;
    const QStringList row{
        QString::fromLatin1(stiffness::toString(t.method)),
        QString::number(t.samples),
        TouchTexts::fileNumber(t.deltaTheta_rad),
        TouchTexts::fileNumber(t.deltaTorque_Nm),
        TouchTexts::fileNumber(t.total.value_NPerM),
        TouchTexts::fileNumber(t.total.se_NPerM),
        TouchTexts::fileNumber(t.object.value_NPerM),
        TouchTexts::fileNumber(t.object.lower95_NPerM),
        TouchTexts::fileNumber(t.object.upper95_NPerM),
        TouchTexts::fileMaterial(t),
        TouchTexts::fileSafety(t),
        TouchTexts::fileLevel(t),
        t.reliable ? QStringLiteral("true") : QStringLiteral("false"),
        TouchTexts::fileWarnings(t),
    };
    return QStringLiteral("method,samples,delta_theta_rad,delta_torque_nm,total_stiffness_n_per_m,"
                          "total_stiffness_se,object_stiffness_n_per_m,object_stiffness_lower_95,"
                          "object_stiffness_upper_95,material,safe,level,reliable,warnings\n") +
           row.join(u',') + u'\n';
}

} // namespace teleta::touch
