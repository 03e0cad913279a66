// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/base/array_input.h"
#include "app/python/base/array_output.h"
#include "app/python/vision/camera_object.h"
#include "app/python/vision/vision_bindings.h"
#include "backend/vision/calibration/camera_calibration.h"

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace teleta::python {

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

Camera load(const py::object& path) {
    const std::string file = pathOf(path);
    std::optional<core::Expected<vision::CameraFile>> read;
    {
        const py::gil_scoped_release released;
        read.emplace(vision::readCamera(file));
    }
    return Camera{valueOf(std::move(*read))};
}

void save(const Camera& camera, const py::object& path) {
    const std::string file = pathOf(path);
    core::Expected<void> written;
    {
        const py::gil_scoped_release released;
        written = vision::writeCamera(camera.file, file);
    }
    valueOf(written);
}

/// Rows of so many coordinates; a single point may be (2,) or (3,).
py::array_t<double, py::array::c_style> rowsOf(const py::object& argument, const char* name,
                                               py::ssize_t coordinates) {
    auto array = realArray<double>(argument, name);
    if (array.ndim() == 1 && array.shape(0) == coordinates)
        array = array.reshape({py::ssize_t(1), coordinates});
    needShape(array, name, {-1, coordinates}, coordinates == 2 ? "(n, 2)" : "(n, 3)");
    return array;
}

py::tuple locate(const Camera& self, const py::object& pixels) {
    const auto rows = rowsOf(pixels, "pixels_px", 2);
    const auto count = static_cast<std::size_t>(rows.shape(0));
    const double* const values = rows.data();
    std::vector<double> points(3 * count, kNaN);
    std::vector<double> deviations(count, kNaN);
    WordColumn<20> why;
    why.reserve(count);
    {
        const py::gil_scoped_release released;
        const vision::CylinderCamera& camera = self.file.camera;
        for (std::size_t i = 0; i < count; ++i) {
            const auto point_m = camera.locate_m({values[2 * i], values[2 * i + 1]});
            why.add(point_m ? "" : vision::toString(point_m.error()));
            if (!point_m)
                continue;
            for (std::size_t k = 0; k < 3; ++k)
                points[3 * i + k] = (*point_m)[static_cast<Eigen::Index>(k)];
            deviations[i] = camera.standardDeviation_m(*point_m).value_or(kNaN);
        }
    }
    return py::make_tuple(arrayOf(std::move(points), {rows.shape(0), 3}), arrayOf(std::move(deviations)),
                          std::move(why).array());
}

py::array project(const Camera& self, const py::object& pointsArgument) {
    const auto rows = rowsOf(pointsArgument, "points_m", 3);
    const auto count = static_cast<std::size_t>(rows.shape(0));
    const double* const values = rows.data();
    std::vector<double> pixels(2 * count, kNaN);
    {
        const py::gil_scoped_release released;
        const vision::CameraModel& camera = self.file.camera.camera();
        for (std::size_t i = 0; i < count; ++i) {
            const auto pixel = camera.project({values[3 * i], values[3 * i + 1], values[3 * i + 2]});
            if (!pixel || !camera.sees(*pixel))
                continue;
            pixels[2 * i] = pixel->x();
            pixels[2 * i + 1] = pixel->y();
        }
    }
    return arrayOf(std::move(pixels), {rows.shape(0), 2});
}

py::dict calibrate(const py::object& pixels, const py::object& points, long long width_px,
                   long long height_px, double radius_m, double length_m, const std::string& method) {
    const auto pixelRows = rowsOf(pixels, "pixels_px", 2);
    const auto pointRows = rowsOf(points, "points_m", 3);
    if (pointRows.shape(0) != pixelRows.shape(0))
        throw wrongValue("points_m", "(" + std::to_string(pixelRows.shape(0)) + ", 3)", shapeText(pointRows));
    const auto side = [](long long value, const char* name) {
        if (value < 1 || value > vision::kLargestSide_px)
            throw wrongValue(name, "1 to " + std::to_string(vision::kLargestSide_px), std::to_string(value));
        return static_cast<int>(value);
    };
    vision::CalibrationSettings settings;
    settings.width_px = side(width_px, "width_px");
    settings.height_px = side(height_px, "height_px");
    settings.surface.radius_m = positive(radius_m, "radius_m");
    settings.surface.highest_z_m = positive(length_m, "length_m");
    const auto chosen = vision::calibrationMethod(method);
    if (!chosen)
        throw wrongValue("method", "'robust', 'paper', 'least_squares' or 'dlt'",
                         std::string(py::repr(py::str(method))));
    std::vector<vision::CalibrationPair> pairs;
    for (py::ssize_t i = 0; i < pixelRows.shape(0); ++i)
        pairs.push_back({{pixelRows.at(i, 0), pixelRows.at(i, 1)},
                         {pointRows.at(i, 0), pointRows.at(i, 1), pointRows.at(i, 2)}});
    std::optional<tl::expected<vision::Calibration, vision::CalibrationRefusal>> found;
    {
        const py::gil_scoped_release released;
        found.emplace(vision::calibrate(pairs, settings, *chosen));
    }
    if (!*found)
        throw Failure(vision::describe(found->error(), pairs.size()));
    const vision::Calibration& calibration = **found;
    std::vector<std::uint8_t> kept;
    std::vector<double> residuals;
    for (const vision::PairResidual& residual : calibration.residuals) {
        kept.push_back(residual.kept ? 1 : 0);
        residuals.push_back(residual.error_px ? residual.error_px->x() : kNaN);
        residuals.push_back(residual.error_px ? residual.error_px->y() : kNaN);
    }
    py::list warnings;
    for (const vision::CalibrationWarning warning : calibration.warnings)
        warnings.append(vision::toString(warning));
    py::dict fields;
    fields["camera"] = Camera{{calibration.camera, vision::summaryOf(calibration)}};
    fields["kept"] = arrayOf(std::move(kept)).attr("astype")("bool");
    fields["residual_px"] = arrayOf(std::move(residuals), {pixelRows.shape(0), 2});
    fields["rms_px"] = calibration.rms_px;
    fields["mean_px"] = calibration.mean_px;
    fields["mean_m"] = calibration.mean_error_m;
    fields["valid_radius_px"] = calibration.camera.camera().validRadius_px();
    fields["uncertainty_m"] = calibration.uncertainty_m;
    fields["warnings"] = py::tuple(warnings);
    return fields;
}

} // namespace

void bindCamera(py::module_& module) {
    py::class_<Camera>(module, "Camera", py::module_local())
        .def_static("load", &load)
        .def("save", &save)
        .def("locate", &locate)
        .def("project", &project)
        .def_property_readonly(
            "width_px", [](const Camera& self) { return self.file.camera.camera().parameters().width_px; })
        .def_property_readonly(
            "height_px", [](const Camera& self) { return self.file.camera.camera().parameters().height_px; });
    module.def("calibrate", &calibrate);
}

} // namespace teleta::python
