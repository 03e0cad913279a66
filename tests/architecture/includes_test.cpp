// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/architecture/include_rules.h"

#include <gtest/gtest.h>

namespace teleta::architecture {
namespace {

constexpr char kTable[] = "packaging/cmake/module_graph.txt";

ModuleGraph readGraph() {
    ModuleGraph graph;
    const std::vector<SourceFile> tables = readFiles(TELETA_SOURCE_DIR, {"packaging"}, {"module_graph.txt"});
    if (tables.size() != 1)
        ADD_FAILURE() << kTable << " is missing";
    else
        EXPECT_EQ(describe(readModuleGraph(tables.front(), graph)), "");
    return graph;
}

const IncludeRules& rules() {
    static const IncludeRules rules(readGraph(), readQtModules(TELETA_QT_INCLUDES));
    return rules;
}

std::vector<SourceFile> sources() {
    return readFiles(TELETA_SOURCE_DIR, {"app", "widgets", "backend", "devices"}, {".cpp", ".h"});
}

std::vector<Violation> check(const std::string& path, const std::string& text) {
    return rules().forbiddenIncludes({path, splitLines(text)});
}

std::string reasonFor(const std::string& path, const std::string& line) {
    const std::vector<Violation> violations = check(path, line);
    return violations.empty() ? std::string() : violations.front().reason;
}

std::string complaintsAbout(const std::string& table) {
    ModuleGraph graph;
    std::vector<Violation> violations = readModuleGraph({"table", splitLines(table)}, graph);
    const std::vector<Violation> layers = againstTheLayers(graph);
    violations.insert(violations.end(), layers.begin(), layers.end());
    return describe(violations);
}

TEST(IncludesTest, keepsTheModuleGraphInEveryFile) {
    const std::vector<SourceFile> files = sources();
    ASSERT_GT(files.size(), 20U);
    std::vector<Violation> violations;
    for (const SourceFile& file : files) {
        const std::vector<Violation> found = rules().forbiddenIncludes(file);
        violations.insert(violations.end(), found.begin(), found.end());
    }
    EXPECT_TRUE(violations.empty()) << describe(violations) << "the table is " << kTable;
}

TEST(IncludesTest, usesEveryEdgeOfTheModuleGraph) {
    EXPECT_EQ(describe(rules().unusedEdges(sources())), "") << "the table is " << kTable;
}

TEST(ModuleGraphTest, keepsTheLayers) {
    EXPECT_EQ(describe(againstTheLayers(readGraph())), "");
}

TEST(ModuleGraphTest, forbidsEdgesAgainstTheLayers) {
    const std::string folders = "folder backend/a\nfolder devices/b\nfolder widgets/base\nfolder widgets/c\n"
                                "folder app/common\nfolder app/cli\n";
    EXPECT_EQ(complaintsAbout(folders), "");
    EXPECT_EQ(complaintsAbout(folders + "folder backend/d\n    uses devices/b\n"),
              "backend/d:0: must not use devices/b\n");
    EXPECT_EQ(complaintsAbout(folders + "folder widgets/d\n    uses widgets/base widgets/c\n"),
              "widgets/d:0: must not use widgets/c\n");
    EXPECT_EQ(complaintsAbout(folders + "folder widgets/c/part\n    uses widgets/c\n"), "");
    EXPECT_EQ(complaintsAbout(folders + "folder widgets/d\n    uses devices/b\n"),
              "widgets/d:0: must not use devices/b\n");
    EXPECT_EQ(complaintsAbout(folders + "folder app/cli/d\n    uses app/common devices/b widgets/c\n"),
              "app/cli/d:0: must not use widgets/c\n");
    EXPECT_EQ(complaintsAbout(folders + "folder app/python/d\n    uses app/common devices/b\n"),
              "app/python/d:0: must not use devices/b\n");
}

TEST(ModuleGraphTest, reportsTheLineThatIsNotUnderstood) {
    EXPECT_EQ(complaintsAbout("folder backend/a\n  uses backend/b\n"), "table:2: not understood\n");
    EXPECT_EQ(complaintsAbout("folder backend/a\n    uses backend/b\nfolder backend/b\n"),
              "table:2: backend/b has no row above\n");
    EXPECT_EQ(complaintsAbout("folder backend/a\n    libraries Eigen\n"),
              "table:2: Eigen is no library of the table\n");
}

TEST(IncludesTest, findsAnEdgeThatNothingUses) {
    ModuleGraph graph;
    ASSERT_TRUE(
        readModuleGraph({"table", splitLines("library Eigen\n    headers Eigen/\nfolder backend/a\n"
                                             "folder backend/b\n    uses backend/a\n    libraries Eigen\n")},
                        graph)
            .empty());
    const IncludeRules small(graph, {});
    EXPECT_EQ(describe(small.unusedEdges({{"backend/b/b.h", {"#include <Eigen/Core>"}}})),
              "backend/b:0: its row names backend/a, which it does not include\n");
}

TEST(IncludesTest, reportsThePlaceOfAPlantedViolation) {
    const std::vector<Violation> violations =
        check("backend/contact/planted.cpp", "#include \"backend/core/data/a.h\"\n"
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
    EXPECT_EQ(reasonFor("backend/pipeline/a.cpp", "#include \"backend/contact/taxels/b.h\""), "");
    EXPECT_EQ(reasonFor("widgets/view3d/a.cpp", "#include <vtkNew.h>"), "");
    EXPECT_EQ(reasonFor("widgets/charts/a.cpp", "#include \"widgets/base/b.h\""), "");
    EXPECT_EQ(reasonFor("app/console/operate/a.cpp", "#include \"widgets/view3d/b.h\""), "");
    EXPECT_EQ(reasonFor("app/console/a.cpp", "#include \"a.moc\""), "");
    EXPECT_EQ(reasonFor("devices/replay/a.cpp", "#include <QtCore/QString>"), "");
}

} // namespace
} // namespace teleta::architecture
