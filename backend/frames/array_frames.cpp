// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/data/array_guess.h"
#include "backend/core/failure.h"
#include "backend/frames/frame_series.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace teleta::frames {

namespace {

struct ArrayFramesText {
    Q_DECLARE_TR_FUNCTIONS(ArrayFramesText)
};

constexpr std::size_t kMostNamed = 12;

core::Unexpected wrong(const std::string& path, const QString& message, const QString& expected) {
    return core::failed(core::ErrorKind::badInput, message, expected, {path});
}

QString quoted(const std::string& name) {
    return QStringLiteral("\"%1\"").arg(QString::fromStdString(name).left(60));
}

/// "frames (2000 x 6 x 14), time_s (2000)".
QString listOf(const std::vector<ArrayHead>& arrays) {
    QStringList names;
    for (const ArrayHead& head : arrays) {
        if (names.size() == static_cast<qsizetype>(kMostNamed)) {
            names << QStringLiteral("…");
            break;
        }
        QString about = QString::fromStdString(shapeText(head.shape));
        if (!head.problem.empty())
            about += QStringLiteral("; ") + QString::fromStdString(head.problem);
        names << QStringLiteral("%1 (%2)").arg(QString::fromStdString(head.name).left(60), about);
    }
    return names.join(QStringLiteral(", "));
}

/// One row or one column of values, such as times.
bool isVector(const ArrayHead& head) {
    return std::ranges::count_if(head.shape, [](std::uint64_t side) { return side != 1; }) <= 1 &&
           !head.shape.empty() && head.shape.size() <= 2;
}

std::optional<std::size_t> named(const ArrayFile& file, const std::string& name) {
    for (std::size_t i = 0; i < file.arrays().size(); ++i)
        if (file.arrays()[i].name == name)
            return i;
    // As HDF5 writes the path of a dataset.
    return name.starts_with('/') ? named(file, name.substr(1)) : std::nullopt;
}

/// An array in the group of another one, or in none.
std::optional<std::size_t> namedBeside(const ArrayFile& file, std::size_t array, const std::string& name) {
    const std::string& frames = file.arrays()[array].name;
    if (const std::size_t slash = frames.rfind('/'); slash != std::string::npos)
        if (const auto found = named(file, frames.substr(0, slash + 1) + name))
            return found;
    return named(file, name);
}

core::Expected<std::size_t> choose(const ArrayFile& file, const FrameRequest& request) {
    const std::vector<ArrayHead>& arrays = file.arrays();
    if (arrays.empty())
        return wrong(file.path(), ArrayFramesText::tr("the file has no arrays"),
                     ArrayFramesText::tr("frames of an array"));
    if (!request.array.empty()) {
        if (const auto found = named(file, request.array))
            return *found;
        return wrong(file.path(),
                     ArrayFramesText::tr("there is no array %1; the file has: %2")
                         .arg(quoted(request.array), listOf(arrays)),
                     ArrayFramesText::tr("one of these"));
    }
    if (arrays.size() == 1)
        return std::size_t{0};
    if (const auto found = named(file, "frames"))
        return *found;
    for (const std::size_t dimensions : {3U, 2U}) {
        std::vector<ArrayHead> candidates;
        std::size_t found = 0;
        for (std::size_t i = 0; i < arrays.size(); ++i)
            if (arrays[i].shape.size() == dimensions && !isVector(arrays[i]) && arrays[i].problem.empty()) {
                candidates.push_back(arrays[i]);
                found = i;
            }
        if (candidates.size() == 1)
            return found;
        if (!candidates.empty())
            return wrong(file.path(),
                         ArrayFramesText::tr("several arrays can be the frames: %1").arg(listOf(candidates)),
                         ArrayFramesText::tr("the name of one (--array NAME)"));
    }
    return wrong(file.path(),
                 ArrayFramesText::tr("no array can be frames; the file has: %1").arg(listOf(arrays)),
                 ArrayFramesText::tr("an array of 3 dimensions: frames x rows x columns"));
}

core::Expected<std::vector<double>> readVector(ArrayFile& file, std::size_t array) {
    std::vector<double> values;
    TELETA_CHECK(file.read(array, [&values](std::span<const double> piece) {
        values.insert(values.end(), piece.begin(), piece.end());
        return true;
    }));
    return values;
}

std::optional<double> positive(std::optional<double> value) {
    return value && std::isfinite(*value) && *value > 0.0 ? value : std::nullopt;
}

/// The value of an array of one entry, such as pitch_m.
core::Expected<std::optional<double>> scalar(ArrayFile& file, std::size_t array, const std::string& name) {
    const auto found = namedBeside(file, array, name);
    if (!found || !file.arrays()[*found].problem.empty() || valuesOf(file.arrays()[*found].shape) != 1U)
        return std::optional<double>();
    TELETA_TRY(const std::vector<double> values, readVector(file, *found));
    return values.empty() ? std::nullopt : positive(values.front());
}

/// The times that the file tells; empty: none.
core::Expected<std::vector<double>> fileTimes(ArrayFile& file, std::size_t array) {
    const auto found = namedBeside(file, array, "time_s");
    if (!found || *found == array)
        return std::vector<double>();
    const ArrayHead& head = file.arrays()[*found];
    if (!head.problem.empty())
        return wrong(file.path(),
                     ArrayFramesText::tr("the array %1: %2")
                         .arg(quoted(head.name), QString::fromStdString(head.problem)),
                     ArrayFramesText::tr("a time in s for each frame"));
    const std::vector<std::uint64_t>& shape = file.arrays()[array].shape;
    const std::optional<std::uint64_t> times = valuesOf(head.shape);
    if (!isVector(head) || (times != shape.front() && times != shape.back()))
        return wrong(
            file.path(),
            ArrayFramesText::tr("time_s has the shape %1, the frames have %2")
                .arg(QString::fromStdString(shapeText(head.shape)), QString::fromStdString(shapeText(shape))),
            ArrayFramesText::tr("a time in s for each frame"));
    return readVector(file, *found);
}

core::Expected<FrameAxis> axisOf(const ArrayFile& file, const ArrayHead& head, const FrameRequest& request,
                                 std::span<const double> times_s) {
    if (request.axis != FrameAxis::automatic)
        return request.axis;
    const bool isFirst = !times_s.empty() && times_s.size() == head.shape.front();
    const bool isLast = !times_s.empty() && times_s.size() == head.shape.back();
    if (head.axisIsOpen && isFirst == isLast)
        return wrong(file.path(),
                     ArrayFramesText::tr("%1 does not say which dimension is the frames").arg(listOf({head})),
                     ArrayFramesText::tr(
                         "the dimension that counts the frames, the first or the last (--frame-axis), or "
                         "a time_s for each frame"));
    return isLast && !isFirst ? FrameAxis::last : FrameAxis::first;
}

/// Where each dimension goes in frames x rows x columns, in the order in which the file has them, the
/// quickest one first.
struct Way {
    std::array<std::uint64_t, 3> sides{1, 1, 1};
    std::array<std::uint64_t, 3> steps{0, 0, 0};
};

/// columns: of a frame of an array of three dimensions.
Way wayOf(const ArrayHead& head, FrameAxis axis, std::uint64_t taxels, std::uint64_t columns) {
    const std::size_t dimensions = head.shape.size();
    std::array<std::uint64_t, 3> steps{};
    if (dimensions == 3)
        steps = axis == FrameAxis::first ? std::array<std::uint64_t, 3>{taxels, columns, 1}
                                         : std::array<std::uint64_t, 3>{columns, 1, taxels};
    else
        steps = axis == FrameAxis::first ? std::array<std::uint64_t, 3>{taxels, 1, 0}
                                         : std::array<std::uint64_t, 3>{1, taxels, 0};
    Way way;
    for (std::size_t i = 0; i < dimensions; ++i) {
        const std::size_t from = head.isColumnMajor ? i : dimensions - 1 - i;
        way.sides[i] = head.shape[from];
        way.steps[i] = steps[from];
    }
    return way;
}

/// Values in the order of the file as frames x rows x columns.
std::vector<float> turned(std::vector<float> values, const Way& way) {
    if (way.steps[0] == 1 && way.steps[1] == way.sides[0] &&
        (way.sides[2] == 1 || way.steps[2] == way.sides[0] * way.sides[1]))
        return values;
    std::vector<float> result(values.size());
    std::size_t from = 0;
    for (std::uint64_t k = 0; k < way.sides[2]; ++k)
        for (std::uint64_t j = 0; j < way.sides[1]; ++j)
            for (std::uint64_t i = 0; i < way.sides[0]; ++i)
                result[i * way.steps[0] + j * way.steps[1] + k * way.steps[2]] = values[from++];
    return result;
}

/// As many values as the head says. They are counted while they come, because a damaged head may say any
/// number.
core::Expected<std::vector<float>> readValues(ArrayFile& file, std::size_t array, std::uint64_t count,
                                              const GoOn& goOn) {
    std::vector<float> values;
    TELETA_CHECK(file.read(array, [&](std::span<const double> piece) {
        if (goOn && !goOn())
            return false;
        for (const double value : piece)
            values.push_back(static_cast<float>(value));
        return true;
    }));
    if (values.size() != count)
        return wrong(
            file.path(),
            ArrayFramesText::tr("the array has %1 instead of %2 values").arg(values.size()).arg(count),
            ArrayFramesText::tr("a whole file"));
    return values;
}

/// One row of all numbers of a frame of a known array. first: the dimension behind which a frame has two.
core::Expected<core::ArrayLayout> knownSides(const ArrayFile& file, const ArrayHead& head, std::size_t first,
                                             const KnownArray& known) {
    const std::uint64_t a = head.shape[first];
    const std::uint64_t b = head.shape[first + 1];
    const core::ArrayLayout& grid = known.layout.grid();
    const bool isGrid = !known.layout.isVector() && known.layout.isGrid() &&
                        a == static_cast<std::uint64_t>(grid.rows) &&
                        b == static_cast<std::uint64_t>(grid.columns);
    const bool isVectors = known.layout.isVector() && b == core::TaxelLayout::kVector &&
                           (a * b == known.numbers || a == known.layout.taxels());
    if (!isGrid && !isVectors)
        return wrong(
            file.path(),
            ArrayFramesText::tr("a frame of %1 has the shape %2 x %3").arg(quoted(head.name)).arg(a).arg(b),
            known.layout.isVector()
                ? ArrayFramesText::tr("%1 taxels x 3, as the layout has them").arg(known.numbers / 3)
                : ArrayFramesText::tr("%1 rows x %2 columns, as the layout has them")
                      .arg(grid.rows)
                      .arg(grid.columns));
    return core::ArrayLayout{1, static_cast<int>(a * b)};
}

/// Rows and columns of the frames of an array.
core::Expected<core::ArrayLayout> sidesOf(const ArrayFile& file, const ArrayHead& head, FrameAxis axis,
                                          const FrameRequest& request) {
    if (head.shape.size() == 2) {
        auto layout = layoutOf(request, axis == FrameAxis::first ? head.shape[1] : head.shape[0],
                               ArrayFramesText::tr("a frame of the array"));
        if (!layout)
            layout.error().where.file = file.path();
        return layout;
    }
    const std::size_t first = axis == FrameAxis::first ? 1 : 0;
    if (request.known)
        return knownSides(file, head, first, *request.known);
    constexpr std::uint64_t kMost = core::ArrayLayout::kMaximumSide;
    for (const std::uint64_t side : {head.shape[first], head.shape[first + 1]})
        if (side < 1 || side > kMost)
            return wrong(file.path(),
                         ArrayFramesText::tr("a frame of %1 has %2 x %3 taxels")
                             .arg(quoted(head.name))
                             .arg(head.shape[first])
                             .arg(head.shape[first + 1]),
                         ArrayFramesText::tr("from 1 to %1 rows and columns").arg(kMost));
    if (head.shape[first + 1] == core::TaxelLayout::kVector && !request.rows && !request.columns)
        return wrong(
            file.path(),
            ArrayFramesText::tr("%1 can be a grid of 3 columns, or %2 taxels with x, y and z each")
                .arg(listOf({head}))
                .arg(head.shape[first]),
            ArrayFramesText::tr("for the grid, %1 rows and 3 columns (--rows %1 --columns 3); for vectors, "
                                "the file that says where the taxels are (--layout FILE.toml)")
                .arg(head.shape[first]));
    core::ArrayLayout layout;
    layout.rows = static_cast<int>(head.shape[first]);
    layout.columns = static_cast<int>(head.shape[first + 1]);
    if ((request.rows && *request.rows != layout.rows) ||
        (request.columns && *request.columns != layout.columns))
        return wrong(
            file.path(),
            ArrayFramesText::tr("the frames have %1 rows x %2 columns").arg(layout.rows).arg(layout.columns),
            ArrayFramesText::tr("%1 rows x %2 columns")
                .arg(request.rows.value_or(layout.rows))
                .arg(request.columns.value_or(layout.columns)));
    return layout;
}

/// Places of taxels along an axis, from the middle between the outermost ones, in m.
std::vector<double> fromTheMiddle(std::vector<double> places_m) {
    const auto [lowest, highest] = std::ranges::minmax(places_m);
    for (double& place_m : places_m)
        place_m -= std::midpoint(lowest, highest);
    return places_m;
}

/// Refuses positions_m, taxels x 3, when a taxel stands more than a tenth of the pitch beside its place in
/// the layout. Where the origin is does not matter.
core::Expected<void> comparePlaces(ArrayFile& file, std::size_t array, const core::TaxelLayout& known) {
    constexpr std::size_t kAxes = 3;
    constexpr double kShare = 0.1;
    const std::size_t taxels = known.taxels();
    const ArrayHead head = file.arrays()[array];
    const QString expected = ArrayFramesText::tr("the layout with which the frames were recorded");
    if (!head.problem.empty() || head.shape != std::vector<std::uint64_t>{taxels, kAxes})
        return wrong(file.path(),
                     ArrayFramesText::tr("positions_m has the shape %1, but the layout has %2 taxels")
                         .arg(QString::fromStdString(shapeText(head.shape)))
                         .arg(taxels),
                     expected);
    TELETA_TRY(const std::vector<double> values, readVector(file, array));
    if (values.size() != kAxes * taxels)
        return wrong(file.path(),
                     ArrayFramesText::tr("the array has %1 instead of %2 values")
                         .arg(values.size())
                         .arg(kAxes * taxels),
                     ArrayFramesText::tr("a whole file"));
    std::array<std::vector<double>, kAxes> told;
    std::array<std::vector<double>, kAxes> laid;
    for (std::size_t i = 0; i < taxels; ++i) {
        for (std::size_t axis = 0; axis < kAxes; ++axis)
            told.at(axis).push_back(values[head.isColumnMajor ? axis * taxels + i : i * kAxes + axis]);
        laid[0].push_back(known.x_m(i));
        laid[1].push_back(known.y_m(i));
        laid[2].push_back(known.isGrid() ? 0.0 : (*known.places())[i].z_m);
    }
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        const std::vector<double> file_m = fromTheMiddle(std::move(told.at(axis)));
        const std::vector<double> layout_m = fromTheMiddle(std::move(laid.at(axis)));
        for (std::size_t i = 0; i < taxels; ++i)
            if (!(std::abs(file_m[i] - layout_m[i]) <= kShare * known.pitch_m()))
                return wrong(
                    file.path(),
                    ArrayFramesText::tr("positions_m has taxel %1 at %2 = %3 mm, the layout at %4 mm",
                                        "a number, x, y or z, two places")
                        .arg(i)
                        .arg(QLatin1Char("xyz"[axis]))
                        .arg(1e3 * file_m[i], 0, 'g', 4)
                        .arg(1e3 * layout_m[i], 0, 'g', 4),
                    expected);
    }
    return {};
}

} // namespace

