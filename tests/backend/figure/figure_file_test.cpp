// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/figure/figure_file.h"
#include "backend/study/report/confusion_figure.h"
#include "tests/backend/core/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <sstream>

namespace teleta::figure {

namespace {

const std::string kSquare = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"200\" height=\"100\">"
                            "<rect width=\"200\" height=\"100\" fill=\"#ff0000\"/>"
                            "<text x=\"10\" y=\"40\" font-family=\"sans-serif\">Measured 42</text></svg>";

std::string outputOf(const std::string& command) {
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
    std::string output;
    char buffer[512];
    while (std::fgets(buffer, sizeof buffer, pipe.get()) != nullptr)
        output += buffer;
    return output;
}

bool isInstalled(const std::string& program) {
    return std::system(("command -v " + program + " > /dev/null").c_str()) == 0;
}

std::uint32_t bigEndian(const std::string& bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
        value = value << 8U | static_cast<std::uint8_t>(bytes.at(at + i));
    return value;
}

} // namespace

TEST(FigureFile, aPngHasItsSignatureAndSize) {
    const auto png = pngOf(kSquare, 1.5);
    ASSERT_TRUE(png) << core::describe(png.error());
    EXPECT_EQ(png->substr(0, 8), "\x89PNG\r\n\x1a\n");
    EXPECT_EQ(bigEndian(*png, 16), 300U);
    EXPECT_EQ(bigEndian(*png, 20), 150U);
}

TEST(FigureFile, aPdfIsOnePageOfTheSizeOfThePictureWithTextThatCanBeSearched) {
    const auto pdf = pdfOf(kSquare);
    ASSERT_TRUE(pdf) << core::describe(pdf.error());
    EXPECT_EQ(pdf->substr(0, 5), "%PDF-");
    if (!isInstalled("pdftotext") || !isInstalled("pdfinfo"))
        GTEST_SKIP() << "poppler-utils is not installed";
    const test::TemporaryFolder folder;
    const std::string path = folder.write("figure.pdf", *pdf);
    EXPECT_NE(outputOf("pdftotext '" + path + "' -").find("Measured 42"), std::string::npos);
    const std::string about = outputOf("LC_ALL=C pdfinfo '" + path + "'");
    EXPECT_NE(about.find("150 x 75 pts"), std::string::npos) << about;
    EXPECT_NE(about.find("Pages:           1"), std::string::npos) << about;
}

TEST(FigureFile, theConfusionMatrixOfAStudyComesThroughWithItsNumbers) {
    study::ConfusionMatrix matrix(2);
    matrix.add(0, 0, 25);
    matrix.add(0, 1, 5);
    matrix.add(1, 1, 7);
    const std::string svg = study::confusionSvg(matrix, {"A", "B"}, "shape, static",
                                                study::ConfusionValues::percent, study::Mode::pilot);
    const auto pdf = pdfOf(svg);
    ASSERT_TRUE(pdf) << core::describe(pdf.error());
    ASSERT_TRUE(pngOf(svg));
    if (!isInstalled("pdftotext"))
        GTEST_SKIP() << "poppler-utils is not installed";
    const test::TemporaryFolder folder;
    const std::string texts = outputOf("pdftotext -raw '" + folder.write("figure.pdf", *pdf) + "' -");
    for (const char* text : {"shape, static", "Subject response, %", "83.3", "16.7", "100.0"})
        EXPECT_NE(texts.find(text), std::string::npos) << text << " in\n" << texts;
    // Letters of a text that is turned come line by line.
    std::string letters = texts;
    letters.erase(
        std::remove_if(letters.begin(), letters.end(), [](char c) { return c == '\n' || c == ' '; }),
        letters.end());
    EXPECT_NE(letters.find("PILOT"), std::string::npos) << texts;
}

TEST(FigureFile, whatIsNoPictureIsAnError) {
    for (const char* text : {"", "no picture", "<svg", "<html></html>"}) {
        EXPECT_EQ(pdfOf(text).error().kind, core::ErrorKind::badInput) << text;
        EXPECT_EQ(pngOf(text).error().kind, core::ErrorKind::badInput) << text;
    }
    EXPECT_EQ(pngOf(kSquare, 1000.0).error().kind, core::ErrorKind::badInput);
    EXPECT_EQ(pngOf(kSquare, 0.0).error().kind, core::ErrorKind::badInput);
}

} // namespace teleta::figure
