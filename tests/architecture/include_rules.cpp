// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/architecture/include_rules.h"

#include <algorithm>
#include <array>
#include <regex>
#include <set>
#include <string_view>

namespace teleta::architecture {
namespace {

using Names = std::vector<std::string_view>;

/// What the files of one folder may include: its own headers, those of other folders (with everything below
/// them), and libraries. The standard library is free for all.
struct Rule {
    std::string_view folder;
    Names mayUse;
    Names libraries;
};

// A folder below another one has its own row; the longest match counts.
const std::vector<Rule> kRules = {
    {"backend/core", {}, {"QtCore", "posix", "expected", "readerwriterqueue", "nlohmann_json"}},
    {"backend/recording", {"backend/core"}, {"QtCore", "QtSql", "expected"}},
    // Pure parts: no Qt.
    {"backend/contact", {"backend/core"}, {"expected", "Eigen"}},
    {"backend/stiffness", {"backend/core"}, {"expected", "Eigen", "Boost.Math"}},
    {"backend/contour", {"backend/core"}, {"expected", "Eigen", "Boost.Math"}},
    {"backend/arm", {"backend/core"}, {"expected", "Eigen"}},
    {"backend/servo", {"backend/core", "backend/contact"}, {"expected", "Eigen"}},
    {"backend/vision", {"backend/core"}, {"QtCore", "expected", "Eigen", "Ceres", "nlohmann_json"}},
    {"backend/simulation",
     {"backend/core", "backend/scene", "backend/arm", "backend/servo", "backend/contact"},
     {"expected", "Eigen"}},
    {"backend/equilibration", {"backend/core", "backend/contact"}, {"QtCore", "expected", "Eigen"}},
    {"backend/pattern", {"backend/core"}, {"QtCore", "expected", "nlohmann_json", "libzip"}},
    {"backend/playback", {"backend/core", "backend/pattern"}, {"QtCore", "expected"}},
    {"backend/study",
     {"backend/core", "backend/figure", "backend/pattern", "backend/scene"},
     {"QtCore", "QtSql", "posix", "expected", "toml++", "nlohmann_json", "Eigen", "Boost.Math"}},
    {"backend/motors",
     {"backend/core", "backend/pattern", "backend/scene", "backend/playback"},
     {"QtCore", "expected", "Eigen"}},
    {"backend/figure", {"backend/core"}, {"QtCore", "expected", "librsvg", "cairo"}},
    {"backend/servo_figure",
     {"backend/core", "backend/figure", "backend/servo"},
     {"QtCore", "expected", "Eigen"}},
    // Services.
    {"backend/scene", {"backend/core"}, {"QtCore", "expected", "toml++"}},
    {"backend/pipeline",
     {"backend/core", "backend/contact", "backend/stiffness", "backend/contour", "backend/arm",
      "backend/servo", "backend/pattern", "backend/playback", "backend/vision", "backend/recording"},
     {"QtCore", "expected", "Eigen", "nlohmann_json", "OpenCV"}},
    {"backend/vision/contacts",
     {"backend/core", "backend/vision"},
     {"QtCore", "expected", "Eigen", "OpenCV"}},
    {"backend/simulation/camera",
     {"backend/core", "backend/scene", "backend/simulation", "backend/vision"},
     {"QtCore", "expected", "Eigen", "OpenCV"}},
    {"backend/scene_run",
     {"backend/core", "backend/contact", "backend/stiffness", "backend/contour", "backend/arm",
      "backend/scene", "backend/servo", "backend/simulation", "backend/pipeline", "backend/vision",
      "backend/pattern", "backend/playback", "backend/study", "backend/recording", "backend/equilibration"},
     {"QtCore", "expected", "Eigen", "nlohmann_json", "OpenCV"}},
    {"backend/cost",
     {"backend/core", "backend/contact", "backend/stiffness", "backend/contour", "backend/scene",
      "backend/arm", "backend/simulation", "backend/vision", "backend/study", "backend/figure",
      "backend/equilibration"},
     {"QtCore", "posix", "expected", "Eigen", "OpenCV"}},

    {"devices/camera", {"backend/core"}, {"QtCore", "posix", "expected", "OpenCV", "V4L2"}},
    {"devices/modbus", {"backend/core", "backend/scene"}, {"QtCore", "posix", "expected", "libmodbus"}},
    {"devices/mouse3d", {"backend/core"}, {"QtCore", "posix", "expected", "hidapi"}},
    {"devices/replay", {"backend/core", "backend/recording"}, {"QtCore", "posix", "expected"}},
    {"devices/simulated", {"backend/core"}, {"QtCore", "posix", "expected"}},
    {"devices/wts", {"backend/core"}, {"QtCore", "posix", "expected"}},
    {"devices/bracelet", {"backend/core", "backend/scene"}, {"QtCore", "posix", "expected", "hidapi"}},
    {"devices/described",
     {"backend/core", "backend/scene", "devices/bracelet", "devices/modbus"},
     {"expected"}},

    {"widgets/base", {"backend"}, {"QtCore", "QtGui", "QtWidgets", "QtSvg", "QtPrintSupport"}},
    {"widgets/plot", {"widgets/base"}, {"QtCore", "QtGui", "QCustomPlot"}},
    {"widgets/tactile",
     {"backend", "widgets/base"},
     {"QtCore", "QtGui", "QtWidgets", "QtSvg", "QtPrintSupport", "QCustomPlot"}},
    {"widgets/charts",
     {"backend", "widgets/base"},
     {"QtCore", "QtGui", "QtWidgets", "QtSvg", "QtPrintSupport", "QCustomPlot"}},
    {"widgets/touch",
     {"backend", "widgets/base"},
     {"QtCore", "QtGui", "QtWidgets", "QtSvg", "QtPrintSupport", "QCustomPlot", "Eigen", "nlohmann_json"}},
    {"widgets/camera", {"backend", "widgets/base"}, {"QtCore", "QtGui", "QtWidgets", "Eigen"}},
    {"widgets/bracelet", {"backend", "widgets/base"}, {"QtCore", "QtGui", "QtWidgets"}},
    {"widgets/pattern", {"backend", "widgets/base"}, {"QtCore", "QtGui", "QtWidgets"}},
    {"widgets/servo", {"backend", "widgets/base"}, {"QtCore", "QtGui", "QtWidgets", "QtSvg", "Eigen"}},
    {"widgets/study", {"backend", "widgets/base"}, {"QtCore", "QtGui", "QtWidgets", "expected"}},
    {"widgets/calibrate",
     {"backend", "widgets/base", "widgets/plot"},
     {"QtCore", "QtGui", "QtWidgets", "QtSvg", "QtPrintSupport", "QCustomPlot"}},
    {"widgets/cost",
     {"backend", "widgets/base", "widgets/plot"},
     {"QtCore", "QtGui", "QtWidgets", "QtSvg", "QtPrintSupport", "QCustomPlot"}},
    {"widgets/chrome", {"backend", "widgets/base"}, {"QtCore", "QtGui", "QtWidgets", "QtSvg"}},
    {"widgets/view3d",
     {"backend", "widgets/base"},
     {"QtCore", "QtGui", "QtWidgets", "QtOpenGL", "QtOpenGLWidgets", "VTK", "Eigen"}},

    {"app/common", {"backend"}, {"QtCore", "expected"}},
    {"app/cli",
     {"backend", "devices", "app/common"},
     {"QtCore", "posix", "expected", "CLI11", "nlohmann_json"}},
    {"app/console",
     {"backend", "devices", "widgets", "app/common"},
     {"QtCore", "QtGui", "QtWidgets", "QtSvg", "QtPrintSupport", "QtOpenGLWidgets", "QtMultimedia", "posix",
      "expected", "Eigen"}},
};

struct Library {
    std::string_view prefix;
    std::string_view name;
};

constexpr std::array kLibraries = {
    Library{"Eigen/", "Eigen"},
    Library{"unsupported/Eigen/", "Eigen"},
    Library{"boost/math/", "Boost.Math"},
    Library{"readerwriterqueue/", "readerwriterqueue"},
    Library{"tl/", "expected"},
    Library{"toml++/", "toml++"},
    Library{"nlohmann/", "nlohmann_json"},
    Library{"CLI/", "CLI11"},
    Library{"qcustomplot.h", "QCustomPlot"},
    Library{"vtk", "VTK"},
    Library{"opencv2/", "OpenCV"},
    Library{"ceres/", "Ceres"},
    Library{"glog/", "Ceres"}, // its log
    Library{"hidapi/", "hidapi"},
    Library{"zip.h", "libzip"},
    Library{"librsvg/", "librsvg"},
    Library{"cairo", "cairo"},
    Library{"modbus/", "libmodbus"},
    Library{"linux/videodev2.h", "V4L2"},
};

const std::set<std::string_view> kPosixHeaders = {
    "fcntl.h",    "netdb.h",     "netinet/tcp.h", "poll.h",      "pthread.h",   "sched.h",
    "stdlib.h",   "termios.h",   "time.h",        "unistd.h",    "sys/mman.h",  "sys/socket.h",
    "sys/stat.h", "sys/types.h", "sys/file.h",    "sys/ioctl.h", "sys/prctl.h", "sys/resource.h"};

bool isStandard(std::string_view header) {
    return !header.empty() && std::all_of(header.begin(), header.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
    });
}

/// Empty when no rule knows the header.
std::string libraryOf(std::string_view header, const QtModules& qtModules) {
    for (const Library& library : kLibraries) {
        if (header.starts_with(library.prefix))
            return std::string(library.name);
    }
    if (kPosixHeaders.contains(header))
        return "posix";
    if (header.starts_with("Qt") && header.find('/') != std::string_view::npos)
        return std::string(header.substr(0, header.find('/')));
    const auto found = qtModules.find(header);
    return found == qtModules.end() ? std::string() : found->second;
}

bool lies(std::string_view path, std::string_view folder) {
    return path.starts_with(folder) && path.substr(folder.size()).starts_with('/');
}

const Rule* ruleOf(std::string_view path) {
    const Rule* best = nullptr;
    for (const Rule& rule : kRules) {
        if (lies(path, rule.folder) && (best == nullptr || rule.folder.size() > best->folder.size()))
            best = &rule;
    }
    return best;
}

std::string reasonAgainstProjectHeader(const Rule& rule, const std::string& header) {
    if (header.ends_with(".moc"))
        return {};
    if (ruleOf(header) == nullptr)
        return "\"" + header + "\" is not a path from the project root to a folder of the module graph";
    const bool allowed =
        lies(header, rule.folder) || std::any_of(rule.mayUse.begin(), rule.mayUse.end(),
                                                 [&](auto folder) { return lies(header, folder); });
    return allowed ? std::string() : std::string(rule.folder) + " must not use " + moduleOf(header);
}

std::string reasonAgainstLibraryHeader(const Rule& rule, const std::string& header,
                                       const QtModules& qtModules) {
    if (isStandard(header) && !qtModules.contains(header))
        return {};
    const std::string library = libraryOf(header, qtModules);
    if (library.empty())
        return "<" + header + "> is of no library that the table lists";
    const bool allowed =
        std::find(rule.libraries.begin(), rule.libraries.end(), library) != rule.libraries.end();
    return allowed ? std::string() : std::string(rule.folder) + " must not use " + library;
}

} // namespace

