// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/touch/touch_texts.h"

#include "backend/core/number_text.h"
#include "widgets/base/numbers/quantity_text.h"

#include <QStringList>

#include <array>
#include <cmath>
#include <vector>

namespace teleta::touch {

using contour::Shape;
using core::ArmDrive;
using stiffness::Material;
using stiffness::Method;
using stiffness::Refusal;
using stiffness::TouchWarning;

namespace {
constexpr QChar kNoBreakSpace(0x00a0);
constexpr int kMostDigitsMore = 4;
} // namespace

QString TouchTexts::material(Material material) {
    static constexpr std::array kNames{QT_TR_NOOP("sponge"), QT_TR_NOOP("rubber sponge"),
                                       QT_TR_NOOP("rubber"), QT_TR_NOOP("wood"), QT_TR_NOOP("metal")};
    return tr(kNames[static_cast<std::size_t>(material)]);
}

QString TouchTexts::shape(Shape shape) {
    static constexpr std::array kNames{
        QT_TR_NOOP("circle"), QT_TR_NOOP("rectangle"), QT_TR_NOOP("triangle"),     QT_TR_NOOP("arc"),
        QT_TR_NOOP("line"),   QT_TR_NOOP("point"),     QT_TR_NOOP("unknown shape")};
    static_assert(kNames.size() == contour::kShapes);
    return tr(kNames[static_cast<std::size_t>(shape)]);
}

QString TouchTexts::shape(Shape shape, double confidence) {
    return tr("%1 (%2 %)", "a recognised shape and its confidence")
        .arg(TouchTexts::shape(shape))
        .arg(std::lround(100.0 * confidence));
}

QString TouchTexts::recognition(const contour::Recognition& recognition) {
    const std::vector<Shape> candidates = recognition.candidates();
    QString text;
    if (candidates.size() == 1)
        return shape(candidates.front(), recognition.confidence);
    for (const Shape candidate : candidates) {
        const QString one = shape(candidate, recognition.probability[static_cast<std::size_t>(candidate)]);
        text = text.isEmpty() ? one : tr("%1 or %2", "recognised shapes").arg(text, one);
    }
    return text;
}

QString TouchTexts::safety(bool safe) {
    return safe ? tr("SAFE") : tr("DANGER");
}

QString TouchTexts::method(Method method) {
    return method == Method::twoPoint ? tr("two points") : tr("regression");
}

QString TouchTexts::refusal(Refusal refusal) {
    switch (refusal) {
    case Refusal::notFinite:
    case Refusal::outOfRange:
        return tr("The readings of angle or torque are not usable numbers. Check the arm's sensors.");
    case Refusal::notPositive:
        return tr("The joint that presses feels nothing of a touch on its axis or along it, or the link's "
                  "stiffness is not set. Touch from another side.");
    case Refusal::negativeUncertainty:
        return tr("The noise of the arm's readings is set below zero.");
    case Refusal::badWindow:
        return tr("The torque window is empty: its upper end must lie above its lower end.");
    case Refusal::noSamples:
        return tr("No joint samples came in during the touch.");
    case Refusal::windowNotReached:
        return tr("The joint that presses felt too little: its torque did not reach the torque window. "
                  "Press harder, or from another side.");
    case Refusal::tooFewSamples:
        return tr(
            "The touch was too quick: fewer than 20 independent samples lie in the torque window. Press "
            "slower.");
    case Refusal::torqueUnchanged:
        return tr("The torque did not change within the torque window. Press with rising force.");
    case Refusal::angleOpposesTorque:
        return tr("The joint turned against the rising torque: the object moved, or a sign is wrong.");
    case Refusal::tooQuick:
        return tr("The touch was too quick: the arm's own inertia was felt with the object. Press slower.");
    case Refusal::noTorques:
        return tr("The arm measures no joint torques, so the touch has a place but no stiffness.");
    }
    return {};
}

QString TouchTexts::warning(TouchWarning warning) {
    switch (warning) {
    case TouchWarning::correlatedNoise:
        return tr("The noise is correlated; the interval allows for it.");
    case TouchWarning::coarseTorque:
        return tr("One step of the torque reading is over a tenth of the window.");
    case TouchWarning::coarseAngle:
        return tr("One step of the angle reading is over a tenth of the rotation.");
    case TouchWarning::torqueOffset:
        return tr("The free joint has a torque; it was taken off.");
    case TouchWarning::torqueDrift:
        return tr("The torque of the free joint changes; the change was taken off.");
    case TouchWarning::nonlinear:
        return tr("The stiffness changes within the torque window.");
    case TouchWarning::rateDependent:
        return tr("The force depends on how quickly the object is pressed.");
    case TouchWarning::stickSlip:
        return tr("The torque jumps or falls back, or the joint has play.");
    }
    return {};
}

QString TouchTexts::warnings(const stiffness::TouchStiffness& touch) {
    QStringList lines;
    for (const TouchWarning seen : touch.warnings)
        lines << warning(seen);
    return lines.join(u'\n');
}

QString TouchTexts::joint(std::size_t joint, std::size_t joints) {
    if (joints != 4 || joint >= joints)
        return tr("joint %1").arg(joint + 1);
    return std::array{tr("shoulder roll"), tr("shoulder pitch"), tr("shoulder yaw"),
                      tr("elbow pitch")}[joint];
}

QString TouchTexts::drive(ArmDrive drive) {
    static constexpr std::array kNames{QT_TR_NOOP("stopped"), QT_TR_NOOP("held"), QT_TR_NOOP("program"),
                                       QT_TR_NOOP("jog")};
    return tr(kNames[static_cast<std::size_t>(drive)]);
}

QString TouchTexts::newtonPerMetre(double stiffness_NPerM, int moreDigits) {
    return base::siText(stiffness_NPerM, tr("N/m"), moreDigits);
}

QString TouchTexts::estimate(const stiffness::Stiffness& stiffness) {
    if (stiffness.value_NPerM)
        return newtonPerMetre(*stiffness.value_NPerM);
    if (stiffness.lower95_NPerM)
        return tr("at least %1 (95 %)").arg(newtonPerMetre(*stiffness.lower95_NPerM));
    return QString(QChar(0x2014));
}

QString TouchTexts::interval(const stiffness::Stiffness& stiffness) {
    if (stiffness.onlyBound() || !stiffness.lower95_NPerM)
        return {};
    QString low = newtonPerMetre(*stiffness.lower95_NPerM);
    if (!stiffness.upper95_NPerM)
        return tr("%1 … rigid").arg(low);
    QString high = newtonPerMetre(*stiffness.upper95_NPerM);
    for (int more = 1; low == high && more <= kMostDigitsMore; ++more) {
        low = newtonPerMetre(*stiffness.lower95_NPerM, more);
        high = newtonPerMetre(*stiffness.upper95_NPerM, more);
    }
    if (low == high)
        return {};
    const auto unitOf = [](const QString& text) { return text.section(kNoBreakSpace, 1); };
    return tr("%1 … %2").arg(unitOf(low) == unitOf(high) ? low.section(kNoBreakSpace, 0, 0) : low, high);
}

QString TouchTexts::fileMaterial(const stiffness::TouchStiffness& touch) {
    return touch.materialKnown() ? QString::fromLatin1(stiffness::toString(touch.material))
                                 : QStringLiteral("NA");
}

QString TouchTexts::fileSafety(const stiffness::TouchStiffness& touch) {
    if (!touch.materialKnown())
        return QStringLiteral("NA");
    return stiffness::isSafe(touch.material) ? QStringLiteral("true") : QStringLiteral("false");
}

QString TouchTexts::fileLevel(const stiffness::TouchStiffness& touch) {
    return touch.materialKnown() ? QString::number(stiffness::level(touch.material)) : QStringLiteral("NA");
}

QString TouchTexts::fileWarnings(const stiffness::TouchStiffness& touch) {
    QStringList names;
    for (const TouchWarning seen : touch.warnings)
        names << QString::fromLatin1(stiffness::toString(seen));
    return names.isEmpty() ? QStringLiteral("NA") : names.join(u' ');
}

QString TouchTexts::fileNumber(const std::optional<double>& value) {
    if (!value || std::isnan(*value))
        return QStringLiteral("NA");
    const core::NumberText text(*value);
    return QString::fromLatin1(text.view().data(), static_cast<qsizetype>(text.view().size()));
}

} // namespace teleta::touch
