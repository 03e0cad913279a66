// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QPushButton;
class QTableView;

namespace teleta::console {

/// Begins the log with what a report of a fault needs: program, Qt and system with their versions; from now
/// on the messages of Qt come, too. Once, when there is an application. Thread: GUI.
void beginLog();

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
