// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <QStringList>

#include <cstddef>
#include <deque>

namespace teleta::base {

/// A flat table whose columns have titles and whose texts are translated when they are asked for. Thread:
/// GUI.
class TitledModel : public QAbstractTableModel {
public:
    TitledModel(int columns, QObject* parent)
        : QAbstractTableModel(parent)
        , m_columns(columns) {}

    /// Lets the views ask for all texts again.
    void retranslate() {
        emit headerDataChanged(Qt::Horizontal, 0, m_columns - 1);
        tellChanged(0);
    }

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override {
        return parent.isValid() ? 0 : rows();
    }
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override {
        return parent.isValid() ? 0 : m_columns;
    }
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override {
        return orientation == Qt::Horizontal && role == Qt::DisplayRole ? titles().value(section)
                                                                        : QVariant();
    }

protected:
    [[nodiscard]] virtual int rows() const = 0;
    [[nodiscard]] virtual QStringList titles() const = 0;

    /// Tells the views that all cells from a column on may have changed.
    void tellChanged(int fromColumn) {
        if (rows() > 0)
            emit dataChanged(index(0, fromColumn), index(rows() - 1, m_columns - 1));
    }

    /// Inserts an entry before the others, which are the rows of the model. If there are already `most`, the
    /// last one is dropped.
    template <typename Entry>
    void putFirst(std::deque<Entry>& entries, const Entry& entry, std::size_t most) {
        if (entries.size() == most) {
            const int last = static_cast<int>(most) - 1;
            beginRemoveRows({}, last, last);
            entries.pop_back();
            endRemoveRows();
        }
        beginInsertRows({}, 0, 0);
        entries.push_front(entry);
        endInsertRows();
    }

private:
    int m_columns;
};

} // namespace teleta::base
