// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/scene_overlay.h"

#include "widgets/base/colour_maps.h"
#include "widgets/base/numbers/number_format.h"
#include "widgets/base/numbers/tabular_text.h"
#include "widgets/base/theme.h"

#include <QFontMetricsF>
#include <QLinearGradient>
#include <QLocale>
#include <QPainter>
#include <QPolygonF>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

namespace teleta::view3d {

namespace {

constexpr double kLegendFrom = 15.0; ///< height in em
constexpr double kSign_em = 1.5;     ///< width of an arrow beside its text
constexpr double kSignHead_em = 0.5; ///< length of its head
constexpr double kAtArray_em = 2.0;  ///< of the array's middle: either side is as good
constexpr double kLeader_em = 2.0;   ///< length of the line to a card at the side
constexpr double kDetour_em = 8.0;   ///< farther away that a card may be to hide no point of another one

class OverlayPainter {
public:
    OverlayPainter(QPainter& painter, const QSizeF& size, const OverlayContent& content)
        : m_painter(painter)
        , m_size(size)
        , m_content(content)
        , m_font(base::sized(content.font, base::kSmallText))
        , m_metrics(m_font)
        , m_em(QFontMetricsF(content.font).height())
        , m_margin(0.5 * m_em) {
        m_painter.setFont(m_font);
    }

    void paint() {
        paintBadge();
        if (!m_content.emptyText.isEmpty()) {
            m_painter.setFont(m_content.font);
            m_painter.setPen(m_content.colours.faintText);
            m_painter.drawText(QRectF(QPointF(), m_size).adjusted(m_em, m_em, -m_em, -m_em),
                               Qt::AlignCenter | Qt::TextWordWrap, m_content.emptyText);
            return;
        }
        // What stands in the corners is no place for cards.
        paintColourBar();
        const double left = m_content.orientationShown ? paintOrientation() : m_margin;
        paintLegend(left);
        // Names stay where they are: cards give way to them.
        for (const OverlayLabel& label : m_content.labels)
            if (!label.boxed)
                paintText(label);
        for (const OverlayLabel& label : m_content.labels)
            if (label.boxed)
                placeCard(label);
        // No line runs over a card.
        for (const Card& card : m_placed)
            paintLeader(card);
        for (const Card& card : m_placed)
            paintCard(card);
    }

private:
    struct Card {
        const OverlayLabel* label = nullptr;
        QRectF rect;
        bool tied = false; ///< to its point, by a line
    };

    void paintBadge() {
        m_painter.setFont(m_content.font);
        // At the left: the colour bar is at the right.
        const QRectF corner(QPointF(m_margin, m_margin),
                            base::badgeSize(m_content.font, base::provenanceText(m_content.provenance)));
        base::paintProvenance(m_painter, corner, m_content.provenance,
                              base::designedPalette(m_content.colours.dark), 0.0);
        m_painter.setFont(m_font);
    }

    [[nodiscard]] QPointF placed(const OverlayLabel& label) const {
        return {label.place.x() * m_size.width(), label.place.y() * m_size.height()};
    }

    void paintText(const OverlayLabel& label) {
        m_painter.setPen(label.colour);
        const QSizeF room(m_metrics.horizontalAdvance(label.text), m_metrics.height());
        const QPointF middle = placed(label);
        const QRectF rect(middle - QPointF(0.5 * room.width(), 0.5 * room.height()), room);
        if (m_legend.intersects(rect))
            return;
        m_cards.push_back(rect);
        m_painter.drawText(rect, Qt::AlignCenter, label.text);
    }

    [[nodiscard]] double dot() const { return 0.55 * m_metrics.height(); }
    [[nodiscard]] double pad() const { return 0.3 * m_metrics.height(); }

    void placeCard(const OverlayLabel& label) {
        const QSizeF room(base::tabularWidth(m_metrics, label.text) + dot() + 3.0 * pad(),
                          m_metrics.height() * 1.2);
        const QPointF foot = placed(label);
        QRectF wanted = label.beside
                            ? besides(foot, room)
                            : QRectF(foot - QPointF(0.5 * room.width(), room.height() + 0.4 * m_em), room);
        const QRectF picture = inner();
        wanted.moveLeft(std::clamp(wanted.left(), picture.left(),
                                   std::max(picture.left(), picture.right() - room.width())));
        wanted.moveTop(std::clamp(wanted.top(), picture.top(),
                                  std::max(picture.top(), picture.bottom() - room.height())));
        const std::optional<QRectF> place = nearestFree(wanted);
        if (!place)
            return; // no room left
        m_cards.push_back(*place);
        m_placed.push_back({&label, *place, (label.beside || *place != wanted) && !place->contains(foot)});
    }

