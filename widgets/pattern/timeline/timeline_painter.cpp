// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/pattern/timeline/timeline_painter.h"

#include "widgets/base/colour_maps.h"
#include "widgets/base/numbers/number_format.h"
#include "widgets/base/numbers/tabular_text.h"
#include "widgets/base/theme.h"
#include "widgets/pattern/timeline/crowded_lines.h"
#include "widgets/pattern/timeline/label_places.h"

#include <QCoreApplication>
#include <QLocale>
#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>

namespace teleta::pattern {

namespace {

constexpr double kDegreesApart = 360.0 / static_cast<double>(core::kTactors);
/// Handles closer together than this (in radii, on average) are left out.
constexpr double kHandlesApart = 1.6;
/// Corners closer together than this are merged.
constexpr double kSeen_px = 0.5;

QString text(const char* source) {
    return QCoreApplication::translate("Timeline", source);
}

class Drawing {
public:
    Drawing(QPainter& painter, const TimelineGeometry& geometry, const TimelineContent& content,
            const QPalette& palette, const QFont& font)
        : m_painter(painter)
        , m_g(geometry)
        , m_content(content)
        , m_palette(palette)
        , m_font(font)
        , m_small(base::sized(font, base::kSmallText))
        , m_text(palette.color(QPalette::Text))
        , m_ground(palette.color(QPalette::Base))
        , m_faint(palette.color(QPalette::PlaceholderText))
        , m_accent(palette.color(QPalette::Highlight))
        , m_line(base::isDark(palette) ? base::mixed(m_accent, Qt::white, 0.35) : m_accent) {}

    int all() {
        m_painter.save();
        m_painter.setRenderHint(QPainter::Antialiasing);
        grounds();
        ruler();
        m_painter.save();
        m_painter.setClipRect(m_g.plot);
        objects();
        for (std::size_t i = 0; i < core::kTactors; ++i) {
            if (hasBands())
                bands(i);
            else
                curves(i);
            if (m_content.comparison)
                differences(i);
        }
        int drawn = 0;
        for (std::size_t i = 0; i < core::kTactors; ++i)
            drawn += handles(i);
        m_painter.restore();
        labels();
        legend();
        m_painter.restore();
        return drawn;
    }

private:
    void grounds() {
        m_painter.setPen(Qt::NoPen);
        const double end =
            std::clamp(m_g.xOf(m_content.pattern->duration_s), m_g.plot.left(), m_g.plot.right());
        for (std::size_t i = 0; i < core::kTactors; ++i)
            m_painter.fillRect(m_g.lane[i], i % 2 == 0 ? m_ground : base::mixed(m_ground, m_text, 0.025));
        m_painter.fillRect(QRectF(QPointF(end, m_g.plot.top()), m_g.plot.bottomRight()),
                           base::mixed(m_ground, m_text, 0.09));
        if (m_content.loop) {
            const double from =
                std::clamp(m_g.xOf(m_content.loop->begin_s), m_g.plot.left(), m_g.plot.right());
            const double to = std::clamp(m_g.xOf(m_content.loop->end_s), m_g.plot.left(), m_g.plot.right());
            m_painter.fillRect(QRectF(QPointF(from, m_g.plot.top()), QPointF(to, m_g.plot.bottom())),
                               base::translucent(m_accent, 0.08F));
        }
        m_painter.setRenderHint(QPainter::Antialiasing, false);
        const double step_s = m_g.tickStep_s();
        m_painter.setPen(QPen(base::mixed(m_ground, m_text, 0.08), 1.0));
        for (double k = std::ceil(m_g.begin_s / step_s); k * step_s <= m_g.end_s(); ++k) {
            const double x = std::floor(m_g.xOf(k * step_s));
            m_painter.drawLine(QPointF(x, m_g.plot.top()), QPointF(x, m_g.plot.bottom()));
        }
        for (std::size_t i = 0; i < core::kTactors; ++i) {
            m_painter.setPen(QPen(base::mixed(m_ground, m_text, 0.07), 1.0, Qt::DotLine));
            const double half = std::floor(m_g.yOf(i, 0.5));
            m_painter.drawLine(QPointF(m_g.plot.left(), half), QPointF(m_g.plot.right(), half));
            m_painter.setPen(QPen(base::mixed(m_ground, m_text, 0.18), 1.0));
            const double bottom = std::floor(m_g.lane[i].bottom());
            m_painter.drawLine(QPointF(m_g.label[i].left(), bottom), QPointF(m_g.plot.right(), bottom));
        }
        m_painter.setPen(QPen(base::mixed(m_ground, m_text, 0.4), 1.0));
        if (end < m_g.plot.right())
            m_painter.drawLine(QPointF(std::floor(end), m_g.plot.top()),
                               QPointF(std::floor(end), m_g.plot.bottom()));
        m_painter.setRenderHint(QPainter::Antialiasing);
    }

