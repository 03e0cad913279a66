// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/base/figure_export.h"
#include "widgets/camera/residual_picture.h"

#include <QWidget>

namespace teleta::camera {

/// Residuals of a calibration on the image or on the unrolled cylinder. A click or the arrow keys choose a
/// pair, Delete excludes it or takes it back; Ctrl+C copies the picture. Thread: GUI.
class ResidualView : public QWidget {
    Q_OBJECT
public:
    explicit ResidualView(ResidualPicture::Surface surface, QWidget* parent = nullptr);

    void setPairs(const CalibratedPairs& pairs);
    void select(std::optional<std::size_t> pair);

    [[nodiscard]] const ResidualPicture& picture() const { return m_picture; }
    [[nodiscard]] base::Figure figure() const;
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

signals:
    void selected(std::size_t pair);
    void toggleRequested(std::size_t pair);
    void exported(const QString& path);
    void exportFailed(const QString& message);

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void retranslate();
    [[nodiscard]] QString wordsFor(std::size_t pair) const;

    ResidualPicture m_picture;
    base::FigureExport* m_export;
};

} // namespace teleta::camera
