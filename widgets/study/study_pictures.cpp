// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/study/study_pictures.h"

#include "backend/study/session/simulated_participant.h"
#include "widgets/base/numbers/quantity_text.h"
#include "widgets/base/theme.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPolygonF>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace teleta::study {

namespace {

struct PictureText {
    Q_DECLARE_TR_FUNCTIONS(StudyPictures)
};

/// A square in the middle of a rect, of a share of its shorter side.
QRectF squareIn(const QRectF& rect, double share) {
    const double side = share * std::min(rect.width(), rect.height());
    QRectF square(0.0, 0.0, side, side);
    square.moveCenter(rect.center());
    return square;
}

void paintCells(QPainter& painter, const QRectF& square, const ConfusionMatrix& matrix,
                const QPalette& palette) {
    const QColor ground = palette.color(QPalette::Base);
    const QColor accent = base::controlColours(palette, true).accent;
    const std::size_t cells = matrix.patterns();
    const double side = square.width() / static_cast<double>(cells);
    for (std::size_t row = 0; row < cells; ++row) {
        for (std::size_t column = 0; column < cells; ++column) {
            const QRectF cell(square.left() + static_cast<double>(column) * side,
                              square.top() + static_cast<double>(row) * side, side, side);
            const double share = matrix.rowPercent(row, column).value_or(0.0) / 100.0;
            painter.fillRect(cell.adjusted(0.5, 0.5, -0.5, -0.5), base::mixed(ground, accent, share));
        }
    }
}

/// The six motors around an arm, some of them on.
void paintBracelet(QPainter& painter, const QRectF& square, const QPalette& palette) {
    const QColor faint = palette.color(QPalette::PlaceholderText);
    const QColor accent = base::controlColours(palette, true).accent;
    const double radius = 0.40 * square.width();
    painter.setPen(QPen(faint, 0.03 * square.width()));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(square.center(), radius, radius);
    constexpr std::array kOn{true, true, false, true, false, false};
    for (std::size_t motor = 0; motor < kOn.size(); ++motor) {
        const double angle = (static_cast<double>(motor) / kOn.size() - 0.25) * 2.0 * std::numbers::pi;
        const QPointF at = square.center() + radius * QPointF(std::cos(angle), std::sin(angle));
        painter.setPen(QPen(kOn[motor] ? accent : faint, 1.5));
        painter.setBrush(kOn[motor] ? accent : palette.color(QPalette::Base));
        painter.drawEllipse(at, 0.1 * square.width(), 0.1 * square.width());
    }
}

/// Four answers to choose from, one of them chosen.
void paintAnswers(QPainter& painter, const QRectF& square, const QPalette& palette) {
    const base::ControlColours colours = base::controlColours(palette, true);
    const double side = 0.46 * square.width();
    QFont letters = base::bold(painter.font());
    letters.setPixelSize(std::max(1, static_cast<int>(0.5 * side)));
    painter.save();
    painter.setFont(letters);
    for (int i = 0; i < 4; ++i) {
        const bool isChosen = i == 1;
        const QRectF answer(square.left() + (i % 2) * (square.width() - side),
                            square.top() + (i / 2) * (square.height() - side), side, side);
        painter.setPen(QPen(isChosen ? colours.accent : colours.edge, 1.0));
        painter.setBrush(isChosen ? colours.accent : palette.color(QPalette::Base));
        painter.drawRoundedRect(answer, 0.12 * side, 0.12 * side);
        painter.setPen(isChosen ? colours.onAccent : palette.color(QPalette::Text));
        painter.drawText(answer, Qt::AlignCenter, QChar('A' + i));
    }
    painter.restore();
}

void paintArrow(QPainter& painter, const QPointF& from, const QPointF& to, const QColor& colour) {
    const double head = 0.3 * (to.x() - from.x());
    painter.setPen(QPen(colour, 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawLine(from, to);
    painter.drawPolyline(QPolygonF{to + QPointF(-head, -head), to, to + QPointF(-head, head)});
}

} // namespace

void paintSessionFlow(QPainter& painter, const QRectF& rect, const QPalette& palette) {
    const QFont small = base::sized(painter.font(), base::kSmallText);
    const double line = QFontMetricsF(small).height();
    const bool hasWords = rect.height() > 6.0 * line;
    const double room = rect.width() / 3.0;
    const std::array words{PictureText::tr("feel"), PictureText::tr("answer"), PictureText::tr("result")};
    painter.save();
    for (std::size_t i = 0; i < words.size(); ++i) {
        const QRectF third(rect.left() + static_cast<double>(i) * room, rect.top(), room, rect.height());
        QRectF square = squareIn(third, 0.66);
        if (hasWords) {
            square.translate(0.0, -0.7 * line);
            painter.setFont(small);
            painter.setPen(palette.color(QPalette::PlaceholderText));
            painter.drawText(QRectF(third.left(), square.bottom() + 0.5 * line, room, line), Qt::AlignCenter,
                             words[i]);
        }
        if (i == 0)
            paintBracelet(painter, square, palette);
        else if (i == 1)
            paintAnswers(painter, square, palette);
        else if (const auto matrix = paperMatrix("stiffness", "dynamic"))
            paintCells(painter, square, *matrix, palette);
        if (i > 0)
            paintArrow(painter, {third.left() - 0.09 * room, square.center().y()},
                       {third.left() + 0.07 * room, square.center().y()},
                       palette.color(QPalette::PlaceholderText));
    }
    painter.restore();
}

void paintPublishedMatrix(QPainter& painter, const QRectF& rect, const QPalette& palette) {
    const auto matrix = paperMatrix("shape", "dynamic");
    if (!matrix)
        return;
    painter.save();
    QRectF square = squareIn(rect, 0.84);
    square.moveLeft(rect.left() + 0.08 * rect.height());
    paintCells(painter, square, *matrix, palette);
    const QFont small = base::sized(painter.font(), base::kSmallText);
    const QRectF words(square.right() + 0.08 * rect.height(), rect.top(),
                       rect.right() - square.right() - 0.1 * rect.height(), rect.height());
    const QString share =
        PictureText::tr("%1 %").arg(base::fixedDigits(100.0 * matrix->accuracy().value_or(0.0), 0));
    const QString what = PictureText::tr("right answers to dynamic shapes");
    QFont huge = base::bold(base::sized(painter.font(), base::kHugeText));
    if (QFontMetricsF(huge).horizontalAdvance(share) > words.width())
        huge = base::bold(base::sized(painter.font(), base::kLargeText));
    const QFontMetricsF metrics(small);
    const double below =
        metrics.boundingRect(QRectF(0.0, 0.0, words.width(), rect.height()), Qt::TextWordWrap, what).height();
    const double above = QFontMetricsF(huge).height();
    QRectF line(words.left(), words.center().y() - 0.5 * (above + below), words.width(), above);
    painter.setFont(huge);
    painter.setPen(palette.color(QPalette::Text));
    painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter, share);
    painter.setFont(small);
    painter.setPen(palette.color(QPalette::PlaceholderText));
    painter.drawText(QRectF(line.left(), line.bottom(), line.width(), below), Qt::TextWordWrap, what);
    painter.restore();
}

void paintProtocolPage(QPainter& painter, const QRectF& rect, const QPalette& palette) {
    const base::ControlColours colours = base::controlColours(palette, true);
    QRectF page(0.0, 0.0, 0.68 * rect.height(), 0.84 * rect.height());
    page.moveCenter(rect.center());
    const double fold = 0.22 * page.width();
    painter.setPen(QPen(colours.edge, 1.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(palette.color(QPalette::Base));
    painter.drawPolygon(QPolygonF{page.topLeft(), page.topRight() - QPointF(fold, 0.0),
                                  page.topRight() + QPointF(0.0, fold), page.bottomRight(),
                                  page.bottomLeft()});
    painter.drawPolyline(QPolygonF{page.topRight() - QPointF(fold, 0.0),
                                   page.topRight() + QPointF(-fold, fold),
                                   page.topRight() + QPointF(0.0, fold)});
    // A name, and a value of some length.
    constexpr std::array<std::pair<double, double>, 6> kLines{
        {{0.3, 0.0}, {0.22, 0.3}, {0.28, 0.18}, {0.18, 0.42}, {0.24, 0.26}, {0.2, 0.36}}};
    const double step = (page.height() - 1.9 * fold) / kLines.size();
    const double thick = std::max(2.0, 0.3 * step);
    painter.setPen(Qt::NoPen);
    for (std::size_t i = 0; i < kLines.size(); ++i) {
        const double y = page.top() + 1.35 * fold + static_cast<double>(i) * step;
        const double left = page.left() + 0.14 * page.width();
        const double name = kLines[i].first * page.width();
        painter.setBrush(colours.accent);
        painter.drawRoundedRect(QRectF(left, y, name, thick), 0.5 * thick, 0.5 * thick);
        painter.setBrush(colours.groove);
        painter.drawRoundedRect(QRectF(left + name + 1.5 * thick, y, kLines[i].second * page.width(), thick),
                                0.5 * thick, 0.5 * thick);
    }
}

void paintProgress(QPainter& painter, const QRectF& rect, const QPalette& palette,
                   const std::vector<ParticipantLine>& participants) {
    const QFont small = base::sized(painter.font(), base::kSmallText);
    const QFontMetricsF metrics(small);
    const double line = std::clamp(rect.height() / (static_cast<double>(participants.size()) + 1.0),
                                   1.5 * metrics.height(), 3.0 * metrics.height());
    const double margin = 0.5 * metrics.height();
    const auto rows = std::min(participants.size(),
                               static_cast<std::size_t>(std::max(1.0, (rect.height() - margin) / line)));
    double names = 0.0;
    for (std::size_t i = participants.size() - rows; i < participants.size(); ++i)
        names = std::max(names, metrics.horizontalAdvance(participants[i].id));
    names = std::min(names, 0.4 * rect.width());
    const base::StatusColours& status = base::statusColours(palette);
    const base::ControlColours colours = base::controlColours(palette, true);
    painter.save();
    painter.setFont(small);
    double y = rect.center().y() - 0.5 * static_cast<double>(rows) * line;
    for (std::size_t i = participants.size() - rows; i < participants.size(); ++i, y += line) {
        const ParticipantLine& person = participants[i];
        painter.setPen(palette.color(QPalette::PlaceholderText));
        painter.drawText(QRectF(rect.left() + margin, y, names, line), Qt::AlignRight | Qt::AlignVCenter,
                         metrics.elidedText(person.id, Qt::ElideRight, names));
        const double left = rect.left() + 2.0 * margin + names;
        const double box = (rect.right() - margin - left) /
                           static_cast<double>(std::max<std::size_t>(1, person.sessions.size()));
        for (std::size_t s = 0; s < person.sessions.size(); ++s) {
            const SessionLine& session = person.sessions[s];
            const QRectF all(left + static_cast<double>(s) * box, y + 0.2 * line, box - 3.0, 0.6 * line);
            painter.fillRect(all, colours.groove);
            QRectF done = all;
            if (!session.finished)
                done.setWidth(session.planned > 0 ? all.width() * static_cast<double>(session.kept) /
                                                        static_cast<double>(session.planned)
                                                  : 0.0);
            painter.fillRect(done, session.finished ? status.live : status.stale);
        }
    }
    painter.restore();
}

} // namespace teleta::study
