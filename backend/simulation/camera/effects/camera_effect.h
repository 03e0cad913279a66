// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/simulation/base/effect.h"
#include "backend/simulation/camera/skin/printed_dots.h"
#include "backend/vision/camera/camera_model.h"

#include <opencv2/core.hpp>

namespace teleta::simulation {

/// One imperfection of the camera inside the tube. Each overrides what it acts on.
class CameraEffect : public Effect {
public:
    using Effect::Effect;

    /// Once, in this order.
    virtual void changeLens(vision::CameraParameters& /*camera*/) {}
    virtual void changePrint(PrintedDots& /*dots*/) {}
    /// light: factor of each pixel's brightness; places: angle and z of the skin behind it, NaN without any.
    virtual void changeLight(cv::Mat1f& /*light*/, const cv::Mat2f& /*places*/) {}

    /// How long before the end of the exposure each of the moments is that a frame averages.
    [[nodiscard]] virtual int moments() const { return 1; }
    [[nodiscard]] virtual double before_s(int /*moment*/) const { return 0.0; }

    /// Each frame from top to bottom, a few rows a call, in grey levels, for an effect that says so.
    [[nodiscard]] virtual bool changesRows() const { return false; }
    virtual void changeRows(cv::Mat1f& /*rows*/) {}
};

} // namespace teleta::simulation
