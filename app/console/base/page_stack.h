// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStackedWidget>

namespace teleta::console {

/// The pages of the window. One that needs more room than there is scrolls: neither a page, one behind it,
/// nor its words in another language make the window larger than the screen, with STOP off it. Thread: GUI.
class PageStack : public QStackedWidget {
    Q_OBJECT

public:
    using QStackedWidget::QStackedWidget;

    void addPage(QWidget* page);
    void showPage(QWidget* page);
};

} // namespace teleta::console
