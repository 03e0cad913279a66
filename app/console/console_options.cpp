// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/console_options.h"

#include "app/common/translation.h"
#include "app/common/version.h"
#include "app/console/operate/docks/operate_docks.h"
#include "app/console/study/study_page.h"

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QFileInfo>
#include <QLocale>

#include <algorithm>
#include <iterator>
#include <limits>

namespace teleta::console {

namespace {

/// The values of one option that is given per recording: the n-th belongs to the n-th --replay, the last one
/// to all that follow.
template <typename Values>
std::optional<typename Values::value_type> valueFor(const Values& values, qsizetype index) {
    if (values.empty())
        return std::nullopt;
    return *(values.begin() + std::min<qsizetype>(index, std::ssize(values) - 1));
}

/// QCommandLineParser knows no option whose value may be missing: --foxglove without a port gets the usual
/// one.
QStringList withFoxglovePort(QStringList arguments) {
    for (qsizetype i = 0; i < arguments.size(); ++i) {
        bool isPort = false;
        if (i + 1 < arguments.size())
            (void)arguments[i + 1].toUInt(&isPort);
        if (arguments[i] == QLatin1String("--foxglove") && !isPort)
            arguments[i] += QStringLiteral("=%1").arg(foxglove::LiveViewOptions().port);
    }
    return arguments;
}

class OptionReader {
    Q_DECLARE_TR_FUNCTIONS(ConsoleOptions)

public:
    ParsedOptions read(const QStringList& arguments);

private:
    QCommandLineOption option(const QString& name, const QString& description,
                              const QString& valueName = {}) {
        QCommandLineOption made(name, description, valueName);
        m_parser.addOption(made);
        return made;
    }
    std::vector<double> numbers(const QCommandLineOption& option, double low, double high);
    std::vector<int> integers(const QCommandLineOption& option, int low, int high);
    void fail(const QString& text) {
        if (m_error.isEmpty())
            m_error = text;
    }

