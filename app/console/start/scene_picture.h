// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/array_layout.h"
#include "backend/core/error.h"
#include "backend/scene/scene.h"

#include <QImage>
#include <QPalette>
#include <QSize>

#include <span>
#include <stop_token>

namespace teleta::console {

/// The loads of an array: cividis, darkest at 0, brightest at the largest. Thread: any.
[[nodiscard]] QImage loadPicture(std::span<const float> load_N, const core::ArrayLayout& layout,
                                 const QSize& size, const QPalette& palette);

/// What a scene looks like while something touches: it is run until then, with seed 1. An array and a servo
/// show their loads (cividis, darkest at 0), an arm its links and objects from above, a camera its image.
/// Takes from a few milliseconds to a second. size: of the picture, px; palette: its colours. Error: badInput
/// when the scene is not valid; cancelled when a stop was asked for meanwhile. Thread: any.
[[nodiscard]] core::Expected<QImage> scenePicture(const scene::Scene& scene, const QSize& size,
                                                  const QPalette& palette, const std::stop_token& stop = {});

} // namespace teleta::console
