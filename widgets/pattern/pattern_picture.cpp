// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/pattern/pattern_picture.h"

#include "widgets/base/theme.h"

#include <QPainter>

#include <algorithm>

namespace teleta::pattern {

namespace {

constexpr double kGap = 0.18; ///< between two rows, of a row

} // namespace

QImage patternPicture(const Pattern& pattern, const QSize& size, const QPalette& palette) {
    const QColor ground = palette.color(QPalette::Base);
    QImage image(size, QImage::Format_RGB32);
    image.fill(ground);
    QPainter painter(&image);
    const double row = size.height() / static_cast<double>(core::kTactors);
    const QColor faint = base::mixed(ground, palette.color(QPalette::Text), 0.08);
    const QColor strong = palette.color(QPalette::Link);
    for (std::size_t tactor = 0; tactor < core::kTactors; ++tactor)
        painter.fillRect(
            QRectF(0.0, row * static_cast<double>(tactor) + row * kGap, size.width(), row * (1.0 - kGap)),
            faint);
    for (int x = 0; x < size.width() && pattern.duration_s > 0.0; ++x) {
        const core::Intensities now = evaluate(pattern, pattern.duration_s * (x + 0.5) / size.width());
        for (std::size_t tactor = 0; tactor < core::kTactors; ++tactor) {
            const double share = std::clamp(static_cast<double>(now[tactor]), 0.0, 1.0);
            const double high = share * row * (1.0 - kGap);
            if (high > 0.0)
                painter.fillRect(QRectF(x, row * static_cast<double>(tactor + 1) - high, 1.0, high), strong);
        }
    }
    return image;
}

} // namespace teleta::pattern
