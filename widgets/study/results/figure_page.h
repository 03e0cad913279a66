// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/base/figure/svg_view.h"
#include "widgets/study/results/result_table.h"
#include "widgets/study/results/results_content.h"

#include <QComboBox>
#include <QLabel>
#include <QString>
#include <QWidget>

#include <functional>
#include <vector>

namespace teleta::study {

/// One of several pictures of a family of results.
struct FigureItem {
    QString key;  ///< stays when results are computed anew
    QString name; ///< in the list
    std::function<base::SvgView::Picture()> draw;
};

/// Pictures to choose from, and a table below them. Thread: GUI.
class FigurePage : public QWidget {
    Q_OBJECT

public:
    /// name: of the page's objects (nameChoice, nameView, nameTable) and of the table's file.
    explicit FigurePage(const QString& name, QWidget* parent = nullptr);

    /// Keeps what is chosen where it is still there.
    void setItems(std::vector<FigureItem> items, const TableContent& table);
    void setChoiceName(const QString& name) { m_choice->setAccessibleName(name); }
    /// What to know about the table; empty: nothing.
    void setNote(const QString& note);
    void setTableName(const QString& name) { m_table->setAccessibleName(name); }

signals:
    void figureFailed(const QString& message);

private:
    void show(int index);

    std::vector<FigureItem> m_items;
    QComboBox* m_choice;
    base::SvgView* m_view;
    ResultTable* m_table;
    QLabel* m_note;
};

} // namespace teleta::study
