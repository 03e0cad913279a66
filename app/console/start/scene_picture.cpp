// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/start/scene_picture.h"

#include "backend/arm/arm4_kinematics.h"
#include "backend/simulation/arm/simulated_arm.h"
#include "backend/simulation/array/simulated_array.h"
#include "backend/simulation/camera/gel/gel_stage.h"
#include "backend/simulation/camera/simulated_tube.h"
#include "backend/simulation/servo/servo_loop.h"
#include "widgets/base/colour_maps.h"
#include "widgets/base/theme.h"

#include <QPainter>
#include <QPolygonF>

#include <opencv2/core.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace teleta::console {

namespace {

constexpr std::uint64_t kSeed = 1;
constexpr double kArrayAt = 0.35;    ///< of the scene's duration: its indenters press by then
constexpr double kServoTime_s = 4.0; ///< in contact by then
constexpr double kCameraTime_s = 1.5;
constexpr double kGelTime_s = 3.2;
constexpr double kArmLongest_s = 30.0; ///< until something is touched
constexpr double kArmAfter_s = 0.3;    ///< of the touch
constexpr double kMargin = 0.08;       ///< of the picture

core::Unexpected stopped() {
    return core::Unexpected(core::Error{core::ErrorKind::cancelled, "The scene was stopped.", {}, {}});
}

QImage blank(const QSize& size, const QPalette& palette) {
    QImage image(size, QImage::Format_RGB32);
    image.fill(palette.color(QPalette::Base));
    return image;
}

core::Expected<QImage> arrayPicture(const scene::Scene& scene, const QSize& size, const QPalette& palette,
                                    const std::stop_token& stop) {
    TELETA_TRY(const auto array, simulation::SimulatedArray::make(scene, kSeed));
    const core::ArrayLayout layout = array->description().layout.grid();
    std::vector<float> load_N(layout.taxels());
    while (array->time_s() < kArrayAt * scene.duration_s) {
        if (stop.stop_requested())
            return stopped();
        array->next(load_N, false);
    }
    return loadPicture(load_N, layout, size, palette);
}

core::Expected<QImage> servoPicture(const scene::Scene& scene, const QSize& size, const QPalette& palette,
                                    const std::stop_token& stop) {
    TELETA_TRY(const auto loop, simulation::ServoLoop::make(scene, kSeed));
    while (loop->world().time_s() < std::min(kServoTime_s, scene.duration_s)) {
        if (stop.stop_requested())
            return stopped();
        loop->next();
    }
    return loadPicture(loop->frame(), loop->world().layout(), size, palette);
}

/// A grey picture that fills the space.
QImage filled(const cv::Mat1b& frame, const QSize& size) {
    const QImage image(frame.data, frame.cols, frame.rows, static_cast<qsizetype>(frame.step),
                       QImage::Format_Grayscale8);
    return image.scaled(size, Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation)
        .convertToFormat(QImage::Format_RGB32);
}

core::Expected<QImage> gelPicture(const scene::Scene& scene, const QSize& size, const std::stop_token& stop) {
    TELETA_TRY(const auto stage, simulation::GelStage::make(scene, kSeed));
    cv::Mat1b frame;
    do {
        if (stop.stop_requested())
            return stopped();
        stage->next(frame);
    } while (stage->time_s() < std::min(kGelTime_s, scene.duration_s));
    return filled(frame, size);
}

core::Expected<QImage> cameraPicture(const scene::Scene& scene, const QSize& size,
                                     const std::stop_token& stop) {
    TELETA_TRY(const auto tube, simulation::SimulatedTube::make(scene, kSeed));
    cv::Mat1b frame;
    do {
        if (stop.stop_requested())
            return stopped();
        tube->next({}, frame);
    } while (tube->time_s() < std::min(kCameraTime_s, scene.duration_s));
    return filled(frame, size);
}

core::Expected<QImage> armPicture(const scene::Scene& scene, const QSize& size, const QPalette& palette,
                                  const std::stop_token& stop) {
    TELETA_TRY(const auto arm, simulation::SimulatedArm::make(scene, kSeed));
    const core::ArmDescription description = arm->description();
    core::JointSample sample;
    double until_s = kArmLongest_s;
    while (arm->time_s() < until_s && !arm->programDone()) {
        if (stop.stop_requested())
            return stopped();
        arm->next({.drive = core::ArmDrive::program}, sample);
        if (until_s == kArmLongest_s && !arm->truth().contacts.empty())
            until_s = arm->time_s() + kArmAfter_s;
    }
    const arm::Arm4Kinematics kinematics({.upperArmLength_m = description.upperArmLength_m,
                                          .forearmLength_m = description.forearmLength_m,
                                          .halfThickness_m = description.halfThickness_m});
    const arm::JointVector& q_rad = arm->truth().link_rad;
    const auto point = [&](arm::Link link, double along_m) {
        const Eigen::Vector3d at = kinematics.X_Base_Link(link, q_rad) * Eigen::Vector3d(along_m, 0.0, 0.0);
        return QPointF(at.x(), at.y());
    };
    const QPointF shoulder = point(arm::Link::upperArm, 0.0);
    const QPointF elbow = point(arm::Link::forearm, 0.0);
    const QPointF tip = point(arm::Link::forearm, description.forearmLength_m);

    QRectF seen_m = QPolygonF{shoulder, elbow, tip}.boundingRect();
    std::vector<QPolygonF> outlines;
    for (const simulation::ArmObjectTruth& object : arm->objects()) {
        const simulation::OutlineGeometry& outline = object.outline;
        if (!std::isfinite(outline.reach_m()))
            continue; // a wall has no outline
        QPolygonF shape;
        for (const Eigen::Vector2d& corner : outline.corners_m())
            shape << QPointF(corner.x(), corner.y());
        constexpr int kSides = 48;
        for (int side = 0; outline.corners_m().empty() && side < kSides; ++side) {
            const double turn = 2.0 * std::numbers::pi * side / kSides;
            shape << QPointF(outline.centre_m().x() + outline.reach_m() * std::cos(turn),
                             outline.centre_m().y() + outline.reach_m() * std::sin(turn));
        }
        seen_m = seen_m.united(shape.boundingRect());
        outlines.push_back(std::move(shape));
    }
    const double around_m = description.halfThickness_m;
    seen_m.adjust(-around_m, -around_m, around_m, around_m);

    QImage image = blank(size, palette);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    const double scale =
        (1.0 - kMargin) * std::min(size.width() / seen_m.width(), size.height() / seen_m.height());
    painter.translate(0.5 * size.width(), 0.5 * size.height());
    painter.scale(scale, -scale);
    painter.translate(-seen_m.center());
    const double line_m = 1.5 / scale;
    const base::SpaceColours& space = base::spaceColours(base::isDark(palette));
    const double thick_m = 2.0 * description.halfThickness_m;
    const auto link = [&](const QPointF& from, const QPointF& to, double width_m, const QColor& colour) {
        painter.setPen(QPen(colour, width_m, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(from, to);
    };
    link(shoulder, elbow, thick_m + 2.0 * line_m, space.joint);
    link(shoulder, elbow, thick_m, space.shell);
    link(elbow, tip, thick_m + 2.0 * line_m, space.joint);
    link(elbow, tip, thick_m, QColor(base::colourAt(base::cividis(), 0.15)));
    painter.setPen(Qt::NoPen);
    painter.setBrush(space.joint);
    for (const QPointF& joint : {shoulder, elbow})
        painter.drawEllipse(joint, 0.6 * thick_m, 0.6 * thick_m);
    const QColor object = palette.color(QPalette::Link);
    for (const QPolygonF& shape : outlines) {
        painter.setPen(QPen(object, line_m));
        painter.setBrush(base::translucent(object, 0.25F));
        painter.drawPolygon(shape);
    }
    // Where it touches.
    for (const simulation::ArmContactTruth& contact : arm->truth().contacts) {
        painter.setPen(QPen(palette.color(QPalette::Base), line_m));
        painter.setBrush(QColor(base::colourAt(base::cividis(), 1.0)));
        painter.drawEllipse(QPointF(contact.p_Base_Contact_m.x(), contact.p_Base_Contact_m.y()), 2.2 * line_m,
                            2.2 * line_m);
    }
    return image;
}

} // namespace

QImage loadPicture(std::span<const float> load_N, const core::ArrayLayout& layout, const QSize& size,
                   const QPalette& palette) {
    QImage image = blank(size, palette);
    QPainter painter(&image);
    float highest_N = 0.0F;
    for (const float load : load_N)
        if (std::isfinite(load))
            highest_N = std::max(highest_N, load);
    const double cell = std::min(size.width() / static_cast<double>(layout.columns),
                                 size.height() / static_cast<double>(layout.rows));
    const QPointF corner(0.5 * (size.width() - cell * layout.columns),
                         0.5 * (size.height() - cell * layout.rows));
    painter.fillRect(image.rect(), QColor(base::colourAt(base::cividis(), 0.0)));
    for (int row = 0; row < layout.rows; ++row) {
        for (int column = 0; column < layout.columns; ++column) {
            const float load = load_N[static_cast<std::size_t>(row * layout.columns + column)];
            const double share =
                highest_N > 0.0F && std::isfinite(load) ? static_cast<double>(load / highest_N) : 0.0;
            // Rows count upwards.
            const QRectF place(corner.x() + cell * column, corner.y() + cell * (layout.rows - 1 - row), cell,
                               cell);
            painter.fillRect(place, QColor(base::colourAt(base::cividis(), share)));
        }
    }
    return image;
}

core::Expected<QImage> scenePicture(const scene::Scene& scene, const QSize& size, const QPalette& palette,
                                    const std::stop_token& stop) {
    if (scene.isArm())
        return armPicture(scene, size, palette, stop);
    if (scene.isServo())
        return servoPicture(scene, size, palette, stop);
    if (scene.isCamera())
        return cameraPicture(scene, size, stop);
    if (scene.isGel())
        return gelPicture(scene, size, stop);
    return arrayPicture(scene, size, palette, stop);
}

} // namespace teleta::console
