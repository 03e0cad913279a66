// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pipeline/touch/touch_record.h"
#include "widgets/base/figure_export.h"
#include "widgets/touch/contour_picture.h"

#include <QString>
#include <QWidget>

class QMenu;

namespace teleta::touch {

/// The explored contour from above, to scale: contact points in the order of touch, the spline through them,
/// the vertices or the circle of the recognised shape, with its measures and confidence. x to the right, y
/// up, in mm. Ctrl+C copies the picture. Thread: GUI.
class ContourView : public QWidget {
    Q_OBJECT
public:
    explicit ContourView(QWidget* parent = nullptr);

    void setContour(const pipeline::ExploredContour& contour);
    void clear();
    void setProvenance(base::Provenance provenance);

    [[nodiscard]] const ContourPicture& picture() const { return m_picture; }
    [[nodiscard]] base::Figure figure() const;
    void populateMenu(QMenu& menu);

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

signals:
    void exported(const QString& path);
    void exportFailed(const QString& message);
    /// The user asks to begin anew with another object.
    void forgetRequested();

protected:
    void paintEvent(QPaintEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void retranslate();
    void shown();

    ContourPicture m_picture;
    base::FigureExport* m_export;
};

} // namespace teleta::touch
