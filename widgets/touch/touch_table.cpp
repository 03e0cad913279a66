// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/touch/touch_table.h"

#include "widgets/base/theme.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHeaderView>
#include <QMenu>
#include <QSortFilterProxyModel>
#include <QStyledItemDelegate>
#include <QTableView>

#include <algorithm>

namespace teleta::touch {

using pipeline::TouchRecord;

namespace {

/// Keeps the texts of neighbouring columns apart.
class PaddedText : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
        QStyledItemDelegate::initStyleOption(option, index);
        const QChar space(0x2002);
        option->text = space + option->text + space;
    }
};

class PaddedHeader : public QHeaderView {
public:
    using QHeaderView::QHeaderView;

protected:
    void initStyleOptionForIndex(QStyleOptionHeader* option, int section) const override {
        QHeaderView::initStyleOptionForIndex(option, section);
        const QChar space(0x2002);
        option->text = space + option->text + space;
    }
};

/// Sorts by value; what is missing comes last in both orders.
class MissingLast : public QSortFilterProxyModel {
public:
    using QSortFilterProxyModel::QSortFilterProxyModel;

protected:
    [[nodiscard]] bool lessThan(const QModelIndex& left, const QModelIndex& right) const override {
        const bool leftMissing = !left.data(sortRole()).isValid();
        const bool rightMissing = !right.data(sortRole()).isValid();
        if (leftMissing != rightMissing)
            return sortOrder() == Qt::AscendingOrder ? rightMissing : leftMissing;
        return QSortFilterProxyModel::lessThan(left, right);
    }
};

} // namespace

TouchTable::TouchTable(QWidget* parent, std::size_t capacity)
    : SheetView(parent)
    , m_model(new TouchModel(capacity, this))
    , m_sorted(new MissingLast(this)) {
    m_sorted->setSourceModel(m_model);
    m_sorted->setSortRole(TouchModel::kSortRole);
    auto* header = new PaddedHeader(Qt::Horizontal, view());
    header->setSectionsClickable(true);
    view()->setHorizontalHeader(header);
    view()->setItemDelegate(new PaddedText(view()));
    view()->setEditTriggers(QAbstractItemView::NoEditTriggers);
    view()->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    start(m_sorted);
    view()->setSortingEnabled(true);
    view()->sortByColumn(TouchModel::number, Qt::DescendingOrder);
    connect(view(), &QTableView::activated, this,
            [this](const QModelIndex& index) { emit touchActivated(shownRecord(index.row()).number); });
}

void TouchTable::retranslate() {
    view()->setAccessibleName(tr("Recent touches"));
    setWhatsThis(
        tr("<p>Every touch of the arm with what was found out about it. A ? in the force marks a "
           "component that the arm cannot observe in its configuration.</p><p>Click a title to sort. "
           "Ctrl+C copies the selected rows.</p>"));
    if (m_defaultEmptyText)
        setHint(tr("No touch yet. Touch an object with the arm's skin."));
    m_model->retranslate();
    update();
}

void TouchTable::restyle() {
    view()->verticalHeader()->setDefaultSectionSize(base::em(this, 1.6));
    view()->setIconSize(QSize(base::em(this, 1), base::em(this, 1)));
    SheetView::restyle();
}

QString TouchTable::title() const {
    return tr("%n touch(es)", nullptr, touches());
}

void TouchTable::setEmptyText(const QString& text) {
    m_defaultEmptyText = false;
    setHint(text);
}

const TouchRecord& TouchTable::shownRecord(int row) const {
    return m_model->record(m_sorted->mapToSource(m_sorted->index(row, 0)).row());
}

bool TouchTable::select(std::uint64_t touch) {
    const auto row = m_model->rowOf(touch);
    if (!row)
        return false;
    view()->setCurrentIndex(m_sorted->mapFromSource(m_model->index(*row, 0)));
    return true;
}

std::optional<std::uint64_t> TouchTable::selected() const {
    const QModelIndex current = view()->currentIndex();
    return current.isValid() ? std::optional(shownRecord(current.row()).number) : std::nullopt;
}

std::vector<TouchRecord> TouchTable::chosen() const {
    std::vector<int> rows;
    for (const QModelIndex& index : view()->selectionModel()->selectedRows())
        rows.push_back(index.row());
    if (rows.empty())
        for (int row = 0; row < m_sorted->rowCount(); ++row)
            rows.push_back(row);
    std::ranges::sort(rows);
    std::vector<TouchRecord> records;
    records.reserve(rows.size());
    for (const int row : rows)
        records.push_back(shownRecord(row));
    return records;
}

void TouchTable::copy() const {
    QGuiApplication::clipboard()->setText(touchesText(chosen(), u'\t'));
}

base::Figure TouchTable::figure() const {
    base::Figure figure;
    figure.name = tr("touches");
    figure.csv = [csv = touchesText(chosen(), u',')] { return csv; };
    return figure;
}

void TouchTable::populateMenu(QMenu& menu) {
    QAction* copy = menu.addAction(tr("&Copy"), this, &TouchTable::copy);
    copy->setShortcut(QKeySequence::Copy);
    menu.addAction(tr("Select &all"), view(), &QTableView::selectAll)->setShortcut(QKeySequence::SelectAll);
    menu.addSeparator();
    addDataActions(menu);
    menu.addSeparator();
    menu.addAction(tr("&Newest first"), this, [this] {
        view()->sortByColumn(TouchModel::number, Qt::DescendingOrder);
        view()->scrollToTop();
    });
}

} // namespace teleta::touch
