// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/servo/servo_link.h"

#include <QStringList>
#include <QWidget>

#include <array>
#include <optional>

namespace teleta::servo {

/// A table of the features with desired and actual values and errors, and below it the inverse tactile
/// Jacobian and the projection matrix with their nonzero elements filled. Rows whose error is controlled are
/// bold. Without a report the table is empty. Thread: GUI.
class ServoPicture : public QWidget {
    Q_OBJECT
public:
    explicit ServoPicture(QWidget* parent = nullptr);

    void setReport(const std::optional<ServoReport>& report);
    /// Whether the matrices are below the table; at first they are not.
    void showMatrices(bool shown);

    /// Texts of a row: desired, actual, error; a dash for undefined values.
    [[nodiscard]] std::array<QString, 3> featureTexts(int row) const;
    /// The rows of a matrix as they are drawn.
    [[nodiscard]] static QStringList matrixTexts(const Matrix6& matrix);

    /// Titles of the table as drawn, shortened with an ellipsis where the widget is too narrow.
    [[nodiscard]] std::array<QString, 4> shownTitles() const;

    /// Wide enough for all titles in the current language.
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
    /// Widths of the columns for a total width; excess or missing width is shared. 0: their preferred widths.
    [[nodiscard]] Columns columns(double width_px) const;
    /// columns: widths as shown.
    [[nodiscard]] QRectF titleRect(const Columns& columns, std::size_t index) const;
    [[nodiscard]] std::array<QString, 4> shownTitles(const Columns& columns) const;
    void paintFeatures(QPainter& painter) const;
    void paintMatrix(QPainter& painter, const QRectF& rect, const QString& name, const Matrix6& matrix) const;
    void describe();

    std::optional<ServoReport> m_report;
    bool m_hasMatrices = false;
};

} // namespace teleta::servo
