// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/base/icons.h"

#include <QString>
#include <QWidget>

#include <vector>

class QButtonGroup;
class QToolButton;
class QVBoxLayout;

namespace teleta::chrome {

/// The pages of the console as a rail of large buttons at the left edge. Ctrl+1, Ctrl+2, ... choose a page.
/// Thread: GUI.
class PageRail : public QWidget {
    Q_OBJECT

public:
    explicit PageRail(QWidget* parent = nullptr);

    /// name: stable, for settings and the command line. title: translated, displayed.
    void addPage(const QString& name, base::Icon icon, const QString& title, const QString& toolTip);
    void setTitle(const QString& name, const QString& title, const QString& toolTip);
    void setCurrentPage(const QString& name);
    [[nodiscard]] QString currentPage() const;

signals:
    void pageRequested(const QString& name);

private:
    struct Page {
        QString name;
        base::Icon icon;
        QToolButton* button = nullptr;
    };
    void restyle();

    QVBoxLayout* m_layout;
    QButtonGroup* m_group;
    std::vector<Page> m_pages;
};

} // namespace teleta::chrome