    void paintLeader(const Card& card) {
        if (!card.tied)
            return;
        const QPointF foot = placed(*card.label);
        m_painter.setPen(QPen(card.label->colour, 1.0));
        m_painter.drawLine(foot, {std::clamp(foot.x(), card.rect.left(), card.rect.right()),
                                  std::clamp(foot.y(), card.rect.top(), card.rect.bottom())});
    }

    void paintCard(const Card& card) {
        const QRectF& rect = card.rect;
        m_painter.setPen(QPen(card.label->colour, 1.0));
        m_painter.setBrush(base::translucent(m_content.colours.backgroundTop, 0.86F));
        m_painter.drawRoundedRect(rect, 3.0, 3.0);
        m_painter.setPen(Qt::NoPen);
        m_painter.setBrush(card.label->colour);
        m_painter.drawEllipse(QRectF(rect.left() + pad(), rect.center().y() - 0.5 * dot(), dot(), dot()));
        m_painter.setPen(m_content.colours.text);
        base::drawTabularText(m_painter, rect.adjusted(2.0 * pad() + dot(), 0.0, -pad(), 0.0),
                              Qt::AlignLeft | Qt::AlignVCenter, card.label->text);
    }

    /// Away from the array, or outwards in its middle, since what the point belongs to is there; where there
    /// is no room, below, above, or on the other side, so that no card comes to lie on a point that another
    /// one names.
    [[nodiscard]] QRectF besides(const QPointF& foot, const QSizeF& room) const {
        const double away = kLeader_em * m_em;
        const double left = foot.x() - away - room.width();
        const double right = foot.x() + away;
        const double level = foot.y() - 0.5 * room.height();
        const double array_px = m_content.array ? m_content.array->x() * m_size.width() : foot.x();
        const bool isAtArray = std::abs(foot.x() - array_px) < kAtArray_em * m_em;
        const bool isLeft = foot.x() < (isAtArray ? 0.5 * m_size.width() : array_px);
        const std::array corners{QPointF(isLeft ? left : right, level),
                                 QPointF(isLeft ? left : right, level - away),
                                 QPointF(isLeft ? left : right, level + away),
                                 QPointF(foot.x() - 0.5 * room.width(), foot.y() + away),
                                 QPointF(foot.x() - 0.5 * room.width(), foot.y() - away - room.height()),
                                 QPointF(isLeft ? right : left, level)};
        for (const QPointF& corner : corners) {
            const QRectF rect(corner, room);
            if (isFree(rect) && isOffFeet(rect))
                return rect;
        }
        return {corners.front(), room};
    }

    [[nodiscard]] QRectF inner() const {
        return QRectF(QPointF(), m_size).adjusted(m_margin, m_margin, -m_margin, -m_margin);
    }

    [[nodiscard]] bool isFree(const QRectF& rect) const {
        return inner().contains(rect) &&
               std::ranges::none_of(m_cards, [&](const QRectF& card) { return card.intersects(rect); });
    }

    /// Whether it lies on no point that a card names.
    [[nodiscard]] bool isOffFeet(const QRectF& rect) const {
        const double clear = 0.4 * m_em;
        return std::ranges::none_of(m_content.labels, [&](const OverlayLabel& other) {
            return other.boxed && rect.adjusted(-clear, -clear, clear, clear).contains(placed(other));
        });
    }

