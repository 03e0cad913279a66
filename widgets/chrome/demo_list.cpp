// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/chrome/demo_list.h"

#include "widgets/base/theme.h"
#include "widgets/chrome/demo_card.h"

#include <QLabel>
#include <QResizeEvent>
#include <QVBoxLayout>

#include <algorithm>

namespace teleta::chrome {

namespace {

constexpr int kMostColumns = 3;
constexpr double kColumn_em = 21.0;

/// The lowest number of cards in the longest of some columns that hold the groups in their order.
int lowestHeight(const std::vector<int>& cards, int columns) {
    const auto columnsFor = [&](int most) {
        int used = 1;
        int filled = 0;
        for (const int count : cards) {
            if (filled + count > most && filled > 0) {
                ++used;
                filled = 0;
            }
            filled += count;
        }
        return used;
    };
    int most = cards.empty() ? 0 : *std::ranges::max_element(cards);
    while (columnsFor(most) > columns)
        ++most;
    return most;
}

} // namespace

DemoList::DemoList(QWidget* parent)
    : QScrollArea(parent) {
    auto* content = new QWidget(this);
    content->setLayout(m_row);
    m_row->setContentsMargins(base::grid(this, base::kGroup), 0, base::grid(this, base::kGroup), 0);
    m_row->setSpacing(base::grid(this, base::kGroup));
    setWidget(content);
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    // Shows the background of the page.
    viewport()->setAutoFillBackground(false);
    content->setAutoFillBackground(false);
}

void DemoList::setDemos(const std::vector<SourceChooser::Demo>& demos) {
    for (const Group& group : m_groups)
        delete group.box;
    m_groups.clear();
    m_cards.clear();
    QString name;
    for (const SourceChooser::Demo& demo : demos) {
        if (m_groups.empty() || demo.group != name) {
            name = demo.group;
            auto* box = new QWidget(widget());
            auto* column = new QVBoxLayout(box);
            column->setContentsMargins(0, 0, 0, base::grid(this));
            column->setSpacing(base::grid(this, 0.75));
            auto* heading = new QLabel(name, box);
            heading->setFont(base::bold(base::sized(font(), base::kTitleText)));
            column->addWidget(heading);
            m_groups.push_back({box, 0});
        }
        Group& group = m_groups.back();
        auto* card = new DemoCard(base::Icon::scene, demo.title, demo.description, group.box);
        connect(card, &DemoCard::clicked, this, [this, path = demo.path] { emit demoRequested(path); });
        group.box->layout()->addWidget(card);
        ++group.cards;
        m_cards.insert(demo.path, card);
    }
    m_columns = 0;
    arrange();
    updateGeometry();
}

void DemoList::setPicture(const QString& path, const QImage& picture) {
    if (DemoCard* card = m_cards.value(path))
        card->setPicture(picture);
}

QSize DemoList::sizeHint() const {
    return {kMostColumns * base::em(this, kColumn_em), m_row->sizeHint().height() + 2 * frameWidth()};
}

void DemoList::resizeEvent(QResizeEvent* event) {
    QScrollArea::resizeEvent(event);
    arrange();
    updateGeometry();
}

void DemoList::arrange() {
    const int columns = std::clamp(viewport()->width() / base::em(this, kColumn_em), 1, kMostColumns);
    if (columns == m_columns)
        return;
    m_columns = columns;
    while (QLayoutItem* column = m_row->takeAt(0)) {
        while (QLayoutItem* item = column->layout()->takeAt(0))
            delete item;
        delete column;
    }
    std::vector<int> counts;
    for (const Group& group : m_groups)
        counts.push_back(group.cards + 1); // with its heading
    const int most = lowestHeight(counts, columns);
    QVBoxLayout* column = nullptr;
    int filled = 0;
    for (std::size_t i = 0; i < m_groups.size(); ++i) {
        if (column == nullptr || filled + counts[i] > most) {
            if (column != nullptr)
                column->addStretch(1);
            column = new QVBoxLayout;
            m_row->addLayout(column, 1);
            filled = 0;
        }
        column->addWidget(m_groups[i].box);
        filled += counts[i];
    }
    if (column != nullptr)
        column->addStretch(1);
}

} // namespace teleta::chrome
