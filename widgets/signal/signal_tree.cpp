// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/signal/signal_tree.h"

#include "widgets/base/compose.h"
#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"
#include "widgets/signal/signals_mime.h"
#include "widgets/signal/unit_text.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMimeData>
#include <QSortFilterProxyModel>
#include <QStandardItemModel>
#include <QStyledItemDelegate>
#include <QTreeView>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace teleta::signal {

namespace {

enum TreeColumn { nameColumn, valueColumn, treeColumns };
constexpr int kStreamRole = Qt::UserRole + 1; ///< of a signal: name of its stream
constexpr int kSourceRole = Qt::UserRole + 2; ///< of a signal: name of its source
constexpr int kOwnRole = Qt::UserRole + 3;    ///< name as files have it

std::optional<SignalId> idAt(const QModelIndex& index) {
    const QModelIndex name = index.siblingAtColumn(nameColumn);
    const QVariant stream = name.data(kStreamRole);
    if (!stream.isValid())
        return std::nullopt;
    return SignalId{name.data(kSourceRole).toString().toStdString(), stream.toString().toStdString(),
                    name.data(kOwnRole).toString().toStdString()};
}

/// Writes the newest value of each signal when it is painted, so that the model need not change for it.
class ValueDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;
    std::function<QString(const SignalId&)> valueOf;

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
        QStyledItemDelegate::initStyleOption(option, index);
        const auto id = idAt(index);
        if (id && valueOf)
            option->text = valueOf(*id);
        option->displayAlignment = Qt::AlignRight | Qt::AlignVCenter;
        option->features |= QStyleOptionViewItem::HasDisplay;
    }
};

bool sameColumns(const std::vector<recording::Column>& a, const std::vector<recording::Column>& b) {
    return std::ranges::equal(a, b, [](const auto& one, const auto& other) {
        return one.name == other.name && one.unit == other.unit;
    });
}

} // namespace

bool SourceEntry::Stream::operator==(const Stream& other) const {
    return name == other.name && sameColumns(columns, other.columns) && meanings == other.meanings;
}

bool SourceEntry::operator==(const SourceEntry& other) const {
    return name == other.name && note == other.note && streams == other.streams;
}

/// The names of the tree; signals are what can be dragged.
class SignalModel : public QStandardItemModel {
public:
    using QStandardItemModel::QStandardItemModel;
    [[nodiscard]] QMimeData* mimeData(const QModelIndexList& indexes) const override {
        std::vector<SignalId> ids;
        for (const QModelIndex& index : indexes)
            if (const auto id = idAt(index); id && index.column() == nameColumn)
                ids.push_back(*id);
        return ids.empty() ? nullptr : mimeOf(ids).release();
    }
};

SignalTree::SignalTree(QWidget* parent)
    : QWidget(parent)
    , m_search(base::named<QLineEdit>("searchSignals", this))
    , m_view(base::named<QTreeView>("signals", this))
    , m_model(new SignalModel(0, treeColumns, this))
    , m_found(new QSortFilterProxyModel(this)) {
    m_found->setSourceModel(m_model);
    m_found->setRecursiveFilteringEnabled(true);
    m_found->setFilterCaseSensitivity(Qt::CaseInsensitive);
    // A source that fits shows all that it has.
    m_found->setAutoAcceptChildRows(true);
    m_view->setModel(m_found);
    m_view->setItemDelegateForColumn(valueColumn, new ValueDelegate(m_view));
    m_view->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_view->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_view->setDragEnabled(true);
    m_view->setDragDropMode(QAbstractItemView::DragOnly);
    m_view->setFrameShape(QFrame::NoFrame);
    m_view->setTextElideMode(Qt::ElideMiddle); // names differ at their ends, too
    m_view->setUniformRowHeights(true);
    m_view->setExpandsOnDoubleClick(true);
    m_view->setIndentation(base::grid(this, 1.5));
    m_view->header()->setStretchLastSection(false);
    m_view->header()->setSectionResizeMode(nameColumn, QHeaderView::Stretch);
    m_view->header()->setSectionResizeMode(valueColumn, QHeaderView::Fixed);
    m_view->header()->resizeSection(valueColumn, base::em(this, 6.5));
    m_search->setClearButtonEnabled(true);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(base::grid(this, 0.5));
    base::addWidgets(layout, {m_search, m_view});
    m_view->installEventFilter(this);
    m_search->installEventFilter(this);
    connect(m_search, &QLineEdit::textChanged, this, &SignalTree::onSearch);
    connect(m_view, &QTreeView::doubleClicked, this, &SignalTree::choose);
    base::keepTranslated(this, &SignalTree::retranslate);
}

