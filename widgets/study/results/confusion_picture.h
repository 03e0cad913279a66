// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/analysis/confusion_matrix.h"
#include "backend/study/protocol/trial.h"

#include <QPalette>
#include <QRectF>
#include <QString>
#include <QStringList>

#include <optional>
#include <utility>

class QPainter;

namespace teleta::study {

/// A confusion matrix with everything that its picture shows.
struct ConfusionContent {
    ConfusionMatrix matrix{1};
    QStringList letters; ///< one per pattern; empty: only the title is shown
    QString title;
    Mode mode = Mode::run;
    bool percent = false;                                    ///< shares of the rows instead of counts
    std::optional<std::pair<std::size_t, std::size_t>> last; ///< cell of the newest trial
    friend bool operator==(const ConfusionContent&, const ConfusionContent&) = default;
};

/// Layout of the cells. Thread: any (pure).
struct ConfusionLayout {
    ConfusionLayout(const QRectF& rect, double em, std::size_t rows, std::size_t columns);

    [[nodiscard]] QRectF cell(std::size_t row, std::size_t column) const;
    [[nodiscard]] std::optional<std::pair<std::size_t, std::size_t>> cellAt(const QPointF& at) const;

    double em = 16.0;
    std::size_t rows = 1;
    std::size_t columns = 1;
    QRectF grid;
};

/// Layout of the paper's tables: rows presented, columns answered, the last one NONE; the larger the share of
/// the row, the darker. Each row ends with its number of trials.
void paintConfusion(QPainter& painter, const QRectF& rect, const ConfusionContent& content,
                    const QPalette& palette);

/// stimulus,response,count,row_total; C locale.
[[nodiscard]] QString confusionCsv(const ConfusionContent& content);

} // namespace teleta::study
