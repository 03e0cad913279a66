// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/chrome/demo_list.h"

#include "widgets/base/icons.h"
#include "widgets/base/theme.h"

#include <QCommandLinkButton>
#include <QResizeEvent>

#include <algorithm>

namespace teleta::chrome {

namespace {

constexpr int kMostColumns = 3;
constexpr double kButton_em = 24.0;

} // namespace

DemoList::DemoList(QWidget* parent)
    : QScrollArea(parent) {
    auto* content = new QWidget(this);
    content->setLayout(m_grid);
    m_grid->setContentsMargins(base::grid(this, 2), 0, base::grid(this, 2), 0);
    setWidget(content);
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    // Shows the background of the page.
    viewport()->setAutoFillBackground(false);
    content->setAutoFillBackground(false);
}

void DemoList::setDemos(const std::vector<SourceChooser::Demo>& demos) {
    for (QWidget* button : m_buttons)
        delete button;
    m_buttons.clear();
    for (const SourceChooser::Demo& demo : demos) {
        auto* button = new QCommandLinkButton(demo.title, demo.description, widget());
        button->setIcon(base::themeIcon(base::Icon::scene));
        button->setAccessibleName(demo.title);
        button->setAccessibleDescription(demo.description);
        connect(button, &QCommandLinkButton::clicked, this,
                [this, path = demo.path] { emit demoRequested(path); });
        m_buttons.push_back(button);
    }
    m_columns = 0;
    arrange();
    updateGeometry();
}

QSize DemoList::sizeHint() const {
    const int width = viewport()->width();
    const int height =
        m_grid->hasHeightForWidth() ? m_grid->heightForWidth(width) : m_grid->sizeHint().height();
    return {kMostColumns * base::em(this, kButton_em), height + 2 * frameWidth()};
}

void DemoList::resizeEvent(QResizeEvent* event) {
    QScrollArea::resizeEvent(event);
    arrange();
    updateGeometry();
}

void DemoList::arrange() {
    const int columns = std::clamp(viewport()->width() / base::em(this, kButton_em), 1, kMostColumns);
    if (columns == m_columns)
        return;
    m_columns = columns;
    for (int column = 0; column < kMostColumns; ++column)
        m_grid->setColumnStretch(column, column < columns ? 1 : 0);
    int place = 0;
    for (QWidget* button : m_buttons) {
        m_grid->addWidget(button, place / columns, place % columns);
        ++place;
    }
    for (int row = 0; row <= place; ++row)
        m_grid->setRowStretch(row, row == place ? 1 : 0);
}

} // namespace teleta::chrome
