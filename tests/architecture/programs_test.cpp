// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <memory>
#include <regex>
#include <string>
#include <vector>

namespace {

struct PipeCloser {
    void operator()(FILE* pipe) const { pclose(pipe); }
};

/// Standard output of a shell command; empty when it could not run.
std::string outputOf(const std::string& command) {
    const std::unique_ptr<FILE, PipeCloser> pipe(popen(command.c_str(), "r"));
    std::string output;
    std::array<char, 4096> buffer{};
    while (pipe != nullptr &&
           std::fgets(buffer.data(), static_cast<int>(buffer.size()), pipe.get()) != nullptr)
        output += buffer.data();
    return output;
}

/// Everything that the dynamic linker loads for a program, one name a line.
std::string loadedLibraries(const std::string& program) {
    return outputOf("ldd '" + program + "'");
}

/// What the program itself names. OpenCV's core loads X11 without our doing, so X11 is looked for here.
std::string namedLibraries(const std::string& program) {
    return outputOf("readelf --dynamic --wide '" + program + "' | grep NEEDED");
}

/// The libraries in a listing whose name matches the pattern.
std::vector<std::string> matching(const std::string& listing, const char* pattern) {
    std::vector<std::string> found;
    const std::regex library(std::string("\\b(") + pattern + ")[^\\s/\\]]*\\.so");
    for (std::sregex_iterator match(listing.begin(), listing.end(), library), end; match != end; ++match)
        found.push_back(match->str());
    return found;
}

constexpr char kQt5[] = "libQt5";
constexpr char kHighGui[] = "libopencv_highgui";
constexpr char kToolkits[] =
    "libQt6Gui|libQt6Widgets|libQt6OpenGL|libQt6Svg|libQt6PrintSupport|libvtk|libqcustomplot"
    "|libQCustomPlot|libgtk";
constexpr char kDisplays[] = "libX11|libxcb|libwayland|libGL|libEGL|libOpenGL";

/// What the parts of the program load when a command needs them: see backend/opencv and backend/frames.
constexpr char kLoadedLater[] =
    "libopencv_(imgcodecs|videoio|video|calib3d|highgui)|libgdal|libgdcm|libheif|libav(codec|format)"
    "|libgst|librsvg|libcairo|libhdf5|libmatio";
constexpr std::ptrdiff_t kMostLibraries = 75; ///< of the module with all commands
/// What devices and cameras need, and everyday commands do without.
constexpr char kOfOtherCommands[] =
    "libopencv|libddsc|libiceoryx|libhidapi|libmodbus|liburdfdom|libglog|libcholmod|liblapack|libtbb|libX11";
/// What VTK's writers and mouse styles would bring, and the console does without at its start.
constexpr char kOfWriters[] = "libvtkIO(Geometry|Image|PLY)|libvtkInteractionStyle|libmpi|libtiff";
constexpr std::ptrdiff_t kMostEverydayLibraries = 28;
/// The C++ library with its own, and the dynamic linker.
constexpr std::ptrdiff_t kMostLibrariesAtTheStart = 6;

using Names = std::vector<std::string>;

TEST(ProgramsTest, listingsAreReadAsTheToolsWriteThem) {
    const std::string ldd = "\tlibQt5Core.so.5 => /usr/lib/libQt5Core.so.5 (0x00007f)\n"
                            "\tlibopencv_highgui.so.406 => /usr/lib/libopencv_highgui.so.406 (0x00007f)\n"
                            "\tlibstdc++.so.6 => /usr/lib/libstdc++.so.6 (0x00007f)\n";
    EXPECT_EQ(matching(ldd, kQt5), (Names{"libQt5Core.so", "libQt5Core.so"}));
    EXPECT_EQ(matching(ldd, kHighGui).size(), 2U);
    EXPECT_EQ(matching(ldd, kToolkits), Names{});
    const std::string readelf =
        " 0x0000000000000001 (NEEDED)             Shared library: [libGLX.so.0]\n"
        " 0x0000000000000001 (NEEDED)             Shared library: [libQt6Core.so.6]\n";
    EXPECT_EQ(matching(readelf, kDisplays), Names{"libGLX.so"});
}

TEST(ProgramsTest, theConsoleAnswersWhereThereIsNoScreen) {
#ifdef TELETA_CONSOLE_PROGRAM
    const std::string console =
        "env -u DISPLAY -u WAYLAND_DISPLAY -u QT_QPA_PLATFORM LC_ALL=C '" TELETA_CONSOLE_PROGRAM "' ";
    EXPECT_NE(outputOf(console + "--help").find("--scene"), std::string::npos);
    EXPECT_EQ(outputOf(console + "--version").find("teleta-console "), 0U);
#else
    GTEST_SKIP() << "built without the console";
#endif
}

#ifndef TELETA_SANITIZED // which brings libraries of its own
TEST(ProgramsTest, commandLineLoadsItsModulesOnly) {
    const std::string loaded = loadedLibraries(TELETA_PROGRAM);
    ASSERT_NE(loaded.find("libc.so"), std::string::npos) << loaded;
    EXPECT_LE(std::ranges::count(loaded, '\n'), kMostLibrariesAtTheStart) << loaded;
    EXPECT_EQ(outputOf("'" TELETA_PROGRAM "' --version").find("teleta "), 0U);
}

TEST(ProgramsTest, everydayCommandsLoadNoLibraryOfDevicesOrCameras) {
    const std::string loaded = loadedLibraries(TELETA_EVERYDAY_PART);
    ASSERT_NE(loaded.find("libQt6Core"), std::string::npos) << loaded;
    EXPECT_EQ(loaded.find("not found"), std::string::npos) << loaded;
    EXPECT_EQ(matching(loaded, kToolkits), Names{});
    EXPECT_EQ(matching(loaded, kOfOtherCommands), Names{});
    EXPECT_EQ(matching(loaded, kLoadedLater), Names{});
    EXPECT_LE(std::ranges::count(loaded, '\n'), kMostEverydayLibraries) << loaded;
}
#endif

TEST(ProgramsTest, commandLineLoadsNoToolkitAndNamesNoDisplay) {
    const std::string loaded = loadedLibraries(TELETA_COMMANDS_PART);
    ASSERT_NE(loaded.find("libopencv_core"), std::string::npos) << loaded;
    EXPECT_EQ(matching(loaded, kToolkits), Names{});
    EXPECT_EQ(matching(loaded, kQt5), Names{});
    EXPECT_EQ(matching(loaded, kHighGui), Names{});
    EXPECT_EQ(loaded.find("not found"), std::string::npos) << loaded;
    EXPECT_EQ(matching(loaded, kLoadedLater), Names{});
    EXPECT_LE(std::ranges::count(loaded, '\n'), kMostLibraries) << loaded;
    const std::string named = namedLibraries(TELETA_COMMANDS_PART);
    ASSERT_NE(named.find("libQt6Core"), std::string::npos) << named;
    EXPECT_EQ(matching(named, kDisplays), Names{});
}

#ifdef TELETA_CONSOLE_PROGRAM
TEST(ProgramsTest, consoleLoadsOneQtOnly) {
    const std::string loaded = loadedLibraries(TELETA_CONSOLE_PROGRAM);
    ASSERT_NE(loaded.find("libQt6Widgets"), std::string::npos) << loaded;
    EXPECT_EQ(matching(loaded, kQt5), Names{});
    EXPECT_EQ(matching(loaded, kHighGui), Names{});
    EXPECT_EQ(loaded.find("not found"), std::string::npos) << loaded;
    EXPECT_EQ(matching(loaded, kOfWriters), Names{});
    const std::string named = namedLibraries(TELETA_CONSOLE_PROGRAM);
    EXPECT_EQ(matching(named, kLoadedLater), Names{});
}
#endif

} // namespace
