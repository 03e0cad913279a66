// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace teleta::figure {

inline constexpr std::size_t kSvgSeries = 6;

/// The colours of a picture, as SVG has them; as they are here, for white paper.
struct SvgColours {
    QString paper = QStringLiteral("#ffffff");
    QString ink = QStringLiteral("#1b1b1f");
    QString soft = QStringLiteral("#5c5f66"); ///< of remarks and references
    QString grid = QStringLiteral("#d4d6da");
    std::array<QString, kSvgSeries> series{QStringLiteral("#0072b2"), QStringLiteral("#d55e00"),
                                           QStringLiteral("#009e73"), QStringLiteral("#cc79a7"),
                                           QStringLiteral("#e69f00"), QStringLiteral("#56b4e9")};
};

/// Draws a picture as SVG. Lengths are px, y points downwards. Colours are classes: ink, soft (grid lines and
/// remarks) and series0 .. series5, so that a page can give them its own; a picture that stands alone has
/// them on white. Thread: one.
class SvgCanvas {
public:
    static constexpr std::size_t kSeries = kSvgSeries;

    /// title: what the picture shows, for readers who do not see it.
    SvgCanvas(double width, double height, const QString& title);

    /// classes: of the text; middle and end anchor it, bold and small say how it looks.
    void text(double x, double y, const QString& content, const QString& classes,
              const QString& attributes = {});
    void line(double x1, double y1, double x2, double y2, const QString& classes);
    void rectangle(double x, double y, double width, double height, const QString& attributes);
    void circle(double x, double y, double radius, const QString& attributes);
    /// A square that stands on a corner.
    void diamond(double x, double y, double radius, const QString& attributes);

    /// A line through points. attributes: its class and others; "hollow series0" draws it in that colour,
    /// "thin" narrower, "dashed" and "dotted" as a reference.
    void path(const std::vector<std::pair<double, double>>& points, const QString& attributes);

    /// Writes a word across the picture, such as SIMULATED; empty: nothing.
    void watermark(const QString& word);

    /// A file of its own.
    [[nodiscard]] std::string standalone(const SvgColours& colours = {}) const;
    /// A part of a page that has style().
    [[nodiscard]] std::string embedded() const;

    [[nodiscard]] static QString style(const SvgColours& colours = {});

private:
    [[nodiscard]] QString head() const;

    double m_width;
    double m_height;
    QString m_title;
    QString m_body;
};

/// A length as SVG has it: C locale, two digits behind the point at most.
[[nodiscard]] QString svgNumber(double value);

} // namespace teleta::figure