    /// The wanted place, or the nearest free one in steps from it; rather a little farther away than on a
    /// point that another card names.
    [[nodiscard]] std::optional<QRectF> nearestFree(const QRectF& wanted) const {
        if (isFree(wanted))
            return wanted;
        const QSizeF step(0.25 * wanted.width(), 0.5 * wanted.height());
        const double shorter = std::min(step.width(), step.height());
        std::optional<QRectF> best;
        double least = m_size.width() + m_size.height();
        const auto look = [&](int column, int row) {
            const QPointF way(column * step.width(), row * step.height());
            const double distance = std::hypot(way.x(), way.y());
            const QRectF rect = wanted.translated(way);
            if (distance >= least || !isFree(rect))
                return;
            const double cost = distance + (isOffFeet(rect) ? 0.0 : kDetour_em * m_em);
            if (cost < least) {
                least = cost;
                best = rect;
            }
        };
        // Squares of places around it, each larger than the one before.
        for (int square = 1; square * shorter < least; ++square)
            for (int i = -square; i <= square; ++i) {
                look(i, -square);
                look(i, square);
                look(-square, i);
                look(square, i);
            }
        return best;
    }

    void paintColourBar() {
        const double height = std::min(0.4 * m_size.height(), 10.0 * m_em);
        const double width = 0.7 * m_em;
        if (!(m_content.loadRange > 0.0) || height < 3.0 * m_em || m_size.width() < 12.0 * m_em)
            return;
        const double top = m_margin + m_metrics.height() + 0.4 * m_em;
        const QRectF bar(m_size.width() - m_margin - width, top, width, height);
        QLinearGradient ramp(bar.bottomLeft(), bar.topLeft());
        constexpr int kStops = 16;
        for (int i = 0; i <= kStops; ++i) {
            const double share = static_cast<double>(i) / kStops;
            ramp.setColorAt(share, QColor(base::colourAt(base::cividis(), share)));
        }
        m_painter.setPen(Qt::NoPen);
        m_painter.setBrush(ramp);
        m_painter.drawRect(bar);
        m_painter.setPen(m_content.colours.text);
        m_cards.emplace_back(QPointF(bar.left() - 2.5 * m_em, 0.0),
                             QPointF(m_size.width(), bar.bottom() + m_em));
        const double textWidth = 8.0 * m_em;
        constexpr int kTicks = 2;
        for (int i = 0; i <= kTicks; ++i) {
            const double share = static_cast<double>(i) / kTicks;
            const double y = bar.bottom() - share * height;
            const QString text = QLocale().toString(share * m_content.loadRange, 'g', 3);
            m_painter.drawText(QRectF(bar.left() - 0.3 * m_em - textWidth, y - m_em, textWidth, 2.0 * m_em),
                               Qt::AlignRight | Qt::AlignVCenter, text);
        }
        m_painter.setPen(m_content.colours.faintText);
        m_painter.drawText(QRectF(bar.right() - textWidth, m_margin, textWidth, m_metrics.height()),
                           Qt::AlignRight | Qt::AlignVCenter, m_content.loadUnit);
    }

    /// Returns its right edge.
    double paintOrientation() {
        const double arm = 1.7 * m_em;
        const QPointF centre(m_margin + 2.3 * m_em, m_size.height() - m_margin - 2.3 * m_em);
        std::array<std::size_t, 3> order{};
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
            return m_content.orientation[a][2] < m_content.orientation[b][2];
        });
        for (const std::size_t axis : order) {
            const QPointF way(m_content.orientation[axis][0], -m_content.orientation[axis][1]);
            const QPointF tip = centre + arm * way;
            m_painter.setPen(QPen(m_content.colours.axes[axis], 0.13 * m_em, Qt::SolidLine, Qt::RoundCap));
            m_painter.drawLine(centre, tip);
            const QPointF name = centre + (arm + 0.55 * m_em) * way;
            m_painter.drawText(QRectF(name - QPointF(m_em, m_em), QSizeF(2.0 * m_em, 2.0 * m_em)),
                               Qt::AlignCenter, axisName(axis));
        }
        m_cards.emplace_back(centre - QPointF(2.3, 2.3) * m_em, QSizeF(4.6, 4.6) * m_em);
        m_painter.setPen(Qt::NoPen);
        m_painter.setBrush(m_content.colours.text);
        m_painter.drawEllipse(centre, 0.12 * m_em, 0.12 * m_em);
        return centre.x() + 2.3 * m_em + m_margin;
    }

