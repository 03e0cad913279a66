// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/touch/gauge_painter.h"

#include "widgets/base/controls/status_glyph.h"
#include "widgets/base/theme.h"
#include "widgets/touch/safety_sign.h"
#include "widgets/touch/touch_texts.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace teleta::touch {

using stiffness::MaterialBand;
using stiffness::materialBands;

namespace {

constexpr std::size_t kBands = 5;

bool beyond(double stiffness_NPerM) {
    return stiffness_NPerM < GaugeLayout::kLowest_NPerM || stiffness_NPerM > GaugeLayout::kHighest_NPerM;
}

class Drawing {
public:
    Drawing(QPainter& painter, const GaugeLayout& layout, const QFont& font, const GaugeContent& content,
            const QPalette& palette)
        : m_painter(painter)
        , m_layout(layout)
        , m_font(font)
        , m_small(base::sized(font, base::kSmallText))
        , m_content(content)
        , m_palette(palette)
        , m_text(palette.color(QPalette::Text))
        , m_ground(palette.color(QPalette::Base))
        , m_faint(palette.color(QPalette::PlaceholderText)) {}

    void all() {
        m_painter.save();
        m_painter.setRenderHint(QPainter::Antialiasing);
        verdict();
        bands();
        if (!m_layout.names.isEmpty())
            bandNames();
        if (!m_layout.axis.isEmpty())
            axis();
        if (m_content.touch)
            estimate(m_content.touch->object);
        if (!m_layout.details.isEmpty())
            details();
        m_painter.restore();
    }

private:
    void verdict() {
        QRectF room = m_layout.headline;
        if (isKnown()) {
            const bool safe = stiffness::isSafe(m_content.touch->material);
            const QFont font = signFont(safe);
            QRectF sign({}, safetySignSize(font, safe));
            sign.moveCenter(room.center());
            sign.moveRight(room.right());
            paintSafetySign(m_painter, sign, font, safe, m_palette);
            room.setRight(sign.left() - 0.5 * m_layout.em);
        }
        const bool known = m_content.touch.has_value();
        const QString text =
            known || m_content.refusal ? GaugeTexts::headline(m_content) : GaugeTexts::tr("no touch yet");
        m_painter.setFont(fitting(text, room.width(), known ? base::kHugeText : base::kLargeText));
        m_painter.setPen(known ? m_text : m_faint);
        m_painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter, text);
        m_painter.setFont(m_font);
        const QRectF line = base::paintProvenance(m_painter, m_layout.material, m_content.provenance,
                                                  m_palette, 0.5 * m_layout.em);
        const QRectF rest = age(line);
        if (m_content.touch)
            words(rest, m_font, m_text, GaugeTexts::material(*m_content.touch));
        else if (m_layout.details.isEmpty())
            words(rest, m_small, m_faint,
                  m_content.refusal ? GaugeTexts::details(m_content) : m_content.emptyText);
    }

    /// At the right end, below the sign: how old its word is. Returns what is left of the line.
    QRectF age(const QRectF& line) {
        const QString text = GaugeTexts::age(m_content);
        if (text.isEmpty())
            return line;
        const bool isOld = GaugeTexts::isStale(m_content);
        const double width = QFontMetricsF(m_small).horizontalAdvance(text) + 1.0;
        const QRectF room(line.right() - width, line.top(), width, line.height());
        words(room, m_small, isOld ? base::statusColours(m_palette).stale : m_faint, text);
        const double mark = isOld ? 0.8 * m_layout.em : 0.0;
        if (isOld)
            base::paintStatusGlyph(
                m_painter, QRectF(room.left() - 1.25 * mark, line.center().y() - 0.5 * mark, mark, mark),
                core::DeviceState::stale, m_palette);
        return line.adjusted(0.0, 0.0, -width - 1.25 * mark - 0.5 * m_layout.em, 0.0);
    }

    /// As large as the reading beside it allows.
    QFont signFont(bool safe) const {
        const QFont reading = base::sized(m_font, base::kHugeText);
        const double room = m_layout.headline.width() - 0.5 * m_layout.em -
                            QFontMetricsF(reading).horizontalAdvance(GaugeTexts::headline(m_content));
        for (const double scale : {base::kLargeText, base::kTitleText}) {
            const QFont candidate = base::sized(m_font, scale);
            const QSizeF size = safetySignSize(candidate, safe);
            if (size.width() <= room && size.height() <= m_layout.headline.height())
                return candidate;
        }
        return m_font;
    }