    void ruler() {
        m_painter.fillRect(QRectF(QPointF(m_g.label[0].left(), m_g.ruler.top()), m_g.ruler.bottomRight()),
                           m_palette.color(QPalette::Window));
        m_painter.save();
        m_painter.setClipRect(m_g.ruler);
        if (m_content.loop) {
            const QRectF bar(QPointF(m_g.xOf(m_content.loop->begin_s), m_g.ruler.bottom() - 0.3 * m_g.em),
                             QPointF(m_g.xOf(m_content.loop->end_s), m_g.ruler.bottom()));
            m_painter.setPen(Qt::NoPen);
            m_painter.setBrush(m_accent);
            m_painter.drawRoundedRect(bar, 2.0, 2.0);
        }
        const double step_s = m_g.tickStep_s();
        m_painter.setFont(m_small);
        const QColor ink = base::mixed(m_palette.color(QPalette::Window), m_text, 0.75);
        constexpr int kMinor = 5;
        const double minor_s = step_s / kMinor;
        m_painter.setRenderHint(QPainter::Antialiasing, false);
        for (double k = std::floor(m_g.begin_s / minor_s); k * minor_s <= m_g.end_s() + step_s; ++k) {
            const double time_s = k * minor_s;
            if (time_s < -1e-9)
                continue;
            const bool major = static_cast<qint64>(k) % kMinor == 0;
            const double x = std::floor(m_g.xOf(time_s));
            m_painter.setPen(base::mixed(m_palette.color(QPalette::Window), m_text, major ? 0.5 : 0.25));
            m_painter.drawLine(QPointF(x, m_g.ruler.bottom() - (major ? 0.4 : 0.2) * m_g.em),
                               QPointF(x, m_g.ruler.bottom()));
            if (major) {
                m_painter.setPen(ink);
                base::drawTabularText(m_painter,
                                      QRectF(x + 0.25 * m_g.em, m_g.ruler.top(), 6.0 * m_g.em,
                                             m_g.ruler.height() - 0.3 * m_g.em),
                                      Qt::AlignLeft | Qt::AlignVCenter, timeText(time_s, step_s));
            }
        }
        m_painter.restore();
        m_painter.setFont(m_small);
        m_painter.setPen(m_faint);
        m_painter.drawText(QRectF(m_g.label[0].left(), m_g.ruler.top(), m_g.label[0].width() - 0.5 * m_g.em,
                                  m_g.ruler.height() - 0.3 * m_g.em),
                           Qt::AlignRight | Qt::AlignVCenter, QStringLiteral("s"));
        m_painter.setFont(m_font);
        m_painter.setRenderHint(QPainter::Antialiasing, false);
        m_painter.setPen(base::mixed(m_ground, m_text, 0.3));
        m_painter.drawLine(QPointF(m_g.label[0].left(), std::floor(m_g.ruler.bottom())),
                           QPointF(m_g.ruler.right(), std::floor(m_g.ruler.bottom())));
        m_painter.setRenderHint(QPainter::Antialiasing);
    }