core::Expected<core::ArrayLayout> layoutOf(const FrameRequest& request, std::uint64_t taxels,
                                           const QString& what) {
    if (request.known) {
        const std::size_t placed = request.known->layout.values();
        if (taxels != request.known->numbers && taxels != placed)
            return wrong({}, ArrayFramesText::tr("%1 has %2 numbers").arg(what).arg(taxels),
                         ArrayFramesText::tr("%1, as the layout has them").arg(request.known->numbers));
        return core::ArrayLayout{1, static_cast<int>(taxels)};
    }
    core::ArrayLayout layout;
    const auto has = [&] { return ArrayFramesText::tr("%1 has %2 taxels").arg(what).arg(taxels); };
    if (!request.rows && !request.columns && request.guessesShape) {
        layout = core::guessArray(taxels).layout;
        constexpr int kMost = core::ArrayLayout::kMaximumSide;
        if (taxels < 1 || layout.rows > kMost || layout.columns > kMost ||
            taxels > static_cast<std::uint64_t>(kMost) * kMost)
            return wrong({}, has(), ArrayFramesText::tr("from 1 to %1 rows and columns").arg(kMost));
        layout.setPitch_m(core::ArrayLayout{}.pitchX_m);
        return layout;
    }
    layout.rows = request.rows.value_or(layout.rows);
    layout.columns = request.columns.value_or(layout.columns);
    if (!request.taxelColumns.empty() && !request.columns && taxels > 0 &&
        taxels % static_cast<std::uint64_t>(layout.rows) == 0 &&
        taxels / static_cast<std::uint64_t>(layout.rows) <= core::ArrayLayout::kMaximumSide)
        layout.columns = static_cast<int>(taxels / static_cast<std::uint64_t>(layout.rows));
    if (layout.taxels() != taxels)
        return wrong({}, has(),
                     ArrayFramesText::tr("%1 = %2 rows x %3 columns, or others (--rows N --columns M)")
                         .arg(layout.taxels())
                         .arg(layout.rows)
                         .arg(layout.columns));
    return layout;
}

