// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/touch/touch_table.h"

#include "widgets/base/on_change.h"
#include "widgets/base/text_colour.h"
#include "widgets/base/theme.h"

#include <QClipboard>
#include <QContextMenuEvent>
#include <QGuiApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QMenu>
#include <QPainter>
#include <QSortFilterProxyModel>
#include <QStyledItemDelegate>
#include <QTableView>
#include <QVBoxLayout>

#include <algorithm>

namespace teleta::touch {

using pipeline::TouchRecord;

namespace {

constexpr double kHeader_em = 1.75;

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
    : QWidget(parent)
    , m_model(new TouchModel(capacity, this))
    , m_sorted(new MissingLast(this))
    , m_view(new QTableView(this))
    , m_empty(new QLabel(m_view->viewport()))
    , m_export(new base::FigureExport(this, [this] { return figure(); })) {
    m_sorted->setSourceModel(m_model);
    m_sorted->setSortRole(TouchModel::kSortRole);
    auto* header = new PaddedHeader(Qt::Horizontal, m_view);
    header->setSectionsClickable(true);
    m_view->setHorizontalHeader(header);
    m_view->setItemDelegate(new PaddedText(m_view));
    m_view->setModel(m_sorted);
    m_view->setSortingEnabled(true);
    m_view->sortByColumn(TouchModel::number, Qt::DescendingOrder);
    m_view->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_view->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_view->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_view->setAlternatingRowColors(true);
    m_view->setShowGrid(false);
    m_view->setWordWrap(false);
    m_view->setTabKeyNavigation(false);
    m_view->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_view->setFrameShape(QFrame::NoFrame);
    m_view->verticalHeader()->hide();
    m_view->horizontalHeader()->setHighlightSections(false);
    m_view->horizontalHeader()->setStretchLastSection(true);
    m_view->installEventFilter(this);
    setFocusProxy(m_view);
    m_empty->setAlignment(Qt::AlignCenter);
    m_empty->setWordWrap(true);
    m_empty->setAttribute(Qt::WA_TransparentForMouseEvents);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_view);

