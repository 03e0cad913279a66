// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/analysis/study_results.h"
#include "backend/study/comparison/task_comparisons.h"
#include "widgets/study/results/interval_chart.h"
#include "widgets/study/results/result_table.h"

#include <QCoreApplication>
#include <QMap>
#include <QString>
#include <QStringList>

#include <optional>
#include <string>
#include <vector>

namespace teleta::study {

/// Names of conditions by id; others are called by their id.
using ConditionNames = QMap<QString, QString>;

/// Header, explanations and rows of a table.
struct TableContent {
    QStringList header;
    QStringList tips;
    std::vector<std::vector<ResultCell>> rows;
};

/// Whose results are shown: a group, and optionally a second one for comparison.
struct ShownPeople {
    QStringList group = {};                 ///< empty: all
    std::optional<QStringList> beside = {}; ///< a second group; empty list: all

    [[nodiscard]] bool isEverybody() const { return group.isEmpty() && !beside; }
    /// The groups in their order.
    [[nodiscard]] std::vector<QStringList> groups() const;
};

/// Contents of the pictures and tables of a task. Thread: any (pure).
class ResultsContent {
    Q_DECLARE_TR_FUNCTIONS(ResultsContent)

public:
    /// Share of right answers: a group's mean with its t interval, or a participant's share with Wilson's.
    [[nodiscard]] static IntervalChartContent
    accuracy(const TaskResults& task, const ShownPeople& people = {}, const ConditionNames& names = {});
    /// The same per pattern, conditions side by side, with p of the comparison if all participants are shown,
    /// and with Holm's if the comparisons are given.
    [[nodiscard]] static IntervalChartContent patterns(const TaskResults& task,
                                                       const ShownPeople& people = {},
                                                       const ConditionNames& names = {},
                                                       const TaskComparisons* comparisons = nullptr);
    /// Median response times of right answers.
    [[nodiscard]] static IntervalChartContent times(const TaskResults& task, const ShownPeople& people = {},
                                                    const ConditionNames& names = {});
    /// Test trials of a group under a condition; empty group: all.
    [[nodiscard]] static ConfusionMatrix matrix(const TaskResults& task, const std::string& condition,
                                                const QStringList& group);
    /// "all participants", "P01, P02", "5 participants".
    [[nodiscard]] static QString nameOf(const QStringList& group);

    [[nodiscard]] static TableContent groups(const TaskResults& task, const ConditionNames& names = {});
    [[nodiscard]] static TableContent people(const TaskResults& task, const ShownPeople& shown = {},
                                             const ConditionNames& names = {});
    [[nodiscard]] static TableContent anova(const TaskResults& task);
    /// What guessing would give, and how far the information transfer can be trusted.
    [[nodiscard]] static QString transferNote(const TaskResults& task);
    [[nodiscard]] static QString anovaNote(const TaskResults& task);

private:
    /// What to know about the intervals of a group.
    [[nodiscard]] static ResultCell groupRemark(const GroupSummary& group);
};

} // namespace teleta::study
