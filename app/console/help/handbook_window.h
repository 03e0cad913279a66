// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QAction;
class QLineEdit;
class QListWidget;
class QTextBrowser;

namespace teleta::console {

/// The handbook: list of pages on the left, the chosen one beside it, with back, forward and search. Follows
/// the language of the program. Thread: GUI.
class HandbookWindow : public QWidget {
    Q_OBJECT

public:
    explicit HandbookWindow(QWidget* parent);

    /// Shows a page by its name, or the first one if there is none of that name.
    void showPage(const QString& name);
    [[nodiscard]] const QString& page() const { return m_page; }

private:
    void load();
    /// Marks the page that is shown in the list.
    void markPage();
    void search();
    void retranslate();

    QListWidget* m_list;
    QTextBrowser* m_text;
    QLineEdit* m_search;
    QAction* m_back;
    QAction* m_forward;
    QAction* m_find;
    QAction* m_close;
    QString m_page;
};

} // namespace teleta::console
