// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pipeline/touch/found_objects.h"
#include "widgets/base/controls/badge.h"
#include "widgets/base/titled_model.h"

#include <QString>
#include <QUndoStack>

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <vector>

namespace teleta::touch {

/// The objects that were found, in the order in which they were found, with the names that the operator gives
/// them. Names and deletions can be undone. Thread: GUI.
class RunSheetModel : public base::TitledModel {
    Q_OBJECT
public:
    enum Column { number, name, time, place, touches, contact, force, stiffness, material, shape };
    static constexpr int kColumns = 10;

    /// What the operator has put down about the objects of a run, with the steps that can be undone.
    struct Notes {
        Notes();
        std::map<std::uint64_t, QString> names;
        std::set<std::uint64_t> removed;
        std::size_t objects = 0; ///< of the run so far: with fewer, it is another one
        std::unique_ptr<QUndoStack> undo;
    };

    explicit RunSheetModel(QObject* parent = nullptr)
        : TitledModel(kColumns, parent) {}

    /// All objects of the run as they are known now. Names and deletions stay with their number.
    void setObjects(const std::vector<pipeline::FoundObject>& objects);
    /// Another run: forgets everything.
    void clear() { (void)takeNotes(); }
    /// Another run is looked at: forgets everything here. The notes are for setNotes() of this model.
    [[nodiscard]] Notes takeNotes();
    /// The run of these notes is looked at again; its objects follow.
    void setNotes(Notes notes);

    /// As one step that can be undone.
    void rename(std::uint64_t object, const QString& text);
    void remove(const std::vector<std::uint64_t>& objects);

    [[nodiscard]] const pipeline::FoundObject& object(int row) const;
    [[nodiscard]] QString nameOf(std::uint64_t object) const;
    [[nodiscard]] QUndoStack& undoStack() { return *m_notes.undo; }

    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;

private:
    [[nodiscard]] int rows() const override { return static_cast<int>(m_kept.size()); }
    [[nodiscard]] QStringList titles() const override;

    void applyName(std::uint64_t object, const QString& text);
    void applyRemoved(const std::vector<std::uint64_t>& objects, bool removed);
    void showKept();

    std::vector<pipeline::FoundObject> m_objects;
    std::vector<std::size_t> m_kept; ///< rows: indices of the objects that are not deleted
    Notes m_notes;
};

/// The rows as CSV: object,name,time_s,x_m,y_m,touches,contact_type,force_n,stiffness_n_per_m,
/// stiffness_lower_95,stiffness_upper_95,material,shape,confidence,source; NA where nothing is known; source:
/// live, recorded, simulated or recorded_simulation; C locale.
[[nodiscard]] QString runSheetText(const RunSheetModel& model, base::Provenance provenance);

} // namespace teleta::touch
