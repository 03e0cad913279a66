// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pattern/model/pattern.h"

#include <QImage>
#include <QPalette>
#include <QSize>

namespace teleta::pattern {

/// A pattern at a glance: the intensity of each tactor over the pattern's time, one row a tactor, the first
/// one on top. size: px; palette: its colours. An empty pattern is a picture of empty rows. Thread: any
/// (pure).
[[nodiscard]] QImage patternPicture(const Pattern& pattern, const QSize& size, const QPalette& palette);

} // namespace teleta::pattern
