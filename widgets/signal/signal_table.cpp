// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/signal/signal_table.h"

#include "widgets/base/colour_maps.h"
#include "widgets/base/compose.h"
#include "widgets/base/numbers/quantity_text.h"
#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"
#include "widgets/signal/unit_text.h"

#include <QAction>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPainter>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace teleta::signal {

namespace {

enum TableColumn { signalColumn, aColumn, bColumn, differenceColumn, unitColumn, tableColumns };
constexpr int kDigits = 5;

QIcon swatch(const QColor& colour, int size_px) {
    QPixmap picture(size_px, size_px);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    painter.fillRect(QRect(0, size_px / 2 - size_px / 8, size_px, size_px / 4), colour);
    return QIcon(picture);
}

} // namespace

SignalTable::SignalTable(QWidget* parent)
    : QWidget(parent)
    , m_view(base::named<QTreeWidget>("plotted", this))
    , m_times(base::named<QLabel>("cursorTimes", this))
    , m_derivative(new QAction(this))
    , m_spectrum(new QAction(this))
    , m_remove(new QAction(this)) {
    m_view->setRootIsDecorated(false);
    m_view->setUniformRowHeights(true);
    m_view->setFrameShape(QFrame::NoFrame);
    m_view->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_view->setContextMenuPolicy(Qt::ActionsContextMenu);
    m_view->setColumnCount(tableColumns);
    m_view->header()->setStretchLastSection(false);
    m_view->header()->setSectionResizeMode(signalColumn, QHeaderView::Stretch);
    for (int column = aColumn; column < tableColumns; ++column) {
        m_view->header()->setSectionResizeMode(column, QHeaderView::Fixed);
        m_view->header()->resizeSection(column, base::em(this, column == unitColumn ? 4.5 : 7.5));
    }
    m_derivative->setShortcut(Qt::Key_D);
    m_spectrum->setShortcut(Qt::Key_S);
    m_spectrum->setCheckable(true);
    m_remove->setShortcut(QKeySequence::Delete);
    for (QAction* action : rowActions()) {
        action->setShortcutContext(Qt::WidgetShortcut);
        m_view->addAction(action);
    }
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(base::grid(this), 0, base::grid(this), 0);
    layout->setSpacing(base::grid(this, 0.5));
    auto* above = new QHBoxLayout;
    above->addWidget(m_times);
    above->addStretch(1);
    for (QAction* action : rowActions()) {
        auto* button = new QToolButton(this);
        button->setAutoRaise(true);
        button->setToolButtonStyle(Qt::ToolButtonTextOnly);
        button->setDefaultAction(action);
        above->addWidget(button);
    }
    layout->addLayout(above);
    layout->addWidget(m_view, 1);
    connect(m_derivative, &QAction::triggered, this, [this] {
        for (const int row : chosenRows())
            emit derivativeRequested(row);
    });
    connect(m_spectrum, &QAction::triggered, this, [this](bool shown) {
        for (const int row : chosenRows())
            emit spectrumRequested(row, shown);
    });
    connect(m_remove, &QAction::triggered, this, [this] {
        if (const auto rows = chosenRows(); !rows.empty())
            emit removeRequested(rows);
    });
    connect(m_view, &QTreeWidget::itemSelectionChanged, this, &SignalTable::showActions);
    base::onChange(this, &SignalTable::recolour, {QEvent::PaletteChange});
    base::keepTranslated(this, &SignalTable::retranslate);
}

std::vector<int> SignalTable::chosenRows() const {
    std::vector<int> rows;
    for (QTreeWidgetItem* item : m_view->selectedItems())
        rows.push_back(m_view->indexOfTopLevelItem(item));
    if (rows.empty() && m_rows.size() == 1)
        rows.push_back(0);
    std::ranges::sort(rows);
    return rows;
}

