// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QAction;
class QLineEdit;
class QListWidget;
class QTextBrowser;

namespace teleta::console {

/// The handbook: its pages at the left, the chosen one beside them, with back, forward and search. In the
/// language of the program, which may change meanwhile. Thread: GUI.
class HandbookWindow : public QWidget {
    Q_OBJECT

public:
    explicit HandbookWindow(QWidget* parent);

    /// A page by its name; the first one when there is none of that name.
    void showPage(const QString& name);
    [[nodiscard]] const QString& page() const { return m_page; }

protected:
    void changeEvent(QEvent* event) override;

private:
    void load();
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
