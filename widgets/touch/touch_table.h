// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pipeline/touch/touch_record.h"
#include "widgets/base/controls/badge.h"
#include "widgets/base/figure_export.h"
#include "widgets/touch/touch_model.h"

#include <QWidget>

#include <cstdint>
#include <optional>
#include <vector>

class QLabel;
class QMenu;
class QSortFilterProxyModel;
class QTableView;

namespace teleta::touch {

/// The recent touches, newest first; a click on a column's title sorts. Ctrl+C copies the selected rows (all
/// without a selection) as tab-separated text, Return activates a touch. Thread: GUI.
class TouchTable : public QWidget {
    Q_OBJECT
public:
    static constexpr std::size_t kCapacity = 1000;

    explicit TouchTable(QWidget* parent = nullptr, std::size_t capacity = kCapacity);

    /// Adds a touch, or replaces the one of the same number. The oldest is forgotten when there are too many.
    void append(const pipeline::TouchRecord& record);
    void clear();
    void setProvenance(base::Provenance provenance);
    void setEmptyText(const QString& text);

    /// Selects a touch by its number; false when it is not kept any more.
    bool select(std::uint64_t touch);
    /// Number of the current touch.
    [[nodiscard]] std::optional<std::uint64_t> selected() const;
    [[nodiscard]] int touches() const { return m_model->rowCount(); }
    [[nodiscard]] QTableView* view() const { return m_view; }
    /// Selected rows, or all, in the order on the screen.
    [[nodiscard]] std::vector<pipeline::TouchRecord> chosen() const;
    void copySelection() const;
    void populateMenu(QMenu& menu);

    [[nodiscard]] QSize sizeHint() const override;

signals:
    /// Double click or Return.
    void touchActivated(std::uint64_t touch);
    void exported(const QString& path);
    void exportFailed(const QString& message);

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    [[nodiscard]] base::Figure figure() const;
    [[nodiscard]] const pipeline::TouchRecord& shownRecord(int row) const;
    void retranslate();
    void restyle();
    void showEmptiness();

    TouchModel* m_model;
    QSortFilterProxyModel* m_sorted;
    QTableView* m_view;
    QLabel* m_empty;
    bool m_defaultEmptyText = true;
    base::Provenance m_provenance = base::Provenance::live;
    base::FigureExport* m_export;
};

} // namespace teleta::touch
