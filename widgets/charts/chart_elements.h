// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/base/controls/badge.h"

#include <QColor>
#include <qcustomplot.h>
#include <QPalette>
#include <QString>

#include <vector>

namespace teleta::charts {

/// Text beside a strip: its title and the value of each series; also the legend.
class ValuePanel : public QCPLayoutElement {
    Q_OBJECT
public:
    struct Line {
        QColor colour;
        bool dashed = false;
        QString name;
        QString value; ///< number and unit, fixed width
    };

    using QCPLayoutElement::QCPLayoutElement;

    void setTitle(const QString& title) { m_title = title; }
    void setLines(std::vector<Line> lines) { m_lines = std::move(lines); }
    void setInk(const QFont& font, const QColor& text, const QColor& faint);
    [[nodiscard]] const std::vector<Line>& lines() const { return m_lines; }
    [[nodiscard]] const QString& title() const { return m_title; }

protected:
    void applyDefaultAntialiasingHint(QCPPainter*) const override {}
    void draw(QCPPainter* painter) override;

private:
    QString m_title;
    std::vector<Line> m_lines;
    QFont m_font;
    QColor m_text, m_faint;
};

/// Heading above the strips: the subject of the view, and a badge if the data are not live.
class HeaderElement : public QCPLayoutElement {
    Q_OBJECT
public:
    using QCPLayoutElement::QCPLayoutElement;

    void setText(const QString& text) { m_text = text; }
    [[nodiscard]] const QString& text() const { return m_text; }
    void setProvenance(base::Provenance provenance) { m_provenance = provenance; }
    /// palette: of the badge.
    void setInk(const QFont& font, const QColor& text, const QPalette& palette);

protected:
    void applyDefaultAntialiasingHint(QCPPainter*) const override {}
    void draw(QCPPainter* painter) override;

private:
    QString m_text;
    base::Provenance m_provenance = base::Provenance::live;
    QFont m_font;
    QColor m_ink;
    QPalette m_palette;
};

/// A vertical line through all strips, at a time relative to the right edge.
struct TimeLine {
    double time_s = 0.0;
    QString label; ///< at the top of the first strip
};

/// Draws vertical time lines across stacked axis rects with a common time axis.
class TimeLines : public QCPLayerable {
    Q_OBJECT
public:
    TimeLines(QCustomPlot* plot, const QString& layer);

    void setRects(std::vector<QCPAxisRect*> rects) { m_rects = std::move(rects); }
    void setLines(std::vector<TimeLine> lines) { m_lines = std::move(lines); }
    [[nodiscard]] const std::vector<TimeLine>& lines() const { return m_lines; }
    void setPen(const QPen& pen) { m_pen = pen; }
    void setFont(const QFont& font) { m_font = font; }

protected:
    void applyDefaultAntialiasingHint(QCPPainter*) const override {}
    void draw(QCPPainter* painter) override;

private:
    std::vector<QCPAxisRect*> m_rects;
    std::vector<TimeLine> m_lines;
    QPen m_pen;
    QFont m_font;
};

/// An interval of time, relative to the right edge, or a range of values.
struct Shade {
    double from = 0.0, to = 0.0;
    QString label; ///< in its upper left corner; times only
};

/// Shading behind the curves: time intervals across all axis rects, or value ranges within each.
class Shades : public QCPLayerable {
    Q_OBJECT
public:
    enum class Kind { times, values };

    Shades(QCustomPlot* plot, const QString& layer, Kind kind);

    void setRects(std::vector<QCPAxisRect*> rects) { m_rects = std::move(rects); }
    void setShades(std::vector<Shade> shades) { m_shades = std::move(shades); }
    [[nodiscard]] const std::vector<Shade>& shades() const { return m_shades; }
    /// edge: pen of both ends.
    void setInk(const QFont& font, const QColor& fill, const QPen& edge, const QColor& text);

protected:
    void applyDefaultAntialiasingHint(QCPPainter*) const override {}
    void draw(QCPPainter* painter) override;

private:
    Kind m_kind;
    std::vector<QCPAxisRect*> m_rects;
    std::vector<Shade> m_shades;
    QFont m_font;
    QColor m_fill, m_text;
    QPen m_edge;
};

/// Styles the left and the bottom axis of a strip. font: that of the view.
void styleAxes(QCPAxisRect* rect, const QFont& font, const QPalette& palette);

/// Ticks at round numbers, with a true minus sign and without rounding noise around zero.
class RoundTicker : public QCPAxisTicker {
public:
    /// fixedStep: distance of the ticks, doubled where there is no room for so many; 0: a round one for about
    /// tickCount() ticks. suffix: of each label.
    explicit RoundTicker(double fixedStep = 0.0, const QString& suffix = {})
        : m_fixedStep(fixedStep)
        , m_suffix(suffix) {}

protected:
    double getTickStep(const QCPRange& range) override;
    int getSubTickCount(double) override { return 0; }
    QString getTickLabel(double tick, const QLocale& locale, QChar format, int precision) override;

private:
    double m_fixedStep;
    QString m_suffix;
    double m_step = 1.0;
};

} // namespace teleta::charts
