// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/base/figure/picture_view.h"
#include "widgets/camera/gel/gel_picture.h"

namespace teleta::camera {

/// The picture of a flat gel. Space freezes it; hovering describes a contact. Thread: GUI.
class GelView : public base::PictureView<GelPicture> {
    Q_OBJECT
public:
    explicit GelView(QWidget* parent = nullptr);

    /// Shows the newest snapshot unless the picture is frozen; null clears.
    void setSnapshot(const pipeline::GelSnapshot* snapshot);
    void setArrowsShown(bool shown);
    void setEnlargement(double factor);
    void setPaused(bool paused);

    [[nodiscard]] base::Figure figure() override;

signals:
    void pauseRequested(bool paused);
    void referenceRequested();

protected:
    [[nodiscard]] QString toolTipAt(const QPointF& point) const override;
    void keyPressEvent(QKeyEvent* event) override;
    void addOwnActions(QMenu& menu, const QPoint& position) override;

private:
    void retranslate();
};

} // namespace teleta::camera
