// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/camera/scene/scene_panel.h"

#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"

#include <algorithm>
#include <cmath>

namespace teleta::camera {

namespace {

constexpr double kUsualShape = 4.0 / 3.0;

} // namespace

ScenePanel::ScenePanel(QWidget* parent)
    : QWidget(parent) {
    base::onChange(this, &ScenePanel::arrange, {QEvent::FontChange, QEvent::LayoutDirectionChange});
}

void ScenePanel::setCameras(const std::vector<std::uint64_t>& keys) {
    if (keys == m_order)
        return;
    std::erase_if(m_tiles, [&keys](const auto& entry) {
        const bool isGone = std::ranges::find(keys, entry.first) == keys.end();
        if (isGone)
            delete entry.second;
        return isGone;
    });
    m_order = keys;
    QWidget* before = nullptr;
    for (const std::uint64_t key : keys) {
        SceneTile*& tile = m_tiles[key];
        if (tile == nullptr) {
            tile = new SceneTile(this);
            connect(tile, &SceneTile::shapeChanged, this, &ScenePanel::arrange);
            connect(tile, &SceneTile::exportFailed, this, &ScenePanel::exportFailed);
            tile->show();
        }
        if (before != nullptr)
            setTabOrder(before, tile);
        before = tile;
    }
    updateGeometry();
    arrange();
}

SceneTile* ScenePanel::tile(std::uint64_t key) const {
    const auto found = m_tiles.find(key);
    return found == m_tiles.end() ? nullptr : found->second;
}

int ScenePanel::columnsFor(int pictures, double shape, const QSizeF& room, double caption) {
    int best = 1;
    double largest = -1.0;
    for (int columns = 1; columns <= pictures; ++columns) {
        const int rows = (pictures + columns - 1) / columns;
        const double width =
            std::min(room.width() / columns, shape * std::max(0.0, room.height() / rows - caption));
        if (width > largest) {
            largest = width;
            best = columns;
        }
    }
    return best;
}

QSize ScenePanel::sizeHint() const {
    return {base::em(this, 40), base::em(this, 20)};
}

QSize ScenePanel::minimumSizeHint() const {
    return {base::em(this, 12), base::em(this, 8)};
}

void ScenePanel::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    arrange();
}

void ScenePanel::arrange() {
    if (m_order.empty())
        return;
    double shape = 0.0;
    for (const auto& [key, tile] : m_tiles) {
        const core::ColourImage& image = tile->picture().image;
        shape += image.isEmpty() ? kUsualShape : static_cast<double>(image.width_px) / image.height_px;
    }
    const auto pictures = static_cast<int>(m_order.size());
    const int columns =
        columnsFor(pictures, shape / pictures, QSizeF(size()), ScenePicture::captionHeight(font()));
    const int rows = (pictures + columns - 1) / columns;
    const int gap = base::grid(this, 0.5);
    const auto at = [gap](int room, int count, int index) { return index * (room + gap) / count; };
    for (int i = 0; i < pictures; ++i) {
        const int column = layoutDirection() == Qt::RightToLeft ? columns - 1 - i % columns : i % columns;
        const int row = i / columns;
        const int left = at(width(), columns, column);
        const int top = at(height(), rows, row);
        m_tiles[m_order[static_cast<std::size_t>(i)]]->setGeometry(
            left, top, at(width(), columns, column + 1) - gap - left,
            at(height(), rows, row + 1) - gap - top);
    }
}

} // namespace teleta::camera