    QCommandLineParser m_parser;
    QString m_error;
};

std::vector<double> OptionReader::numbers(const QCommandLineOption& option, double low, double high) {
    std::vector<double> values;
    for (const QString& text : m_parser.values(option)) {
        bool ok = false;
        values.push_back(text.toDouble(&ok));
        if (!ok || !(values.back() >= low && values.back() <= high))
            fail(tr("--%1 %2: expected a number from %3 to %4")
                     .arg(option.names().front(), text)
                     .arg(low)
                     .arg(high));
    }
    return values;
}

std::vector<int> OptionReader::integers(const QCommandLineOption& option, int low, int high) {
    std::vector<int> values;
    for (const QString& text : m_parser.values(option)) {
        bool ok = false;
        values.push_back(text.toInt(&ok));
        if (!ok || values.back() < low || values.back() > high)
            fail(tr("--%1 %2: expected a whole number from %3 to %4")
                     .arg(option.names().front(), text)
                     .arg(low)
                     .arg(high));
    }
    return values;
}

ParsedOptions OptionReader::read(const QStringList& arguments) {
    constexpr double kLargest = 1e12;
    m_parser.setApplicationDescription(
        tr("Shows what a remote robot arm touches: where, how hard, how stiff, what shape.\n\n"
           "Examples:\n"
           "  teleta-console --scene tactile-indenter\n"
           "  teleta-console --replay run.csv --rows 64 --columns 27 --tare empty.csv --threshold 10\n"
           "  teleta-console session.teleta\n"
           "  teleta-console --camera 0 --camera-model camera.json\n"
           "  teleta-console --arm arm.toml\n"
           "  teleta-console --site lab.toml\n"
           "  teleta-console --sources both-arrays.toml --theme dark"));
    m_parser.setSingleDashWordOptionMode(QCommandLineParser::ParseAsLongOptions);
    m_parser.addPositionalArgument(QStringLiteral("FILE"),
                                   tr("Recordings (.teleta, .csv, .mcap, .npz, .npy, .h5, .mat), scenes, "
                                      "arms, sites and source lists (.toml) to open."),
                                   QStringLiteral("[FILE...]"));
    // It adds --help-all too, of which this program has no more to say.
    const QCommandLineOption help = m_parser.addHelpOption();
    const QCommandLineOption version = m_parser.addVersionOption();

    const auto scene = option(
        "scene",
        tr("Open a simulated scene: a file, or the name of one that comes with the program (repeatable)."),
        tr("SCENE"));
    const auto seed = option("seed", tr("Seed of the simulated scenes (default 1)."), tr("N"));
    const auto replay = option("replay",
                               tr("Play back a recording of this program, or recorded frames, CSV "
                                  "time_s,t0,t1,... (repeatable; the options below go with the recordings "
                                  "in their order)."),
                               tr("FILE"));
    const auto rows = option("rows", tr("Rows of the array (default: by the number of taxels)."), tr("N"));
    const auto columns = option("columns", tr("Columns of the array."), tr("N"));
    const auto pitch = option("pitch-mm", tr("Distance between taxels in mm."), tr("MM"));
    const auto tare =
        option("tare", tr("Recording of the unloaded array, subtracted from the frames."), tr("FILE"));
    const auto invert = option("invert", tr("The values fall under load."));
    const auto gain = option("gain", tr("Load per raw unit (default 1)."), tr("G"));
    const auto unit =
        option("unit", tr("Unit of the loads (default N or counts, by the array)."), tr("NAME"));
    const auto threshold =
        option("threshold", tr("Load from which a taxel is in contact (default 0.2)."), tr("LOAD"));
    const auto rate = option("rate", tr("Play at this rate in Hz instead of the recorded times."), tr("HZ"));
    const auto sources = option("sources", tr("Open the sources listed in a TOML file."), tr("FILE"));
    const auto record =
        option("record", tr("Record all sources and the bracelet into a new file."), tr("FILE"));
    const auto live =
        option("foxglove", tr("Show all sources live to Foxglove on this port (default 8765)."), tr("PORT"));
    const auto liveAddress = option(
        "foxglove-address",
        tr("Address on which the live view listens (default 127.0.0.1: this computer only)."), tr("ADDRESS"));
    const auto camera = option(
        "camera", tr("Open a camera in the soft tube by its number, or a video of one."), tr("FILE|N"));
    const auto cameraModel =
        option("camera-model", tr("Calibration of that camera (JSON of teleta calibrate)."), tr("FILE"));
    const auto arm = option(
        "arm",
        tr("Open an arm over ROS 2, or the joints that a Modbus device reports, described in a file (TOML; "
           "repeatable)."),
        tr("FILE"));
    const auto site = option(
        "site", tr("Connect to a site where teleta-site runs, by its file (TOML; repeatable)."), tr("FILE"));
    const auto pattern =
        option("pattern", tr("Open a pattern file, or a built-in pattern by its id, on the Patterns page."),
               tr("FILE"));
    const auto data =
        option("data", tr("Folder of your own patterns (default: the user's data folder)."), tr("FOLDER"));
    const auto dock =
        option("dock",
               tr("View of the Operate page (%1) or of the Study page (%2) to bring to the front.")
                   .arg(OperateDocks::names().join(QStringLiteral(", ")),
                        StudyPage::viewNames().join(QStringLiteral(", "))),
               tr("NAME"));
    const auto cameraPairs =
        option("camera-pairs", tr("Calibrate the cylinder camera with these pairs (CSV)."), tr("FILE"));
    const auto study = option(
        "study", tr("Open the folder of a study, or a protocol (TOML) to begin one with."), tr("PATH"));
    const auto rehearse =
        option("rehearse", tr("Let simulated participants go through the study, which is made if need be."));
    const auto page =
        option("page", tr("Page to show: %1.").arg(pageNames().join(QStringLiteral(", "))), tr("NAME"));
    const auto plot = option("plot",
                             tr("Plot a signal on the Plot page as soon as its source is open, "
                                "SOURCE/STREAM/COLUMN with the names that the page shows (repeatable)."),
                             tr("SIGNAL"));
    const auto bracelet =
        option("bracelet", tr("Bracelet to drive: simulated, usb, none, or a file that describes one."),
               tr("WHICH"));
    const auto theme = option("theme", tr("light, dark or system."), tr("NAME"));
    const auto language = option("language", tr("Language, for example en, ja, fr, zh_CN."), tr("CODE"));
    const auto screenshot =
        option("screenshot", tr("Save a picture of the window as PNG and quit."), tr("FILE"));
    const auto after = option("after", tr("Seconds to wait before the picture (default 3)."), tr("S"));
    const auto size = option("size", tr("Size of the window, for example 1600x1000."), tr("WxH"));
    const auto measure = option(
        "measure", tr("Run for so many seconds, print how long the event loop was busy, quit."), tr("S"));
    const auto fresh = option("fresh", tr("Start with the default layout and settings, and save none."));

    if (!m_parser.parse(withFoxglovePort(arguments)))
        return {std::nullopt, m_parser.errorText(), 2};
    if (m_parser.isSet(help) || m_parser.isSet(QStringLiteral("help-all")))
        return {std::nullopt, m_parser.helpText(), 0};
    if (m_parser.isSet(version))
        return {std::nullopt, QCoreApplication::applicationName() + QLatin1Char(' ') + app::version().number,
                0};
    ConsoleOptions options;
    options.files = m_parser.positionalArguments();
    for (const QString& file : options.files) {
        const QString suffix = QFileInfo(file).suffix().toLower();
        if (!app::isPlayable(file) && suffix != QLatin1String("toml"))
            fail(tr("unexpected argument \"%1\"").arg(file));
    }
    options.scenes = m_parser.values(scene);
    const auto allRows = integers(rows, 1, core::ArrayLayout::kMaximumSide);
    const auto allColumns = integers(columns, 1, core::ArrayLayout::kMaximumSide);
    const auto allPitches_mm = numbers(pitch, 1e-6, 1e6);
    const auto allGains = numbers(gain, 1e-12, kLargest);
    const auto allThresholds = numbers(threshold, 1e-12, kLargest);
    const auto allRates = numbers(rate, 0.001, 100'000.0);
    const QStringList allTares = m_parser.values(tare);
    const QStringList allUnits = m_parser.values(unit);
    const QStringList replays = m_parser.values(replay);
    for (qsizetype nth = 0; nth < replays.size(); ++nth) {
        RecordingArguments recording;
        recording.path = replays[nth];
        recording.rows = valueFor(allRows, nth);
        recording.columns = valueFor(allColumns, nth);
        if (const auto pitch_mm = valueFor(allPitches_mm, nth))
            recording.pitch_m = *pitch_mm * 1e-3;
        recording.tarePath = valueFor(allTares, nth);
        recording.unit = valueFor(allUnits, nth);
        recording.gain = valueFor(allGains, nth);
        recording.threshold_N = valueFor(allThresholds, nth);
        recording.rate_Hz = valueFor(allRates, nth);
        recording.inverted = m_parser.isSet(invert);
        options.recordings.push_back(recording);
    }
    options.sourceList = m_parser.value(sources);
    options.record = m_parser.value(record);
    options.startsLiveView = m_parser.isSet(live);
    if (const auto ports = integers(live, 1, std::numeric_limits<std::uint16_t>::max()); !ports.empty())
        options.liveView.port = static_cast<std::uint16_t>(ports.back());
    if (m_parser.isSet(liveAddress))
        options.liveView.address = m_parser.value(liveAddress).toStdString();
    if (const auto seeds = integers(seed, 0, std::numeric_limits<int>::max()); !seeds.empty())
        options.seed = static_cast<std::uint64_t>(seeds.back());
    options.pattern = m_parser.value(pattern);
    options.dataFolder = m_parser.value(data);
    options.dock = m_parser.value(dock);
    const QStringList views = OperateDocks::names() + StudyPage::viewNames();
    if (m_parser.isSet(dock) && !views.contains(options.dock))
        fail(tr("--dock %1: expected one of %2").arg(options.dock, views.join(QStringLiteral(", "))));
    if (m_parser.isSet(camera) != m_parser.isSet(cameraModel))
        fail(
            tr("--camera and --camera-model belong together: a camera is of no use without its calibration"));
    if (m_parser.isSet(camera))
        options.camera = app::CameraRequest{m_parser.value(camera).toStdString(),
                                            m_parser.value(cameraModel).toStdString(), true};
    options.arms = m_parser.values(arm);
    options.sites = m_parser.values(site);
    options.cameraPairs = m_parser.value(cameraPairs);
    options.study = m_parser.value(study);
    options.rehearse = m_parser.isSet(rehearse);
    options.page = m_parser.value(page);
    if (m_parser.isSet(page) && !pageNames().contains(options.page))
        fail(tr("--page %1: expected one of %2").arg(options.page, pageNames().join(QStringLiteral(", "))));
    options.plotted = m_parser.values(plot);
    for (const QString& plotted : options.plotted)
        if (plotted.count(QLatin1Char('/')) < 2)
            fail(tr("--plot %1: expected SOURCE/STREAM/COLUMN").arg(plotted));
    options.bracelet = m_parser.value(bracelet);
    options.theme = m_parser.value(theme);
    if (m_parser.isSet(theme) && !QStringList{"light", "dark", "system"}.contains(options.theme))
        fail(tr("--theme %1: expected light, dark or system").arg(options.theme));
    options.language = m_parser.value(language);
    const QList<QLocale> spoken = app::availableLocales();
    const auto isAsked = [asked = QLocale(options.language).language()](const QLocale& locale) {
        return locale.language() == asked;
    };
    if (m_parser.isSet(language) && std::ranges::none_of(spoken, isAsked))
        fail(tr("--language %1: expected en, fr, ja or zh_CN").arg(options.language));
    options.screenshot = m_parser.value(screenshot);
    if (const auto waits_s = numbers(after, 0.0, 3600.0); !waits_s.empty())
        options.after_s = waits_s.back();
    if (m_parser.isSet(size)) {
        const QStringList parts = m_parser.value(size).split(QLatin1Char('x'));
        bool widthOk = false;
        bool heightOk = false;
        if (parts.size() == 2)
            options.size = {parts[0].toInt(&widthOk), parts[1].toInt(&heightOk)};
        if (!widthOk || !heightOk || options.size.width() < 320 || options.size.height() < 240 ||
            options.size.width() > 16384 || options.size.height() > 16384)
            fail(tr("--size %1: expected WIDTHxHEIGHT, from 320x240 to 16384x16384")
                     .arg(m_parser.value(size)));
    }
    if (const auto times_s = numbers(measure, 0.1, 86'400.0); !times_s.empty())
        options.measure_s = times_s.back();
    options.freshLayout = m_parser.isSet(fresh);

    if (!m_error.isEmpty())
        return {std::nullopt, m_error, 2};
    return {options, {}, 0};
}

} // namespace

QStringList pageNames() {
    return {QStringLiteral("operate"),   QStringLiteral("patterns"), QStringLiteral("study"),
            QStringLiteral("calibrate"), QStringLiteral("cost"),     QStringLiteral("plot")};
}

ParsedOptions parseOptions(const QStringList& arguments) {
    return OptionReader().read(arguments);
}

} // namespace teleta::console
