// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/calibrate/gain_map.h"

#include "widgets/base/colour_maps.h"
#include "widgets/base/numbers/number_format.h"
#include "widgets/base/numbers/quantity_text.h"
#include "widgets/base/theme.h"

#include <QContextMenuEvent>
#include <QCoreApplication>
#include <QFontMetricsF>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::calibrate {

namespace {

using equilibration::TaxelGain;
using equilibration::TaxelGains;
using equilibration::TaxelState;

/// Smaller differences of gains do not use the full range of colours.
constexpr double kLeastRange = 0.1;

struct MapText {
    Q_DECLARE_TR_FUNCTIONS(GainMap)
};

QString stateText(TaxelState state) {
    return state == TaxelState::dead     ? MapText::tr("dead")
           : state == TaxelState::weak   ? MapText::tr("too weak")
           : state == TaxelState::strong ? MapText::tr("too strong")
           : state == TaxelState::stuck  ? MapText::tr("stuck")
                                         : QString();
}

/// Layout of the picture.
struct MapLayout {
    QRectF array;
    QRectF bar;
    double side = 1.0;

    MapLayout(const core::ArrayLayout& layout, const QSizeF& size, const QFontMetricsF& metrics) {
        const double em = metrics.height();
        const double barRoom = 1.2 * em + metrics.horizontalAdvance(QStringLiteral("\u00d7 0.00")) + em;
        const QRectF room(0.5 * em, 0.5 * em, std::max(size.width() - barRoom - em, 1.0),
                          std::max(size.height() - 2.0 * em, 1.0));
        side = std::min(room.width() / layout.columns, room.height() / layout.rows);
        array = QRectF(0.0, 0.0, side * layout.columns, side * layout.rows);
        array.moveTopLeft(room.topLeft() + QPointF(0.0, 0.5 * em));
        bar = QRectF(array.right() + em, array.top(), 0.8 * em, std::max(array.height(), 6.0 * em));
        bar.moveCenter({bar.center().x(), array.center().y()});
    }

