// SPDX-License-Identifier: GPL-3.0-or-later
// Where the docks of each kind of source stand, and how they share the room.
#include "app/console/operate/operate_docks.h"
#include "widgets/base/theme.h"

#include <QDockWidget>
#include <QScopedValueRollback>
#include <QSet>

#include <algorithm>
#include <initializer_list>

namespace teleta::console {

void OperateDocks::arrange() {
    const QScopedValueRollback building(m_building, true);
    m_sceneClosed[index()] = false;
    arrangeKind();
    showScene();
}

void OperateDocks::arrangeKind() {
    for (QDockWidget* dock : m_docks) {
        dock->setFloating(false);
        removeDockWidget(dock); // hides it
    }
    const auto show = [this](std::initializer_list<Dock> docks) {
        for (const Dock dock : docks)
            m_docks[dock]->show();
    };
    // The others have a place too, but hidden: otherwise Qt would make room for them whenever it restores a
    // layout.
    for (std::size_t i = 0; i < kDocks; ++i) {
        if (belongs(m_kind, i))
            continue;
        addDockWidget(Qt::BottomDockWidgetArea, m_docks[i]);
        m_docks[i]->hide();
    }
    if (m_kind == Kind::camera) {
        addDockWidget(Qt::LeftDockWidgetArea, m_docks[camera]);
        splitDockWidget(m_docks[camera], m_docks[reconstruction], Qt::Horizontal);
        splitDockWidget(m_docks[reconstruction], m_docks[events], Qt::Vertical);
        splitDockWidget(m_docks[camera], m_docks[scene], Qt::Vertical);
        tabifyDockWidget(m_docks[events], m_docks[marks]);
        show({camera, reconstruction, events, marks});
        m_docks[events]->raise();
        return;
    }
    if (m_kind == Kind::gel) {
        addDockWidget(Qt::LeftDockWidgetArea, m_docks[gel]);
        splitDockWidget(m_docks[gel], m_docks[reconstruction], Qt::Horizontal);
        splitDockWidget(m_docks[reconstruction], m_docks[gelEvents], Qt::Vertical);
        splitDockWidget(m_docks[gel], m_docks[scene], Qt::Vertical);
        tabifyDockWidget(m_docks[gelEvents], m_docks[marks]);
        show({gel, reconstruction, gelEvents, marks});
        m_docks[gelEvents]->raise();
        return;
    }
    if (m_kind == Kind::scene) {
        addDockWidget(Qt::LeftDockWidgetArea, m_docks[scene]);
        tabifyDockWidget(m_docks[scene], m_docks[marks]);
        show({marks});
        return;
    }
    if (m_kind == Kind::joints) {
        addDockWidget(Qt::LeftDockWidgetArea, m_docks[reconstruction]);
        splitDockWidget(m_docks[reconstruction], m_docks[joints], Qt::Vertical);
        splitDockWidget(m_docks[joints], m_docks[scene], Qt::Horizontal);
        tabifyDockWidget(m_docks[joints], m_docks[marks]);
        addDockWidget(Qt::RightDockWidgetArea, m_docks[jog]);
        show({reconstruction, joints, marks, jog});
        m_docks[joints]->raise();
        return;
    }
    addDockWidget(Qt::LeftDockWidgetArea, m_docks[heatmap]);
    if (m_kind == Kind::array) {
        splitDockWidget(m_docks[heatmap], m_docks[charts], Qt::Vertical);
        splitDockWidget(m_docks[heatmap], m_docks[reconstruction], Qt::Horizontal);
        splitDockWidget(m_docks[charts], m_docks[scene], Qt::Horizontal);
        addDockWidget(Qt::RightDockWidgetArea, m_docks[processing]);
        tabifyDockWidget(m_docks[charts], m_docks[marks]);
        show({heatmap, charts, reconstruction, processing, marks});
        m_docks[charts]->raise();
        return;
    }
    if (m_kind == Kind::servo) {
        splitDockWidget(m_docks[heatmap], m_docks[charts], Qt::Vertical);
        splitDockWidget(m_docks[heatmap], m_docks[reconstruction], Qt::Horizontal);
        splitDockWidget(m_docks[charts], m_docks[scene], Qt::Horizontal);
        tabifyDockWidget(m_docks[charts], m_docks[runs]);
        tabifyDockWidget(m_docks[charts], m_docks[marks]);
        addDockWidget(Qt::RightDockWidgetArea, m_docks[servo]);
        tabifyDockWidget(m_docks[servo], m_docks[processing]);
        show({heatmap, charts, runs, marks, reconstruction, servo, processing});
        m_docks[charts]->raise();
        m_docks[servo]->raise();
        return;
    }
    splitDockWidget(m_docks[heatmap], m_docks[joints], Qt::Vertical);
    splitDockWidget(m_docks[heatmap], m_docks[reconstruction], Qt::Horizontal);
    splitDockWidget(m_docks[joints], m_docks[scene], Qt::Horizontal);
    tabifyDockWidget(m_docks[joints], m_docks[contour]);
    tabifyDockWidget(m_docks[joints], m_docks[charts]);
    tabifyDockWidget(m_docks[joints], m_docks[touches]);
    tabifyDockWidget(m_docks[joints], m_docks[objects]);
    tabifyDockWidget(m_docks[joints], m_docks[marks]);
    addDockWidget(Qt::RightDockWidgetArea, m_docks[stiffness]);
    splitDockWidget(m_docks[stiffness], m_docks[bracelet], Qt::Vertical);
    splitDockWidget(m_docks[bracelet], m_docks[jog], Qt::Vertical);
    tabifyDockWidget(m_docks[jog], m_docks[feedback]);
    tabifyDockWidget(m_docks[jog], m_docks[processing]);
    show({heatmap, reconstruction, joints, contour, charts, touches, objects, marks, stiffness, bracelet, jog,
          feedback, processing});
    m_docks[joints]->raise();
    m_docks[jog]->raise();
}

void OperateDocks::shareSpace() {
    shareAmongKind();
    // The scene has taken a part of what it stands beside, or below.
    if (!isUsed(scene) || m_docks[scene]->isHidden() || m_kind == Kind::scene)
        return;
    if (m_kind == Kind::camera || m_kind == Kind::gel)
        resizeDocks({m_docks[m_kind == Kind::gel ? gel : camera], m_docks[scene]},
                    {height() / 2, height() / 2}, Qt::Vertical);
    else
        resizeDocks(
            {m_docks[m_kind == Kind::array || m_kind == Kind::servo ? charts : joints], m_docks[scene]},
            {width() * 11 / 20, width() * 9 / 20}, Qt::Horizontal);
}

void OperateDocks::shareAmongKind() {
    if (m_kind == Kind::scene)
        return;
    if (m_kind == Kind::camera || m_kind == Kind::gel) {
        const bool isGel = m_kind == Kind::gel;
        resizeDocks({m_docks[isGel ? gel : camera], m_docks[reconstruction]},
                    {width() * 11 / 20, width() * 9 / 20}, Qt::Horizontal);
        resizeDocks({m_docks[reconstruction], m_docks[isGel ? gelEvents : events]},
                    {height() * 13 / 20, height() * 7 / 20}, Qt::Vertical);
        return;
    }
    if (m_kind == Kind::joints) {
        const int side = base::em(this, 25);
        resizeDocks({m_docks[reconstruction], m_docks[jog]}, {std::max(width() - side, side), side},
                    Qt::Horizontal);
        resizeDocks({m_docks[reconstruction], m_docks[joints]}, {height() * 11 / 20, height() * 9 / 20},
                    Qt::Vertical);
        return;
    }
    if (m_kind != Kind::arm) {
        const bool servos = m_kind == Kind::servo;
        const int settings = base::em(this, servos ? 25 : 18);
        const int rest = std::max(width() - settings, settings);
        resizeDocks({m_docks[heatmap], m_docks[charts]}, {height() * 11 / 20, height() * 9 / 20},
                    Qt::Vertical);
        resizeDocks({m_docks[heatmap], m_docks[reconstruction], m_docks[servos ? servo : processing]},
                    {rest * 11 / 20, rest * 9 / 20, settings}, Qt::Horizontal);
        return;
    }
    // In a small window the pictures have more than half of the width.
    const int side = std::min(base::em(this, 25), std::max(base::em(this, 20), width() * 2 / 5));
    const int rest = std::max(width() - side, side);
    resizeDocks({m_docks[heatmap], m_docks[joints]}, {height() * 11 / 20, height() * 9 / 20}, Qt::Vertical);
    resizeDocks({m_docks[heatmap], m_docks[reconstruction], m_docks[stiffness]},
                {rest * 9 / 20, rest * 11 / 20, side}, Qt::Horizontal);
    // The hand controls are whole where there is room, and scroll before the pictures are cut.
    const int hand = m_docks[jog]->sizeHint().height() + base::em(this, 2);
    const int pictures = std::clamp(height() - hand, base::em(this, 23), base::em(this, 27));
    resizeDocks({m_docks[stiffness], m_docks[bracelet], m_docks[jog]},
                {pictures * 14 / 27, pictures * 13 / 27, std::max(height() - pictures, 1)}, Qt::Vertical);
}

std::array<QSize, OperateDocks::kDocks> OperateDocks::sizesNow() const {
    std::array<QSize, kDocks> sizes;
    for (std::size_t i = 0; i < kDocks; ++i)
        sizes[i] = m_docks[i]->isVisible() && !m_docks[i]->isFloating() ? m_docks[i]->size() : QSize();
    return sizes;
}

void OperateDocks::noteSizes() {
    m_sizesIn = size();
    m_sizes = sizesNow();
}

void OperateDocks::bringSizes() {
    if (m_sizesIn.isEmpty())
        noteSizes();
    else
        keepSizes();
}

void OperateDocks::keepSizes() {
    if (m_sizesIn.isEmpty())
        return;
    const auto isForm = [](std::size_t dock) {
        return dock == processing || dock == stiffness || dock == bracelet || dock == jog ||
               dock == feedback || dock == servo;
    };
    int forms = 0;
    for (std::size_t i = 0; i < kDocks; ++i)
        if (isForm(i) && m_sizes[i].isValid())
            forms = std::max(forms, m_sizes[i].width());
    const double wider =
        std::max(width() - forms, 1) / std::max(1.0, m_sizesIn.width() - static_cast<double>(forms));
    const double higher = static_cast<double>(height()) / m_sizesIn.height();
    const auto isSeen = [this](std::size_t dock) {
        return m_sizes[dock].isValid() && m_docks[dock]->isVisible() && !m_docks[dock]->isFloating();
    };
    // What stands above or below a form is as wide as that.
    QSet<int> columnsOfForms;
    for (std::size_t i = 0; i < kDocks; ++i)
        if (isForm(i) && isSeen(i))
            columnsOfForms << m_docks[i]->x();
    QList<QDockWidget*> inRows;
    QList<QDockWidget*> inColumns;
    QList<int> widths;
    QList<int> heights;
    for (std::size_t i = 0; i < kDocks; ++i) {
        if (!isSeen(i))
            continue;
        inColumns << m_docks[i];
        heights << std::max(1, qRound(higher * m_sizes[i].height()));
        if (!isForm(i) && columnsOfForms.contains(m_docks[i]->x()))
            continue;
        inRows << m_docks[i];
        widths << (isForm(i) ? m_sizes[i].width() : std::max(1, qRound(wider * m_sizes[i].width())));
    }
    resizeDocks(inRows, widths, Qt::Horizontal);
    resizeDocks(inColumns, heights, Qt::Vertical);
}

} // namespace teleta::console