    connect(m_view, &QTableView::activated, this,
            [this](const QModelIndex& index) { emit touchActivated(shownRecord(index.row()).number); });
    connect(m_export, &base::FigureExport::saved, this, &TouchTable::exported);
    connect(m_export, &base::FigureExport::failed, this, &TouchTable::exportFailed);
    base::keepTranslated(this, &TouchTable::retranslate);
    base::onChange(this, &TouchTable::restyle,
                   {QEvent::LanguageChange, QEvent::PaletteChange, QEvent::FontChange});
    restyle();
}

void TouchTable::retranslate() {
    m_view->setAccessibleName(tr("Recent touches"));
    setWhatsThis(
        tr("<p>Every touch of the arm with what was found out about it. A ? in the force marks a "
           "component that the arm cannot observe in its configuration.</p><p>Click a title to sort. "
           "Ctrl+C copies the selected rows.</p>"));
    if (m_defaultEmptyText)
        m_empty->setText(tr("No touch yet. Touch an object with the forearm."));
    m_model->retranslate();
    update();
}

void TouchTable::restyle() {
    layout()->setContentsMargins(0, base::em(this, kHeader_em), 0, 0);
    base::setTextColour(m_empty, palette().color(QPalette::PlaceholderText));
    m_view->verticalHeader()->setDefaultSectionSize(base::em(this, 1.6));
    m_view->setIconSize(QSize(base::em(this, 1), base::em(this, 1)));
    const QFontMetrics metrics(font());
    const auto wide = [&](int column, const QString& sample) {
        const QString title = m_model->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString();
        const int text = std::max(metrics.horizontalAdvance(sample), metrics.horizontalAdvance(title));
        m_view->setColumnWidth(column, text + base::em(this, 1.8));
    };
    // The widest usual contents, so that the columns stand still while touches come in.
    wide(TouchModel::number, QStringLiteral("88888"));
    wide(TouchModel::time, QStringLiteral("88888.888 s"));
    wide(TouchModel::point, QStringLiteral("\u2212888, \u2212888, \u2212888 mm"));
    wide(TouchModel::distance, QStringLiteral("888 mm"));
    wide(TouchModel::force, QStringLiteral("\u22128.88, \u22128.88, \u22128.88 N"));
    wide(TouchModel::stiffness, QStringLiteral("88.8 kN/m (88.8 … 88.8 kN/m)"));
    wide(TouchModel::material, QStringLiteral("rubber (not certain), DANGER") + QStringLiteral("     "));
    wide(TouchModel::level, QStringLiteral("8"));
    showEmptiness();
}

void TouchTable::showEmptiness() {
    m_empty->setGeometry(m_view->viewport()->rect());
    m_empty->setVisible(m_model->rowCount() == 0);
    update();
}

void TouchTable::append(const TouchRecord& record) {
    // Who looks at the top sees the newest; who has scrolled down keeps what is read.
    m_model->put(record);
    showEmptiness();
}

void TouchTable::clear() {
    m_model->clear();
    showEmptiness();
}

void TouchTable::setProvenance(base::Provenance provenance) {
    m_provenance = provenance;
    update();
}

void TouchTable::setEmptyText(const QString& text) {
    m_defaultEmptyText = false;
    m_empty->setText(text);
}

const TouchRecord& TouchTable::shownRecord(int row) const {
    return m_model->record(m_sorted->mapToSource(m_sorted->index(row, 0)).row());
}

bool TouchTable::select(std::uint64_t touch) {
    const auto row = m_model->rowOf(touch);
    if (!row)
        return false;
    m_view->setCurrentIndex(m_sorted->mapFromSource(m_model->index(*row, 0)));
    return true;
}

std::optional<std::uint64_t> TouchTable::selected() const {
    const QModelIndex current = m_view->currentIndex();
    return current.isValid() ? std::optional(shownRecord(current.row()).number) : std::nullopt;
}

std::vector<TouchRecord> TouchTable::chosen() const {
    std::vector<int> rows;
    for (const QModelIndex& index : m_view->selectionModel()->selectedRows())
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

void TouchTable::copySelection() const {
    QGuiApplication::clipboard()->setText(touchesText(chosen(), u'\t'));
}

base::Figure TouchTable::figure() const {
    base::Figure figure;
    figure.name = tr("touches");
    figure.csv = [csv = touchesText(chosen(), u',')] { return csv; };
    return figure;
}

void TouchTable::populateMenu(QMenu& menu) {
    QAction* copy = menu.addAction(tr("&Copy"), this, &TouchTable::copySelection);
    copy->setShortcut(QKeySequence::Copy);
    menu.addAction(tr("Select &all"), m_view, &QTableView::selectAll)->setShortcut(QKeySequence::SelectAll);
    menu.addSeparator();
    m_export->addDataActions(menu);
    menu.addSeparator();
    menu.addAction(tr("&Newest first"), this, [this] {
        m_view->sortByColumn(TouchModel::number, Qt::DescendingOrder);
        m_view->scrollToTop();
    });
}

QSize TouchTable::sizeHint() const {
    return {base::em(this, 60), base::em(this, 12)};
}

bool TouchTable::eventFilter(QObject* watched, QEvent* event) {
    if (watched != m_view)
        return QWidget::eventFilter(watched, event);
    if (event->type() == QEvent::KeyPress && static_cast<QKeyEvent*>(event)->matches(QKeySequence::Copy)) {
        copySelection();
        return true;
    }
    if (event->type() == QEvent::ContextMenu) {
        auto* menu = new QMenu(this);
        menu->setAttribute(Qt::WA_DeleteOnClose);
        populateMenu(*menu);
        menu->popup(static_cast<QContextMenuEvent*>(event)->globalPos());
        return true;
    }
    if (event->type() == QEvent::Resize || event->type() == QEvent::Show)
        m_empty->setGeometry(m_view->viewport()->rect());
    return false;
}

void TouchTable::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    m_empty->setGeometry(m_view->viewport()->rect());
}

void TouchTable::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setFont(font());
    const QRectF line(base::grid(this), 0, width() - 2 * base::grid(this), base::em(this, kHeader_em));
    const QString badge = base::provenanceText(m_provenance);
    if (!badge.isEmpty()) {
        const QSizeF size = base::badgeSize(font(), badge);
        base::paintBadge(
            painter,
            QRectF(QPointF(line.right() - size.width(), line.center().y() - 0.5 * size.height()), size),
            badge, base::statusColours(palette()).simulated);
    }
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter, tr("%n touch(es)", nullptr, touches()));
}

} // namespace teleta::touch
