// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pipeline/touch/touch_record.h"
#include "widgets/touch/sheet_view.h"
#include "widgets/touch/touch_model.h"

#include <cstdint>
#include <optional>
#include <vector>

class QSortFilterProxyModel;

namespace teleta::touch {

/// The recent touches, newest first; a click on a column's title sorts. Ctrl+C copies the selected rows (all
/// without a selection) as tab-separated text, Return activates a touch. Thread: GUI.
class TouchTable : public SheetView {
    Q_OBJECT
public:
    static constexpr std::size_t kCapacity = 1000;

    explicit TouchTable(QWidget* parent = nullptr, std::size_t capacity = kCapacity);

    /// Adds a touch, or replaces the one of the same number. The oldest is forgotten when there are too many.
    void append(const pipeline::TouchRecord& record) { m_model->put(record); }
    void clear() { m_model->clear(); }
    void setEmptyText(const QString& text);

    /// Selects a touch by its number; false when it is not kept any more.
    bool select(std::uint64_t touch);
    /// Number of the current touch.
    [[nodiscard]] std::optional<std::uint64_t> selected() const;
    [[nodiscard]] int touches() const { return m_model->rowCount(); }
    /// Selected rows, or all, in the order on the screen.
    [[nodiscard]] std::vector<pipeline::TouchRecord> chosen() const;
    void populateMenu(QMenu& menu) override;

signals:
    /// Double click or Return.
    void touchActivated(std::uint64_t touch);

protected:
    [[nodiscard]] QString title() const override;
    [[nodiscard]] base::Figure figure() const override;
    void copy() const override;
    void retranslate() override;
    void restyle() override;

private:
    [[nodiscard]] const pipeline::TouchRecord& shownRecord(int row) const;

    TouchModel* m_model;
    QSortFilterProxyModel* m_sorted;
    bool m_defaultEmptyText = true;
};

} // namespace teleta::touch
