// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/figure/figure_file.h"

#include "backend/core/part.h"
#include "backend/figure/drawing_part.h"

namespace teleta::figure {

namespace {

core::Expected<const Drawing*> drawing() {
    static const auto loaded = core::part<Drawing>("teleta_drawing");
    return loaded;
}

} // namespace

core::Expected<std::string> pdfOf(const std::string& svg) {
    TELETA_TRY(const Drawing* part, drawing());
    return part->pdf(svg);
}

core::Expected<std::string> pngOf(const std::string& svg, double scale) {
    TELETA_TRY(const Drawing* part, drawing());
    return part->png(svg, scale);
}

} // namespace teleta::figure
