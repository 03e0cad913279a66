// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/camera/scene/scene_tile.h"

#include <QWidget>

#include <cstdint>
#include <map>
#include <vector>

namespace teleta::camera {

/// The cameras that are looked at, side by side: as many columns as make the pictures largest. Thread: GUI.
class ScenePanel : public QWidget {
    Q_OBJECT
public:
    explicit ScenePanel(QWidget* parent = nullptr);

    /// One tile for each camera, in this order; those that are there already stay. keys: of the cameras.
    void setCameras(const std::vector<std::uint64_t>& keys);
    /// Null: no such camera.
    [[nodiscard]] SceneTile* tile(std::uint64_t key) const;
    [[nodiscard]] const std::vector<std::uint64_t>& cameras() const { return m_order; }

    /// The number of columns in which so many pictures of one shape (width over height) are largest in a room
    /// with this height of text above each.
    [[nodiscard]] static int columnsFor(int pictures, double shape, const QSizeF& room, double caption);

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

signals:
    void exportFailed(const QString& message);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void arrange();

    std::map<std::uint64_t, SceneTile*> m_tiles;
    std::vector<std::uint64_t> m_order;
};

} // namespace teleta::camera
