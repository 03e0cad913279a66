// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/servo/servo_link.h"

#include <QStringList>
#include <QWidget>

#include <array>
#include <optional>

namespace teleta::servo {

/// The features with desired and actual values and errors as a table, and below it the inverse tactile
/// Jacobian and the projection matrix, their nonzero elements filled. Rows whose error acts are bold.
/// Nothing: an empty table. Thread: GUI.
class ServoPicture : public QWidget {
    Q_OBJECT
public:
    explicit ServoPicture(QWidget* parent = nullptr);

    void setReport(const std::optional<ServoReport>& report);

    /// What a row of the table says: desired, actual, error; a dash for what is not defined.
    [[nodiscard]] std::array<QString, 3> featureTexts(int row) const;
    /// The rows of a matrix as they are drawn.
    [[nodiscard]] static QStringList matrixTexts(const Matrix6& matrix);

    /// The table's titles as they are drawn: cut, with an ellipsis, where the widget is too narrow for them.
    [[nodiscard]] std::array<QString, 4> shownTitles() const;

    /// Wide enough for all titles in the language of the moment.
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    struct Columns {
        std::array<double, 4> width_px{};
        double unit_px = 0.0;
    };

    [[nodiscard]] double lineHeight() const;
    [[nodiscard]] static std::array<QString, 4> titles();
    /// As wide as their content; what a width leaves over, or lacks, is shared. 0: as they want to be.
    [[nodiscard]] Columns columns(double width_px) const;
    /// columns: as wide as the widget shows them.
    [[nodiscard]] QRectF titleRect(const Columns& columns, std::size_t index) const;
    [[nodiscard]] std::array<QString, 4> shownTitles(const Columns& columns) const;
    void paintFeatures(QPainter& painter) const;
    void paintMatrix(QPainter& painter, const QRectF& rect, const QString& name, const Matrix6& matrix) const;
    void describe();

    std::optional<ServoReport> m_report;
};

} // namespace teleta::servo