    /// Whether the material may be told.
    [[nodiscard]] bool isKnown() const { return m_content.touch && m_content.touch->materialKnown(); }

    /// The largest of the sizes from factor down in which the text fits.
    QFont fitting(const QString& text, double width, double factor) const {
        for (const double smaller : {factor, base::kLargeText, base::kNormalText}) {
            const QFont candidate = base::sized(m_font, std::min(factor, smaller));
            if (QFontMetricsF(candidate).horizontalAdvance(text) <= width)
                return candidate;
        }
        return m_small;
    }

    void words(const QRectF& room, const QFont& font, const QColor& colour, const QString& text,
               Qt::Alignment alignment = Qt::AlignLeft | Qt::AlignVCenter) {
        m_painter.setFont(font);
        m_painter.setPen(colour);
        m_painter.drawText(room, alignment,
                           QFontMetricsF(font).elidedText(text, Qt::ElideRight, room.width()));
    }

    void bands() {
        const auto& all = materialBands();
        for (std::size_t i = 0; i < kBands; ++i) {
            const QRectF room = m_layout.band(i);
            const bool safe = stiffness::isSafe(all[i].material);
            const bool chosen = isKnown() && m_content.touch->material == all[i].material;
            const QColor colour = safetyColour(safe, m_palette);
            m_painter.setPen(Qt::NoPen);
            m_painter.setBrush(base::mixed(m_ground, colour, chosen ? 0.55 : 0.16));
            m_painter.drawRect(room.adjusted(i == 0 ? 0.0 : 0.75, 0.0, i + 1 == kBands ? 0.0 : -0.75, 0.0));
        }
        // Which part is safe is said under the bands by line, shape and word.
        const auto firstDanger = static_cast<std::size_t>(
            std::ranges::find_if(all, [](const MaterialBand& b) { return !stiffness::isSafe(b.material); }) -
            all.begin());
        foot(QRectF(m_layout.band(0).bottomLeft(), m_layout.band(firstDanger - 1).bottomRight()), true);
        foot(QRectF(m_layout.band(firstDanger).bottomLeft(), m_layout.band(kBands - 1).bottomRight()), false);
    }

    void foot(const QRectF& edge, bool safe) {
        const QColor colour = safetyColour(safe, m_palette);
        const double thickness = std::max(2.0, 0.18 * m_layout.em);
        m_painter.fillRect(
            QRectF(edge.left() + (safe ? 0.0 : 0.75), edge.top(), edge.width() - 0.75, thickness), colour);
    }

    void bandNames() {
        const QFontMetricsF metrics(m_small);
        const auto& all = materialBands();
        for (std::size_t i = 0; i < kBands; ++i) {
            const bool chosen = isKnown() && m_content.touch->material == all[i].material;
            QFont font = m_small;
            font.setBold(chosen);
            const QString name = TouchTexts::material(all[i].material);
            QRectF room = m_layout.band(i);
            room.setTop(m_layout.names.top());
            room.setBottom(m_layout.names.bottom());
            words(room, font, chosen ? m_text : base::mixed(m_text, m_ground, 0.25), name, Qt::AlignCenter);
        }
    }

    void axis() {
        const QColor line = base::mixed(m_text, m_ground, 0.4);
        const QRectF& room = m_layout.axis;
        m_painter.setRenderHint(QPainter::Antialiasing, false);
        for (double decade = GaugeLayout::kLowest_NPerM; decade <= GaugeLayout::kHighest_NPerM * 1.001;
             decade *= 10.0) {
            for (int digit = 1; digit < 10; ++digit) {
                const double value = digit * decade;
                if (value > GaugeLayout::kHighest_NPerM * 1.001)
                    break;
                m_painter.setPen(QPen(line, 1.0));
                const double x = std::round(m_layout.x(value));
                m_painter.drawLine(QPointF(x, room.top()),
                                   QPointF(x, room.top() + (digit == 1 ? 0.4 : 0.22) * m_layout.em));
            }
            axisLabel(decade);
        }
        m_painter.setRenderHint(QPainter::Antialiasing);
    }

