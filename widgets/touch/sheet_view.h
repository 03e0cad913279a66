// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/base/controls/badge.h"
#include "widgets/base/figure/figure_export.h"

#include <QWidget>

class QAbstractItemModel;
class QKeyEvent;
class QLabel;
class QMenu;
class QTableView;

namespace teleta::touch {

/// A table under a line with its count; an empty table shows a hint. Ctrl+C copies, the
/// context menu offers the rest. Thread: GUI.
class SheetView : public QWidget {
    Q_OBJECT
public:
    virtual void setProvenance(base::Provenance provenance);
    [[nodiscard]] QTableView* view() const { return m_view; }
    virtual void populateMenu(QMenu& menu) = 0;

    [[nodiscard]] QSize sizeHint() const override;

signals:
    void exported(const QString& path);
    void exportFailed(const QString& message);

protected:
    explicit SheetView(QWidget* parent);

    /// Shows a model and writes the texts; the last step of a constructor.
    void start(QAbstractItemModel* model);
    void setHint(const QString& text);
    /// Makes columns as wide as their title or their widest cell in sight, whichever is wider. While rows
    /// come in, they only grow.
    void fitColumns();
    void addDataActions(QMenu& menu) { m_export->addDataActions(menu); }
    [[nodiscard]] base::Provenance provenance() const { return m_provenance; }

    /// Text of the line above the table.
    [[nodiscard]] virtual QString title() const = 0;
    [[nodiscard]] virtual base::Figure figure() const = 0;
    virtual void copy() const = 0;
    virtual void retranslate() = 0;
    virtual void restyle();
    /// Returns whether the key was used.
    virtual bool onKey(const QKeyEvent& key);

    void paintEvent(QPaintEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void showEmptiness();
    void growColumns();
    [[nodiscard]] int fittingWidth(int column) const;

    QTableView* m_view;
    QLabel* m_empty;
    base::Provenance m_provenance = base::Provenance::live;
    base::FigureExport* m_export;
    bool m_isFitDue = false;
};

} // namespace teleta::touch
