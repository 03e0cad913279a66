// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QPushButton;
class QTableView;

namespace teleta::console {

/// Starts the log with what a fault report needs: the program, Qt and the system with their versions; from
/// then on Qt messages are logged too. Call it once, when there is an application. Thread: GUI.
void beginLog();

/// The messages since the program started (chrome::MessageLog), to read, copy and save as text. Opens at the
/// newest and follows new ones unless scrolled up. Thread: GUI.
class LogWindow : public QWidget {
    Q_OBJECT

public:
    explicit LogWindow(QWidget* parent);

protected:
    void showEvent(QShowEvent* event) override;

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
