// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/camera/plane_calibration.h"

#include "app/cli/base/command_io.h"
#include "app/cli/base/interruption.h"
#include "app/cli/base/options.h"
#include "app/cli/commands/camera/gel_frames.h"
#include "backend/core/data/input_file.h"
#include "backend/core/data/output_file.h"
#include "backend/core/failure.h"
#include "backend/core/number_text.h"
#include "backend/opencv/coded_picture.h"
#include "backend/opencv/opencv_parts.h"
#include "backend/vision/gel/board_corners.h"
#include "backend/vision/gel/gel_plane.h"
#include "backend/vision/gel/marker_gel.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>

#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include <array>
#include <cmath>
#include <optional>

namespace teleta::cli {

namespace {

struct PlaneText {
    Q_DECLARE_TR_FUNCTIONS(PlaneCalibration)
};

constexpr double kPlaneMmPerM = 1000.0;
constexpr std::size_t kMostPicturePixels = std::size_t{1} << 26U;

core::Unexpected inFile(core::Error error, const std::string& path) {
    error.where.file = path;
    if (error.kind == core::ErrorKind::refused)
        error.kind = core::ErrorKind::badInput;
    return core::Unexpected(error);
}

/// A still picture in one channel; nothing: the file is none.
core::Expected<std::optional<cv::Mat1b>> stillPicture(const std::string& path, vision::GelChannel channel) {
    TELETA_TRY(const std::string bytes, core::readFile(path));
    if (!opencv::isPicture(bytes, kMostPicturePixels))
        return std::nullopt;
    TELETA_TRY(const opencv::Pictures* pictures, opencv::pictures());
    const bool isGrey = channel == vision::GelChannel::grey;
    try {
        // OpenCV takes no constant bytes, and does not change these.
        const cv::Mat coded(1, static_cast<int>(bytes.size()), CV_8UC1, const_cast<char*>(bytes.data()));
        const cv::Mat picture = pictures->decode(coded, isGrey ? cv::IMREAD_GRAYSCALE : cv::IMREAD_COLOR);
        if (picture.empty())
            return std::nullopt;
        if (isGrey)
            return cv::Mat1b(picture);
        cv::Mat1b part;
        cv::extractChannel(picture, part, 3 - static_cast<int>(channel)); // blue, green, red
        return part;
    } catch (const cv::Exception&) {
        return std::nullopt;
    }
}

/// Pictures of the gel at rest.
core::Expected<std::vector<cv::Mat1b>> restPictures(const vision::MarkerGelFile& file,
                                                    const std::string& path) {
    // What cannot be read as a whole may be a camera or a long video.
    const auto still = stillPicture(path, file.channel);
    if (still && *still) {
        const auto picture = vision::MarkerGel::picture(file, **still);
        if (!picture)
            return inFile(picture.error(), path);
        return std::vector{picture->clone()};
    }
    auto first = firstGelFrames(file, path);
    if (!first && first.error().kind == core::ErrorKind::refused)
        return inFile(first.error(), path);
    return first;
}

std::string numbersOf(const Eigen::Matrix3d& matrix) {
    std::string all;
    for (Eigen::Index i = 0; i < 9; ++i)
        (all += all.empty() ? "" : ", ") += core::NumberText(matrix(i / 3, i % 3)).view();
    return '[' + all + ']';
}

/// For the sensor file.
std::string linesOf(const vision::PlaneFit& fit) {
    std::string text = "[plane]\n";
    if (fit.isScale)
        (text += "mm_per_px = ") += core::NumberText(kPlaneMmPerM * fit.scale_mPerPx).view();
    else
        (text += "homography = ") += numbersOf(fit.homography);
    return text + '\n';
}

nlohmann::ordered_json toJson(const vision::PlaneFit& fit) {
    nlohmann::ordered_json homography = nullptr;
    if (!fit.isScale) {
        homography = nlohmann::ordered_json::array();
        for (Eigen::Index i = 0; i < 9; ++i)
            homography.push_back(fit.homography(i / 3, i % 3));
    }
    return {{"mm_per_px", kPlaneMmPerM * fit.scale_mPerPx},
            {"mm_per_px_se", kPlaneMmPerM * fit.scaleError_mPerPx},
            {"homography", std::move(homography)},
            {"points", fit.pairs},
            {"kept", fit.kept},
            {"rms_px", fit.rms_px}};
}

} // namespace

void PlaneCalibration::declare(CLI::App& app) {
    addFlag(app, "--plane", m_wanted,
            PlaneText::tr("Find how pixels become places on a flat gel: by --board, --ruler or --pitch-mm"));
    addOption(app, "--sensor", m_sensorPath,
              PlaneText::tr("Of a flat gel: its sensor file, with crop, flips, lens and grid of markers; "
                            "[plane] may be absent"),
              "FILE.toml")
        ->needs("--plane");
    addOption(app, "--board", m_board,
              PlaneText::tr("Inner corners of the chessboard in the picture, as 7x5"), "COLUMNSxROWS")
        ->needs("--plane");
    addOption(app, "--square-mm", m_square_mm, PlaneText::tr("Side of a square of the chessboard, mm"))
        ->check(positive())
        ->needs("--board");
    addOption(
        app, "--ruler", m_rulers,
        PlaneText::tr("Two points of a ruler in the camera's whole picture, and their distance; several "
                      "times for several lengths. A picture is only read for its size"),
        "U,V,U,V,MM")
        ->allow_extra_args(false)
        ->needs("--plane");
    addOption(app, "--pitch-mm", m_pitch_mm, PlaneText::tr("Distance of neighbouring markers of the gel, mm"))
        ->check(positive())
        ->needs("--sensor");
}

core::Expected<void> PlaneCalibration::run(const std::string& picturePath, const std::string& outPath,
                                           bool json) const {
    TELETA_TRY(const vision::PlaneFit found, fit(picturePath));
    const std::string lines = linesOf(found);
    if (!outPath.empty()) {
        TELETA_TRY(auto file, core::OutputFile::create(outPath));
        file.write(lines);
        TELETA_CHECK(file.finish());
    }
    if (json)
        return printDocument(toJson(found));
    Fields fields{
        {PlaneText::tr("Scale"), PlaneText::tr("%1 mm/px, standard deviation %2 mm/px")
                                     .arg(forPeople(kPlaneMmPerM * found.scale_mPerPx, 5),
                                          forPeople(kPlaneMmPerM * found.scaleError_mPerPx, 2))},
        {hasRuler() ? PlaneText::tr("Rulers") : PlaneText::tr("Points"), QString::number(found.pairs)}};
    if (!hasRuler())
        fields.emplace_back(PlaneText::tr("Kept"), QString::number(found.kept));
    if (std::isfinite(found.rms_px))
        fields.emplace_back(PlaneText::tr("Off by"),
                            PlaneText::tr("%1 px rms").arg(forPeople(found.rms_px, 3)));
    TELETA_CHECK(printFields(fields));
    return outPath.empty() ? printText('\n' + lines) : core::Expected<void>();
}

core::Expected<vision::PlaneFit> PlaneCalibration::fit(const std::string& picturePath) const {
    const int ways = (m_board.empty() ? 0 : 1) + (hasRuler() ? 1 : 0) + (m_pitch_mm > 0.0 ? 1 : 0);
    if (ways != 1)
        refuse("--plane", PlaneText::tr("one of --board, --ruler and --pitch-mm is needed"));
    vision::MarkerGelFile file;
    if (!m_sensorPath.empty()) {
        TELETA_TRY(file, vision::readMarkerGelWithoutPlane(m_sensorPath));
    }
    if (hasRuler())
        return fitRulers(file, picturePath);
    return m_board.empty() ? fitMarkers(file, picturePath) : fitBoard(file, picturePath);
}

core::Expected<vision::PlaneFit> PlaneCalibration::fitBoard(const vision::MarkerGelFile& file,
                                                            const std::string& picturePath) const {
    static const QRegularExpression kSize(QStringLiteral("^([0-9]{1,3})[xX]([0-9]{1,3})$"));
    const auto size = kSize.match(QString::fromStdString(m_board));
    const vision::BoardSize board{size.captured(1).toInt(), size.captured(2).toInt(),
                                  m_square_mm / kPlaneMmPerM};
    if (!size.hasMatch())
        refuse("--board",
               PlaneText::tr("\"%1\" is not a size such as 7x5").arg(QString::fromStdString(m_board)));
    if (board.columns < 2 || board.rows < 2)
        refuse("--board", PlaneText::tr("a single row does not show a plane"));
    if (!(m_square_mm > 0.0))
        refuse("--square-mm", PlaneText::tr("the side of a square is needed with --board"));
    TELETA_TRY(const auto still, stillPicture(picturePath, file.channel));
    if (!still)
        return core::failed(core::ErrorKind::badInput, PlaneText::tr("this is not a picture"),
                            PlaneText::tr("a PNG or JPEG picture of a chessboard"), {picturePath});
    auto part = vision::MarkerGel::part(file, *still);
    if (!part)
        return inFile(part.error(), picturePath);
    auto corners = vision::boardCorners(part->clone(), board);
    if (!corners)
        return inFile(corners.error(), picturePath);
    TELETA_CHECK(straighten(file, part->size(), corners->pairs));
    auto found = vision::fitHomography(corners->pairs, corners->shared_px);
    if (!found)
        return inFile(found.error(), picturePath);
    return *found;
}

core::Expected<vision::PlaneFit> PlaneCalibration::fitMarkers(const vision::MarkerGelFile& file,
                                                              const std::string& picturePath) const {
    if (file.grid != vision::MarkerGrid::rectangular)
        return core::failed(core::ErrorKind::badInput,
                            PlaneText::tr("the markers of this sensor form no rectangular grid"),
                            PlaneText::tr("grid = \"rectangular\" with rows and columns"), {m_sensorPath});
    TELETA_TRY(const auto pictures, restPictures(file, picturePath));
    if (pictures.empty())
        return core::failed(core::ErrorKind::badInput, PlaneText::tr("no picture can be read from it"), {},
                            {picturePath});
    // The places of markers are taken in pixels.
    vision::MarkerGelFile anyPlane = file;
    anyPlane.plane = {.mmPerPx = 1.0, .homography = {}, .pitch_mm = {}};
    const auto gel = vision::MarkerGel::make(anyPlane, pictures);
    if (!gel)
        return inFile(gel.error(), picturePath);
    std::vector<vision::PlanePair> pairs;
    for (const vision::GelMarker& marker : gel->markers())
        if (marker.grid.row >= 0)
            pairs.push_back({marker.rest_px, m_pitch_mm / kPlaneMmPerM *
                                                 Eigen::Vector2d(marker.grid.column, marker.grid.row)});
    TELETA_CHECK(straighten(file, pictures.front().size(), pairs));
    auto found = vision::fitScale(pairs);
    if (!found)
        return inFile(found.error(), picturePath);
    return *found;
}

/// Takes the distortion of the file's lens out of the pixels. size: of the picture after the crop.
core::Expected<void> PlaneCalibration::straighten(const vision::MarkerGelFile& file, const cv::Size& size,
                                                  std::vector<vision::PlanePair>& pairs) const {
    if (!file.lens)
        return {};
    vision::MarkerGelFile onlyLens = file;
    onlyLens.plane = {.mmPerPx = kPlaneMmPerM, .homography = {}, .pitch_mm = {}}; // a metre a pixel
    const auto plane = vision::GelPlane::make(onlyLens, size.width, size.height, {});
    if (!plane)
        return inFile(plane.error(), m_sensorPath);
    for (vision::PlanePair& pair : pairs)
        pair.pixel = plane->surface_m(pair.pixel);
    return {};
}

std::vector<vision::RulerReading> PlaneCalibration::readings() const {
    std::vector<vision::RulerReading> readings;
    for (const std::string& text : m_rulers) {
        const QStringList parts = QString::fromStdString(text).split(QLatin1Char(','));
        std::array<double, 5> numbers{};
        bool isRight = parts.size() == static_cast<qsizetype>(numbers.size());
        for (std::size_t i = 0; isRight && i < numbers.size(); ++i) {
            numbers[i] = parts[static_cast<qsizetype>(i)].trimmed().toDouble(&isRight);
            isRight = isRight && std::isfinite(numbers[i]);
        }
        if (!isRight)
            refuse("--ruler", PlaneText::tr("\"%1\" is not two pixels and a length: U,V,U,V,MM")
                                  .arg(QString::fromStdString(text)));
        readings.push_back({{numbers[0], numbers[1]}, {numbers[2], numbers[3]}, numbers[4] / kPlaneMmPerM});
    }
    return readings;
}

/// Without a lens, crop and flips change no length.
core::Expected<vision::PlaneFit> PlaneCalibration::fitRulers(const vision::MarkerGelFile& file,
                                                             const std::string& picturePath) const {
    std::vector<vision::RulerReading> rulers = readings();
    std::optional<cv::Size> size;
    if (file.crop.size() == 4)
        size = cv::Size(static_cast<int>(file.crop[2]), static_cast<int>(file.crop[3]));
    if (!picturePath.empty()) {
        TELETA_TRY(const auto still, stillPicture(picturePath, file.channel));
        if (!still)
            return core::failed(core::ErrorKind::badInput, PlaneText::tr("this is not a picture"),
                                PlaneText::tr("a PNG or JPEG picture"), {picturePath});
        const auto part = vision::MarkerGel::part(file, *still);
        if (!part)
            return inFile(part.error(), picturePath);
        size = part->size();
        const auto isIn = [&](const Eigen::Vector2d& point) {
            return point.x() >= 0.0 && point.y() >= 0.0 && point.x() <= still->cols &&
                   point.y() <= still->rows;
        };
        for (const vision::RulerReading& ruler : rulers)
            if (!isIn(ruler.from_px) || !isIn(ruler.to_px))
                refuse("--ruler", PlaneText::tr("a point lies outside the picture of %1 x %2 pixels")
                                      .arg(still->cols)
                                      .arg(still->rows));
    }
    if (!file.lens)
        return vision::fitRuler(rulers);
    if (!size)
        refuse("--ruler", PlaneText::tr("the lens of the sensor file needs the size of the picture: give a "
                                        "picture too, or a crop in the sensor file"));
    std::vector<vision::PlanePair> ends;
    for (const vision::RulerReading& ruler : rulers)
        for (Eigen::Vector2d pixel : {ruler.from_px, ruler.to_px}) {
            if (file.crop.size() == 4)
                pixel -= Eigen::Vector2d(file.crop[0], file.crop[1]);
            if (file.flipX)
                pixel.x() = size->width - 1.0 - pixel.x();
            if (file.flipY)
                pixel.y() = size->height - 1.0 - pixel.y();
            ends.push_back({pixel, Eigen::Vector2d::Zero()});
        }
    TELETA_CHECK(straighten(file, *size, ends));
    for (std::size_t i = 0; i < rulers.size(); ++i) {
        rulers[i].from_px = ends[2 * i].pixel;
        rulers[i].to_px = ends[2 * i + 1].pixel;
        if (!rulers[i].from_px.allFinite() || !rulers[i].to_px.allFinite())
            refuse("--ruler", PlaneText::tr("a point lies where the lens of the sensor file shows no place"));
    }
    return vision::fitRuler(rulers);
}

} // namespace teleta::cli
