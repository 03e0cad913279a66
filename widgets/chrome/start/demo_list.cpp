// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/chrome/start/demo_list.h"

#include "widgets/base/theme.h"
#include "widgets/chrome/start/demo_card.h"

#include <QLabel>
#include <QResizeEvent>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace teleta::chrome {

namespace {

constexpr int kMostColumns = 4;
constexpr double kColumn_em = 21.0;
constexpr double kSmallColumn_em = 13.0;
constexpr double kGroupGap = 1.0; ///< above a heading, more than below it
constexpr double kCardGap = 0.75; ///< in steps of the grid

/// The least height of the highest of some columns that hold groups of these heights in their order.
int lowestHeight(const std::vector<int>& heights, int columns) {
    const auto columnsFor = [&](int most) {
        int used = 1;
        int filled = 0;
        for (const int count : heights) {
            if (filled + count > most && filled > 0) {
                ++used;
                filled = 0;
            }
            filled += count;
        }
        return used;
    };
    int most = heights.empty() ? 0 : *std::ranges::max_element(heights);
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
    setFocusPolicy(Qt::ClickFocus); // no stop of Tab, which it could not show; its cards follow it
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
    QWidget* before = this;
    for (const SourceChooser::Demo& demo : demos) {
        if (m_groups.empty() || demo.group != name) {
            name = demo.group;
            auto* box = new QWidget(widget());
            auto* column = new QVBoxLayout(box);
            column->setContentsMargins(0, 0, 0, base::grid(this));
            column->setSpacing(base::grid(this, kCardGap));
            auto* heading = new QLabel(name, box);
            heading->setFont(base::bold(base::sized(font(), base::kTitleText)));
            column->addWidget(heading);
            m_groups.push_back({box, heading, 0});
        }
        Group& group = m_groups.back();
        auto* card = new DemoCard(base::Icon::scene, demo.title, demo.description, group.box);
        connect(card, &DemoCard::clicked, this, [this, path = demo.path] { emit demoRequested(path); });
        group.box->layout()->addWidget(card);
        ++group.cards;
        m_cards.insert(demo.path, card);
        setTabOrder(std::exchange(before, card), card);
    }
    m_plan = {};
    arrange();
    updateGeometry();
}

void DemoList::setPicture(const QString& path, const QImage& picture) {
    if (DemoCard* card = m_cards.value(path))
        card->setPicture(picture);
}

QSize DemoList::sizeHint() const {
    const int least = kMostColumns * base::em(this, kColumn_em);
    return {least, planOf(false, width() > 0 ? width() : least).height + 2 * frameWidth()};
}

void DemoList::resizeEvent(QResizeEvent* event) {
    QScrollArea::resizeEvent(event);
    arrange();
    updateGeometry();
}

DemoList::Plan DemoList::planOf(bool isSmall, int width) const {
    Plan plan{.isSmall = isSmall, .columns = {}};
    if (m_groups.empty())
        return plan;
    // All headings and all cards are alike.
    const auto size = isSmall ? DemoCard::Size::small : DemoCard::Size::large;
    const int card = DemoCard::heightOf(*this, size) + base::grid(this, kCardGap);
    const int heading = m_groups.front().heading->sizeHint().height() + base::grid(this, 1.0 + kGroupGap);
    std::vector<int> heights;
    for (const Group& group : m_groups)
        heights.push_back(heading + group.cards * card);
    const int columns =
        std::clamp(width / base::em(this, isSmall ? kSmallColumn_em : kColumn_em), 1, kMostColumns);
    const int most = lowestHeight(heights, columns);
    int filled = 0;
    for (std::size_t i = 0; i < m_groups.size(); ++i) {
        if (plan.columns.empty() || filled + heights[i] > most) {
            plan.columns.emplace_back();
            filled = 0;
        }
        plan.columns.back().push_back(i);
        filled += heights[i];
        plan.height = std::max(plan.height, filled);
    }
    return plan;
}

void DemoList::arrange() {
    const QSize room = viewport()->size();
    Plan plan = planOf(false, room.width());
    if (plan.height > room.height())
        plan = planOf(true, room.width());
    if (plan == m_plan)
        return;
    m_plan = plan;
    while (QLayoutItem* column = m_row->takeAt(0)) {
        while (QLayoutItem* item = column->layout()->takeAt(0))
            delete item;
        delete column;
    }
    for (DemoCard* card : m_cards)
        card->setSize(plan.isSmall ? DemoCard::Size::small : DemoCard::Size::large);
    for (const std::vector<std::size_t>& groups : plan.columns) {
        auto* column = new QVBoxLayout;
        column->setSpacing(base::grid(this, kGroupGap));
        for (const std::size_t group : groups)
            column->addWidget(m_groups[group].box);
        column->addStretch(1);
        m_row->addLayout(column, 1);
    }
}

} // namespace teleta::chrome
