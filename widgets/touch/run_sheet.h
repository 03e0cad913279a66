// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pipeline/touch/found_objects.h"
#include "widgets/base/controls/badge.h"
#include "widgets/base/figure_export.h"
#include "widgets/touch/run_sheet_model.h"

#include <QWidget>

#include <vector>

class QLabel;
class QMenu;
class QTableView;

namespace teleta::touch {

/// The objects that the operator has found, one a row. F2 or a double click names one, Delete takes the
/// selected ones off the sheet, Ctrl+Z brings them back, Ctrl+C copies. Thread: GUI.
class RunSheet : public QWidget {
    Q_OBJECT
public:
    explicit RunSheet(QWidget* parent = nullptr);

    void setObjects(const std::vector<pipeline::FoundObject>& objects) {
        m_model->setObjects(objects);
        showEmptiness();
    }
    void clear();
    void setProvenance(base::Provenance provenance);

    [[nodiscard]] RunSheetModel& model() { return *m_model; }
    [[nodiscard]] QTableView* view() const { return m_view; }
    /// All rows as CSV.
    [[nodiscard]] QString csv() const { return runSheetText(*m_model, m_provenance); }
    void removeSelected();
    /// Of the current object, whichever of its columns is the current one.
    void editName();
    void undo();
    void redo();
    void populateMenu(QMenu& menu);

    [[nodiscard]] QSize sizeHint() const override;

signals:
    void exported(const QString& path);
    void exportFailed(const QString& message);

protected:
    void paintEvent(QPaintEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    bool onKey(const QKeyEvent& key);
    [[nodiscard]] bool isOwnKey(const QKeyEvent& key) const;
    void retranslate();
    void restyle();
    void showEmptiness();
    void showHint();

    RunSheetModel* m_model;
    QTableView* m_view;
    QLabel* m_empty;
    base::Provenance m_provenance = base::Provenance::live;
    base::FigureExport* m_export;
};

} // namespace teleta::touch
