// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/base/figure/picture_view.h"
#include "widgets/base/numbers/number_format.h"
#include "widgets/camera/scene/scene_picture.h"

#include <cstdint>
#include <optional>

namespace teleta::camera {

/// How a camera does, at a steady time.
struct SceneReading {
    core::DeviceState state = core::DeviceState::connecting;
    double age_s = 0.0; ///< of the newest picture
    double rate_Hz = 0.0;
    QString reason; ///< what its device says; may be empty
    std::int64_t now_ns = 0;
};

/// One camera in the dock Scene: its newest picture, its name, and the size, rate and age of the picture. The
/// numbers change twice a second; the age is the greatest that was shown since. A picture older than
/// kOldest_s of a camera that is stale, and one of a camera that is lost, is dimmed. Thread: GUI.
class SceneTile : public base::PictureView<ScenePicture> {
    Q_OBJECT
public:
    static constexpr double kOldest_s = 0.5;
    static constexpr double kNumbersEvery_s = 0.5;

    explicit SceneTile(QWidget* parent = nullptr);

    void setName(const QString& name);
    /// A new picture; it is not copied.
    void setImage(const core::ColourImage& image);
    /// Called at each tick of the GUI; repaints only when what is seen has changed.
    void setReading(const SceneReading& reading);

    /// The picture alone, in its own size.
    [[nodiscard]] base::Figure figure() override;

signals:
    /// The picture has another shape.
    void shapeChanged();

protected:
    [[nodiscard]] QString toolTipAt(const QPointF& point) const override;

private:
    void retranslate();
    void describe();
    [[nodiscard]] QString problemOf(const SceneReading& reading) const;
    [[nodiscard]] QString csv() const;

    std::int64_t m_numbers_ns = 0; ///< of the last change of the numbers; 0: none yet
    double m_oldest_s = 0.0;       ///< that was shown since
    base::SteadyNumber m_age_ms{1.0};
    base::SteadyNumber m_rate_Hz{0.5};
};

} // namespace teleta::camera
