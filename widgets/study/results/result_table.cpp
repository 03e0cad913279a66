// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/study/results/result_table.h"

#include "widgets/base/theme.h"

#include <QContextMenuEvent>
#include <QHeaderView>
#include <QKeyEvent>
#include <QMenu>
#include <QResizeEvent>
#include <QScrollBar>
#include <QWheelEvent>

#include <algorithm>
#include <utility>

namespace teleta::study {

namespace {

constexpr double kWrapped_em = 16.0; ///< least width of a text that is wrapped

} // namespace

ResultTable::ResultTable(QString name, QWidget* parent)
    : QTableWidget(parent)
    , m_name(std::move(name))
    , m_export(new base::FigureExport(this, [this] {
        base::Figure figure;
        figure.name = m_name;
        figure.csv = [text = csv()] { return text; };
        return figure;
    })) {
    verticalHeader()->hide();
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setAlternatingRowColors(true);
    setTabKeyNavigation(false);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void ResultTable::setRows(const QStringList& header, const QStringList& tips,
                          const std::vector<std::vector<ResultCell>>& rows) {
    setColumnCount(static_cast<int>(header.size()));
    setHorizontalHeaderLabels(header);
    for (int column = 0; column < columnCount(); ++column)
        horizontalHeaderItem(column)->setToolTip(tips.value(column));
    setRowCount(static_cast<int>(rows.size()));
    for (int row = 0; row < rowCount(); ++row) {
        for (int column = 0; column < columnCount(); ++column) {
            const auto& cells = rows[static_cast<std::size_t>(row)];
            const ResultCell cell = static_cast<std::size_t>(column) < cells.size()
                                        ? cells[static_cast<std::size_t>(column)]
                                        : ResultCell{};
            auto* item = new QTableWidgetItem(cell.shown);
            item->setData(Qt::UserRole, cell.data.isEmpty() ? cell.shown : cell.data);
            item->setTextAlignment(Qt::AlignCenter);
            setItem(row, column, item);
        }
    }
    fitColumns();
}

void ResultTable::fitColumns() {
    resizeColumnsToContents();
    for (int column = 0; column < columnCount(); ++column)
        setColumnWidth(column, columnWidth(column) + base::em(this, 0.8));
    const int last = columnCount() - 1;
    const int excess = horizontalHeader()->length() - viewport()->width();
    const int least = base::em(this, kWrapped_em);
    if (last >= 0 && excess > 0 && columnWidth(last) > least)
        setColumnWidth(last, std::max(least, columnWidth(last) - excess));
    resizeRowsToContents();
    const int bar = horizontalScrollBar()->sizeHint().height();
    setFixedHeight(horizontalHeader()->sizeHint().height() + verticalHeader()->length() + bar +
                   2 * frameWidth());
}

QString ResultTable::csv() const {
    const auto quoted = [](QString text) {
        text.replace(QLatin1Char('"'), QStringLiteral("\"\""));
        return text.contains(QLatin1Char(',')) || text.contains(QLatin1Char('"')) ||
                       text.contains(QLatin1Char('\n'))
                   ? QLatin1Char('"') + text + QLatin1Char('"')
                   : text;
    };
    QString text;
    for (int row = -1; row < rowCount(); ++row) {
        QStringList cells;
        for (int column = 0; column < columnCount(); ++column)
            cells << quoted(row < 0 ? horizontalHeaderItem(column)->text()
                                    : item(row, column)->data(Qt::UserRole).toString());
        text += cells.join(QLatin1Char(',')) + QLatin1Char('\n');
    }
    return text;
}

void ResultTable::contextMenuEvent(QContextMenuEvent* event) {
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    m_export->addDataActions(*menu);
    menu->popup(event->globalPos());
}

void ResultTable::keyPressEvent(QKeyEvent* event) {
    if (!event->matches(QKeySequence::Copy)) {
        QTableWidget::keyPressEvent(event);
        return;
    }
    base::Figure figure;
    figure.csv = [text = csv()] { return text; };
    base::copyData(figure);
}

void ResultTable::resizeEvent(QResizeEvent* event) {
    QTableWidget::resizeEvent(event);
    if (event->size().width() != event->oldSize().width())
        fitColumns();
}

/// All rows are visible: the wheel scrolls the page.
void ResultTable::wheelEvent(QWheelEvent* event) {
    event->ignore();
}

} // namespace teleta::study
