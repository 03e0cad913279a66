// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/finders/contact_ladder.h"

#include <QCoreApplication>
#include <QString>
#include <QStyledItemDelegate>

namespace teleta::camera {

/// What people call the finders of contacts, translated when it is asked for. Thread: GUI.
class FinderNames {
    Q_DECLARE_TR_FUNCTIONS(FinderNames)

public:
    /// Another one for each finder.
    [[nodiscard]] static QString title(const vision::ContactRung& finder);
    /// What it does and costs, in a few words: its place among the presets, and the share of the picture's
    /// points that it looks at.
    [[nodiscard]] static QString cost(const vision::ContactRung& finder);
    /// In a sentence or two.
    [[nodiscard]] static QString explanation(const vision::ContactRung& finder);
    /// Its code, as the command line and files have it.
    [[nodiscard]] static QString code(const vision::ContactRung& finder);
};

/// A line of the list of finders: the title with the code in grey behind it, below what it costs. Thread:
/// GUI.
class FinderDelegate : public QStyledItemDelegate {
    Q_OBJECT

public:
    static constexpr int kCode = Qt::UserRole;     ///< role of the code
    static constexpr int kCost = Qt::UserRole + 1; ///< role of what it costs
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

} // namespace teleta::camera
