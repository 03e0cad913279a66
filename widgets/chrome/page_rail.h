// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/base/icons.h"

#include <QButtonGroup>
#include <QString>
#include <QVBoxLayout>
#include <QWidget>

#include <vector>

class QToolButton;

namespace teleta::chrome {

/// The console's pages as large buttons at the left edge. Ctrl+1, Ctrl+2 ... choose a page. Thread: GUI.
class PageRail : public QWidget {
    Q_OBJECT

public:
    explicit PageRail(QWidget* parent = nullptr);

    /// name: stable, for settings and the command line. title: translated, displayed.
    void addPage(const QString& name, base::Icon icon, const QString& title, const QString& toolTip);
    void setTitle(const QString& name, const QString& title, const QString& toolTip);
    void setCurrentPage(const QString& name);
    /// Without the names of the pages, for a small window: their tool tips say them.
    void setIconsOnly(bool iconsOnly);
    [[nodiscard]] QString currentPage() const;

signals:
    void pageRequested(const QString& name);

private:
    struct Page {
        QString name;
        base::Icon icon;
        QString title;
        QString about;
        QToolButton* button = nullptr;
    };
    void restyle();

    QVBoxLayout* m_layout = new QVBoxLayout(this);
    QButtonGroup* m_group = new QButtonGroup(this);
    std::vector<Page> m_pages;
    bool m_iconsOnly = false;
};

} // namespace teleta::chrome
