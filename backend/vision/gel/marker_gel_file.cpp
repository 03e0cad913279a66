// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/gel/marker_gel_file.h"

#include "backend/core/keys/key_lists.h"
#include "backend/core/keys/toml_keys.h"
#include "backend/core/keys/toml_string.h"
#include "backend/core/number_text.h"

#include <QCoreApplication>

#include <Eigen/Core>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace teleta::vision {

namespace {

struct GelFileText {
    Q_DECLARE_TR_FUNCTIONS(MarkerGelFile)
};

// In the order of their enumerators.
constexpr std::array kChannels{"grey", "red", "green", "blue"};
constexpr std::array kPolarities{"dark", "bright"};
constexpr std::array kGrids{"rectangular", "hexagonal", "free"};

constexpr double kMostPixels = 100000.0;
constexpr double kMostLensValue = 1e6;

void describeLens(core::Keys& keys, MarkerGelFile::Lens& lens) {
    const auto focus = core::NumberRange::positiveUpTo(kMostLensValue);
    const auto place = core::NumberRange::between(-kMostLensValue, kMostLensValue);
    const auto bend = core::NumberRange::between(-1000.0, 1000.0);
    keys.number("fx", lens.fx_px, focus, "Focal length along u, in pixels");
    keys.number("fy", lens.fy_px, focus, "Focal length along v, in pixels");
    keys.number("cx", lens.cx_px, place, "Principal point, along u, in pixels");
    keys.number("cy", lens.cy_px, place, "Principal point, along v, in pixels");
    keys.number("k1", lens.k1, bend, "Radial distortion, as in OpenCV", core::Need::optional);
    keys.number("k2", lens.k2, bend, "Radial distortion, second term", core::Need::optional);
    keys.number("p1", lens.p1, bend, "Tangential distortion", core::Need::optional);
    keys.number("p2", lens.p2, bend, "Tangential distortion, second term", core::Need::optional);
    keys.number("k3", lens.k3, bend, "Radial distortion, third term", core::Need::optional);
}

void describePlane(core::Keys& keys, MarkerGelFile::Plane& plane) {
    keys.number("mm_per_px", plane.mmPerPx, core::NumberRange::positiveUpTo(1000.0),
                "Scale on the gel's surface, in mm a pixel");
    core::describeList(keys, "homography", plane.homography, core::NumberRange::any(), {9, 9},
                       "Matrix from a pixel (u, v, 1) to the place on the surface in m, row by row",
                       core::Need::optional);
    keys.number("pitch_mm", plane.pitch_mm, core::NumberRange::positiveUpTo(1000.0),
                "Distance of neighbouring markers; their distance in the picture gives the scale");
    const auto given = static_cast<int>(plane.mmPerPx.has_value()) +
                       static_cast<int>(!plane.homography.empty()) +
                       static_cast<int>(plane.pitch_mm.has_value());
    if (given > 1)
        keys.refuse(plane.mmPerPx ? "mm_per_px" : "pitch_mm",
                    GelFileText::tr("the plane is described twice").toStdString(),
                    GelFileText::tr("one of mm_per_px, homography and pitch_mm").toStdString());
    if (plane.homography.size() != 9)
        return;
    const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> matrix(plane.homography.data());
    const double size = matrix.col(0).norm() * matrix.col(1).norm() * matrix.col(2).norm();
    if (!(std::abs(matrix.determinant()) > 1e-12 * size))
        keys.refuse("homography", GelFileText::tr("the matrix has no inverse").toStdString(),
                    GelFileText::tr("a matrix that maps the picture onto a plane").toStdString());
}

} // namespace

void MarkerGelFile::describeKeys(core::Keys& keys, core::Need needOfPlane) {
    keys.word("kind", "marker_gel", "A flat gel with markers in front of a camera");
    keys.text("name", name, "Name on the screen", core::Need::optional);
    keys.text("source", source, "Number of the camera, a video, or a pattern of numbered images",
              core::Need::optional);
    const core::WholeRange side{0, static_cast<int>(kMostPixels)};
    keys.whole("width_px", width_px, side, "Width of the picture asked of a camera; 0: its own",
               core::Need::optional);
    keys.whole("height_px", height_px, side, "Height of the same", core::Need::optional);
    core::describeList(keys, "crop", crop, core::NumberRange::between(0.0, kMostPixels), {4, 4},
                       "Part of the picture that is used: x, y, width, height in pixels",
                       core::Need::optional);
    if (crop.size() == 4) {
        if (std::ranges::any_of(crop, [](double value) { return value != std::floor(value); }))
            keys.refuse("crop", GelFileText::tr("a part of a pixel cannot be cut off").toStdString(),
                        GelFileText::tr("whole numbers").toStdString());
        else if (crop[2] < 16.0 || crop[3] < 16.0)
            keys.refuse("crop", GelFileText::tr("the picture would be too small").toStdString(),
                        GelFileText::tr("at least 16 x 16 pixels").toStdString());
    }
    keys.flag("flip_x", flipX, "Exchange left and right, after the crop");
    keys.flag("flip_y", flipY, "Exchange top and bottom, after the crop");
    keys.number("rate_Hz", rate_Hz, core::NumberRange::between(0.0, 10000.0),
                "Frames a second asked of a camera; 0: its own", core::Need::optional);
    keys.choice("channel", channel, {"grey", "red", "green", "blue"}, "Colour in which the markers show best",
                core::Need::optional);
    keys.choice("marker", polarity, {"dark", "bright"}, "Whether markers are darker or brighter than the gel",
                core::Need::optional);
    keys.number("diameter_px", diameter_px, core::NumberRange::between(0.0, 1000.0),
                "Diameter of a marker; 0: found from the picture", core::Need::optional);
    if (diameter_px > 0.0 && diameter_px < 2.0)
        keys.refuse("diameter_px",
                    GelFileText::tr("such small markers cannot be told from noise").toStdString(),
                    GelFileText::tr("at least 2 px, or 0").toStdString());
    keys.choose("grid", static_cast<std::size_t>(grid), {"rectangular", "hexagonal", "free"},
                "How the markers are arranged", core::Need::required,
                [this](core::Keys& inner, std::size_t chosen) {
                    grid = static_cast<MarkerGrid>(chosen);
                    if (grid != MarkerGrid::rectangular)
                        return;
                    inner.whole("rows", rows, {2, 1000}, "Rows of markers, along v");
                    inner.whole("columns", columns, {2, 1000}, "Markers in a row, along u");
                });
    keys.text(
        "loads", loads,
        "Calibration that `teleta loads fit` has written: each contact has its loads in N with their errors",
        core::Need::optional);
    keys.table("plane", "From the picture to the gel's surface: one of mm_per_px, homography and pitch_mm",
               needOfPlane, [this](core::Keys& inner) { describePlane(inner, plane); });
    keys.table("lens", lens, "The lens, in pixels of the cropped and flipped picture",
               [](core::Keys& inner, Lens& value) { describeLens(inner, value); });
}

