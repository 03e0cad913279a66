// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contour/shape_recogniser.h"
#include "backend/core/device/arm_device.h"
#include "backend/stiffness/material.h"
#include "backend/stiffness/refusal.h"
#include "backend/stiffness/stiffness_estimator.h"

#include <QCoreApplication>
#include <QString>

#include <cstddef>
#include <optional>

namespace teleta::touch {

/// Words for what a touch tells, translated when they are asked for.
class TouchTexts {
    Q_DECLARE_TR_FUNCTIONS(TouchTexts)

public:
    [[nodiscard]] static QString material(stiffness::Material material);
    [[nodiscard]] static QString shape(contour::Shape shape);
    /// "circle (97 %)". confidence: 0 .. 1.
    [[nodiscard]] static QString shape(contour::Shape shape, double confidence);
    /// "circle (97 %)", or the candidates where the points do not decide: "circle (55 %) or rectangle (40
    /// %)".
    [[nodiscard]] static QString recognition(const contour::Recognition& recognition);
    /// "SAFE", "DANGER".
    [[nodiscard]] static QString safety(bool safe);
    [[nodiscard]] static QString method(stiffness::Method method);
    /// Why a touch has no stiffness, and what helps; a sentence.
    [[nodiscard]] static QString refusal(stiffness::Refusal refusal);
    /// What was seen, in a sentence.
    [[nodiscard]] static QString warning(stiffness::TouchWarning warning);
    /// All warnings of a touch, a line each.
    [[nodiscard]] static QString warnings(const stiffness::TouchStiffness& touch);
    /// "shoulder roll" ... "elbow pitch" of an arm with four joints, "joint 1" ... of any other.
    [[nodiscard]] static QString joint(std::size_t joint, std::size_t joints);
    [[nodiscard]] static QString drive(core::ArmDrive drive);

    /// Three significant digits with unit: "282 N/m", "7.22 kN/m".
    [[nodiscard]] static QString newtonPerMetre(double stiffness_NPerM, int moreDigits = 0);
    /// "1.25 kN/m", or "at least 34.7 kN/m (95 %)" when only a bound is known; a dash for neither.
    [[nodiscard]] static QString estimate(const stiffness::Stiffness& stiffness);
    /// The 95 % interval, "1.20 … 1.31 kN/m", with more digits where its ends would look the same; "1.20 kN/m
    /// … rigid" when rigid is not excluded; empty without one, when only a bound is known, or when its ends
    /// are the same.
    [[nodiscard]] static QString interval(const stiffness::Stiffness& stiffness);

    /// For files: NA where an estimate is not reliable; warnings separated by spaces.
    [[nodiscard]] static QString fileMaterial(const stiffness::TouchStiffness& touch);
    [[nodiscard]] static QString fileSafety(const stiffness::TouchStiffness& touch);
    [[nodiscard]] static QString fileLevel(const stiffness::TouchStiffness& touch);
    [[nodiscard]] static QString fileWarnings(const stiffness::TouchStiffness& touch);
    /// A value as exported files have it: all digits, a point, "NA" for none.
    [[nodiscard]] static QString fileNumber(const std::optional<double>& value);
};

} // namespace teleta::touch
