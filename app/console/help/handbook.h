// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

#include <optional>

namespace teleta::console {

/// A page of the handbook, Markdown as QTextDocument reads it. Links lead to NAME.md, pictures are
/// ../pictures/NAME.png.
struct HandbookPage {
    QString name;
    QString title; ///< its first heading
    QString text;
};

/// Names of the pages that say how to use the program, in reading order.
[[nodiscard]] const QStringList& handbookGuide();
/// Names of the pages in which things are looked up.
[[nodiscard]] const QStringList& handbookReference();
/// Both, in this order.
[[nodiscard]] QStringList handbookPages();

/// The page in that language ("fr", "zh_CN", "ja_JP"; otherwise English). Empty if there is none of that
/// name.
[[nodiscard]] std::optional<HandbookPage> handbookPage(const QString& name, const QString& language);

} // namespace teleta::console