    void labels() {
        for (std::size_t i = 0; i < core::kTactors; ++i) {
            const QRectF& rect = m_g.label[i];
            if (m_content.currentLane == i) {
                m_painter.setPen(Qt::NoPen);
                m_painter.setBrush(m_accent);
                m_painter.drawRect(QRectF(rect.left(), rect.top() + 1.0, 3.0, rect.height() - 1.0));
            }
            const QRectF upper(rect.left(), rect.center().y() - 1.15 * m_g.em, rect.width() - 0.6 * m_g.em,
                               1.2 * m_g.em);
            m_painter.setFont(base::bold(m_font));
            m_painter.setPen(m_text);
            const bool twoLines = rect.height() > 2.3 * m_g.em;
            m_painter.drawText(
                twoLines ? upper : QRectF(rect.left(), rect.top(), 1.7 * m_g.em, rect.height()),
                (twoLines ? Qt::AlignRight : Qt::AlignHCenter) | Qt::AlignVCenter, QString::number(i + 1));
            m_painter.setFont(m_small);
            m_painter.setPen(m_faint);
            m_painter.drawText(twoLines ? upper.translated(0.0, 1.15 * m_g.em)
                                        : rect.adjusted(0.0, 0.0, -0.4 * m_g.em, 0.0),
                               Qt::AlignRight | Qt::AlignVCenter,
                               base::withUnit(QString::number(kDegreesApart * static_cast<double>(i)),
                                              QStringLiteral("\u00b0")));
        }
        m_painter.setFont(m_font);
    }

    void objects() {
        constexpr double kNarrow_px = 4.0;
        std::array<double, core::kTactors> drawnTo;
        drawnTo.fill(-1.0);
        std::array<LabelPlaces, core::kTactors> labels;
        for (std::size_t k = 0; k < m_content.pattern->objects.size(); ++k) {
            const PatternObject& object = m_content.pattern->objects[k];
            const Span span = spanOf(object.form);
            if (span.end_s < m_g.begin_s || span.begin_s > m_g.end_s())
                continue;
            const bool selected = m_content.selection && m_content.selection->object == k;
            const QColor colour = formColour(object.form, m_palette);
            const QColor wash = base::translucent(colour, selected ? 0.30F : 0.16F);
            // Far outside the picture the coordinates would overflow.
            const double from = std::max(m_g.xOf(span.begin_s), m_g.plot.left() - 100.0);
            const double to = std::min(std::max(m_g.xOf(span.end_s), m_g.xOf(span.begin_s) + 2.0),
                                       m_g.plot.right() + 100.0);
            bool titled = false;
            for (const std::size_t tactor : tactorsOf(object.form)) {
                const QRectF& lane = m_g.lane[tactor];
                if (!selected && to - from < kNarrow_px) {
                    // Thousands of them may cover a few pixels: each pixel is drawn once, without a frame.
                    if (std::floor(from) > drawnTo[tactor])
                        m_painter.fillRect(QRectF(QPointF(std::floor(from), lane.top() + 1.0),
                                                  QPointF(std::ceil(to), lane.bottom() - 1.0)),
                                           wash);
                    drawnTo[tactor] = std::max(drawnTo[tactor], std::floor(to));
                    continue;
                }
                const QRectF block(QPointF(from, lane.top() + 1.0), QPointF(to, lane.bottom() - 1.0));
                m_painter.setPen(QPen(selected ? m_line : colour, selected ? 2.0 : 1.0));
                m_painter.setBrush(wash);
                m_painter.drawRoundedRect(block, 3.0, 3.0);
                if (!titled) {
                    titled = true;
                    m_painter.setFont(m_small);
                    m_painter.setPen(m_text);
                    const QFontMetricsF metrics(m_small);
                    const double left = std::max(from, m_g.plot.left());
                    const double width = std::max(0.0, to - left - 0.6 * m_g.em);
                    const QString title = metrics.elidedText(objectTitle(object), Qt::ElideRight, width);
                    const QRectF wanted(
                        QPointF(left + 0.4 * m_g.em, block.top() + 1.0),
                        QSizeF(std::min(width, metrics.horizontalAdvance(title) + 1.0), m_g.em));
                    if (const auto room = labels[tactor].place(wanted, block.bottom()))
                        m_painter.drawText(*room, Qt::AlignLeft | Qt::AlignVCenter, title);
                    m_painter.setFont(m_font);
                }
            }
        }
    }

