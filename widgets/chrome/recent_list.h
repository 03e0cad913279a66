// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <QWidget>

class QHBoxLayout;
class QLabel;

namespace teleta::chrome {

/// On a page without a source: what was open the last time, and the files that were opened before, the newest
/// first, as buttons. Empty when there are neither. Thread: GUI.
class RecentList : public QWidget {
    Q_OBJECT

public:
    /// So many files are shown; the menu has the others.
    static constexpr int kFiles = 3;

    explicit RecentList(QWidget* parent = nullptr);

    /// files: paths; a button shows the name, its tool tip the path.
    void setFiles(const QStringList& files);
    /// names: what was open; empty: there is nothing to reopen.
    void setSession(const QString& names);

signals:
    void fileRequested(const QString& path);
    void sessionRequested();

private:
    void rebuild();

    QHBoxLayout* m_row;
    QLabel* m_title;
    QStringList m_files;
    QString m_session;
};

} // namespace teleta::chrome