void SignalTable::showActions() {
    const std::vector<int> rows = chosenRows();
    for (QAction* action : rowActions())
        action->setEnabled(!rows.empty());
    m_derivative->setEnabled(std::ranges::any_of(
        rows, [this](int row) { return !m_rows[static_cast<std::size_t>(row)].isDerivative; }));
    m_spectrum->setChecked(!rows.empty() && std::ranges::all_of(rows, [this](int row) {
        return m_rows[static_cast<std::size_t>(row)].hasSpectrum;
    }));
}

void SignalTable::retranslate() {
    m_view->setAccessibleName(tr("Plotted signals with their values"));
    m_derivative->setText(tr("Add its &derivative"));
    m_spectrum->setText(tr("Show its &spectrum"));
    m_remove->setText(tr("&Remove"));
    labelColumns();
    setReadings({}, m_cursors_s);
}

void SignalTable::labelColumns() {
    const bool cursors = m_cursors_s.has_value();
    m_view->setHeaderLabels({tr("Plotted signal"), cursors ? tr("at A") : tr("Newest"), tr("at B"),
                             tr("B \u2212 A", "difference of two values"), tr("Unit")});
    for (int column = aColumn; column < unitColumn; ++column)
        m_view->headerItem()->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
    m_view->setColumnHidden(bColumn, !cursors);
    m_view->setColumnHidden(differenceColumn, !cursors);
    m_times->setVisible(cursors);
}

void SignalTable::recolour() {
    const bool dark = base::isDark(palette());
    for (std::size_t i = 0; i < m_rows.size(); ++i)
        m_view->topLevelItem(static_cast<int>(i))
            ->setIcon(signalColumn, swatch(base::identityColour(m_rows[i].colour, dark), base::em(this, 1)));
}

void SignalTable::setRows(const std::vector<SignalRow>& rows) {
    if (rows == m_rows)
        return;
    m_rows = rows;
    while (m_view->topLevelItemCount() > static_cast<int>(rows.size()))
        delete m_view->takeTopLevelItem(m_view->topLevelItemCount() - 1);
    while (m_view->topLevelItemCount() < static_cast<int>(rows.size())) {
        auto* item = new QTreeWidgetItem(m_view);
        for (int column = aColumn; column < unitColumn; ++column)
            item->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
        QTreeWidgetItem* item = m_view->topLevelItem(static_cast<int>(i));
        QString text = rows[i].name;
        if (!rows[i].note.isEmpty())
            text += QStringLiteral(" \u2013 ") + rows[i].note;
        item->setText(signalColumn, text);
        item->setToolTip(signalColumn, text);
        item->setText(unitColumn, unitText(rows[i].unit));
    }
    recolour();
    showActions();
}

void SignalTable::setReadings(const std::vector<SignalReading>& readings, std::optional<double> cursors_s) {
    const bool had = std::exchange(m_cursors_s, cursors_s).has_value();
    if (had != cursors_s.has_value())
        labelColumns();
    if (cursors_s) {
        const QString frequency = *cursors_s != 0.0 ? base::siText(1.0 / *cursors_s, QStringLiteral("Hz"), 2)
                                                    : QStringLiteral("\u2014");
        m_times->setText(tr("B \u2212 A: %1, 1/(B \u2212 A): %2")
                             .arg(base::siText(*cursors_s, QStringLiteral("s"), 2), frequency));
    }
    for (std::size_t i = 0; i < std::min(readings.size(), m_rows.size()); ++i) {
        QTreeWidgetItem* item = m_view->topLevelItem(static_cast<int>(i));
        const auto [a, b] = readings[i];
        item->setText(aColumn, base::significantDigits(a, kDigits));
        item->setText(bColumn, base::significantDigits(b, kDigits));
        item->setText(differenceColumn,
                      base::significantDigits(a && b ? std::optional(*b - *a) : std::nullopt, kDigits));
    }
}

QString SignalTable::times() const {
    return m_times->text();
}

} // namespace teleta::signal
