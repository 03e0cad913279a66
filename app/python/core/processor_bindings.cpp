// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/base/array_output.h"
#include "app/python/base/frame_input.h"
#include "app/python/base/turn.h"
#include "app/python/core/contact_columns.h"
#include "app/python/core/core_bindings.h"
#include "app/python/core/frame_settings.h"

#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <pybind11/pybind11.h>
#include <span>
#include <string>
#include <vector>

namespace teleta::python {

namespace {

/// Fills instances of a frozen dataclass with slots without calling its constructor, which takes longer than
/// the features. Needs the interpreter's lock.
class FeaturesFactory {
public:
    explicit FeaturesFactory(py::object type)
        : m_type(std::move(type)) {
        m_names[0] = py::str("time_s");
        m_names[1] = py::str("contact_type");
        for (std::size_t i = 0; i < FeatureColumns::kNumbers.size(); ++i)
            m_names[2 + i] = py::str(FeatureColumns::kNumbers[i]);
        m_names.back() = py::str("active");
        for (const contact::ContactType each :
             {contact::ContactType::none, contact::ContactType::point, contact::ContactType::edge})
            m_types[static_cast<std::size_t>(each)] = py::str(contact::toString(each));
    }

    [[nodiscard]] py::object make(double time_s, const contact::TactileFeatures& features) const {
        auto* const type = reinterpret_cast<PyTypeObject*>(m_type.ptr());
        py::object made = py::reinterpret_steal<py::object>(type->tp_alloc(type, 0));
        if (!made)
            throw py::error_already_set();
        set(made, 0, std::isnan(time_s) ? py::object(py::none()) : py::object(py::float_(time_s)));
        set(made, 1, m_types[static_cast<std::size_t>(features.type)]);
        const auto numbers = FeatureColumns::numbersOf(features);
        for (std::size_t i = 0; i < numbers.size(); ++i)
            set(made, 2 + i,
                std::isnan(numbers[i]) ? py::object(py::none()) : py::object(py::float_(numbers[i])));
        set(made, m_names.size() - 1, py::int_(features.active));
        return made;
    }

private:
    void set(const py::object& made, std::size_t field, const py::object& value) const {
        // Not the class's own way of setting, which is frozen.
        if (PyObject_GenericSetAttr(made.ptr(), m_names[field].ptr(), value.ptr()) != 0)
            throw py::error_already_set();
    }

    py::object m_type;
    std::array<py::object, FeatureColumns::kNumbers.size() + 3> m_names;
    std::array<py::object, 3> m_types;
};

/// One array of a few values; what numpy's own constructor does, without the owner that large ones need.
template <typename T, typename Value>
py::array columnOf(std::span<const contact::Contact> contacts, Value value) {
    py::array_t<T> column(static_cast<py::ssize_t>(contacts.size()));
    T* const data = column.mutable_data();
    for (std::size_t i = 0; i < contacts.size(); ++i)
        data[i] = static_cast<T>(contacts[i].*value);
    return column;
}

/// Features and contacts of one frame after another, for a control loop. All memory of the computation is
/// allocated once.
class Processor {
public:
    Processor(long long rows, long long columns, double pitch_m, const py::dict& arguments,
              const py::object& featuresType)
        : m_layout(layoutOf(rows, columns, pitch_m))
        , m_conditioner(m_layout.taxels(), conditioningOf(arguments, m_layout))
        , m_featureSettings(featureSettingsOf(arguments))
        , m_segmentation(segmentationSettingsOf(arguments))
        , m_tracking(trackingSettingsOf(arguments, m_layout))
        , m_extractor(m_layout, m_featureSettings)
        , m_segmenter(m_layout, m_segmentation)
        , m_tracker(m_tracking)
        , m_load_N(m_layout.taxels())
        , m_dead(m_layout.taxels())
        , m_factory(featuresType)
        , m_names{py::str("contact_id"), py::str("x_m"),    py::str("y_m"),
                  py::str("force_n"),    py::str("peak_n"), py::str("area_m2")} {}

    [[nodiscard]] py::tuple process(const py::object& frame, double time_s) {
        const Turn turn(m_busy);
        const auto array = realArray<float>(frame, "frame");
        if (array.ndim() != 2 || array.shape(0) != m_layout.rows || array.shape(1) != m_layout.columns)
            throw wrongValue(
                "frame", "(" + std::to_string(m_layout.rows) + ", " + std::to_string(m_layout.columns) + ")",
                shapeText(array));
        if (!std::isfinite(time_s) || time_s < m_last_s)
            throw wrongValue("time_s", "finite times that do not decrease",
                             std::string(py::repr(py::float_(time_s))));
        m_last_s = time_s;
        std::span<const contact::Contact> contacts;
        contact::TactileFeatures features;
        const auto compute = [&] {
            m_conditioner.apply(valuesOf(array), m_load_N, m_dead);
            features = m_extractor.compute(m_load_N, m_dead);
            if (m_featureSettings.automaticThreshold) {
                m_segmentation.threshold_N = features.threshold_N;
                m_segmenter.setSettings(m_segmentation);
            }
            const std::span<contact::Contact> found = m_segmenter.segment(m_load_N, m_dead);
            m_tracker.assign(found, time_s);
            contacts = found;
        };
        // To get the lock back may take milliseconds where other threads want it, a small frame takes less
        // than two microseconds.
        if (m_layout.taxels() > kTaxelsUnderLock) {
            const py::gil_scoped_release released;
            compute();
        } else {
            compute();
        }
        return py::make_tuple(m_factory.make(time_s, features), table(contacts));
    }

    void reset() {
        const Turn turn(m_busy);
        m_extractor.reset();
        m_tracker.reset();
        m_last_s = -std::numeric_limits<double>::infinity();
    }

private:
    static constexpr std::size_t kTaxelsUnderLock = 512;

    [[nodiscard]] py::dict table(std::span<const contact::Contact> contacts) const {
        using contact::Contact;
        py::dict columns;
        columns[m_names[0]] = columnOf<std::int64_t>(contacts, &Contact::id);
        columns[m_names[1]] = columnOf<double>(contacts, &Contact::x_m);
        columns[m_names[2]] = columnOf<double>(contacts, &Contact::y_m);
        columns[m_names[3]] = columnOf<double>(contacts, &Contact::force_N);
        columns[m_names[4]] = columnOf<double>(contacts, &Contact::peak_N);
        columns[m_names[5]] = columnOf<double>(contacts, &Contact::area_m2);
        return columns;
    }

    core::ArrayLayout m_layout;
    contact::FrameConditioner m_conditioner;
    contact::FeatureSettings m_featureSettings;
    contact::SegmentationSettings m_segmentation;
    contact::TrackingSettings m_tracking;
    contact::FeatureExtractor m_extractor;
    contact::ContactSegmenter m_segmenter;
    contact::ContactTracker m_tracker;
    std::vector<float> m_load_N;
    std::vector<std::uint8_t> m_dead;
    FeaturesFactory m_factory;
    std::array<py::str, 6> m_names;
    double m_last_s = -std::numeric_limits<double>::infinity();
    std::atomic_flag m_busy = ATOMIC_FLAG_INIT;
};

} // namespace

void bindProcessor(py::module_& module) {
    py::class_<Processor>(module, "Processor", py::module_local())
        .def(py::init<long long, long long, double, const py::dict&, const py::object&>())
        .def("process", &Processor::process, py::arg("frame"), py::arg("time_s"))
        .def("reset", &Processor::reset);
}

} // namespace teleta::python
