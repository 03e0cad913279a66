// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/base/figure/picture_view.h"
#include "widgets/camera/residual_picture.h"

namespace teleta::camera {

/// Residuals of a calibration on the image or on the unrolled cylinder. A click or the arrow keys select a
/// pair, Delete excludes or includes it. Thread: GUI.
class ResidualView : public base::PictureView<ResidualPicture> {
    Q_OBJECT
public:
    explicit ResidualView(ResidualPicture::Surface surface, QWidget* parent = nullptr);

    void setPairs(const CalibratedPairs& pairs);
    void select(std::optional<std::size_t> pair);

    [[nodiscard]] base::Figure figure() override;

signals:
    void selected(std::size_t pair);
    void toggleRequested(std::size_t pair);

protected:
    [[nodiscard]] QString toolTipAt(const QPointF& point) const override;
    void mousePressEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void addOwnActions(QMenu& menu, const QPoint& position) override;

private:
    void retranslate();
    [[nodiscard]] QString wordsFor(std::size_t pair) const;
};

} // namespace teleta::camera