void SignalTree::retranslate() {
    m_search->setPlaceholderText(tr("Search signals (Ctrl+F)"));
    m_search->setAccessibleName(tr("Search signals"));
    m_view->setAccessibleName(tr("Signals of all sources"));
    m_model->setHorizontalHeaderLabels({tr("Signal"), tr("Newest value")});
}

void SignalTree::setValues(std::function<QString(const SignalId&)> valueOf) {
    static_cast<ValueDelegate*>(m_view->itemDelegateForColumn(valueColumn))->valueOf = std::move(valueOf);
}

void SignalTree::setSources(const std::vector<SourceEntry>& sources) {
    if (sources == m_sources)
        return;
    const auto row = [](const QString& text, const std::string& own) {
        auto* item = new QStandardItem(text);
        item->setData(QString::fromStdString(own), kOwnRole);
        item->setToolTip(text);
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
        return item;
    };
    const auto withValue = [](QStandardItem* item) {
        auto* value = new QStandardItem;
        value->setFlags(item->flags());
        return QList<QStandardItem*>{item, value};
    };
    // Sources that are as they were keep their items, and with them what is open and chosen.
    for (int i = m_model->rowCount() - 1; i >= 0; --i) {
        const std::string name = m_model->item(i)->data(kOwnRole).toString().toStdString();
        const auto before = std::ranges::find(m_sources, name, &SourceEntry::name);
        const auto now = std::ranges::find(sources, name, &SourceEntry::name);
        if (now == sources.end() || before == m_sources.end() || *now != *before)
            m_model->removeRow(i);
    }
    for (const SourceEntry& source : sources) {
        bool isThere = false;
        for (int i = 0; i < m_model->rowCount(); ++i)
            isThere = isThere || m_model->item(i)->data(kOwnRole).toString().toStdString() == source.name;
        if (isThere)
            continue;
        const QString name = QString::fromStdString(source.name);
        auto* top =
            row(source.note.isEmpty() ? name : name + QStringLiteral(" \u2013 ") + source.note, source.name);
        for (const SourceEntry::Stream& stream : source.streams) {
            auto* branch = row(QString::fromStdString(stream.name), stream.name);
            for (std::size_t i = 0; i < stream.columns.size(); ++i) {
                const recording::Column& column = stream.columns[i];
                const QString unit = unitText(QString::fromStdString(column.unit));
                QString text = QString::fromStdString(column.name);
                if (i < stream.meanings.size() && !stream.meanings[i].isEmpty())
                    text += QStringLiteral(", ") + stream.meanings[i];
                auto* leaf =
                    row(unit.isEmpty() ? text : tr("%1 (%2)", "signal, unit").arg(text, unit), column.name);
                leaf->setData(QString::fromStdString(stream.name), kStreamRole);
                leaf->setData(name, kSourceRole);
                leaf->setFlags(leaf->flags() | Qt::ItemIsDragEnabled);
                branch->appendRow(withValue(leaf));
            }
            top->appendRow(withValue(branch));
        }
        m_model->appendRow(withValue(top));
        m_view->expand(m_found->mapFromSource(top->index()));
    }
    m_sources = sources;
    if (!m_search->text().isEmpty())
        m_view->expandAll();
}

void SignalTree::refreshValues() {
    m_view->viewport()->update();
}

std::vector<SignalId> SignalTree::selected() const {
    std::vector<SignalId> ids;
    for (const QModelIndex& index : m_view->selectionModel()->selectedRows(nameColumn))
        if (const auto id = idAt(index))
            ids.push_back(*id);
    return ids;
}

void SignalTree::onSearch(const QString& text) {
    m_found->setFilterFixedString(text);
    if (!text.isEmpty())
        m_view->expandAll();
}

void SignalTree::choose() {
    const std::vector<SignalId> ids = selected();
    if (!ids.empty())
        emit chosen(ids);
}

bool SignalTree::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (watched == m_search && key == Qt::Key_Down) {
            m_view->setFocus();
            if (!m_view->currentIndex().isValid())
                m_view->setCurrentIndex(m_found->index(0, 0));
            return true;
        }
        if (watched == m_view && (key == Qt::Key_Return || key == Qt::Key_Enter)) {
            if (selected().empty() && m_view->currentIndex().isValid())
                m_view->setExpanded(m_view->currentIndex(), !m_view->isExpanded(m_view->currentIndex()));
            else
                choose();
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace teleta::signal
