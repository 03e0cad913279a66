// SPDX-License-Identifier: GPL-3.0-or-later
// Where the docks of each kind of source stand, and how they share the room.
#include "app/console/operate/docks/operate_docks.h"
#include "widgets/base/theme.h"

#include <QDockWidget>
#include <QScopedValueRollback>
#include <QScrollArea>
#include <QSet>
#include <QTabBar>

#include <algorithm>
#include <array>
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
    if (isStacked()) {
        arrangeStacked();
        return;
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

/// The other kinds have room enough as they are.
bool OperateDocks::isStacked() const {
    return m_small &&
           (m_kind == Kind::array || m_kind == Kind::arm || m_kind == Kind::servo || m_kind == Kind::joints);
}

void OperateDocks::arrangeStacked() {
    const bool moves = m_kind == Kind::arm || m_kind == Kind::joints;
    const std::array pictures{moves || m_kind == Kind::servo ? reconstruction : heatmap,
                              moves || m_kind == Kind::servo ? heatmap : reconstruction,
                              joints,
                              contour,
                              charts,
                              runs,
                              touches,
                              objects,
                              marks,
                              scene};
    const std::array forms{moves                   ? jog
                           : m_kind == Kind::servo ? servo
                                                   : processing,
                           bracelet, feedback, processing};
    addDockWidget(Qt::LeftDockWidgetArea, m_docks[pictures.front()]);
    addDockWidget(Qt::RightDockWidgetArea, m_docks[forms.front()]);
    if (m_kind == Kind::arm) {
        addDockWidget(Qt::RightDockWidgetArea, m_docks[stiffness]);
        splitDockWidget(m_docks[stiffness], m_docks[forms.front()], Qt::Vertical);
        m_docks[stiffness]->show();
    }
    const auto stack = [this](const auto& docks) {
        for (const Dock dock : docks) {
            if (!belongs(m_kind, dock))
                continue;
            if (dock != docks.front())
                tabifyDockWidget(m_docks[docks.front()], m_docks[dock]);
            m_docks[dock]->setVisible(dock != scene);
        }
        m_docks[docks.front()]->raise();
    };
    stack(pictures);
    stack(forms);
}

void OperateDocks::shareStacked() {
    const bool isForced = m_kind == Kind::servo;
    const int side = base::em(this, m_kind == Kind::array ? 14 : isForced ? 25 : 24);
    const Dock form = m_kind == Kind::array ? processing : isForced ? servo : jog;
    share({{{heatmap, reconstruction}, std::max(width() - side, side)}, {{form}, side}}, Qt::Horizontal);
    if (m_kind != Kind::arm)
        return;
    const int hand = neededHeight(jog);
    const int above = std::max(height() - hand, base::em(this, 7));
    share({{{stiffness}, above}, {{jog}, std::max(height() - above, 1)}}, Qt::Vertical);
}

void OperateDocks::shareSpace() {
    if (isStacked()) {
        shareStacked();
        return;
    }
    shareAmongKind();
    // The scene has taken a part of what it stands beside, or below.
    if (!isUsed(scene) || m_docks[scene]->isHidden() || m_kind == Kind::scene)
        return;
    if (m_kind == Kind::camera || m_kind == Kind::gel)
        share({{{m_kind == Kind::gel ? gel : camera}, height() / 2}, {{scene}, height() / 2}}, Qt::Vertical);
    else
        share({{{m_kind == Kind::array || m_kind == Kind::servo ? charts : joints}, width() * 11 / 20},
               {{scene}, width() * 9 / 20}},
              Qt::Horizontal);
}

void OperateDocks::shareAmongKind() {
    if (m_kind == Kind::scene)
        return;
    if (m_kind == Kind::camera || m_kind == Kind::gel) {
        const bool isGel = m_kind == Kind::gel;
        const Dock list = isGel ? gelEvents : events;
        share({{{isGel ? gel : camera}, width() * 11 / 20}, {{reconstruction, list}, width() * 9 / 20}},
              Qt::Horizontal);
        share({{{reconstruction}, height() * 13 / 20}, {{list}, height() * 7 / 20}}, Qt::Vertical);
        return;
    }
    if (m_kind == Kind::joints) {
        const int side = base::em(this, 25);
        share({{{reconstruction, joints}, std::max(width() - side, side)}, {{jog}, side}}, Qt::Horizontal);
        share({{{reconstruction}, height() * 11 / 20}, {{joints}, height() * 9 / 20}}, Qt::Vertical);
        return;
    }
    if (m_kind != Kind::arm) {
        const bool servos = m_kind == Kind::servo;
        const int settings = base::em(this, servos ? 25 : 14);
        const int rest = std::max(width() - settings, settings);
        share({{{heatmap, reconstruction}, height() * 11 / 20}, {{charts}, height() * 9 / 20}}, Qt::Vertical);
        share({{{heatmap}, rest * 11 / 20},
               {{reconstruction}, rest * 9 / 20},
               {{servos ? servo : processing}, settings}},
              Qt::Horizontal);
        return;
    }
    // In a small window the pictures have more than half of the width.
    const int side = std::min(base::em(this, 25), std::max(base::em(this, 20), width() * 2 / 5));
    const int rest = std::max(width() - side, side);
    share({{{heatmap, reconstruction}, height() * 11 / 20}, {{joints}, height() * 9 / 20}}, Qt::Vertical);
    share(
        {{{heatmap}, rest * 9 / 20}, {{reconstruction}, rest * 11 / 20}, {{stiffness, bracelet, jog}, side}},
        Qt::Horizontal);
    // The hand controls are whole where there is room, and scroll before the pictures are cut.
    const int hand = neededHeight(jog);
    const int pictures = std::clamp(height() - hand, base::em(this, 18), base::em(this, 27));
    share({{{stiffness}, pictures * 14 / 27},
           {{bracelet}, pictures * 13 / 27},
           {{jog}, std::max(height() - pictures, 1)}},
          Qt::Vertical);
}

/// Of a form with the tabs above it, when nothing of it scrolls.
int OperateDocks::neededHeight(Dock dock) const {
    const QWidget* form = m_docks[dock]->widget();
    if (const auto* room = qobject_cast<const QScrollArea*>(form))
        form = room->widget(); // the room itself limits and remembers what it would like
    return form->sizeHint().height() + base::em(this, 2.5);
}

QDockWidget* OperateDocks::standing(std::initializer_list<Dock> docks) const {
    const auto stands = [](const QDockWidget* dock) { return !dock->isHidden() && !dock->isFloating(); };
    for (const Dock dock : docks) {
        if (stands(m_docks[dock]))
            return m_docks[dock];
        for (QDockWidget* other : tabifiedDockWidgets(m_docks[dock]))
            if (stands(other))
                return other;
    }
    return nullptr;
}

void OperateDocks::share(std::initializer_list<Share> shares, Qt::Orientation orientation) {
    QList<QDockWidget*> docks;
    QList<int> sizes;
    QList<int> growing; // forms keep their size
    int free = 0;
    int all = 0;
    for (const Share& share : shares) {
        if (QDockWidget* dock = standing(share.docks)) {
            const bool grows = orientation == Qt::Vertical || !isForm(*share.docks.begin());
            docks << dock;
            sizes << share.size;
            growing << (grows ? share.size : 0);
            all += growing.back();
        } else {
            free += share.size;
        }
    }
    for (qsizetype i = 0; all > 0 && i < sizes.size(); ++i)
        sizes[i] += free * growing[i] / all;
    resizeDocks(docks, sizes, orientation);
}

bool OperateDocks::isForm(std::size_t dock) {
    return dock == processing || dock == stiffness || dock == bracelet || dock == jog || dock == feedback ||
           dock == servo;
}

/// Qt puts a dock behind others outside of the window, where it keeps a size of its own.
bool OperateDocks::isSeen(std::size_t dock) const {
    const QDockWidget& frame = *m_docks[dock];
    return frame.isVisible() && !frame.isFloating() && rect().intersects(frame.geometry());
}

/// Height of the tabs above the dock, if any: for Qt they are a part of it.
int OperateDocks::tabRoom(const QDockWidget& dock) const {
    for (const auto* tabs : findChildren<QTabBar*>(QString(), Qt::FindDirectChildrenOnly))
        if (tabs->isVisible() && tabs->x() == dock.x() && tabs->geometry().bottom() + 1 == dock.y())
            return tabs->height();
    return 0;
}

std::array<QSize, OperateDocks::kDocks> OperateDocks::sizesNow() const {
    std::array<QSize, kDocks> sizes;
    for (std::size_t i = 0; i < kDocks; ++i)
        sizes[i] = isSeen(i) ? m_docks[i]->size() : QSize();
    return sizes;
}

void OperateDocks::noteSizes() {
    m_sizesIn = size();
    m_sizes = sizesNow();
}

void OperateDocks::bringSizes() {
    if (m_default[index()])
        shareSpace();
    else if (m_sizesIn.isEmpty())
        noteSizes();
    else
        keepSizes();
}

void OperateDocks::keepSizes() {
    if (m_sizesIn.isEmpty())
        return;
    int forms = 0;
    for (std::size_t i = 0; i < kDocks; ++i)
        if (isForm(i) && m_sizes[i].isValid())
            forms = std::max(forms, m_sizes[i].width());
    const double wider =
        std::max(width() - forms, 1) / std::max(1.0, m_sizesIn.width() - static_cast<double>(forms));
    const double higher = static_cast<double>(height()) / m_sizesIn.height();
    const auto isKept = [this](std::size_t dock) { return m_sizes[dock].isValid() && isSeen(dock); };
    // What stands above or below a form is as wide as that.
    QSet<int> columnsOfForms;
    for (std::size_t i = 0; i < kDocks; ++i)
        if (isForm(i) && isKept(i))
            columnsOfForms << m_docks[i]->x();
    QList<QDockWidget*> inRows;
    QList<QDockWidget*> inColumns;
    QList<int> widths;
    QList<int> heights;
    for (std::size_t i = 0; i < kDocks; ++i) {
        if (!isKept(i))
            continue;
        inColumns << m_docks[i];
        heights << std::max(1, qRound(higher * m_sizes[i].height())) + tabRoom(*m_docks[i]);
        if (!isForm(i) && columnsOfForms.contains(m_docks[i]->x()))
            continue;
        inRows << m_docks[i];
        widths << (isForm(i) ? m_sizes[i].width() : std::max(1, qRound(wider * m_sizes[i].width())));
    }
    resizeDocks(inRows, widths, Qt::Horizontal);
    resizeDocks(inColumns, heights, Qt::Vertical);
}

} // namespace teleta::console
