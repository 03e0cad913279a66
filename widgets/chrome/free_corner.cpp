// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/chrome/free_corner.h"

#include "widgets/base/picture_property.h"
#include "widgets/base/theme.h"

#include <QAbstractItemView>
#include <QDockWidget>
#include <QLabel>
#include <QWidget>

#include <algorithm>
#include <compare>
#include <vector>

namespace teleta::chrome {

namespace {

/// A control that is not higher than this is covered as a whole by a notice.
constexpr double kSmallControl_em = 4.0;
/// A narrower notice would be high, since its text is broken into many lines.
constexpr double kLeastWidth_em = 24.0;

struct Covered {
    int small = 0;
    qint64 lists_px2 = 0;
    int texts = 0; ///< which are only read
    qint64 area_px2 = 0;
    [[nodiscard]] bool isHarm() const { return small > 0 || lists_px2 > 0; }
    friend auto operator<=>(const Covered&, const Covered&) = default;
};

/// What notices at these places would cover.
std::vector<Covered> coveredAt(const QWidget& view, const std::vector<QRect>& places,
                               const QWidget& ignored) {
    std::vector<Covered> covered(places.size());
    const int smallHeight_px = base::em(&view, kSmallControl_em);
    const auto count = [&](const QRect& control, bool isList = false) {
        for (std::size_t index = 0; index < places.size(); ++index) {
            const QRect common = control & places[index];
            if (common.isEmpty())
                continue;
            covered[index].small += control.height() <= smallHeight_px ? 1 : 0;
            (isList ? covered[index].lists_px2 : covered[index].area_px2) +=
                qint64{common.width()} * common.height();
        }
    };
    const auto countText = [&](const QRect& text) {
        for (std::size_t index = 0; index < places.size(); ++index)
            covered[index].texts += text.intersects(places[index]) ? 1 : 0;
    };
    for (const QWidget* each : view.findChildren<QWidget*>()) {
        if (!each->isVisibleTo(&view) || each->isWindow() || each == &ignored || ignored.isAncestorOf(each))
            continue;
        const QPoint at = each->mapTo(&view, QPoint());
        const auto* label = qobject_cast<const QLabel*>(each);
        if (label != nullptr && !label->text().isEmpty())
            countText({at, each->size()});
        const auto* dock = qobject_cast<const QDockWidget*>(each);
        if (dock != nullptr && dock->widget() != nullptr)
            count({at, QSize(dock->width(), dock->widget()->y())}); // its title
        else if ((each->focusPolicy() & Qt::TabFocus) != 0)
            count({at, each->size()}, qobject_cast<const QAbstractItemView*>(each) != nullptr);
    }
    return covered;
}

} // namespace

FreeCorner freeCorner(const QWidget& view, const QRect& seen, QSize size, const QWidget& ignored) {
    size = size.boundedTo(seen.size());
    const int right = seen.right() + 1 - size.width();
    const int bottom = seen.bottom() + 1 - size.height();
    std::vector<QRect> corners;
    for (const QPoint& corner :
         {QPoint(seen.left(), bottom), QPoint(right, bottom), seen.topLeft(), QPoint(right, seen.top())})
        corners.emplace_back(corner, size);
    const std::vector<Covered> covered = coveredAt(view, corners, ignored);
    const auto best =
        static_cast<std::size_t>(std::min_element(covered.begin(), covered.end()) - covered.begin());
    return {.place = corners[best], .covers = covered[best].isHarm()};
}

std::optional<QRect> freePicture(const QWidget& view, const QRect& seen, int width,
                                 const std::function<int(int)>& heightFor, const QWidget& ignored) {
    QRect largest;
    for (const QWidget* each : view.findChildren<QWidget*>()) {
        if (!each->isVisibleTo(&view) || !each->property(base::kPictureProperty).toBool())
            continue;
        const QRect picture = QRect(each->mapTo(&view, QPoint()), each->size()) & seen;
        if (qint64{picture.width()} * picture.height() > qint64{largest.width()} * largest.height())
            largest = picture;
    }
    const int narrow = std::min(width, largest.width());
    if (narrow < base::em(&view, kLeastWidth_em))
        return std::nullopt;
    const int height = heightFor(narrow);
    const QRect place(largest.left(), largest.bottom() + 1 - height, narrow, height);
    if (height > largest.height() / 2 || coveredAt(view, {place}, ignored).front().isHarm())
        return std::nullopt;
    return place;
}

} // namespace teleta::chrome
