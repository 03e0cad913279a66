// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pattern/motors/motor_model.h"
#include "backend/study/methods/felt/equal_strength.h"
#include "widgets/study/results/level_content.h"
#include "widgets/study/results/results_content.h"

#include <QCoreApplication>
#include <QString>

#include <optional>
#include <vector>

namespace teleta::study {

/// Two measurements of equal strength with different reference tactors, and where they contradict each other.
struct StrengthConflict {
    std::size_t reference = 0; ///< tactor of the other one
    std::vector<std::size_t> tactors;
};

/// What a task says of the bracelet: best onsets, levels that can be told apart, equal strength. Thread: any
/// (pure).
class BraceletContent {
    Q_DECLARE_TR_FUNCTIONS(BraceletContent)

public:
    /// Whether there is anything to show for the task.
    [[nodiscard]] static bool has(const LevelResults& results, const QString& task);
    [[nodiscard]] static TableContent onsets(const LevelResults& results, const QString& task,
                                             const ConditionNames& names);
    [[nodiscard]] static TableContent steps(const LevelResults& results, const QString& task);
    /// motors: null: no bracelet. balanced: empty where it cannot be balanced.
    [[nodiscard]] static TableContent strength(const EqualStrength& equal, double strongest,
                                               const pattern::MotorProfiles* motors,
                                               const std::optional<pattern::MotorProfiles>& balanced);
    /// The first measurement of equal strength of a task and a participant (empty: the mean); empty: none.
    [[nodiscard]] static std::optional<EqualStrength> equal(const LevelResults& results, const QString& task,
                                                            const QString& participant);
    /// What other measurements of the same people, in any task, say otherwise.
    [[nodiscard]] static std::vector<StrengthConflict> conflicts(const LevelResults& results,
                                                                 const QString& task,
                                                                 const QString& participant,
                                                                 const pattern::MotorProfiles& motors);
    [[nodiscard]] static QString conflictText(const std::vector<StrengthConflict>& conflicts);
};

} // namespace teleta::study
