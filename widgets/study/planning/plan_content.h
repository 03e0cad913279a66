// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/planning/power.h"
#include "backend/study/planning/study_truth.h"
#include "backend/study/planning/threshold_plan.h"
#include "backend/study/protocol/protocol.h"
#include "widgets/study/results/curve_picture.h"

#include <QCoreApplication>
#include <QString>

#include <optional>
#include <vector>

namespace teleta::study {

/// A test that can be planned for.
struct PlanTest {
    std::size_t task = 0; ///< in the protocol
    QString id;           ///< "shape:condition"
    QString name;
};

/// What to plan.
struct PlanRequest {
    QString test; ///< "shape:condition"
    PlanSettings settings;
    StudyTruth truth;
    std::optional<ThresholdWish> wish = {}; ///< of a threshold
};

/// Contents of the plan view. Thread: any (pure).
class PlanContent {
    Q_DECLARE_TR_FUNCTIONS(PlanContent)

public:
    /// The lines of the analyses of tasks in which patterns are told apart, and the thresholds of the others.
    [[nodiscard]] static std::vector<PlanTest> tests(const Protocol& protocol);
    /// Power, or the share of studies whose interval is narrow enough, over the number of participants, with
    /// Wilson's intervals and the target. test: as shown.
    [[nodiscard]] static CurveContent curve(const PowerPlan& plan, const PlanRequest& request,
                                            const QString& test);
    /// How many participants the test needs.
    [[nodiscard]] static QString answer(const PowerPlan& plan, const PlanSettings& settings);
};

} // namespace teleta::study
