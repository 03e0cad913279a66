// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/operate/recording/mark_list.h"

#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"

#include <QEvent>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QScopedValueRollback>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::console {

namespace {

enum Column { timeColumn, textColumn, columns };

QString clock(double time_s) {
    const auto hundredths = static_cast<long long>(std::llround(std::max(time_s, 0.0) * 100.0));
    return QStringLiteral("%1:%2.%3")
        .arg(hundredths / 6000)
        .arg(hundredths / 100 % 60, 2, 10, QLatin1Char('0'))
        .arg(hundredths % 100, 2, 10, QLatin1Char('0'));
}

} // namespace

MarkList::MarkList(QWidget* parent)
    : QWidget(parent)
    , m_table(new QTableWidget(0, columns, this))
    , m_hint(new QLabel(this))
    , m_fixed(new QLabel(this)) {
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setAlternatingRowColors(true);
    m_table->setShowGrid(false);
    m_table->setFrameShape(QFrame::NoFrame);
    m_table->setTabKeyNavigation(false);
    m_table->verticalHeader()->hide();
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_table->horizontalHeader()->setHighlightSections(false);
    m_table->installEventFilter(this);
    m_hint->setAlignment(Qt::AlignCenter);
    m_hint->setWordWrap(true);
    m_fixed->setObjectName(QStringLiteral("marksAreFixed"));
    m_fixed->setWordWrap(true);
    m_fixed->setContentsMargins(base::grid(this), 0, base::grid(this), base::grid(this, 0.5));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_hint, 1);
    layout->addWidget(m_table, 1);
    layout->addWidget(m_fixed);
    connect(m_table, &QTableWidget::itemChanged, this, [this](QTableWidgetItem* item) {
        const auto row = static_cast<std::size_t>(item->row());
        if (!m_building && item->column() == textColumn && row < m_rows.size())
            emit renamed(m_rows[row].number, item->text().trimmed());
    });
    connect(m_table, &QTableWidget::cellDoubleClicked, this, [this](int row, int column) {
        // A text that cannot be typed is there to be gone to as well.
        if ((column == timeColumn || !m_editable) && row < static_cast<int>(m_rows.size()))
            emit timeChosen(m_rows[static_cast<std::size_t>(row)].time_s);
    });
    base::keepTranslated(this, &MarkList::retranslate);
    rebuild();
}

void MarkList::setMarks(std::vector<Row> rows, bool editable) {
    if (rows == m_rows && editable == m_editable)
        return;
    m_rows = std::move(rows);
    m_editable = editable;
    rebuild();
}

void MarkList::edit(std::uint64_t number) {
    const auto found = std::ranges::find(m_rows, number, &Row::number);
    if (found == m_rows.end() || !m_editable)
        return;
    auto* item = m_table->item(static_cast<int>(found - m_rows.begin()), textColumn);
    // A table that is asked twice complains.
    if (m_table->isPersistentEditorOpen(item))
        return;
    m_table->setCurrentItem(item);
    m_table->editItem(item);
}

void MarkList::finishEditing() {
    if (m_table->indexWidget(m_table->currentIndex()) == nullptr)
        return;
    // A table takes over what is typed in a cell that is left.
    const int row = m_table->currentRow();
    m_table->setCurrentItem(nullptr);
    m_table->setCurrentCell(row, textColumn);
}

void MarkList::rebuild() {
    const QScopedValueRollback building(m_building, true);
    const Qt::ItemFlags flags = m_editable ? Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsEditable
                                           : Qt::ItemIsEnabled | Qt::ItemIsSelectable;
    const int current = m_table->currentRow();
    m_table->setRowCount(static_cast<int>(m_rows.size()));
    for (int row = 0; row < m_table->rowCount(); ++row) {
        const Row& mark = m_rows[static_cast<std::size_t>(row)];
        // Not in place of those that are there: the text of one may be being set.
        QTableWidgetItem* time = itemAt(row, timeColumn);
        time->setText(clock(mark.time_s));
        time->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
        time->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        QTableWidgetItem* text = itemAt(row, textColumn);
        text->setText(mark.text);
        // An editor is filled anew when they are set, even to what they were.
        if (text->flags() != flags)
            text->setFlags(flags);
    }
    m_table->setCurrentCell(std::min(current, m_table->rowCount() - 1), textColumn);
    // Tab ends at a stand-in for a table that is hidden, which takes no focus.
    setFocusProxy(nullptr);
    m_table->setVisible(!m_rows.empty());
    if (!m_rows.empty())
        setFocusProxy(m_table);
    m_hint->setVisible(m_rows.empty());
    m_fixed->setVisible(!m_rows.empty() && !m_editable);
}

QTableWidgetItem* MarkList::itemAt(int row, int column) {
    QTableWidgetItem* item = m_table->item(row, column);
    if (item == nullptr) {
        item = new QTableWidgetItem;
        m_table->setItem(row, column, item);
    }
    return item;
}

bool MarkList::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_table && event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        const int row = m_table->currentRow();
        const bool isRow = row >= 0 && row < static_cast<int>(m_rows.size());
        if (key == Qt::Key_Delete && m_editable && isRow) {
            emit removed(m_rows[static_cast<std::size_t>(row)].number);
            return true;
        }
        if ((key == Qt::Key_Return || key == Qt::Key_Enter) && isRow) {
            if (m_editable)
                edit(m_rows[static_cast<std::size_t>(row)].number);
            else
                emit timeChosen(m_rows[static_cast<std::size_t>(row)].time_s);
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

void MarkList::retranslate() {
    m_table->setHorizontalHeaderLabels({tr("Time"), tr("What was marked")});
    m_table->horizontalHeaderItem(timeColumn)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_table->horizontalHeaderItem(textColumn)->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    m_table->setAccessibleName(tr("Marks"));
    m_hint->setText(
        tr("No marks yet. While something is recorded, M sets one. Press Enter on it to type what it was."));
    m_fixed->setText(
        tr("This recording is played: Enter goes to a mark. Marks are named while they are recorded, or "
           "afterwards beside the source that was recorded."));
    setWhatsThis(tr("Moments that somebody marked in the recording. Double-click a text or press Enter to "
                    "type it, Delete takes a mark out, Ctrl+Z undoes. In a recording that is played, a "
                    "double click on a mark goes there."));
}

} // namespace teleta::console
