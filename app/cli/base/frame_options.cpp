// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/base/frame_options.h"

#include "app/cli/base/feature_rows.h"
#include "app/cli/base/interruption.h"
#include "app/cli/base/options.h"
#include "app/cli/base/progress_bar.h"
#include "app/cli/base/standard_streams.h"
#include "backend/contact/taxels/frame_analysis.h"
#include "backend/core/data/input_file.h"
#include "backend/equilibration/taxel_gain_file.h"
#include "backend/frames/rest_values.h"
#include "devices/taxels/known_array.h"
#include "devices/taxels/layout_file.h"

#include <QCoreApplication>
#include <QStringList>

#include <array>
#include <filesystem>
#include <utility>

namespace teleta::cli {

namespace {

struct FrameOptionText {
    Q_DECLARE_TR_FUNCTIONS(FrameOptionText)
};

constexpr char kMedian[] = "median";
constexpr char kFirst[] = "first";
constexpr char kUntouched[] = "untouched";

/// What the options say of the array and its taxels.
core::Expected<contact::ConditioningSettings> conditioning(const FrameOptions& options,
                                                           const OpenFrames& frames) {
    const core::TaxelLayout& layout = frames.reader.taxels();
    TELETA_TRY(contact::ConditioningSettings settings, options.array.conditioning(layout, options.path));
    settings.gain = frames.gain;
    if (!options.gainsPath.empty()) {
        TELETA_TRY(const auto gains, equilibration::readTaxelGains(options.gainsPath, layout.grid()));
        settings.taxelGain = gains.values();
    }
    return settings;
}

void refuseDeadOutside(const std::vector<int>& dead, std::size_t taxels) {
    for (const int taxel : dead) {
        if (taxel < 0 || static_cast<std::size_t>(taxel) >= taxels)
            refuse("--dead", FrameOptionText::tr("%1 is given, a taxel from 0 to %2 is expected")
                                 .arg(taxel)
                                 .arg(taxels - 1));
    }
}

bool isRange(const std::string& columns) {
    return columns.find_first_of(".,") != std::string::npos;
}

/// A number of columns of the array, or columns of a table.
CLI::Validator columnsOption() {
    CLI::Validator side = between(1, core::ArrayLayout::kMaximumSide);
    CLI::Validator validator(std::string{});
    validator.operation([side](std::string& text) -> std::string {
        if (isRange(text) && frames::columnRangesOf(text))
            return {};
        if (text.find_first_not_of("0123456789") == std::string::npos)
            return side(text);
        return FrameOptionText::tr("%1 is given, a number of columns, or columns such as 2..85 are expected")
            .arg(QString::fromStdString(text))
            .toStdString();
    });
    return validator;
}

} // namespace

void ArrayOptions::declare(CLI::App& app) {
    m_rowsOption = addOption(app, "--rows", m_rows, FrameOptionText::tr("Rows of the array"),
                             between(1, core::ArrayLayout::kMaximumSide));
    addOption(app, "--columns", m_columns,
              FrameOptionText::tr("Columns of the array; or columns of a table of another program that are "
                                  "taxels, from 1, such as 2..85"),
              "INT|RANGES")
        ->check(columnsOption())
        ->default_str(std::to_string(core::ArrayLayout{}.columns));
    m_pitchOption = addOption(app, "--pitch-mm", pitch_mm,
                              FrameOptionText::tr("Distance of neighbouring taxels in mm"), positive());
    addOption(app, "--rate", m_rate_Hz, FrameOptionText::tr("Frames per second of a file without times"),
              "HZ")
        ->check(positive());
    addOption(app, "--array", m_array, FrameOptionText::tr("Name of the frames in a file of several arrays"),
              "NAME");
    addChoice(app, "--frame-axis", m_axis,
              FrameOptionText::tr("Dimension of the array that counts the frames"), {"auto", "first", "last"})
        ->capture_default_str();
    addOption(
        app, "--tare", tare,
        FrameOptionText::tr("Frames of the unloaded array, whose mean is subtracted; or of the recording "
                            "itself the median of each taxel, the mean of the first half second, or its "
                            "value while it is untouched, in at least one frame in ten"),
        "FILE|median|first|untouched");
    addOption(app, "--time-column", m_timeColumn,
              FrameOptionText::tr("Name or number of the column of the times in a table of another program"),
              "NAME");
    addChoice(app, "--time-unit", m_timeUnit,
              FrameOptionText::tr("Unit of these times; default: as the name of the column ends"),
              {"s", "ms", "us", "ns", "iso"});
    addFlag(app, "--invert", inverted, FrameOptionText::tr("The raw values fall under load"));
    addOption(app, "--dead", dead, FrameOptionText::tr("Numbers of taxels to leave out, such as 0,17"),
              "LIST")
        ->delimiter(',')
        ->allow_extra_args(false);
}

void ArrayOptions::declareLayout(CLI::App& app) {
    addOption(app, "--layout", m_layoutPath,
              FrameOptionText::tr("Where the taxels are and what each tells, also off a grid and as vectors: "
                                  "the table [layout] of a device file"),
              "FILE.toml");
}

core::Expected<std::optional<double>> ArrayOptions::newtonsPerUnit(const std::string& unit) const {
    if (m_layoutPath.empty())
        return std::optional<double>();
    return taxels::readLayout(m_layoutPath).map([&unit](const taxels::LayoutFile& file) {
        const bool alreadyInNewtons = unit == "N" && file.grid.unit() != unit;
        return alreadyInNewtons ? std::nullopt : file.grid.newtonsPerUnit();
    });
}

core::Expected<double> ArrayOptions::threshold(const std::optional<double>& given,
                                               const std::string& unit) const {
    if (given)
        return *given;
    if (!m_layoutPath.empty()) {
        TELETA_TRY(const taxels::LayoutFile file, taxels::readLayout(m_layoutPath));
        if (file.threshold && file.grid.loadUnit() == unit)
            return *file.threshold;
    }
    const std::optional<double> usual = frames::usualThreshold(unit);
    if (!usual)
        refuse(
            "--threshold",
            FrameOptionText::tr("the loads are in %1: write from how many %1 a taxel is in contact, such as "
                                "five times the noise at rest")
                .arg(QString::fromStdString(unit)));
    return *usual;
}

core::Expected<frames::FrameRequest> ArrayOptions::request(const std::string& path) const {
    frames::FrameRequest request{.path = path};
    if (!m_layoutPath.empty()) {
        if (m_rowsOption->count() > 0 || m_pitchOption->count() > 0 ||
            (!m_columns.empty() && !isRange(m_columns)))
            refuse("--layout", FrameOptionText::tr("it says rows, columns and pitch itself"));
        TELETA_TRY(taxels::LayoutFile file, taxels::readLayout(m_layoutPath));
        request.known = taxels::knownArray(std::move(file.grid));
    }
    if (m_rowsOption->count() > 0)
        request.rows = m_rows;
    if (isRange(m_columns))
        request.taxelColumns = frames::columnRangesOf(m_columns).value_or(std::vector<frames::ColumnRange>());
    else if (!m_columns.empty())
        request.columns = std::stoi(m_columns);
    if (m_pitchOption->count() > 0)
        request.pitch_m = pitch_mm * 1e-3;
    // What is wrong already is said before a file is read.
    constexpr auto kMost = static_cast<std::size_t>(core::ArrayLayout::kMaximumSide);
    refuseDeadOutside(dead, request.rows && request.columns ? static_cast<std::size_t>(*request.rows) *
                                                                  static_cast<std::size_t>(*request.columns)
                                                            : kMost * kMost);
    request.rate_Hz = m_rate_Hz;
    request.array = m_array;
    request.timeColumn = m_timeColumn;
    request.timeUnit = m_timeUnit;
    request.axis = m_axis == "first"  ? frames::FrameAxis::first
                   : m_axis == "last" ? frames::FrameAxis::last
                                      : frames::FrameAxis::automatic;
    return request;
}

std::string ArrayOptions::tarePath() const {
    return tare == kMedian || tare == kFirst || tare == kUntouched ? std::string() : tare;
}

core::Expected<contact::ConditioningSettings> ArrayOptions::conditioning(const core::TaxelLayout& layout,
                                                                         const std::string& path) const {
    contact::ConditioningSettings settings;
    settings.inverted = inverted;
    const std::size_t taxels = layout.taxels();
    if (!dead.empty())
        settings.dead.assign(taxels, 0);
    refuseDeadOutside(dead, taxels);
    for (const int taxel : dead)
        settings.dead[static_cast<std::size_t>(taxel)] = 1;
    if (tare.empty())
        return settings;
    if (tare == kUntouched && layout.isVector())
        refuse("--tare", FrameOptionText::tr("'untouched' is for loads, but each taxel tells three values"));
    const std::string file = tarePath();
    TELETA_TRY(frames::FrameRequest unloaded, request(file.empty() ? path : file));
    if (!unloaded.known) {
        unloaded.rows = layout.grid().rows;
        unloaded.columns = layout.grid().columns;
    }
    unloaded.needsTimes = file.empty();
    if (file.empty())
        TELETA_CHECK(core::requireFile(path)); // it is read twice
    else
        unloaded.rate_Hz.reset();
    auto series = frames::readFrames(unloaded, [] { return !interrupted(); });
    if (!series)
        return core::Unexpected(interruptedInstead(std::move(series).error()));
    if (tare == kUntouched) {
        TELETA_TRY(settings.tare, frames::untouchedValues(*series, inverted, settings.dead));
        return settings;
    }
    settings.tare = frames::restValues(*series, tare == kMedian  ? frames::RestRule::median
                                                : tare == kFirst ? frames::RestRule::first
                                                                 : frames::RestRule::mean);
    return settings;
}

void refuseToReplace(const std::string& output, std::span<const std::string> inputs, const char* option) {
    for (const std::string& input : inputs) {
        std::error_code missing;
        if (!output.empty() && output != kStandardOutput &&
            std::filesystem::equivalent(input, output, missing))
            refuse(option, FrameOptionText::tr("the output would replace the input"));
    }
}

void FrameOptions::declare(CLI::App& app) {
    addOption(app, "FRAMES", path,
              FrameOptionText::tr("Recorded frames: CSV time_s,t0,t1,... with one row a frame, row-major, or "
                                  "a file of another program"),
              "")
        ->required();
    array.declare(app);
    array.declareLayout(app);
    addOption(app, "-t,--threshold", threshold,
              FrameOptionText::tr("Load from which a taxel is in contact, in N or the unit of the file; 0.2 "
                                  "unless that is another one than N and counts"),
              "LOAD")
        ->check(positive());
    addOption(app, "--gain", gain, FrameOptionText::tr("N per raw unit"))->check(nonZero());
    addOption(app, "--gains", gainsPath,
              FrameOptionText::tr("Gains of the taxels, as \"teleta gains\" writes them"), "GAINS.csv");
    addFlag(app, "--weighted", weighted,
            FrameOptionText::tr("Weight the taxels with their load to find the principal axis"));
    addFlag(app, "--auto-threshold", automaticThreshold,
            FrameOptionText::tr("Find the threshold in each frame; --threshold is the least"));
    addFlag(
        app, "--active-only", activeOnly,
        FrameOptionText::tr("Force and centre of pressure over taxels in contact, not over the whole array"));
    addOption(app, "--noise-height", noiseHeight,
              FrameOptionText::tr(
                  "Summits that rise less than this share of the frame's peak are no contacts of their own"),
              between(0.0, 1.0));
    addFlag(app, "--summit", summit,
            FrameOptionText::tr("Add the place of deepest pressure, finer than the taxels, also on a strip"));
    addOption(
        app, "--noise-sd", noise_N,
        FrameOptionText::tr("Standard deviation of a taxel's load at rest in N, for the standard errors "
                            "of the summit"),
        "N")
        ->check(positive())
        ->needs("--summit");
    addOption(app, "--min-taxels", minimumTaxels, FrameOptionText::tr("Contacts of fewer taxels are dropped"),
              between(1, core::ArrayLayout::kMaximumSide * core::ArrayLayout::kMaximumSide));
    declareJson(app, output.json);
    declareOut(app, output.outPath);
}

contact::FeatureSettings FrameOptions::featureSettings() const {
    return {.threshold_N = threshold.value_or(contact::FeatureSettings{}.threshold_N),
            .automaticThreshold = automaticThreshold,
            .orientation =
                weighted ? contact::OrientationMode::weighted : contact::OrientationMode::binarised,
            .range = activeOnly ? contact::MomentRange::active : contact::MomentRange::image};
}

contact::SegmentationSettings FrameOptions::segmentationSettings() const {
    return {.threshold_N = threshold.value_or(contact::SegmentationSettings{}.threshold_N),
            .noiseHeight = noiseHeight,
            .minimumTaxels = minimumTaxels};
}

void warnOfUnused(const frames::FrameReader& frames) {
    QStringList names;
    for (const std::string& name : frames.unused())
        names << QString::fromStdString(name);
    if (!names.isEmpty())
        warn(FrameOptionText::tr("These lines of the file have no effect: %1.")
                 .arg(names.join(QStringLiteral(", "))));
}

core::Expected<OpenFrames> openFrames(FrameOptions& options) {
    refuseToReplace(options.output.outPath, std::array{options.path, options.array.tarePath(),
                                                       options.gainsPath, options.array.layoutPath()});
    TELETA_TRY(const frames::FrameRequest request, options.array.request(options.path));
    auto reader = frames::FrameReader::open(request, [] { return !interrupted(); });
    if (!reader)
        return core::Unexpected(interruptedInstead(std::move(reader).error()));
    warnOfUnused(*reader);
    const std::string unit = reader->unit();
    TELETA_TRY(const std::optional<double> newtons, options.array.newtonsPerUnit(unit));
    const std::optional<double> gain = options.gain ? options.gain : newtons;
    OpenFrames frames{*std::move(reader), gain.value_or(1.0), gain || unit.empty() ? "N" : unit};
    if (frames.loadUnit != "N")
        warn(FrameOptionText::tr("The values are in %1, not in N: give the N of one unit with --gain.")
                 .arg(QString::fromStdString(unit)));
    TELETA_TRY(options.threshold, options.array.threshold(options.threshold, frames.loadUnit));
    return frames;
}

namespace {

/// Reads the frames and hands each of them to take(raw, time_s, rows).
template <typename Take>
core::Expected<void> readInto(const FrameOptions& options, frames::FrameReader& frames,
                              const std::vector<std::string>& columns, Take take) {
    TELETA_TRY(RowOutput rows, openRows(columns, options.output));
    std::vector<float> raw(frames.taxels().values());
    double time_s = 0.0;
    const auto total = static_cast<double>(frames.bytesTotal());
    ProgressBar progress(ProgressBar::Unit::bytes, rows.onTerminal());
    bool stopped = false;
    while (!(stopped = interrupted()) && !rows.failed()) {
        const core::Expected<bool> any = frames.next(time_s, raw);
        if (!any) {
            stopped = any.error().kind == core::ErrorKind::cancelled;
            if (stopped)
                break;
            rows.flush();
            return core::Unexpected(any.error());
        }
        if (!*any)
            break;
        take(std::span<const float>(raw), time_s, rows);
        rows.flushIfDue();
        progress.update(static_cast<double>(frames.bytesRead()), total);
    }
    return unlessCut(rows.finish(), stopped);
}

} // namespace

core::Expected<void> processFrames(const FrameOptions& options, OpenFrames frames,
                                   const std::vector<std::string>& columns,
                                   const std::function<void(const ConditionedFrame&, RowOutput&)>& write) {
    TELETA_TRY(contact::ConditioningSettings settings, conditioning(options, frames));
    const std::size_t taxels = frames.reader.taxels().taxels();
    const contact::FrameConditioner conditioner(taxels, std::move(settings));
    std::vector<float> load_N(taxels);
    std::vector<std::uint8_t> dead(taxels);
    return readInto(options, frames.reader, columns,
                    [&](std::span<const float> raw, double time_s, RowOutput& rows) {
                        conditioner.apply(raw, load_N, dead);
                        write({time_s, load_N, dead}, rows);
                    });
}

core::Expected<void>
analyseFrames(const FrameOptions& options, OpenFrames frames, const std::vector<std::string>& columns,
              const std::function<void(double time_s, const contact::TaxelFrame&, RowOutput&)>& write) {
    if (options.summit)
        refuse("--summit", FrameOptionText::tr("this is for loads on a grid"));
    contact::AnalysisSettings settings{.conditioning = {},
                                       .features = options.featureSettings(),
                                       .segmentation = options.segmentationSettings()};
    TELETA_TRY(settings.conditioning, conditioning(options, frames));
    contact::FrameAnalysis analysis(frames.reader.taxels(), settings);
    contact::TaxelFrame frame;
    return readInto(options, frames.reader, columns,
                    [&](std::span<const float> raw, double time_s, RowOutput& rows) {
                        analysis.analyse(raw, time_s, frame);
                        write(time_s, frame, rows);
                    });
}

} // namespace teleta::cli
