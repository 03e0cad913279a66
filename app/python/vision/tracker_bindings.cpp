// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/base/array_input.h"
#include "app/python/base/array_output.h"
#include "app/python/base/table_rows.h"
#include "app/python/base/turn.h"
#include "app/python/vision/camera_object.h"
#include "app/python/vision/video_file.h"
#include "app/python/vision/vision_bindings.h"
#include "backend/vision/contacts/camera_tracker.h"
#include "backend/vision/contacts/contact_rows.h"
#include "backend/vision/finders/contact_ladder.h"

#include <atomic>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace teleta::python {

namespace {

/// One character a column of vision::kContactColumns.
constexpr char kKinds[] = "ififffffffffs";

std::unique_ptr<vision::ContactFinder> makeFinder(const Camera& camera, const std::string& preset) {
    const vision::ContactRung* const rung = vision::contactRung(preset);
    if (rung == nullptr) {
        std::string names;
        for (const vision::ContactRung& each : vision::contactLadder())
            names += (names.empty() ? "'" : ", '") + std::string(each.name) + "'";
        throw wrongValue("preset", "one of " + names, std::string(py::repr(py::str(preset))));
    }
    core::Expected<std::unique_ptr<vision::ContactFinder>> finder;
    {
        const py::gil_scoped_release released;
        finder = vision::makeContactFinder(*rung, camera.file.camera);
    }
    return valueOf(std::move(finder));
}

/// Follows the contacts in one picture after another.
class Tracker {
public:
    Tracker(const Camera& camera, const std::string& preset)
        : m_tracker(makeFinder(camera, preset), {}) {}

    /// The rows of `teleta track` for the next picture; None: it could not be decoded.
    [[nodiscard]] py::dict next(const py::object& picture, long long frame, double time_s) {
        const Turn turn(m_busy);
        if (!std::isfinite(time_s) || (m_last_s && time_s <= *m_last_s))
            throw wrongValue("time_s", "finite times that rise", std::string(py::repr(py::float_(time_s))));
        py::array_t<std::uint8_t, py::array::c_style> pixels;
        cv::Mat1b image;
        if (!picture.is_none()) {
            const py::array any = py::array::ensure(picture);
            if (!any || any.dtype().kind() != 'u' || any.itemsize() != 1)
                throw py::type_error("pictures: expected uint8");
            pixels = realArray<std::uint8_t>(picture, "pictures");
            needShape(pixels, "pictures", {-1, -1}, "(height, width)");
            // Only read, and not kept: the first one, which becomes the reference, is copied.
            image = cv::Mat1b(static_cast<int>(pixels.shape(0)), static_cast<int>(pixels.shape(1)),
                              const_cast<std::uint8_t*>(pixels.data()));
            if (!m_tracker.hasReference())
                image = image.clone();
        }
        core::Expected<std::vector<vision::FollowedContact>> contacts;
        {
            const py::gil_scoped_release released;
            contacts = m_tracker.next(image, time_s);
        }
        m_last_s = time_s;
        TableRows rows(vision::kContactColumns, kKinds);
        if (!contacts && !picture.is_none())
            throw Failure(contacts.error());
        const int bumped = m_tracker.bump() ? m_tracker.bump()->contact : 0;
        for (const vision::FollowedContact& followed :
             contacts ? *contacts : std::vector<vision::FollowedContact>()) {
            if (followed.seen || followed.event == vision::ContactEvent::ends)
                vision::writeContact(rows, frame, time_s, followed, bumped);
        }
        return std::move(rows).table();
    }

    [[nodiscard]] bool hasReference() const { return m_tracker.hasReference(); }
    [[nodiscard]] std::uint64_t unusableFrames() const { return m_tracker.unusableFrames(); }
    [[nodiscard]] std::string whyUnusable() const { return m_tracker.whyUnusable(); }

private:
    vision::CameraTracker m_tracker;
    std::optional<double> m_last_s;
    std::atomic_flag m_busy = ATOMIC_FLAG_INIT;
};

/// Iterates over a video: (picture or None, time_s).
class Video {
public:
    explicit Video(const py::object& path)
        : m_path(pathOf(path))
        , m_file(openFile(m_path)) {}

    [[nodiscard]] py::tuple next() {
        const Turn turn(m_busy);
        double time_s = 0.0;
        auto outcome = VideoFile::Outcome::ended;
        {
            const py::gil_scoped_release released;
            outcome = m_file.next(m_picture, time_s);
        }
        if (outcome == VideoFile::Outcome::ended)
            throw py::stop_iteration();
        if (outcome == VideoFile::Outcome::undecodable)
            return py::make_tuple(py::none(), time_s);
        std::vector<std::uint8_t> pixels(m_picture.begin(), m_picture.end());
        return py::make_tuple(arrayOf(std::move(pixels), {m_picture.rows, m_picture.cols}), time_s);
    }

private:
    static VideoFile openFile(const std::string& path) {
        std::optional<core::Expected<VideoFile>> file;
        {
            const py::gil_scoped_release released;
            file.emplace(VideoFile::open(path));
        }
        return valueOf(std::move(*file));
    }

    std::string m_path;
    VideoFile m_file;
    cv::Mat1b m_picture;
    std::atomic_flag m_busy = ATOMIC_FLAG_INIT;
};

} // namespace

void bindTracker(py::module_& module) {
    py::class_<Tracker>(module, "Tracker", py::module_local())
        .def(py::init<const Camera&, const std::string&>())
        .def("next", &Tracker::next)
        .def("has_reference", &Tracker::hasReference)
        .def("unusable_frames", &Tracker::unusableFrames)
        .def("why_unusable", &Tracker::whyUnusable);
    py::class_<Video>(module, "Video", py::module_local())
        .def(py::init<const py::object&>())
        .def("__iter__", [](py::object self) { return self; })
        .def("__next__", &Video::next);
    py::list presets;
    for (const vision::ContactRung& rung : vision::contactLadder())
        presets.append(py::str(std::string(rung.name)));
    module.attr("presets") = py::tuple(presets);
}

} // namespace teleta::python
