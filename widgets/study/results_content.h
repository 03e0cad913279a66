// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/study_results.h"
#include "widgets/study/interval_chart.h"
#include "widgets/study/result_table.h"

#include <QCoreApplication>
#include <QString>

#include <vector>

namespace teleta::studyview {

/// Header, explanations and rows of a table.
struct TableContent {
    QStringList header;
    QStringList tips;
    std::vector<std::vector<ResultCell>> rows;
};

/// What the pictures and tables of a task show. participant: empty for all together. Thread: any (pure).
class ResultsContent {
    Q_DECLARE_TR_FUNCTIONS(ResultsContent)

public:
    /// Share of right answers: the group's mean with its t interval, or a participant's with Wilson's.
    [[nodiscard]] static IntervalChartContent accuracy(const study::TaskResults& task,
                                                       const QString& participant);
    /// The same for each pattern, conditions side by side, with p of the comparison.
    [[nodiscard]] static IntervalChartContent patterns(const study::TaskResults& task,
                                                       const QString& participant);
    /// Median response times of right answers.
    [[nodiscard]] static IntervalChartContent times(const study::TaskResults& task,
                                                    const QString& participant);

    [[nodiscard]] static TableContent groups(const study::TaskResults& task);
    [[nodiscard]] static TableContent people(const study::TaskResults& task, const QString& participant);
    [[nodiscard]] static TableContent anova(const study::TaskResults& task);
    /// What a guesser would show, and how far the information transfer can be trusted.
    [[nodiscard]] static QString transferNote(const study::TaskResults& task);
    [[nodiscard]] static QString anovaNote(const study::TaskResults& task);
};

} // namespace teleta::studyview
