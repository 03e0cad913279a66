// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pipeline/touch/touch_record.h"
#include "widgets/base/figure/picture_view.h"
#include "widgets/touch/contour_picture.h"

namespace teleta::touch {

/// The explored contour from above, to scale: contact points in the order of touch, the spline through them,
/// the vertices or the circle of the recognised shape, with its measures and confidence. x to the right, y
/// up, in mm. Ctrl+C copies the picture. Thread: GUI.
class ContourView : public base::PictureView<ContourPicture> {
    Q_OBJECT
public:
    explicit ContourView(QWidget* parent = nullptr);

    void setContour(const pipeline::ExploredContour& contour);
    void clear();

    [[nodiscard]] base::Figure figure() override;

signals:
    /// The user asks to start again with another object.
    void forgetRequested();

protected:
    void addOwnActions(QMenu& menu, const QPoint& position) override;

private:
    void retranslate();
    void shown();
};

} // namespace teleta::touch
