// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/chrome/free_corner.h"

#include "widgets/base/theme.h"

#include <QAbstractItemView>
#include <QDockWidget>
#include <QWidget>

#include <algorithm>
#include <array>
#include <utility>

namespace teleta::chrome {

namespace {

/// A control that is not higher than this is covered as a whole by a notice.
constexpr double kSmallControl_em = 4.0;

struct Covered {
    int small = 0;
    qint64 lists_px2 = 0;
    qint64 area_px2 = 0;
    friend auto operator<=>(const Covered&, const Covered&) = default;
};

} // namespace

FreeCorner freeCorner(const QWidget& view, const QRect& seen, QSize size, const QWidget& ignored) {
    size = size.boundedTo(seen.size());
    const int right = seen.right() + 1 - size.width();
    const int bottom = seen.bottom() + 1 - size.height();
    const std::array corners{QPoint(seen.left(), bottom), QPoint(right, bottom), seen.topLeft(),
                             QPoint(right, seen.top())};
    std::array<Covered, corners.size()> covered;
    const int smallHeight_px = base::em(&view, kSmallControl_em);
    const auto count = [&](const QRect& place, bool isList = false) {
        for (std::size_t index = 0; index < corners.size(); ++index) {
            const QRect common = place & QRect(corners[index], size);
            if (common.isEmpty())
                continue;
            covered[index].small += place.height() <= smallHeight_px ? 1 : 0;
            (isList ? covered[index].lists_px2 : covered[index].area_px2) +=
                qint64{common.width()} * common.height();
        }
    };
    for (const QWidget* each : view.findChildren<QWidget*>()) {
        if (!each->isVisibleTo(&view) || each->isWindow() || each == &ignored || ignored.isAncestorOf(each))
            continue;
        const QPoint at = each->mapTo(&view, QPoint());
        const auto* dock = qobject_cast<const QDockWidget*>(each);
        if (dock != nullptr && dock->widget() != nullptr)
            count({at, QSize(dock->width(), dock->widget()->y())}); // its title
        else if ((each->focusPolicy() & Qt::TabFocus) != 0)
            count({at, each->size()}, qobject_cast<const QAbstractItemView*>(each) != nullptr);
    }
    const auto best =
        static_cast<std::size_t>(std::min_element(covered.begin(), covered.end()) - covered.begin());
    return {.place = {corners[best], size}, .covers = covered[best].small > 0 || covered[best].lists_px2 > 0};
}

} // namespace teleta::chrome
