// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/chrome/recent_name.h"

#include <QImage>
#include <QString>
#include <QStringList>
#include <QWidget>

#include <vector>

class QHBoxLayout;
class QIcon;
class QLabel;
class QToolButton;

namespace teleta::chrome {

/// On a page without a source: what was open the last time, and the files that were opened before, the newest
/// first, as buttons with a picture where there is one. Empty when there are neither. Thread: GUI.
class RecentList : public QWidget {
    Q_OBJECT

public:
    /// So many files are shown; the menu has the others.
    static constexpr int kFiles = 3;

    explicit RecentList(QWidget* parent = nullptr);

    /// files: paths; a button shows a name, its tool tip the path.
    void setFiles(const QStringList& files);
    /// What the buttons call the files, in place of their own names: the title, and below it the rest.
    void setNames(const RecentNames& names);
    /// A picture of a file, in place of its icon; unknown paths are ignored.
    void setPicture(const QString& path, const QImage& picture);
    /// names: what was open; empty: there is nothing to reopen.
    void setSession(const QString& names);

signals:
    void fileRequested(const QString& path);
    void sessionRequested();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    /// Of a text at most; the row is shared evenly.
    [[nodiscard]] int textWidth() const;
    void retranslate();
    void fill(QToolButton& button, const RecentName& name, const QString& about, const QIcon& icon);

    QHBoxLayout* m_row;
    QLabel* m_title;
    QToolButton* m_reopen;
    QString m_session;
    RecentNames m_names;
    struct File {
        QString path;
        QToolButton* button;
        QImage picture;
    };
    std::vector<File> m_files; ///< as they are shown
};

} // namespace teleta::chrome
