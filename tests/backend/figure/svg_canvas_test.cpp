// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/figure/round_step.h"
#include "backend/figure/svg_canvas.h"

#include <QStringList>
#include <QXmlStreamReader>

#include <gtest/gtest.h>

#include <cmath>
#include <map>

using teleta::figure::roundStep;
using teleta::figure::SvgCanvas;

namespace {

/// Elements of a document with their attributes, and its texts; another reader than the one that draws it.
struct Document {
    explicit Document(const std::string& svg) {
        QXmlStreamReader reader(QByteArray::fromStdString(svg));
        while (!reader.atEnd()) {
            if (reader.readNext() == QXmlStreamReader::StartElement)
                elements.emplace_back(reader.name().toString(), reader.attributes());
            else if (reader.tokenType() == QXmlStreamReader::Characters && !reader.isWhitespace())
                texts << reader.text().toString();
        }
        error = reader.hasError() ? reader.errorString() : QString();
    }
    [[nodiscard]] std::vector<QXmlStreamAttributes> all(const char* name) const {
        std::vector<QXmlStreamAttributes> found;
        for (const auto& [element, attributes] : elements)
            if (element == QLatin1String(name))
                found.push_back(attributes);
        return found;
    }

    std::vector<std::pair<QString, QXmlStreamAttributes>> elements;
    QStringList texts;
    QString error;
};

} // namespace

TEST(SvgCanvas, whatIsDrawnIsAWellFormedDocumentOfItsSizeWithATitle) {
    SvgCanvas canvas(320.0, 200.0, QStringLiteral("Force & way < \"3\""));
    canvas.text(10.0, 20.0, QStringLiteral("a < b & %1 \u89e6"), QStringLiteral("ink"));
    canvas.line(0.0, 1.0, 2.5, 3.126, QStringLiteral("soft"));
    canvas.rectangle(1.0, 2.0, 3.0, 4.0, QStringLiteral("class=\"series0\""));
    canvas.circle(5.0, 6.0, 7.0, QStringLiteral("class=\"series1\""));
    const Document document(canvas.standalone());
    EXPECT_EQ(document.error, QString());
    const auto svg = document.all("svg");
    ASSERT_EQ(svg.size(), 1U);
    EXPECT_EQ(svg[0].value("viewBox"), QStringLiteral("0 0 320 200"));
    EXPECT_TRUE(document.texts.contains(QStringLiteral("a < b & %1 \u89e6")));
    EXPECT_TRUE(document.texts.contains(QStringLiteral("Force & way < \"3\"")));
    ASSERT_EQ(document.all("line").size(), 1U);
    EXPECT_EQ(document.all("line")[0].value("x2"), QStringLiteral("2.5"));
    EXPECT_EQ(document.all("line")[0].value("y2"), QStringLiteral("3.13"));
    EXPECT_EQ(document.all("circle")[0].value("r"), QStringLiteral("7"));
}

TEST(SvgCanvas, aLineGoesThroughItsPointsInOrderAndNoPointsAreNone) {
    SvgCanvas canvas(100.0, 100.0, QStringLiteral("line"));
    canvas.path({}, QStringLiteral("class=\"hollow\""));
    canvas.path({{1.0, 2.0}, {3.5, 4.0}, {5.0, 0.25}}, QStringLiteral("class=\"hollow\""));
    const Document document(canvas.standalone());
    const auto paths = document.all("path");
    ASSERT_EQ(paths.size(), 1U);
    EXPECT_EQ(paths[0].value("d"), QStringLiteral("M1 2L3.5 4L5 0.25"));
}

TEST(SvgCanvas, aWatermarkIsAWordAndNoWordIsNone) {
    SvgCanvas canvas(100.0, 100.0, QStringLiteral("marked"));
    canvas.watermark({});
    EXPECT_TRUE(Document(canvas.standalone()).all("text").empty());
    canvas.watermark(QStringLiteral("SIMULATED"));
    const Document document(canvas.standalone());
    EXPECT_EQ(document.error, QString());
    EXPECT_TRUE(document.texts.contains(QStringLiteral("SIMULATED")));
}

TEST(RoundStep, isOneTwoOrFiveTimesAPowerOfTenAndNoSmallerThanAsked) {
    const std::map<double, double> expected{{1.0, 1.0},   {1.01, 2.0},  {2.0, 2.0},      {2.5, 5.0},
                                            {5.1, 10.0},  {0.1, 0.1},   {0.03, 0.05},    {1e-9, 1e-9},
                                            {3e12, 5e12}, {700.0, 1e3}, {6e-300, 1e-299}};
    for (const auto& [asked, step] : expected)
        EXPECT_NEAR(roundStep(asked) / step, 1.0, 1e-9) << asked;
}