core::Expected<std::vector<double>> timesAt(std::optional<double> rate_Hz, std::size_t frames,
                                            const std::string& path) {
    if (!rate_Hz)
        return wrong(path, ArrayFramesText::tr("the file does not say when its frames were taken"),
                     ArrayFramesText::tr("frames per second (--rate HZ), or times in time_s"));
    std::vector<double> times_s(frames);
    for (std::size_t i = 0; i < frames; ++i)
        times_s[i] = static_cast<double>(i) / *rate_Hz;
    return times_s;
}

core::Expected<void> checkTimes(std::span<const double> time_s, const std::string& path) {
    for (std::size_t i = 0; i < time_s.size(); ++i) {
        if (!std::isfinite(time_s[i]))
            return wrong(path, ArrayFramesText::tr("the time of frame %1 is not a finite number").arg(i + 1),
                         ArrayFramesText::tr("a finite time in s"));
        if (i > 0 && time_s[i] < time_s[i - 1])
            return wrong(path,
                         ArrayFramesText::tr("the time goes back at frame %1, from %2 s to %3 s")
                             .arg(i + 1)
                             .arg(time_s[i - 1])
                             .arg(time_s[i]),
                         ArrayFramesText::tr("times that do not decrease"));
    }
    return {};
}

std::vector<std::string> namesOfFrames(const ArrayFile& file) {
    std::vector<std::string> names;
    for (const ArrayHead& head : file.arrays())
        if ((head.shape.size() == 2 || head.shape.size() == 3) && !isVector(head) && head.problem.empty())
            names.push_back(head.name);
    return names;
}

