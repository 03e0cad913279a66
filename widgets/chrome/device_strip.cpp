// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/chrome/device_strip.h"

#include "widgets/base/controls/status_glyph.h"
#include "widgets/base/numbers/quantity_text.h"
#include "widgets/base/numbers/tabular_text.h"
#include "widgets/base/theme.h"

#include <QEvent>
#include <QHelpEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace teleta::chrome {

namespace {

/// Of a name that stay when it is cut so that a rate stays.
constexpr qsizetype kNameLetters = 16;

QString cutToWidth(QString text, double width, const QFontMetricsF& metrics) {
    if (base::tabularWidth(metrics, text) <= width)
        return text;
    const QChar ellipsis(0x2026);
    while (!text.isEmpty() && base::tabularWidth(metrics, text + ellipsis) > width)
        text.chop(1);
    return text.trimmed() + ellipsis;
}

/// A name's end tells it from others as well as its beginning.
QString cutInside(const QString& name, double width, const QFontMetricsF& metrics) {
    if (base::tabularWidth(metrics, name) <= width)
        return name;
    for (qsizetype kept = name.size() - 1; kept > 0; --kept) {
        QString text = name.first((kept + 1) / 2) + QChar(0x2026) + name.last(kept / 2);
        if (base::tabularWidth(metrics, text) <= width)
            return text;
    }
    return QString(QChar(0x2026));
}

/// The largest width per device with which all of them fit.
double fairShare(std::vector<double> widths, double room) {
    std::ranges::sort(widths);
    for (std::size_t i = 0; i < widths.size(); ++i) {
        const double share = room / static_cast<double>(widths.size() - i);
        if (widths[i] > share)
            return std::max(0.0, std::floor(share));
        room -= widths[i];
    }
    return std::numeric_limits<double>::infinity();
}

/// The badge's word, in a sentence.
QString wordOf(base::Provenance provenance) {
    return QLocale().toLower(base::provenanceText(provenance));
}

/// The same where there is little room; the colour of the stripe says it as well.
QString shortWordOf(base::Provenance provenance) {
    switch (provenance) {
    case base::Provenance::live:
        break;
    case base::Provenance::unguarded:
        return wordOf(provenance);
    case base::Provenance::recorded:
        return DeviceStrip::tr("rec", "recorded, short");
    case base::Provenance::recordedSimulation:
        return DeviceStrip::tr("rec sim", "a recorded simulation, short");
    case base::Provenance::simulated:
        return DeviceStrip::tr("sim", "simulated, short");
    }
    return {};
}

} // namespace

