// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/base/theme.h"

#include <QListWidget>
#include <QStyledItemDelegate>
#include <QWidget>

namespace teleta::console {

/// Keeps the items of a list apart, with more room above a heading, which is an item that is not enabled. The
/// list's own spacing makes items narrower than it has counted their lines for. Thread: GUI.
class ApartItems : public QStyledItemDelegate {
public:
    explicit ApartItems(QWidget* list)
        : QStyledItemDelegate(list)
        , m_gap(base::grid(list, 0.5)) {}

    /// Adds a heading without a text at the end of a list, which owns it.
    static QListWidgetItem* addHeading(QListWidget& list) {
        auto* heading = new QListWidgetItem(&list);
        heading->setFlags(Qt::NoItemFlags);
        heading->setFont(base::bold(list.font()));
        heading->setTextAlignment(Qt::AlignLeft | Qt::AlignBottom);
        return heading;
    }

    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option,
                                 const QModelIndex& index) const override {
        const bool isHeading = !index.flags().testFlag(Qt::ItemIsEnabled);
        return QStyledItemDelegate::sizeHint(option, index) + QSize(0, (isHeading ? 4 : 2) * m_gap);
    }

protected:
    /// A heading cannot be chosen, and is as dark as what can.
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
        QStyledItemDelegate::initStyleOption(option, index);
        option->state |= QStyle::State_Enabled;
    }

private:
    int m_gap;
};

} // namespace teleta::console
