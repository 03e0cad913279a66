// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/array_layout.h"
#include "widgets/view3d/scene3d_view.h"
#include "widgets/view3d/vtk/vtk_widget.h"

#include <QAction>
#include <QImage>
#include <QTest>

#include <vtkRenderer.h>
#include <vtkRendererCollection.h>
#include <vtkRenderWindow.h>

#include <algorithm>
#include <cmath>
#include <unordered_set>

/// A 3-D view on the screen, and what its pictures show.
namespace teleta::test {

inline constexpr core::ArrayLayout kLayout{.rows = 6, .columns = 14, .pitchX_m = 0.0034};

inline view3d::VtkWidget& vtkOf(const view3d::Scene3dView& view) {
    return *view.findChild<view3d::VtkWidget*>();
}

inline void check(const view3d::Scene3dView& view, const char* action, bool checked) {
    view.findChild<QAction*>(QLatin1String(action))->setChecked(checked);
}

inline vtkRenderer* rendererOf(const view3d::Scene3dView& view) {
    return vtkOf(view).renderWindow()->GetRenderers()->GetFirstRenderer();
}

/// The picture of the 3-D part as shown, without the tool bar.
inline QImage shown(const view3d::Scene3dView& view) {
    return vtkOf(view).grab().toImage().convertToFormat(QImage::Format_RGB32);
}

/// Where VTK itself says that a point of the world is, in pixels of shown().
inline QPoint pixelOf(const view3d::Scene3dView& view, const Eigen::Vector3d& p_World) {
    vtkRenderer* renderer = rendererOf(view);
    renderer->SetWorldPoint(p_World.x(), p_World.y(), p_World.z(), 1.0);
    renderer->WorldToDisplay();
    const double* display = renderer->GetDisplayPoint();
    const int height = vtkOf(view).renderWindow()->GetSize()[1];
    return {static_cast<int>(std::floor(display[0])), height - 1 - static_cast<int>(std::floor(display[1]))};
}

/// Whether a pixel has the hue of a colour, whatever the light.
inline bool hasHueOf(QRgb pixel, const QColor& colour) {
    const int largest = std::max({qRed(pixel), qGreen(pixel), qBlue(pixel)});
    const int smallest = std::min({qRed(pixel), qGreen(pixel), qBlue(pixel)});
    if (largest - smallest <= 0.35 * largest) {
        return false; // hardly any hue
    }
    const double apart =
        std::abs(std::remainder(static_cast<double>(QColor(pixel).hsvHueF() - colour.hsvHueF()), 1.0));
    return apart < 15.0 / 360.0;
}

template <typename Visit>
void forEachPixel(const QImage& picture, Visit&& visit) {
    for (int y = 0; y < picture.height(); ++y) {
        const auto* line = reinterpret_cast<const QRgb*>(picture.constScanLine(y));
        std::for_each(line, line + picture.width(), visit);
    }
}

inline int countHue(const QImage& picture, const QColor& colour) {
    int count = 0;
    forEachPixel(picture, [&](QRgb pixel) { count += hasHueOf(pixel, colour) ? 1 : 0; });
    return count;
}

inline std::size_t countColours(const QImage& picture) {
    std::unordered_set<QRgb> colours;
    forEachPixel(picture, [&](QRgb pixel) { colours.insert(pixel); });
    return colours.size();
}

/// A view on the screen with only the data in it.
struct Stage {
    view3d::Scene3dView view;

    explicit Stage(QSize size = {480, 360}) {
        check(view, "axes", false);
        check(view, "contactLabels", false);
        view.resize(size);
        view.show();
    }
    [[nodiscard]] bool ready() { return QTest::qWaitForWindowExposed(&view) && vtkOf(view).canRender(); }
    void settle() { (void)shown(view); }
    /// Keys come to the view.
    [[nodiscard]] bool focused() {
        view.activateWindow();
        view.setFocus();
        return QTest::qWaitForWindowActive(&view);
    }
};

/// On the sphere of the only contact, by the numbers that the drawing is made of: range and heights.
inline Eigen::Vector3d peakOf(double x_m, double y_m) {
    // 5 thresholds of 0.05 N are less than the peak of 1 N, so the range is 1; rise 0.15 of the array's
    // diagonal, tile 0.06 of the pitch.
    const double diagonal_m = std::hypot(14 * 0.0034, 6 * 0.0034);
    // Half a radius of the sphere above: its lower half is inside the taxel.
    return {x_m, y_m, 0.06 * 0.0034 + 0.15 * diagonal_m + 0.5 * 0.4 * 0.0034};
}

} // namespace teleta::test