    [[nodiscard]] QRectF taxel(const core::ArrayLayout& layout, std::size_t index) const {
        const auto columns = static_cast<std::size_t>(layout.columns);
        const auto row = static_cast<double>(index / columns);
        const auto column = static_cast<double>(index % columns);
        return {array.left() + column * side, array.bottom() - (row + 1.0) * side, side, side};
    }
};

/// Largest |ln gain|: the colours are symmetric about a gain of 1.
double rangeOf(const TaxelGains& gains) {
    double range = kLeastRange;
    for (const TaxelGain& taxel : gains.taxels) {
        if (taxel.isGood())
            range = std::max(range, std::abs(std::log(taxel.gain)));
    }
    return range;
}

void paintHatched(QPainter& painter, const QRectF& rect, const QPalette& palette) {
    painter.fillRect(rect, palette.color(QPalette::Base));
    const double step = std::max(rect.width() / 4.0, 3.0);
    painter.setPen(QPen(palette.color(QPalette::PlaceholderText), 1.0));
    for (double offset = step / 2.0; offset < 2.0 * rect.width(); offset += step) {
        const double from = std::max(0.0, offset - rect.width());
        const double to = std::min(offset, rect.width());
        painter.drawLine(QPointF(rect.left() + from, rect.top() + offset - from),
                         QPointF(rect.left() + to, rect.top() + offset - to));
    }
}

void paintMap(QPainter& painter, const TaxelGains& gains, const QSizeF& size, const QPalette& palette,
              std::optional<std::size_t> cursor) {
    const QFontMetricsF metrics(painter.font());
    const MapLayout layout(gains.layout, size, metrics);
    const base::ColourMap& map = base::diverging();
    const double range = rangeOf(gains);
    const bool numbers = metrics.horizontalAdvance(QStringLiteral("0.00")) < 0.9 * layout.side &&
                         metrics.height() < layout.side;
    for (std::size_t i = 0; i < gains.taxels.size(); ++i) {
        const TaxelGain& taxel = gains.taxels[i];
        const QRectF rect = layout.taxel(gains.layout, i);
        if (!taxel.isGood()) {
            paintHatched(painter, rect, palette);
            continue;
        }
        const QColor colour(base::colourAt(map, 0.5 + 0.5 * std::log(taxel.gain) / range));
        painter.fillRect(rect, colour);
        if (numbers) {
            painter.setPen(base::readableOn(colour));
            painter.drawText(rect, Qt::AlignCenter, base::fixedDigits(taxel.gain, 2));
        }
    }
    constexpr double kSmallestGrid = 9.0;
    if (layout.side >= kSmallestGrid) {
        painter.setPen(QPen(palette.color(QPalette::Window), 1.0));
        for (int column = 0; column <= gains.layout.columns; ++column) {
            const double x = layout.array.left() + column * layout.side;
            painter.drawLine(QPointF(x, layout.array.top()), QPointF(x, layout.array.bottom()));
        }
        for (int row = 0; row <= gains.layout.rows; ++row) {
            const double y = layout.array.top() + row * layout.side;
            painter.drawLine(QPointF(layout.array.left(), y), QPointF(layout.array.right(), y));
        }
    }
    if (cursor && *cursor < gains.taxels.size()) {
        painter.setPen(QPen(palette.color(QPalette::WindowText), 2.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(layout.taxel(gains.layout, *cursor));
    }
    constexpr int kSteps = 64;
    for (int step = 0; step < kSteps; ++step) {
        const double share = (step + 0.5) / kSteps;
        const double height = layout.bar.height() / kSteps;
        painter.fillRect(QRectF(layout.bar.left(), layout.bar.bottom() - (step + 1) * height,
                                layout.bar.width(), height + 0.5),
                         QColor(base::colourAt(map, share)));
    }
    painter.setPen(palette.color(QPalette::WindowText));
    for (const double at : {-1.0, 0.0, 1.0}) {
        const double y = layout.bar.center().y() - 0.5 * at * layout.bar.height();
        const QString text = QStringLiteral("\u00d7 ") + base::fixedDigits(std::exp(at * range), 2);
        painter.drawText(
            QPointF(layout.bar.right() + 0.4 * metrics.height(),
                    y + 0.5 * (metrics.ascent() - metrics.descent()) - 0.5 * at * metrics.height()),
            text);
    }
}

QString gainsCsv(const TaxelGains& gains) {
    QString text = QStringLiteral("taxel,row,column,gain,gain_se,state\n");
    for (std::size_t i = 0; i < gains.taxels.size(); ++i) {
        const TaxelGain& taxel = gains.taxels[i];
        const auto columns = static_cast<std::size_t>(gains.layout.columns);
        const std::string_view state = equilibration::toString(taxel.state);
        text += QStringLiteral("%1,%2,%3,%4,%5,%6\n")
                    .arg(i)
                    .arg(i / columns)
                    .arg(i % columns)
                    .arg(base::csvNumber(taxel.gain), base::csvNumber(taxel.error),
                         QLatin1String(state.data(), static_cast<qsizetype>(state.size())));
    }
    return text;
}

} // namespace

GainMap::GainMap(QWidget* parent)
    : FigureView(parent, {46, 20}, {20, 9}) {
    setAutoFillBackground(false);
    setMouseTracking(true);
}

void GainMap::setGains(std::shared_ptr<const TaxelGains> gains) {
    if (gains == m_gains)
        return;
    m_gains = std::move(gains);
    setCursorTaxel(m_cursor);
    update();
}

QString GainMap::readout() const {
    if (!m_gains || !m_cursor)
        return {};
    const TaxelGain& taxel = m_gains->taxels[*m_cursor];
    const auto columns = static_cast<std::size_t>(m_gains->layout.columns);
    const QString place = MapText::tr("Taxel %1, row %2, column %3")
                              .arg(*m_cursor)
                              .arg(*m_cursor / columns)
                              .arg(*m_cursor % columns);
    if (!taxel.isGood())
        return place + QStringLiteral(": ") + MapText::tr("%1, not used").arg(stateText(taxel.state));
    const QString gain = place + QStringLiteral(": \u00d7 ") + base::fixedDigits(taxel.gain, 3);
    return taxel.error > 0.0 ? gain + QStringLiteral(" \u00b1 ") + base::fixedDigits(taxel.error, 3) : gain;
}

QRectF GainMap::taxelRect(std::size_t taxel) const {
    if (!m_gains)
        return {};
    return MapLayout(m_gains->layout, size(), QFontMetricsF(font())).taxel(m_gains->layout, taxel);
}

base::Figure GainMap::figure() {
    base::Figure figure;
    figure.name = QStringLiteral("taxel-gains");
    figure.size_px = size();
    if (!m_gains)
        return figure;
    figure.paint = [gains = m_gains, size = QSizeF(size()), font = font()](QPainter& painter) {
        painter.setFont(font);
        paintMap(painter, *gains, size, base::designedPalette(false), std::nullopt);
    };
    figure.csv = [gains = m_gains] { return gainsCsv(*gains); };
    return figure;
}

bool GainMap::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        auto* help = static_cast<QHelpEvent*>(event);
        setCursorTaxel(taxelAt(help->pos()));
        QToolTip::showText(help->globalPos(), readout(), this);
        return true;
    }
    return QWidget::event(event);
}