core::Expected<FrameSeries> framesOf(ArrayFile& file, const FrameRequest& request, const GoOn& goOn) {
    TELETA_TRY(const std::size_t array, choose(file, request));
    const ArrayHead head = file.arrays()[array];
    if (!head.problem.empty())
        return wrong(file.path(),
                     head.name.empty() ? QString::fromStdString(head.problem)
                                       : ArrayFramesText::tr("the array %1: %2")
                                             .arg(quoted(head.name), QString::fromStdString(head.problem)),
                     ArrayFramesText::tr("an array of real numbers"));
    if (head.shape.size() != 2 && head.shape.size() != 3)
        return wrong(file.path(),
                     ArrayFramesText::tr("the array has the shape %1")
                         .arg(QString::fromStdString(shapeText(head.shape))),
                     ArrayFramesText::tr("frames x rows x columns, or frames x taxels"));
    const std::optional<std::uint64_t> count = valuesOf(head.shape);
    if (!count)
        return wrong(file.path(),
                     ArrayFramesText::tr("the array is too large: %1")
                         .arg(QString::fromStdString(shapeText(head.shape))),
                     ArrayFramesText::tr("at most %1 values").arg(kMostValues));
    TELETA_TRY(auto times_s, fileTimes(file, array));
    TELETA_TRY(const FrameAxis axis, axisOf(file, head, request, times_s));

    FrameSeries series;
    const auto places = namedBeside(file, array, "positions_m");
    const bool hasPlaces = places.has_value();
    if (hasPlaces && !request.known && !request.rows && !request.columns)
        return wrong(file.path(), ArrayFramesText::tr("the taxels have places of their own, in positions_m"),
                     ArrayFramesText::tr("the file that says where the taxels are (--layout FILE.toml)"));
    TELETA_TRY(series.layout, sidesOf(file, head, axis, request));
    if (request.known) {
        const core::TaxelLayout& known = request.known->layout;
        series.isPlaced = hasPlaces || (head.shape.size() == 3 && !known.isVector());
        const std::size_t wanted = series.isPlaced ? known.values() : request.known->numbers;
        if (series.layout.taxels() != wanted)
            return wrong(
                file.path(),
                ArrayFramesText::tr("a frame of the array has %1 numbers").arg(series.layout.taxels()),
                ArrayFramesText::tr("%1, as the layout has them").arg(wanted));
        if (places)
            TELETA_CHECK(comparePlaces(file, *places, known));
    }
    const std::uint64_t frames = axis == FrameAxis::first ? head.shape.front() : head.shape.back();
    if (frames == 0)
        return wrong(file.path(), ArrayFramesText::tr("the recording has no frames"),
                     ArrayFramesText::tr("at least one frame"));
    if (!times_s.empty() && times_s.size() != frames)
        return wrong(file.path(),
                     ArrayFramesText::tr("time_s has %1 times for %2 frames").arg(times_s.size()).arg(frames),
                     ArrayFramesText::tr("a time in s for each frame"));
    if (!times_s.empty() && request.rate_Hz)
        return wrong(file.path(), ArrayFramesText::tr("the file has times of its own, in time_s"),
                     ArrayFramesText::tr("no rate"));
    TELETA_TRY(std::optional<double> rate_Hz, scalar(file, array, "rate_hz"));
    TELETA_TRY(std::optional<double> pitch_m, scalar(file, array, "pitch_m"));
    if (!rate_Hz)
        rate_Hz = positive(head.rate_Hz);
    if (!pitch_m)
        pitch_m = positive(head.pitch_m);
    series.unit = head.unit;
    if (request.rate_Hz)
        rate_Hz = request.rate_Hz;
    if (!rate_Hz && !request.needsTimes)
        rate_Hz = 1.0;
    if (request.pitch_m)
        pitch_m = request.pitch_m;
    if (!times_s.empty()) {
        series.time_s = std::move(times_s);
    } else {
        TELETA_TRY(series.time_s, timesAt(rate_Hz, frames, file.path()));
    }
    TELETA_CHECK(checkTimes(series.time_s, file.path()));
    series.hasPitch = pitch_m.has_value();
    series.layout.setPitch_m(pitch_m.value_or(series.layout.pitchX_m));
    TELETA_TRY(std::vector<float> values, readValues(file, array, *count, goOn));
    const std::uint64_t columns = head.shape[axis == FrameAxis::first ? head.shape.size() - 1 : 1];
    series.values = turned(std::move(values), wayOf(head, axis, series.layout.taxels(), columns));
    return series;
}

} // namespace teleta::frames
