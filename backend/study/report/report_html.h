// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/figure/html_table.h"
#include "backend/figure/svg_canvas.h"
#include "backend/study/analysis/proportion.h"

#include <QString>

#include <optional>
#include <string>

/// What the sections of a report are made of. Texts are plain and escaped here. Missing numbers are NA.
/// Thread: any (pure).
namespace teleta::study::report_html {

[[nodiscard]] QString text(const std::string& value);
[[nodiscard]] QString fixed(const std::optional<double>& value, int digits);
/// A share as a percentage without its sign.
[[nodiscard]] QString percent(const std::optional<double>& share);
/// Both ends times scale.
[[nodiscard]] QString interval(const std::optional<Interval>& ends, double scale, int digits);
/// Four digits, or "< 0.0001".
[[nodiscard]] QString probability(const std::optional<double>& p);

[[nodiscard]] QString heading(const QString& title);
[[nodiscard]] QString paragraph(const QString& content);
/// caption: HTML.
[[nodiscard]] QString figure(const figure::SvgCanvas& picture, const QString& caption);

using figure::HtmlTable;

} // namespace teleta::study::report_html
