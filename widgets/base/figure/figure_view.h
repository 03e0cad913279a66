// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/base/figure/figure_export.h"
#include "widgets/base/figure/sized_view.h"

#include <QPoint>

class QMenu;

namespace teleta::base {

/// A self-painted view whose picture and data can be copied and saved: Ctrl+C copies the picture, the context
/// menu offers the rest. It takes the focus and has the background of text fields. Thread: GUI.
class FigureView : public SizedView {
    Q_OBJECT
public:
    /// The picture on white with its data; independent of later changes to the view.
    [[nodiscard]] virtual Figure figure() = 0;
    /// Fills the context menu. position: of the click, in the view.
    void populateMenu(QMenu& menu, const QPoint& position = {});

signals:
    void exported(const QString& path);
    void exportFailed(const QString& message);

protected:
    explicit FigureView(QWidget* parent, QSizeF usual_em = {}, QSizeF smallest_em = {});

    /// Text of the tool tip at a point of the view; empty: none.
    [[nodiscard]] virtual QString toolTipAt(const QPointF& point) const;
    /// Adds the actions that copy and save.
    void addFigureActions(QMenu& menu) { m_export.addActions(menu); }
    /// Adds the view's own actions, above those that copy and save.
    virtual void addOwnActions(QMenu& menu, const QPoint& position);
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    FigureExport m_export;
};

} // namespace teleta::base
