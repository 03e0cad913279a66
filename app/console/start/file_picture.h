// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <QImage>
#include <QPalette>
#include <QSize>
#include <QString>

#include <stop_token>

namespace teleta::console {

/// A picture of what can be opened from the start page, made cheaply:
///   a scene             scenePicture()
///   a .teleta file      the strongest of some frames of its first array; other recordings have none
///   "pattern:ID"        a built-in pattern
///   "study:KIND"        some stimuli of the published study
/// Error: notFound where there is no picture, cancelled, or as the reader of the file. Thread: any.
[[nodiscard]] core::Expected<QImage> startPicture(const QString& place, const QSize& size,
                                                  const QPalette& palette, const std::stop_token& stop = {});

/// What the picture depends on, for a name under which it is kept: the text of a scene, which includes where
/// it comes from, or place, size and time of a file. Thread: any.
[[nodiscard]] QByteArray startPictureKey(const QString& place);

} // namespace teleta::console
