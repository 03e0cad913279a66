// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QPushButton;
class QTableView;

namespace teleta::console {

/// What the program has told since it began (chrome::MessageLog), to read, copy and save as text. Stays at
/// its end while more comes, unless one has scrolled up. Thread: GUI.
class LogWindow : public QWidget {
    Q_OBJECT

public:
    explicit LogWindow(QWidget* parent);

protected:
    void changeEvent(QEvent* event) override;

private:
    void save();
    void write(const QString& path);
    void retranslate();

    QTableView* m_table;
    QPushButton* m_copy;
    QPushButton* m_save;
    QPushButton* m_close;
};

} // namespace teleta::console