    void axisLabel(double value) {
        const QFontMetricsF metrics(m_small);
        const QString text = TouchTexts::newtonPerMetre(value)
                                 .replace(QStringLiteral(".00"), QString())
                                 .replace(QStringLiteral(".0"), QString());
        const double width = metrics.horizontalAdvance(text);
        const QRectF& room = m_layout.axis;
        const double left = std::clamp(m_layout.x(value) - 0.5 * width, room.left() - 0.4 * m_layout.em,
                                       room.right() + 0.4 * m_layout.em - width);
        m_painter.setFont(m_small);
        m_painter.setPen(base::mixed(m_text, m_ground, 0.25));
        m_painter.drawText(QRectF(left, room.top() + 0.45 * m_layout.em, width + 1.0, metrics.height()),
                           Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip, text);
    }

    void estimate(const stiffness::Stiffness& k) {
        const double thickness = 2.0 * std::round(0.08 * m_layout.em) + 1.0;
        const double y = lane();
        const double half = 0.42 * m_layout.em;
        m_painter.setPen(QPen(m_text, thickness, Qt::SolidLine, Qt::FlatCap));
        m_painter.setBrush(Qt::NoBrush);
        const auto cap = [&](double x) { m_painter.drawLine(QPointF(x, y - half), QPointF(x, y + half)); };
        if (k.lower95_NPerM) {
            const double low = m_layout.x(*k.lower95_NPerM);
            const bool open = !k.upper95_NPerM;
            const double high = open ? m_layout.bands.right() : m_layout.x(*k.upper95_NPerM);
            // An interval that lies beyond the scale is not drawn; the arrow of its value is.
            if (low < high) {
                m_painter.drawLine(QPointF(low, y), QPointF(high, y));
                if (*k.lower95_NPerM < GaugeLayout::kLowest_NPerM)
                    arrowHead(low, -1.0);
                else
                    cap(low);
                if (open || *k.upper95_NPerM > GaugeLayout::kHighest_NPerM)
                    arrowHead(high, 1.0);
                else
                    cap(high);
            } else if (k.onlyBound()) {
                arrowHead(high, 1.0);
            }
            if (k.onlyBound())
                cursor(low, true);
        }
        if (k.value_NPerM) {
            const double x = m_layout.x(*k.value_NPerM);
            cursor(x, false);
            m_painter.setPen(QPen(m_ground, 1.5));
            m_painter.setBrush(m_text);
            const double r = 0.36 * m_layout.em;
            if (beyond(*k.value_NPerM)) {
                const double side = *k.value_NPerM < GaugeLayout::kLowest_NPerM ? -1.0 : 1.0;
                m_painter.drawPolygon(
                    QPolygonF({{x + side * r, y}, {x - side * r, y - r}, {x - side * r, y + r}}));
            } else {
                m_painter.drawEllipse(QPointF(x, y), r, r);
            }
        }
    }

    /// Height of the interval, in the middle of a pixel so that the line is sharp.
    [[nodiscard]] double lane() const { return std::floor(m_layout.interval.center().y()) + 0.5; }

    /// An open arrow: the interval has no end there.
    void arrowHead(double x, double side) {
        const double y = lane();
        const double half = 0.5 * m_layout.em;
        QPainterPath head(QPointF(x - side * half, y - half));
        head.lineTo(x, y);
        head.lineTo(x - side * half, y + half);
        QPen pen = m_painter.pen();
        pen.setJoinStyle(Qt::MiterJoin);
        m_painter.strokePath(head, pen);
    }

    void cursor(double x, bool bound) {
        const double top = lane();
        m_painter.save();
        m_painter.setPen(QPen(m_text, std::max(1.5, 0.1 * m_layout.em), bound ? Qt::DashLine : Qt::SolidLine,
                              Qt::FlatCap));
        m_painter.drawLine(QPointF(x, top), QPointF(x, m_layout.bands.bottom()));
        m_painter.restore();
    }