DeviceStrip::DeviceStrip(QWidget* parent)
    : QWidget(parent) {
    setAccessibleName(tr("Devices"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void DeviceStrip::setReadings(const std::vector<DeviceReading>& readings) {
    bool changed = readings.size() != m_cells.size();
    m_cells.resize(readings.size());
    for (std::size_t index = 0; index < readings.size(); ++index) {
        Cell& cell = m_cells[index];
        const DeviceReading& now = readings[index];
        changed = changed || now.state != cell.reading.state || now.active != cell.reading.active ||
                  now.provenance != cell.reading.provenance;
        cell.reading = now;
        cell.rate.update(now.rate_Hz);
        cell.touchToSkin_ms.update(now.touchToSkin_s ? std::optional(*now.touchToSkin_s * 1e3)
                                                     : std::nullopt);
        cell.latency_ms.update(now.latency_s ? std::optional(*now.latency_s * 1e3) : std::nullopt);
        const QString before = cell.text;
        cell.text = compose(cell, Detail::all, now.name);
        changed = changed || before != cell.text;
    }
    if (!changed)
        return;
    arrange();
    QStringList spoken;
    for (const Cell& cell : m_cells)
        spoken << cell.text;
    setAccessibleDescription(spoken.join(QStringLiteral("; ")));
    update();
}

QSize DeviceStrip::sizeHint() const {
    return {std::max(m_wanted_px, base::em(this, 12)), base::em(this, 1.75)};
}

QSize DeviceStrip::minimumSizeHint() const {
    return {base::em(this, 8), base::em(this, 1.75)};
}

QString DeviceStrip::text(int index) const {
    const auto cell = static_cast<std::size_t>(index);
    return cell < m_cells.size() ? m_cells[cell].text : QString();
}

QString DeviceStrip::shownText(int index) const {
    const auto cell = static_cast<std::size_t>(index);
    return cell < m_cells.size() ? m_cells[cell].shown : QString();
}

QString DeviceStrip::compose(const Cell& cell, Detail detail, const QString& name) const {
    const DeviceReading& reading = cell.reading;
    QString word = base::statusWord(reading.state);
    if (reading.state == core::DeviceState::stale || reading.state == core::DeviceState::lost)
        word = tr("%1 for %2", "state of a device and its age").arg(word, base::ageText(reading.age_s));
    const bool live = reading.state == core::DeviceState::live;
    if (live && (reading.provenance == base::Provenance::recorded ||
                 reading.provenance == base::Provenance::recordedSimulation))
        word = tr("playing", "a recording");
    QStringList parts{name};
    // The symbol alone says that a device works.
    if (!live || detail < Detail::nameAndRate)
        parts << word;
    if (live && detail < Detail::troubles)
        parts << base::withUnit(cell.rate.text().trimmed(), tr("Hz"));
    if (reading.lost > 0)
        parts << tr("%1 lost", "frames").arg(base::shortCount(reading.lost));
    if (!reading.remark.isEmpty() && detail < Detail::troubles)
        parts << reading.remark;
    if (reading.active && cell.latency_ms.shown() && live && detail == Detail::all)
        parts << tr("to screen %1 ms").arg(cell.latency_ms.text().trimmed());
    if (cell.touchToSkin_ms.shown() && detail == Detail::all)
        parts << tr("touch to skin %1 ms").arg(cell.touchToSkin_ms.text().trimmed());
    return parts.join(QStringLiteral("  "));
}

bool DeviceStrip::cutsTooMuch(const Cell& cell, double room_px) const {
    const QFontMetricsF metrics(font());
    const double name_px = room_px - base::tabularWidth(metrics, compose(cell, Detail::cutNames, {}));
    return cutInside(cell.reading.name, name_px, metrics).size() <
           std::min(kNameLetters, cell.reading.name.size());
}

QString DeviceStrip::cutShort(const Cell& cell, Detail detail, double room_px) const {
    const QFontMetricsF metrics(font());
    const QString rest = compose(cell, detail, {});
    const QString whole =
        cutInside(cell.reading.name, room_px - base::tabularWidth(metrics, rest), metrics) + rest;
    return base::tabularWidth(metrics, whole) <= room_px ? whole
                                                         : cutToWidth(rest.trimmed(), room_px, metrics);
}

QFont DeviceStrip::smallFont() const {
    return base::sized(font(), base::kSmallText);
}

double DeviceStrip::besideText(const Cell& cell) const {
    const double room = cell.word.isEmpty()
                            ? 0.0
                            : QFontMetricsF(smallFont()).horizontalAdvance(cell.word) + base::grid(this);
    return base::grid(this, 4) + room;
}

int DeviceStrip::place(Detail detail) {
    const QFontMetricsF metrics(font());
    const int gap = base::grid(this, 2);
    std::vector<double> widths;
    for (Cell& cell : m_cells) {
        cell.shown = compose(cell, detail, cell.reading.name);
        // A name is shortened only when the word is gone, but for one that warns.
        const bool warns = cell.reading.provenance == base::Provenance::unguarded;
        cell.word = detail < Detail::shortWords ? wordOf(cell.reading.provenance)
                    : (detail != Detail::cutNames && detail != Detail::cutShort) || warns
                        ? shortWordOf(cell.reading.provenance)
                        : QString();
        widths.push_back(std::ceil(besideText(cell) + base::tabularWidth(metrics, cell.shown)));
    }
    const double most = detail == Detail::cutShort || detail == Detail::cutNames
                            ? fairShare(widths, width() - (static_cast<double>(m_cells.size()) - 1.0) * gap)
                            : std::numeric_limits<double>::infinity();
    int left = 0;
    for (std::size_t index = 0; index < m_cells.size(); ++index) {
        Cell& cell = m_cells[index];
        const double beside = besideText(cell);
        if (widths[index] > most && detail == Detail::cutNames && cutsTooMuch(cell, most - beside))
            return std::numeric_limits<int>::max();
        if (widths[index] > most)
            cell.shown = cutShort(cell, detail, most - beside);
        const double width = beside + base::tabularWidth(metrics, cell.shown);
        cell.rect = QRect(left, 0, static_cast<int>(std::ceil(width)), base::em(this, 1.75));
        left = cell.rect.right() + 1 + gap;
    }
    return m_cells.empty() ? 0 : left - gap;
}

void DeviceStrip::arrange() {
    const int wanted_px = place(Detail::all);
    if (wanted_px > width()) {
        for (const Detail detail : {Detail::withoutLatencies, Detail::shortWords, Detail::nameAndRate,
                                    Detail::cutNames, Detail::troubles, Detail::cutShort})
            if (place(detail) <= width())
                break;
    }
    if (std::exchange(m_wanted_px, wanted_px) != wanted_px)
        updateGeometry();
}

void DeviceStrip::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    arrange();
}

void DeviceStrip::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double glyph = base::em(this, 0.75);
    for (const Cell& cell : m_cells) {
        const QRectF box(cell.rect);
        if (cell.reading.active && m_cells.size() > 1) {
            painter.setPen(Qt::NoPen);
            painter.setBrush(
                base::mixed(palette().color(QPalette::Window), palette().color(QPalette::Highlight), 0.18));
            painter.drawRoundedRect(box, base::grid(this, 0.5), base::grid(this, 0.5));
        }
        double x = box.left() + base::grid(this);
        base::paintStatusGlyph(painter, {x, box.center().y() - 0.5 * glyph, glyph, glyph}, cell.reading.state,
                               palette());
        x += glyph + base::grid(this);
        if (cell.reading.provenance != base::Provenance::live) {
            const QColor colour = base::provenanceColour(cell.reading.provenance, palette());
            painter.fillRect(QRectF(box.left(), box.top(), base::grid(this, base::kStripe), box.height()),
                             colour);
            painter.setPen(colour);
            painter.setFont(smallFont());
            const QRectF place(x, box.top(), painter.fontMetrics().horizontalAdvance(cell.word),
                               box.height());
            painter.drawText(place, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip, cell.word);
            painter.setFont(font());
            if (!cell.word.isEmpty())
                x += place.width() + base::grid(this);
        }
        painter.setPen(palette().color(QPalette::WindowText));
        base::drawTabularText(painter, {x, box.top(), box.right() - x, box.height()},
                              Qt::AlignLeft | Qt::AlignVCenter, cell.shown);
    }
    if (m_cells.empty()) {
        painter.setPen(palette().color(QPalette::PlaceholderText));
        painter.drawText(rect().adjusted(base::grid(this), 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter,
                         tr("No device"));
    }
}

void DeviceStrip::mousePressEvent(QMouseEvent* event) {
    const int index = cellAt(event->pos());
    if (event->button() == Qt::LeftButton && index >= 0)
        emit deviceActivated(index);
}

bool DeviceStrip::event(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        setAccessibleName(tr("Devices"));
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        const int index = cellAt(help->pos());
        if (index >= 0)
            QToolTip::showText(help->globalPos(), toolTipText(m_cells[static_cast<std::size_t>(index)]),
                               this);
        else
            QToolTip::hideText();
        return true;
    }
    return QWidget::event(event);
}

int DeviceStrip::cellAt(const QPoint& point) const {
    for (std::size_t index = 0; index < m_cells.size(); ++index) {
        if (m_cells[index].rect.contains(point))
            return static_cast<int>(index);
    }
    return -1;
}

QString DeviceStrip::toolTipText(const Cell& cell) const {
    const DeviceReading& reading = cell.reading;
    QStringList lines{
        reading.name,
        tr("State: %1").arg(base::statusWord(reading.state)),
        tr("Rate: %1 Hz").arg(base::fixedDigits(reading.rate_Hz, 1)),
        reading.countsLosses || reading.lost > 0 ? tr("Frames lost: %1").arg(reading.lost)
                                                 : tr("Frames lost: not counted by the sensor"),
        tr("Frames displayed: %1").arg(reading.displayed),
        tr("Age of the newest frame: %1").arg(base::ageText(reading.age_s)),
    };
    if (reading.latency_s)
        lines << tr("From sensor read to screen: %1 ms").arg(base::fixedDigits(*reading.latency_s * 1e3, 1));
    if (reading.touchToSkin_s)
        lines << tr("From the completed touch to the first frame of its pattern: %1 ms")
                     .arg(base::fixedDigits(*reading.touchToSkin_s * 1e3, 1));
    for (const QString& more : {reading.remark, reading.details})
        if (!more.isEmpty())
            lines << more;
    return lines.join(QLatin1Char('\n'));
}

} // namespace teleta::chrome