namespace {

struct WithoutPlane {
    MarkerGelFile gel;
    void describeKeys(core::Keys& keys) { gel.describeKeys(keys, core::Need::optional); }
};

/// Without any of the three keys there is no scale. The place is that of the file, as the table may be empty.
core::Expected<MarkerGelFile> withScale(MarkerGelFile gel, const std::string& file) {
    if (gel.plane.mmPerPx || gel.plane.pitch_mm || gel.plane.homography.size() == 9)
        return gel;
    return core::Unexpected(
        core::Error{core::ErrorKind::badInput,
                    GelFileText::tr("[plane] gives no scale").toStdString(),
                    GelFileText::tr("one of mm_per_px, homography and pitch_mm").toStdString(),
                    {file, 0, 0}});
}

} // namespace

core::Expected<MarkerGelFile> readMarkerGel(const std::string& path) {
    TELETA_TRY(const auto document, core::TomlDocument::open(path));
    TELETA_TRY(MarkerGelFile gel, core::readKeys<MarkerGelFile>(document));
    return withScale(std::move(gel), path);
}

core::Expected<MarkerGelFile> readMarkerGelWithoutPlane(const std::string& path) {
    TELETA_TRY(const auto document, core::TomlDocument::open(path));
    TELETA_TRY(WithoutPlane file, core::readKeys<WithoutPlane>(document));
    return std::move(file.gel);
}

core::Expected<MarkerGelFile> parseMarkerGel(std::string_view text, const std::string& file) {
    TELETA_TRY(const auto document, core::TomlDocument::parse(text, file));
    TELETA_TRY(MarkerGelFile gel, core::readKeys<MarkerGelFile>(document));
    return withScale(std::move(gel), file);
}

std::string markerGelText(const MarkerGelFile& gel) {
    std::string text;
    const auto write = [&text](const char* key, const std::string& value) {
        ((text += key) += " = ") += value + '\n';
    };
    const auto number = [&](const char* key, double value) {
        write(key, std::string(core::NumberText(value).view()));
    };
    const auto list = [&](const char* key, const std::vector<double>& values) {
        std::string all;
        for (const double value : values)
            (all += all.empty() ? "" : ", ") += core::NumberText(value).view();
        if (!values.empty())
            write(key, '[' + all + ']');
    };
    const auto word = [&](const char* key, const std::string& chosen) {
        write(key, core::quotedToml(chosen));
    };
    write("kind", "\"marker_gel\"");
    write("name", core::quotedToml(gel.name));
    if (!gel.source.empty())
        write("source", core::quotedToml(gel.source));
    if (gel.width_px > 0)
        write("width_px", std::to_string(gel.width_px));
    if (gel.height_px > 0)
        write("height_px", std::to_string(gel.height_px));
    list("crop", gel.crop);
    write("flip_x", gel.flipX ? "true" : "false");
    write("flip_y", gel.flipY ? "true" : "false");
    number("rate_Hz", gel.rate_Hz);
    word("channel", kChannels.at(static_cast<std::size_t>(gel.channel)));
    word("marker", kPolarities.at(static_cast<std::size_t>(gel.polarity)));
    number("diameter_px", gel.diameter_px);
    word("grid", kGrids.at(static_cast<std::size_t>(gel.grid)));
    if (gel.grid == MarkerGrid::rectangular) {
        write("rows", std::to_string(gel.rows));
        write("columns", std::to_string(gel.columns));
    }
    text += "[plane]\n";
    if (gel.plane.mmPerPx)
        number("mm_per_px", *gel.plane.mmPerPx);
    list("homography", gel.plane.homography);
    if (gel.plane.pitch_mm)
        number("pitch_mm", *gel.plane.pitch_mm);
    if (!gel.lens)
        return text;
    text += "[lens]\n";
    const MarkerGelFile::Lens& lens = *gel.lens;
    for (const auto& [key, value] :
         {std::pair("fx", lens.fx_px), std::pair("fy", lens.fy_px), std::pair("cx", lens.cx_px),
          std::pair("cy", lens.cy_px), std::pair("k1", lens.k1), std::pair("k2", lens.k2),
          std::pair("p1", lens.p1), std::pair("p2", lens.p2), std::pair("k3", lens.k3)})
        number(key, value);
    return text;
}

} // namespace teleta::vision