QtModules readQtModules(const std::filesystem::path& qtIncludes) {
    QtModules modules;
    for (const auto& folder : std::filesystem::directory_iterator(qtIncludes)) {
        if (!folder.is_directory())
            continue;
        for (const auto& header : std::filesystem::directory_iterator(folder))
            modules.emplace(header.path().filename().string(), folder.path().filename().string());
    }
    return modules;
}

std::string moduleOf(const std::string& path) {
    const Rule* rule = ruleOf(path);
    return rule == nullptr ? std::string() : std::string(rule->folder);
}

std::vector<Violation> forbiddenIncludes(const SourceFile& file, const QtModules& qtModules) {
    const Rule* rule = ruleOf(file.path);
    if (rule == nullptr)
        return {{file.path, 0, "this folder has no row in the table of the module graph"}};

    static const std::regex include(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"].*)");
    std::vector<Violation> violations;
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
        std::smatch match;
        if (!std::regex_match(file.lines[i], match, include))
            continue;
        const std::string reason = match[1] == "\"" ? reasonAgainstProjectHeader(*rule, match[2])
                                                    : reasonAgainstLibraryHeader(*rule, match[2], qtModules);
        if (!reason.empty())
            violations.push_back({file.path, static_cast<int>(i) + 1, reason});
    }
    return violations;
}

} // namespace teleta::architecture
