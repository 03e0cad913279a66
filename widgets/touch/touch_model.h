// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pipeline/touch/touch_record.h"
#include "widgets/base/titled_model.h"

#include <QChar>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

namespace teleta::touch {

/// The newest touches as a table, the newest first; older ones than fit are forgotten. Thread: GUI.
class TouchModel : public base::TitledModel {
    Q_OBJECT
public:
    enum Column { number, time, point, distance, force, stiffness, material, level, condition };
    static constexpr int kColumns = 9;
    /// Value of a cell to sort by.
    static constexpr int kSortRole = Qt::UserRole;

    /// capacity: rows that are kept, > 0.
    explicit TouchModel(std::size_t capacity, QObject* parent = nullptr);

    /// Adds a touch, or replaces the one of the same number.
    void put(const pipeline::TouchRecord& record);
    void clear();

    /// row: of this model, 0 is the newest.
    [[nodiscard]] const pipeline::TouchRecord& record(int row) const {
        return m_records[static_cast<std::size_t>(row)];
    }
    [[nodiscard]] std::optional<int> rowOf(std::uint64_t touch) const;

    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    [[nodiscard]] int rows() const override { return static_cast<int>(m_records.size()); }
    [[nodiscard]] QStringList titles() const override;

    std::size_t m_capacity;
    std::deque<pipeline::TouchRecord> m_records;
};

/// Records as text, one a line under a header line: SI units, C locale, NA where undefined or not observed.
[[nodiscard]] QString touchesText(const std::vector<pipeline::TouchRecord>& records, QChar separator);

} // namespace teleta::touch