    void details() {
        const QString warning = GaugeTexts::warning(m_content);
        QString text = GaugeTexts::details(m_content);
        if (!m_content.touch && !m_content.refusal)
            text = m_content.emptyText;
        if (!warning.isEmpty())
            text = warning + u'\n' + text;
        if (m_layout.details.height() < 2.0 * QFontMetricsF(m_small).height())
            text = QFontMetricsF(m_small).elidedText(text.section(u'\n', 0, 0), Qt::ElideRight,
                                                     m_layout.details.width());
        m_painter.setFont(m_small);
        m_painter.setPen(warning.isEmpty() ? base::mixed(m_text, m_ground, 0.2)
                                           : base::statusColours(m_palette).stale);
        m_painter.drawText(m_layout.details, Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, text);
    }

    QPainter& m_painter;
    const GaugeLayout& m_layout;
    QFont m_font, m_small;
    const GaugeContent& m_content;
    const QPalette& m_palette;
    QColor m_text, m_ground, m_faint;
};

} // namespace

GaugeLayout::GaugeLayout(const QRectF& rect, const QFont& font)
    : em(QFontMetricsF(font).height()) {
    const double margin = 0.75 * em;
    const QRectF inner = rect.adjusted(margin, 0.5 * margin, -margin, -0.5 * margin);
    constexpr double kMaterial = 1.3, kLeastBand = 0.8;
    double headlineHeight = 2.4, namesHeight = 1.2, intervalHeight = 1.2, axisHeight = 1.5,
           detailsHeight = 2.0;
    const auto rest_em = [&] {
        return inner.height() / em - headlineHeight - kMaterial - namesHeight - intervalHeight - axisHeight -
               detailsHeight;
    };
    // The lower it is, the fewer of its parts remain; the verdict and the scale do to the end.
    for (double* part : {&detailsHeight, &axisHeight, &namesHeight, &intervalHeight}) {
        if (part == &detailsHeight && rest_em() < kLeastBand - 0.1)
            detailsHeight = 1.0;
        if (rest_em() < kLeastBand - 0.1)
            *part = 0.0;
    }
    if (rest_em() < kLeastBand)
        headlineHeight = 2.0;
    const double rest = rest_em();
    const double bandHeight = std::clamp(rest - 0.6, kLeastBand, 4.5);
    // What is left over is shared above and below the scale.
    const double gap = std::max(0.0, rest - bandHeight) * 0.5;
    double y = inner.top();
    const auto row = [&](double height_em) {
        const QRectF room(inner.left(), y, inner.width(), height_em * em);
        y = room.bottom();
        return room;
    };
    headline = row(headlineHeight);
    material = row(kMaterial);
    y += gap * em;
    names = row(namesHeight);
    interval = row(intervalHeight);
    bands = row(bandHeight);
    if (intervalHeight == 0.0)
        interval = bands;
    y += 0.2 * em;
    axis = row(axisHeight);
    y += std::min(gap, 0.4) * em;
    details =
        QRectF(inner.left(), y, inner.width(), detailsHeight == 0.0 ? 0.0 : std::max(em, inner.bottom() - y));
}

double GaugeLayout::x(double stiffness_NPerM) const {
    const double k = std::clamp(stiffness_NPerM, kLowest_NPerM, kHighest_NPerM);
    return bands.left() +
           bands.width() * std::log(k / kLowest_NPerM) / std::log(kHighest_NPerM / kLowest_NPerM);
}

QRectF GaugeLayout::band(std::size_t index) const {
    const MaterialBand& part = materialBands()[index];
    const double left = x(part.lower_NPerM);
    const double right = x(part.upper_NPerM.value_or(kHighest_NPerM));
    return {left, bands.top(), right - left, bands.height()};
}

std::optional<std::size_t> GaugeLayout::bandAt(const QPointF& point) const {
    for (std::size_t i = 0; i < kBands; ++i)
        if (const QRectF room = band(i); point.x() >= room.left() && point.x() < room.right() &&
                                         point.y() >= names.top() && point.y() < axis.top())
            return i;
    return std::nullopt;
}

void paintGauge(QPainter& painter, const GaugeLayout& layout, const QFont& font, const GaugeContent& content,
                const QPalette& palette) {
    Drawing(painter, layout, font, content, palette).all();
}

} // namespace teleta::touch
