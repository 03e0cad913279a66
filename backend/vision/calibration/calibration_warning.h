// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace teleta::vision {

/// What the pairs show to be wrong although a camera fits them.
enum class CalibrationWarning {
    offSurface,    ///< the points are not at the stated radius
    beyondEnds,    ///< points are beyond the ends of the stated cylinder
    swappedPixels, ///< u and v are in each other's place
    outsideImage,  ///< pixels are outside the stated image
    structured,    ///< neighbouring residuals are alike
};
/// All of them, in the order in which they are told.
inline constexpr std::array kCalibrationWarnings{
    CalibrationWarning::offSurface, CalibrationWarning::beyondEnds, CalibrationWarning::swappedPixels,
    CalibrationWarning::outsideImage, CalibrationWarning::structured};
/// Name in files and on the command line, such as "off_surface". Thread: any.
[[nodiscard]] const char* toString(CalibrationWarning warning);

/// Factor that brings x and y of points onto a cylinder, with its standard error.
struct SurfaceFactor {
    double value = 1.0;
    double standardError = 0.0;
};

} // namespace teleta::vision