    /// Lines that are too long go on below. The scene may reach behind the legend.
    void paintLegend(double left) {
        if (m_content.legend.empty() || m_size.height() < kLegendFrom * m_em)
            return; // the scene needs the room
        const bool hasArrows = std::ranges::any_of(
            m_content.legend, [](const LegendLine& line) { return line.arrow != LegendLine::Arrow::none; });
        const double indent = hasArrows ? (kSign_em + 0.4) * m_em : 0.0;
        const QRectF room(left + indent, 0.0, m_size.width() - left - indent - m_margin, m_size.height());
        std::vector<QRectF> places;
        double high = 0.0;
        double wide = 0.0;
        for (const LegendLine& line : m_content.legend) {
            const QRectF text = m_metrics.boundingRect(room, Qt::TextWordWrap, line.text);
            places.emplace_back(room.left(), high, room.width(), text.height());
            high += text.height();
            wide = std::max(wide, text.width());
        }
        const double pad = 0.4 * m_em;
        const double top = m_size.height() - m_margin - high;
        const QRectF ground(left - pad, top - 0.5 * pad, indent + wide + 2.0 * pad, high + pad);
        m_cards.push_back(ground);
        m_legend = ground;
        QColor colour = m_content.colours.backgroundBottom;
        colour.setAlphaF(0.75F);
        m_painter.setPen(Qt::NoPen);
        m_painter.setBrush(colour);
        m_painter.drawRoundedRect(ground, pad, pad);
        m_painter.setBrush(Qt::NoBrush);
        for (std::size_t i = 0; i < places.size(); ++i) {
            const LegendLine& line = m_content.legend[i];
            const QRectF place = places[i].translated(0.0, top);
            if (line.arrow != LegendLine::Arrow::none) {
                const QRectF sign(left, place.top(), kSign_em * m_em, m_metrics.height());
                line.arrow == LegendLine::Arrow::straight ? paintStraightArrow(sign) : paintTurnedArrow(sign);
            }
            m_painter.setPen(m_content.colours.faintText);
            m_painter.drawText(place, Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, line.text);
        }
    }

    void paintStraightArrow(const QRectF& sign) {
        const double y = sign.center().y();
        m_painter.setPen(QPen(m_content.colours.text, 0.12 * m_em, Qt::SolidLine, Qt::FlatCap));
        m_painter.drawLine(QPointF(sign.left(), y), QPointF(sign.right() - kSignHead_em * m_em, y));
        paintHead(QPointF(sign.right(), y), QPointF(1.0, 0.0));
    }

    void paintTurnedArrow(const QRectF& sign) {
        // Over the upper part of a circle, clockwise.
        const double radius = 0.42 * m_em;
        const QPointF centre(sign.center().x(), sign.center().y() + 0.45 * radius);
        const QRectF circle(centre - QPointF(radius, radius), QSizeF(2.0 * radius, 2.0 * radius));
        constexpr int kDegree = 16; // Qt's unit is a sixteenth
        m_painter.setPen(QPen(m_content.colours.text, 0.12 * m_em, Qt::SolidLine, Qt::FlatCap));
        m_painter.setBrush(Qt::NoBrush);
        m_painter.drawArc(circle, 210 * kDegree, -190 * kDegree);
        paintHead(centre + QPointF(radius, 0.45 * radius), QPointF(0.0, 1.0));
    }

    /// way: of length 1.
    void paintHead(const QPointF& tip, const QPointF& way) {
        const double length = kSignHead_em * m_em;
        const QPointF across(-way.y(), way.x());
        const QPointF neck = tip - length * way;
        m_painter.setPen(Qt::NoPen);
        m_painter.setBrush(m_content.colours.text);
        m_painter.drawPolygon(QPolygonF{tip, neck + 0.45 * length * across, neck - 0.45 * length * across});
    }

    QPainter& m_painter;
    QSizeF m_size;
    const OverlayContent& m_content;
    QFont m_font;
    QFontMetricsF m_metrics;
    double m_em;
    double m_margin;
    QRectF m_legend;
    std::vector<Card> m_placed;
    std::vector<QRectF> m_cards; ///< and what else is not to be covered
};

} // namespace

void paintOverlay(QPainter& painter, const QSizeF& size, const OverlayContent& content) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    OverlayPainter(painter, size, content).paint();
    painter.restore();
}

} // namespace teleta::view3d