    [[nodiscard]] QPolygonF lineOf(const TimelineCurves& curves, const std::vector<double>& values,
                                   std::size_t track) const {
        QPolygonF line;
        line.reserve(static_cast<qsizetype>(values.size()));
        for (std::size_t k = 0; k < values.size(); ++k) {
            const QPointF point(m_g.xOf(curves.times_s[k]), m_g.yOf(track, values[k]));
            const qsizetype n = line.size();
            // A run of equal values is a single line, and so are steps too small to see.
            const bool level = n >= 2 && line[n - 1].y() == point.y() && line[n - 2].y() == point.y();
            const bool near = n >= 2 && point.x() - line[n - 2].x() < kSeen_px &&
                              std::abs(point.y() - line[n - 2].y()) < kSeen_px &&
                              std::abs(line[n - 1].y() - line[n - 2].y()) < kSeen_px;
            if (level || near)
                line[n - 1] = point;
            else
                line << point;
        }
        return line;
    }

    [[nodiscard]] QPolygonF floorUnder(const QPolygonF& line, std::size_t track) const {
        const double floor = m_g.yOf(track, 0.0);
        return QPolygonF({QPointF(line.first().x(), floor), QPointF(line.last().x(), floor)});
    }

    void curves(std::size_t track) {
        const TimelineCurves& curves = *m_content.curves;
        if (curves.times_s.empty())
            return;
        const QPolygonF commanded = lineOf(curves, curves.commanded[track], track);
        m_painter.setPen(Qt::NoPen);
        m_painter.setBrush(base::translucent(m_line, 0.16F));
        fillBetween(m_painter, commanded, floorUnder(commanded, track));
        if (curves.hasPrediction())
            hatch(track);
        if (m_content.reference) {
            const QPolygonF other =
                lineOf(*m_content.reference, m_content.reference->commanded[track], track);
            m_painter.setPen(Qt::NoPen);
            m_painter.setBrush(base::translucent(referenceColour(), 0.22F));
            fillBetween(m_painter, commanded, other);
            strokeLine(m_painter, other, QPen(referenceColour(), 1.5, Qt::DashLine));
        }
        strokeLine(m_painter, commanded, QPen(m_line, 1.8, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        if (curves.hasPrediction())
            strokeLine(m_painter, lineOf(curves, curves.predicted[track], track), predictedPen(1.2));
    }

    [[nodiscard]] QPen predictedPen(double width) const {
        return {base::mixed(m_ground, m_text, 0.75), width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin};
    }
    [[nodiscard]] QColor referenceColour() const { return base::identityColour(2, base::isDark(m_palette)); }

    [[nodiscard]] bool hasBands() const { return m_content.bands && !m_content.bands->empty(); }
    [[nodiscard]] bool hasPrediction() const {
        return hasBands() ? m_content.bands->hasPrediction() : m_content.curves->hasPrediction();
    }

    /// Draws a line through one value of each column.
    template <typename Values, typename Value>
    [[nodiscard]] QPolygonF lineOf(const TimelineBands& bands, const Values& values, std::size_t track,
                                   Value value) const {
        QPolygonF line;
        line.reserve(static_cast<qsizetype>(values.size()));
        for (std::size_t k = 0; k < values.size(); ++k)
            line << QPointF(m_g.xOf(bands.begin_s + (static_cast<double>(k) + 0.5) * bands.column_s),
                            m_g.yOf(track, value(values[k])));
        return line;
    }

    /// Draws a long span: from the lowest to the highest value of each column of pixels.
    void bands(std::size_t track) {
        const TimelineBands& all = *m_content.bands;
        const TimelineBands::Band& band = all.tracks[track];
        const auto high = [](const auto& range) { return static_cast<double>(range.high); };
        const QPolygonF upper = lineOf(all, band.commanded, track, high);
        fillColumns(track);
        if (all.hasPrediction())
            hatchColumns(track);
        const QPen referencePen(referenceColour(), 1.5, Qt::DashLine);
        if (m_content.referenceBands && !m_content.referenceBands->empty())
            strokeLine(m_painter,
                       lineOf(*m_content.referenceBands, m_content.referenceBands->tracks[track].commanded,
                              track, high),
                       referencePen);
        else if (m_content.reference)
            strokeLine(m_painter, lineOf(*m_content.reference, m_content.reference->commanded[track], track),
                       referencePen);
        strokeLine(m_painter, upper, QPen(m_line, 1.4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        if (all.hasPrediction())
            strokeLine(m_painter, lineOf(all, band.predicted, track, high), predictedPen(1.0));
    }

    /// Draws faintly below the lowest value of each column and strongly up to its highest.
    void fillColumns(std::size_t track) {
        const TimelineBands& all = *m_content.bands;
        const auto& ranges = all.tracks[track].commanded;
        const QColor faint = base::translucent(m_line, 0.16F);
        const QColor strong = base::translucent(m_line, 0.58F);
        const double floor = m_g.yOf(track, 0.0);
        m_painter.setRenderHint(QPainter::Antialiasing, false);
        for (std::size_t k = 0; k < ranges.size(); ++k) {
            const double left = std::floor(m_g.xOf(all.begin_s + static_cast<double>(k) * all.column_s));
            const double right = std::floor(m_g.xOf(all.begin_s + static_cast<double>(k + 1) * all.column_s));
            const double low = m_g.yOf(track, ranges[k].low);
            m_painter.fillRect(QRectF(QPointF(left, low), QPointF(right, floor)), faint);
            m_painter.fillRect(QRectF(QPointF(left, m_g.yOf(track, ranges[k].high)), QPointF(right, low)),
                               strong);
        }
        m_painter.setRenderHint(QPainter::Antialiasing);
    }

    /// Draws a strip along the bottom of the lane where the motor cannot follow somewhere in the column.
    void hatchColumns(std::size_t track) {
        const TimelineBands& all = *m_content.bands;
        const auto& columns = all.tracks[track].predicted;
        const double floor = m_g.yOf(track, 0.0);
        m_painter.setPen(Qt::NoPen);
        m_painter.setBrush(QBrush(base::statusColours(m_palette).stale, Qt::BDiagPattern));
        const auto apart = [&](std::size_t k) {
            return static_cast<double>(columns[k].apart) > kFollowTolerance;
        };
        for (std::size_t k = 0; k < columns.size();) {
            const std::size_t first = k;
            while (k < columns.size() && apart(k))
                ++k;
            if (k > first)
                m_painter.drawRect(
                    QRectF(QPointF(m_g.xOf(all.begin_s + static_cast<double>(first) * all.column_s),
                                   floor - 0.35 * m_g.em),
                           QPointF(m_g.xOf(all.begin_s + static_cast<double>(k) * all.column_s), floor)));
            else
                ++k;
        }
    }

    /// Writes the difference of the two patterns on a tactor into its lane.
    void differences(std::size_t track) {
        const TactorDifference& apart = m_content.comparison->tactors[track];
        const QLocale locale;
        const QString words = text(QT_TRANSLATE_NOOP("Timeline", "\u0394 %1 %, rms %2 %"))
                                  .arg(locale.toString(100.0 * apart.largest, 'f', 1),
                                       locale.toString(100.0 * apart.rms, 'f', 1));
        m_painter.setFont(m_small);
        const double width = base::tabularWidth(QFontMetricsF(m_small), words) + 0.6 * m_g.em;
        const QRectF room(m_g.lane[track].right() - width - 0.3 * m_g.em, m_g.lane[track].top() + 2.0, width,
                          1.1 * m_g.em);
        m_painter.setPen(Qt::NoPen);
        m_painter.setBrush(base::translucent(m_ground, 0.8F));
        m_painter.drawRoundedRect(room, 3.0, 3.0);
        m_painter.setPen(apart.largest > 0.0 ? referenceColour() : m_faint);
        base::drawTabularText(m_painter, room, Qt::AlignCenter, words);
        m_painter.setFont(m_font);
    }

    /// Hatches the area between the commanded and the predicted intensity where they differ too much.
    void hatch(std::size_t track) {
        const TimelineCurves& curves = *m_content.curves;
        const auto& asked = curves.commanded[track];
        const auto& done = curves.predicted[track];
        m_painter.setPen(Qt::NoPen);
        m_painter.setBrush(QBrush(base::statusColours(m_palette).stale, Qt::BDiagPattern));
        // The lines hide its edges, and antialiasing hundreds of them would be slow.
        m_painter.setRenderHint(QPainter::Antialiasing, false);
        const auto apart = [&](std::size_t k) { return std::abs(asked[k] - done[k]) > kFollowTolerance; };
        for (std::size_t k = 0; k < asked.size();) {
            if (!apart(k)) {
                ++k;
                continue;
            }
            QPolygonF upper;
            QPolygonF lower;
            for (; k < asked.size() && apart(k); ++k) {
                const double x = m_g.xOf(curves.times_s[k]);
                upper << QPointF(x, m_g.yOf(track, asked[k]));
                lower << QPointF(x, m_g.yOf(track, done[k]));
            }
            fillBetween(m_painter, upper, lower);
        }
        m_painter.setRenderHint(QPainter::Antialiasing);
    }

    int handles(std::size_t track) {
        const Track& points = m_content.pattern->tracks[track];
        const double margin_s = m_g.handle * m_g.secondsPerPixel();
        const std::size_t first = firstFrom(points, m_g.begin_s - margin_s);
        const std::size_t last = firstFrom(points, m_g.end_s() + margin_s);
        const bool crowded =
            static_cast<double>(last - first) * kHandlesApart * m_g.handle > m_g.plot.width();
        int drawn = 0;
        const auto draw = [&](std::size_t i, bool selected) {
            const QPointF at(m_g.xOf(points[i].time_s), m_g.yOf(track, points[i].intensity));
            m_painter.setPen(QPen(selected ? m_text : m_line, 1.5));
            m_painter.setBrush(selected ? m_line : m_ground);
            const double radius = selected ? m_g.handle + 1.0 : m_g.handle;
            if (points[i].easing == Easing::linear)
                m_painter.drawEllipse(at, radius, radius);
            else if (points[i].easing == Easing::hold)
                m_painter.drawRect(QRectF(at.x() - radius, at.y() - radius, 2.0 * radius, 2.0 * radius));
            else
                m_painter.drawPolygon(
                    QPolygonF({at + QPointF(0, -1.2 * radius), at + QPointF(1.2 * radius, 0),
                               at + QPointF(0, 1.2 * radius), at + QPointF(-1.2 * radius, 0)}));
            ++drawn;
        };
        if (!crowded)
            for (std::size_t i = first; i < last; ++i)
                draw(i, false);
        if (!m_content.selection)
            return drawn;
        const PointRefs& chosen = m_content.selection->points;
        auto at = std::lower_bound(chosen.begin(), chosen.end(), PointRef{track, first});
        const auto end = std::lower_bound(chosen.begin(), chosen.end(), PointRef{track, last});
        if (crowded && static_cast<double>(end - at) * kHandlesApart * m_g.handle > m_g.plot.width())
            return drawn;
        const int before = drawn;
        for (; at != end; ++at)
            draw(at->index, true);
        return crowded ? drawn : before; // a selected one has already been counted
    }

    void legend() {
        m_painter.setFont(m_small);
        const QFontMetricsF metrics(m_small);
        double x = m_g.plot.left();
        const double y = m_g.legend.center().y();
        const auto word = [&](const QString& words) {
            x += 2.2 * m_g.em;
            m_painter.setPen(m_faint);
            m_painter.drawText(QPointF(x, y + 0.5 * metrics.ascent() - 0.1 * m_g.em), words);
            x += metrics.horizontalAdvance(words) + 1.2 * m_g.em;
        };
        const auto sample = [&](const QPen& pen) {
            m_painter.setPen(pen);
            m_painter.drawLine(QPointF(x, y), QPointF(x + 1.8 * m_g.em, y));
        };
        sample(QPen(m_line, 1.8));
        word(text(QT_TRANSLATE_NOOP("Timeline", "commanded")));
        if (hasPrediction()) {
            sample(predictedPen(1.2));
            word(m_content.assumedMotors ? text(QT_TRANSLATE_NOOP("Timeline", "predicted (assumed motors)"))
                                         : text(QT_TRANSLATE_NOOP("Timeline", "predicted")));
            m_painter.setPen(Qt::NoPen);
            m_painter.setBrush(QBrush(base::statusColours(m_palette).stale, Qt::BDiagPattern));
            m_painter.drawRect(QRectF(x, y - 0.35 * m_g.em, 1.8 * m_g.em, 0.7 * m_g.em));
            word(text(QT_TRANSLATE_NOOP("Timeline", "the motor cannot follow")));
        } else {
            x -= 2.2 * m_g.em;
            word(text(QT_TRANSLATE_NOOP("Timeline", "zoom in to see what the motors do")));
        }
        if (m_content.reference) {
            sample(QPen(referenceColour(), 1.5, Qt::DashLine));
            word(m_content.referenceName);
        }
        m_painter.setFont(m_font);
    }

    QPainter& m_painter;
    const TimelineGeometry& m_g;
    const TimelineContent& m_content;
    const QPalette& m_palette;
    QFont m_font, m_small;
    QColor m_text, m_ground, m_faint, m_accent, m_line;
};

} // namespace

int paintTimeline(QPainter& painter, const TimelineGeometry& geometry, const TimelineContent& content,
                  const QPalette& palette, const QFont& font) {
    return Drawing(painter, geometry, content, palette, font).all();
}

void paintPlayhead(QPainter& painter, const TimelineGeometry& geometry, double time_s,
                   const QPalette& palette) {
    const double x = geometry.xOf(time_s);
    if (x < geometry.plot.left() - 1.0 || x > geometry.plot.right() + 1.0)
        return;
    const QColor colour = base::statusColours(palette).lost;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(colour, 1.5));
    painter.drawLine(QPointF(x, geometry.ruler.bottom()), QPointF(x, geometry.plot.bottom()));
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    const double w = 0.4 * geometry.em;
    const double bottom = geometry.ruler.bottom();
    painter.drawPolygon(QPolygonF({{x - w, bottom - 1.8 * w},
                                   {x + w, bottom - 1.8 * w},
                                   {x + w, bottom - 0.8 * w},
                                   {x, bottom + 0.3 * w},
                                   {x - w, bottom - 0.8 * w}}));
    painter.restore();
}

QString formName(const ObjectForm& form) {
    static constexpr std::array<const char*, 6> kNames{
        QT_TRANSLATE_NOOP("Timeline", "Sweep"),       QT_TRANSLATE_NOOP("Timeline", "Ring"),
        QT_TRANSLATE_NOOP("Timeline", "Phantom"),     QT_TRANSLATE_NOOP("Timeline", "Ramp"),
        QT_TRANSLATE_NOOP("Timeline", "Pulse train"), QT_TRANSLATE_NOOP("Timeline", "Stroke")};
    static_assert(std::variant_size_v<ObjectForm> == kNames.size());
    return text(kNames[form.index()]);
}

QString objectTitle(const PatternObject& object) {
    return object.name.empty() ? formName(object.form) : QString::fromStdString(object.name);
}

QColor formColour(const ObjectForm& form, const QPalette& palette) {
    return base::identityColour(static_cast<int>(form.index()) + 3, base::isDark(palette));
}

} // namespace teleta::pattern
