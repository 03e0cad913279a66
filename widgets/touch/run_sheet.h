// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pipeline/touch/found_objects.h"
#include "widgets/touch/run_sheet_model.h"
#include "widgets/touch/sheet_view.h"

#include <cstdint>
#include <vector>

namespace teleta::touch {

/// The objects that the operator has found, one a row. F2 or a double click names one, Delete takes the
/// selected ones off the sheet, Ctrl+Z brings them back, Ctrl+C copies. Thread: GUI.
class RunSheet : public SheetView {
    Q_OBJECT
public:
    explicit RunSheet(QWidget* parent = nullptr);

    void setObjects(const std::vector<pipeline::FoundObject>& objects) { m_model->setObjects(objects); }
    void clear() { m_model->clear(); }
    void setProvenance(base::Provenance provenance) override;

    [[nodiscard]] RunSheetModel& model() { return *m_model; }
    /// All rows as CSV.
    [[nodiscard]] QString csv() const { return runSheetText(*m_model, provenance()); }
    void removeSelected();
    /// Selects the row of an object, and no other; one that is not on the sheet is ignored.
    void select(std::uint64_t object);
    /// Of the current object, whichever of its columns is the current one.
    void editName();
    void undo() { m_model->undoStack().undo(); }
    void redo() { m_model->undoStack().redo(); }
    void populateMenu(QMenu& menu) override;

protected:
    [[nodiscard]] QString title() const override;
    [[nodiscard]] base::Figure figure() const override;
    void copy() const override;
    void retranslate() override;
    void restyle() override;
    bool onKey(const QKeyEvent& key) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    [[nodiscard]] bool isOwnKey(const QKeyEvent& key) const;
    void showHint();

    RunSheetModel* m_model;
};

} // namespace teleta::touch
