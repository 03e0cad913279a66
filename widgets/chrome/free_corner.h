// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRect>

#include <functional>
#include <optional>

class QWidget;

namespace teleta::chrome {

/// A place over a view.
struct FreeCorner {
    QRect place;
    bool covers = false; ///< a control, a list or table, or the title of a dock
};

/// The place of a notice of this size over a view: the corner of `seen` (in the view's coordinates) where it
/// covers the fewest controls. Of equal ones the first of bottom left, bottom right, top left, top right. A
/// control is what takes the focus, also one that cannot be used yet, or the title of a dock; `ignored` and
/// what is inside it do not count. Buttons, fields and sliders count before lists and tables, these
/// before texts, and these before canvases, of which a part remains in reach. Thread: GUI.
[[nodiscard]] FreeCorner freeCorner(const QWidget& view, const QRect& seen, QSize size,
                                    const QWidget& ignored);

/// A place at the lower left of the largest picture in the view (kPictureProperty) where a notice covers no
/// control; `width` at most. heightFor: the notice's height at a width. Empty: no picture is large enough.
/// Thread: GUI.
[[nodiscard]] std::optional<QRect> freePicture(const QWidget& view, const QRect& seen, int width,
                                               const std::function<int(int)>& heightFor,
                                               const QWidget& ignored);

} // namespace teleta::chrome
