// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/architecture/include_rules.h"

#include <gtest/gtest.h>

namespace teleta::architecture {
namespace {

const QtModules& qtModules() {
    static const QtModules modules = readQtModules(TELETA_QT_INCLUDES);
    return modules;
}

std::vector<Violation> check(const std::string& path, const std::string& text) {
    return forbiddenIncludes({path, splitLines(text)}, qtModules());
}

std::string reasonFor(const std::string& path, const std::string& line) {
    const std::vector<Violation> violations = check(path, line);
    return violations.empty() ? std::string() : violations.front().reason;
}

TEST(IncludesTest, keepsTheModuleGraphInEveryFile) {
    const std::vector<SourceFile> files =
        readFiles(TELETA_SOURCE_DIR, {"app", "widgets", "backend", "devices"}, {".cpp", ".h"});
    ASSERT_GT(files.size(), 20U);
    std::vector<Violation> violations;
    for (const SourceFile& file : files) {
        const std::vector<Violation> found = forbiddenIncludes(file, qtModules());
        violations.insert(violations.end(), found.begin(), found.end());
    }
    EXPECT_TRUE(violations.empty()) << describe(violations);
}

TEST(IncludesTest, reportsThePlaceOfAPlantedViolation) {
    const std::vector<Violation> violations =
        check("backend/contact/planted.cpp", "#include \"backend/core/error.h\"\n"
                                             "\n"
                                             "#include <vector>\n"
                                             "  #  include <QString> // text\n"
                                             "// #include <QWidget>\n");
    EXPECT_EQ(describe(violations), "backend/contact/planted.cpp:4: backend/contact must not use QtCore\n");
}

TEST(IncludesTest, forbidsTheEdgesThatTheGraphDoesNotHave) {
    EXPECT_EQ(reasonFor("backend/core/a.h", "#include \"backend/contact/b.h\""),
              "backend/core must not use backend/contact");
    EXPECT_EQ(reasonFor("backend/pipeline/a.cpp", "#include \"devices/replay/b.h\""),
              "backend/pipeline must not use devices/replay");
    EXPECT_EQ(reasonFor("devices/replay/a.cpp", "#include \"backend/pipeline/b.h\""),
              "devices/replay must not use backend/pipeline");
    EXPECT_EQ(reasonFor("devices/replay/a.cpp", "#include \"devices/simulated/b.h\""),
              "devices/replay must not use devices/simulated");
    EXPECT_EQ(reasonFor("widgets/charts/a.cpp", "#include \"widgets/tactile/b.h\""),
              "widgets/charts must not use widgets/tactile");
    EXPECT_EQ(reasonFor("widgets/tactile/a.cpp", "#include \"devices/replay/b.h\""),
              "widgets/tactile must not use devices/replay");
    EXPECT_EQ(reasonFor("widgets/base/a.cpp", "#include \"app/console/b.h\""),
              "widgets/base must not use app/console");
    EXPECT_EQ(reasonFor("app/cli/a.cpp", "#include \"widgets/base/b.h\""),
              "app/cli must not use widgets/base");
    EXPECT_EQ(reasonFor("app/cli/a.cpp", "#include \"app/console/b.h\""), "app/cli must not use app/console");
}

TEST(IncludesTest, forbidsLibrariesOutsideTheirFolders) {
    EXPECT_EQ(reasonFor("backend/scene/a.cpp", "#include <QWidget>"), "backend/scene must not use QtWidgets");
    EXPECT_EQ(reasonFor("backend/scene/a.cpp", "#include <QtGui/QImage>"),
              "backend/scene must not use QtGui");
    EXPECT_EQ(reasonFor("backend/stiffness/a.cpp", "#include <toml++/toml.h>"),
              "backend/stiffness must not use toml++");
    EXPECT_EQ(reasonFor("widgets/charts/a.cpp", "#include <vtkActor.h>"), "widgets/charts must not use VTK");
    EXPECT_EQ(reasonFor("app/cli/a.cpp", "#include <qcustomplot.h>"), "app/cli must not use QCustomPlot");
    EXPECT_EQ(reasonFor("backend/contact/a.cpp", "#include <unistd.h>"),
              "backend/contact must not use posix");
    EXPECT_EQ(reasonFor("app/cli/a.cpp", "#include <boost/asio.hpp>"),
              "<boost/asio.hpp> is of no library that the table lists");
}

TEST(IncludesTest, forbidsPathsThatDoNotStartAtTheRoot) {
    EXPECT_NE(reasonFor("backend/core/a.cpp", "#include \"error.h\""), "");
    EXPECT_NE(reasonFor("backend/core/a.cpp", "#include \"../contact/b.h\""), "");
    EXPECT_NE(reasonFor("backend/core/a.cpp", "#include \"tests/backend/core/b.h\""), "");
}

TEST(IncludesTest, forbidsAFolderThatTheTableDoesNotName) {
    EXPECT_NE(reasonFor("backend/fresh/a.cpp", ""), "");
    EXPECT_NE(reasonFor("backend/a.cpp", ""), "");
    EXPECT_NE(reasonFor("backend/corelike/a.cpp", ""), "");
}

TEST(IncludesTest, allowsTheEdgesThatTheGraphHas) {
    EXPECT_EQ(reasonFor("backend/simulation/effects/a.cpp", "#include \"backend/simulation/effects/b.h\""),
              "");
    EXPECT_EQ(reasonFor("backend/pipeline/a.cpp", "#include \"backend/contact/b.h\""), "");
    EXPECT_EQ(reasonFor("widgets/view3d/a.cpp", "#include <vtkNew.h>"), "");
    EXPECT_EQ(reasonFor("widgets/charts/a.cpp", "#include \"widgets/base/b.h\""), "");
    EXPECT_EQ(reasonFor("app/console/a.cpp", "#include \"widgets/view3d/b.h\""), "");
    EXPECT_EQ(reasonFor("app/console/a.cpp", "#include \"a.moc\""), "");
    EXPECT_EQ(reasonFor("devices/replay/a.cpp", "#include <QtCore/QString>"), "");
}

} // namespace
} // namespace teleta::architecture
