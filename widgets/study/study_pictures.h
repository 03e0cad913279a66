// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/study/study_panel.h"

#include <QPalette>
#include <QRectF>

#include <vector>

class QPainter;

namespace teleta::study {

/// Small pictures of what can be done with a study. The painter's font is that of the words. Thread: GUI.

/// From the pattern that is felt over the answer to the result.
void paintSessionFlow(QPainter& painter, const QRectF& rect, const QPalette& palette);
/// The confusion matrix of the published study for dynamic shapes, with its share of right answers.
void paintPublishedMatrix(QPainter& painter, const QRectF& rect, const QPalette& palette);
/// A page with the lines of a protocol.
void paintProtocolPage(QPainter& painter, const QRectF& rect, const QPalette& palette);
/// A row for each participant, a box for each session: finished, interrupted or to do. The last rows where
/// there is no room for all.
void paintProgress(QPainter& painter, const QRectF& rect, const QPalette& palette,
                   const std::vector<ParticipantLine>& participants);

} // namespace teleta::study
