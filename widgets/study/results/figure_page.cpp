// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/study/results/figure_page.h"

#include "widgets/base/theme.h"

#include <QScrollArea>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace teleta::study {

FigurePage::FigurePage(const QString& name, QWidget* parent)
    : QWidget(parent)
    , m_choice(new QComboBox(this))
    , m_view(new base::SvgView(this))
    , m_table(new ResultTable(name, this))
    , m_note(new QLabel(this)) {
    m_choice->setObjectName(name + QStringLiteral("Choice"));
    m_view->setObjectName(name + QStringLiteral("View"));
    m_table->setObjectName(name + QStringLiteral("Table"));
    m_note->setObjectName(name + QStringLiteral("Note"));
    m_note->setWordWrap(true);
    m_note->setTextFormat(Qt::PlainText);
    m_note->setFont(base::sized(m_note->font(), base::kSmallText));
    m_note->hide();
    m_choice->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    auto* content = new QWidget(this);
    auto* column = new QVBoxLayout(content);
    const int margin = base::grid(this, 2);
    column->setContentsMargins(margin, margin, margin, margin);
    column->setSpacing(base::grid(this, 1.5));
    column->addWidget(m_choice, 0, Qt::AlignLeft);
    column->addWidget(m_view);
    column->addWidget(m_table);
    column->addWidget(m_note);
    column->addStretch(1);
    auto* area = new QScrollArea(this);
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setWidget(content);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(area);
    connect(m_choice, &QComboBox::currentIndexChanged, this, &FigurePage::show);
    connect(m_view, &base::SvgView::exportFailed, this, &FigurePage::figureFailed);
    connect(&m_table->exporter(), &base::FigureExport::failed, this, &FigurePage::figureFailed);
}

void FigurePage::setItems(std::vector<FigureItem> items, const TableContent& table) {
    const QString chosen = m_choice->currentData().toString();
    m_items = std::move(items);
    {
        const QSignalBlocker quiet(m_choice);
        m_choice->clear();
        for (const FigureItem& item : m_items)
            m_choice->addItem(item.name, item.key);
        m_choice->setCurrentIndex(std::max(0, m_choice->findData(chosen)));
    }
    m_table->setRows(table.header, table.tips, table.rows);
    m_table->setVisible(!table.rows.empty());
    m_view->setMinimumHeight(base::em(this, 26));
    show(m_choice->currentIndex());
}

void FigurePage::setNote(const QString& note) {
    m_note->setText(note);
    m_note->setVisible(!note.isEmpty());
}

void FigurePage::show(int index) {
    if (index < 0 || static_cast<std::size_t>(index) >= m_items.size())
        m_view->setPicture({});
    else
        m_view->setPicture(m_items[static_cast<std::size_t>(index)].draw());
}

} // namespace teleta::study