void GainMap::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.setFont(font());
    if (m_gains)
        paintMap(painter, *m_gains, size(), palette(), m_cursor);
}

void GainMap::mouseMoveEvent(QMouseEvent* event) {
    setCursorTaxel(taxelAt(event->position()));
}

void GainMap::leaveEvent(QEvent* /*event*/) {
    setCursorTaxel(std::nullopt);
}

void GainMap::keyPressEvent(QKeyEvent* event) {
    if (!m_gains)
        return QWidget::keyPressEvent(event);
    const core::ArrayLayout& layout = m_gains->layout;
    const auto columns = static_cast<std::size_t>(layout.columns);
    int row = m_cursor ? static_cast<int>(*m_cursor / columns) : 0;
    int column = m_cursor ? static_cast<int>(*m_cursor % columns) : 0;
    switch (event->key()) {
    case Qt::Key_Left:
        --column;
        break;
    case Qt::Key_Right:
        ++column;
        break;
    case Qt::Key_Up:
        ++row;
        break;
    case Qt::Key_Down:
        --row;
        break;
    case Qt::Key_Home:
        row = column = 0;
        break;
    case Qt::Key_Escape:
        return setCursorTaxel(std::nullopt);
    default:
        return FigureView::keyPressEvent(event);
    }
    row = std::clamp(row, 0, layout.rows - 1);
    column = std::clamp(column, 0, layout.columns - 1);
    setCursorTaxel(m_cursor ? static_cast<std::size_t>(row) * columns + static_cast<std::size_t>(column) : 0);
}

void GainMap::contextMenuEvent(QContextMenuEvent* event) {
    if (m_gains)
        FigureView::contextMenuEvent(event);
}

void GainMap::setCursorTaxel(std::optional<std::size_t> taxel) {
    if (!m_gains || (taxel && *taxel >= m_gains->taxels.size()))
        taxel.reset();
    m_cursor = taxel;
    const QString text = readout();
    setAccessibleDescription(text);
    emit readoutChanged(text);
    update();
}

std::optional<std::size_t> GainMap::taxelAt(const QPointF& pixel) const {
    if (!m_gains)
        return std::nullopt;
    const core::ArrayLayout& layout = m_gains->layout;
    const MapLayout map(layout, size(), QFontMetricsF(font()));
    const int column = static_cast<int>(std::floor((pixel.x() - map.array.left()) / map.side));
    const int row = static_cast<int>(std::floor((map.array.bottom() - pixel.y()) / map.side));
    if (column < 0 || column >= layout.columns || row < 0 || row >= layout.rows)
        return std::nullopt;
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(layout.columns) +
           static_cast<std::size_t>(column);
}

} // namespace teleta::calibrate
