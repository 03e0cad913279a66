// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace teleta::figure {

/// A whole page for a browser: its title as heading, and the body, which is HTML. It needs no other file, is
/// well-formed XML, and fits light and dark screens and paper. Pictures in it are SvgCanvas::embedded().
/// language: of its texts, as BCP 47 has it. Thread: any.
[[nodiscard]] QString htmlPage(const QString& language, const QString& title, const QString& body);

} // namespace teleta::figure
