// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/view3d/empty_scene.h"
#include "tests/widgets/view3d/touch_examples.h"
#include "widgets/base/theme.h"
#include "widgets/view3d/mesh/geometry_export.h"
#include "widgets/view3d/scene/frame_part.h"
#include "widgets/view3d/scene/touch_scene.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QtEndian>

#include <gtest/gtest.h>
#include <vtkActorCollection.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkTexture.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <set>
#include <vector>

using namespace teleta;
using view3d::Surface;
using view3d::TouchScene;

namespace {

constexpr core::ArrayLayout kLayout{.rows = 6, .columns = 14, .pitchX_m = 0.0034};

std::set<vtkObject*> objectsOf(const TouchScene& scene) {
    std::set<vtkObject*> objects;
    vtkActorCollection* actors = scene.renderer()->GetActors();
    actors->InitTraversal();
    while (vtkActor* actor = actors->GetNextActor()) {
        auto* mesh = vtkPolyData::SafeDownCast(actor->GetMapper()->GetInputDataObject(0, 0));
        objects.insert({actor, actor->GetMapper(), mesh, mesh->GetPoints(), mesh->GetPoints()->GetData(),
                        mesh->GetPointData()->GetScalars()});
    }
    return objects;
}

} // namespace

TEST(TouchScene, snapshotsChangeArraysAndMakeNoNewObjects) {
    TouchScene scene = test::emptyScene();
    scene.take(test::pressed(kLayout, {{1, 0.0, 0.0, 1.0}}, 1));
    EXPECT_TRUE(scene.draw()) << "a new layout changes the shape of the scene";
    const std::set<vtkObject*> before = objectsOf(scene);
    EXPECT_EQ(scene.take(test::pressed(kLayout, {{1, 0.01, 0.0, 2.0}, {2, -0.01, 0.0, 1.0}}, 2)),
              TouchScene::Taken::fresh);
    EXPECT_FALSE(scene.draw());
    EXPECT_EQ(objectsOf(scene), before);
}

TEST(TouchScene, drawsNothingWhereTheArrayHasNoTaxel) {
    static constexpr core::ArrayLayout kCross{.rows = 3, .columns = 3, .pitchX_m = 0.007};
    const auto facesOf = [](const core::TaxelLayout& layout) {
        TouchScene scene = test::emptyScene();
        auto snapshot = test::pressed(kCross, {});
        snapshot.layout = layout;
        scene.take(snapshot);
        scene.draw();
        vtkIdType faces = 0;
        for (vtkObject* object : objectsOf(scene))
            if (auto* mesh = vtkPolyData::SafeDownCast(object))
                faces += mesh->GetNumberOfPolys();
        return faces;
    };
    core::TaxelLayout cross(kCross);
    cross.setAbsent({1, 0, 1, 0, 0, 0, 1, 0, 1});
    constexpr vtkIdType kFacesOfCell = 5;
    EXPECT_EQ(facesOf(kCross) - facesOf(cross), 4 * kFacesOfCell);
}

/// The border of a cell is in its texture: the middle of it has none.
TEST(TouchScene, discsHaveNoBordersOfCells) {
    const auto placesInTexture = [](const core::TaxelLayout& layout) {
        TouchScene scene = test::emptyScene();
        pipeline::TouchSnapshot snapshot;
        snapshot.layout = layout;
        snapshot.load_N.assign(layout.taxels(), 0.0F);
        scene.take(snapshot);
        scene.draw();
        std::set<double> places;
        for (vtkObject* object : objectsOf(scene)) {
            auto* mesh = vtkPolyData::SafeDownCast(object);
            vtkDataArray* all = mesh != nullptr ? mesh->GetPointData()->GetTCoords() : nullptr;
            for (vtkIdType i = 0; all != nullptr && i < all->GetNumberOfTuples(); ++i)
                places.insert(all->GetComponent(i, 0));
        }
        return places;
    };
    EXPECT_EQ(placesInTexture(kLayout), (std::set<double>{0.0, 0.5, 1.0}));
    const core::TaxelLayout discs(std::make_shared<const core::TaxelPlaces>(
        std::vector<core::TaxelPlace>{{-0.005, -0.004}, {0.005, -0.004}, {0.0, 0.006}}));
    EXPECT_EQ(placesInTexture(discs), std::set<double>{0.5});
}

TEST(TouchScene, theSameFrameIsNotDrawnTwice) {
    TouchScene scene = test::emptyScene();
    const auto snapshot = test::pressed(kLayout, {{1, 0.0, 0.0, 1.0}}, 7);
    EXPECT_EQ(scene.take(snapshot), TouchScene::Taken::fresh);
    EXPECT_EQ(scene.take(snapshot), TouchScene::Taken::same);
}

TEST(TouchScene, framesThatDoNotFitTheirLayoutAreRefused) {
    TouchScene scene = test::emptyScene();
    auto snapshot = test::pressed(kLayout, {});
    snapshot.load_N.pop_back();
    EXPECT_EQ(scene.take(snapshot), TouchScene::Taken::refused);
    snapshot = test::pressed(kLayout, {});
    snapshot.dead.resize(3);
    EXPECT_EQ(scene.take(snapshot), TouchScene::Taken::refused);
    for (const core::ArrayLayout layout : {core::ArrayLayout{.rows = 0, .columns = 14, .pitchX_m = 0.0034},
                                           {.rows = 6, .columns = 1025, .pitchX_m = 0.0034},
                                           {.rows = 6, .columns = 14, .pitchX_m = 0.0},
                                           {.rows = 6, .columns = 14, .pitchX_m = std::nan("")}}) {
        snapshot = test::pressed(kLayout, {});
        snapshot.layout = layout;
        EXPECT_EQ(scene.take(snapshot), TouchScene::Taken::refused);
    }
    EXPECT_TRUE(scene.isEmpty());
}

TEST(TouchScene, aMarkSitsOnThePeakAndItsArrowIsAsLongAsItsForceSays) {
    TouchScene scene = test::emptyScene();
    const auto snapshot = test::pressed(kLayout, {{1, 0.01, 0.002, 1.0}, {2, -0.01, 0.0, 0.5}});
    scene.take(snapshot);
    scene.draw();
    ASSERT_EQ(scene.marks().size(), 2U);
    const view3d::SensorSize& size = scene.sensorSize();
    for (const view3d::ContactMark& mark : scene.marks()) {
        EXPECT_DOUBLE_EQ(mark.p_Sensor_Foot.x(), mark.contact.x_m);
        EXPECT_DOUBLE_EQ(mark.p_Sensor_Foot.y(), mark.contact.y_m);
        EXPECT_NEAR(mark.p_Sensor_Foot.z(),
                    size.tile_m + size.rise_m * mark.contact.peak_N / scene.loadRange_N(), 1e-12);
        const Eigen::Vector3d arrow = mark.p_Sensor_Tail - mark.p_Sensor_Foot;
        EXPECT_NEAR(arrow.z(), size.mark_m + size.arrow_m * mark.contact.force_N / scene.forceRange_N(),
                    1e-12);
        EXPECT_NEAR(arrow.head<2>().norm(), 0.0, 1e-12);
    }
}

TEST(TouchScene, onTheCylinderTheMarkIsWhereTheMapSaysAndTheArrowAlongTheNormal) {
    TouchScene scene = test::emptyScene();
    scene.setSurface(Surface::cylinder);
    scene.take(test::pressed(kLayout, {{1, 0.01, 0.008, 1.0}}));
    scene.draw();
    ASSERT_EQ(scene.marks().size(), 1U);
    const view3d::ContactMark& mark = scene.marks().front();
    const double angle = 0.008 / 0.025;
    const Eigen::Vector3d normal(0.0, std::sin(angle), std::cos(angle));
    EXPECT_NEAR(mark.p_Sensor_Foot.x(), 0.01, 1e-12);
    EXPECT_NEAR(mark.p_Sensor_Foot.dot(normal), mark.p_Sensor_Foot.tail<2>().norm(), 1e-12);
    EXPECT_GT(mark.p_Sensor_Foot.dot(normal), 0.025);
    EXPECT_NEAR((mark.p_Sensor_Tail - mark.p_Sensor_Foot).normalized().dot(normal), 1.0, 1e-12);
}

TEST(TouchScene, aContactOverTheSeamHasOneMarkWithTheForceOfItsParts) {
    TouchScene scene = test::emptyScene();
    scene.setSurface(Surface::cylinder);
    const auto apart = test::pressed(kLayout, {{1, 0.01, 0.0085, 1.0}, {2, 0.01, -0.0085, 0.5}});
    auto joined = apart;
    joined.contacts[1].id = 1;
    joined.frame = apart.frame + 1;
    scene.take(apart);
    scene.draw();
    ASSERT_EQ(scene.marks().size(), 2U);
    scene.take(joined);
    scene.draw();
    ASSERT_EQ(scene.marks().size(), 1U);
    const contact::Contact& whole = scene.marks().front().contact;
    EXPECT_DOUBLE_EQ(whole.force_N, apart.contacts[0].force_N + apart.contacts[1].force_N);
    EXPECT_DOUBLE_EQ(whole.area_m2, apart.contacts[0].area_m2 + apart.contacts[1].area_m2);
    EXPECT_DOUBLE_EQ(whole.y_m, apart.contacts[0].y_m) << "where the strongest part is";
}

TEST(TouchScene, loadsOfAnyMagnitudeFillTheSameHeights) {
    for (const double unit : {1e-12, 1.0, 1e12}) {
        TouchScene scene = test::emptyScene();
        auto snapshot = test::pressed(kLayout, {{1, 0.0, 0.0, 1.0}});
        for (float& load : snapshot.load_N) {
            load = static_cast<float>(static_cast<double>(load) * unit);
        }
        snapshot.threshold_N *= unit;
        snapshot.contacts.front().force_N *= unit;
        snapshot.contacts.front().peak_N *= unit;
        scene.take(snapshot);
        scene.draw();
        EXPECT_GE(scene.loadRange_N(), snapshot.contacts.front().peak_N);
        EXPECT_LE(scene.loadRange_N(), 2.0 * snapshot.contacts.front().peak_N);
        const auto z = scene.marks().front().p_Sensor_Foot.z();
        EXPECT_GT(z, 0.5 * scene.sensorSize().rise_m);
        EXPECT_LE(z, scene.sensorSize().tile_m + scene.sensorSize().rise_m);
    }
}

TEST(TouchScene, contactsThatAreNotFiniteAreLeftOut) {
    TouchScene scene = test::emptyScene();
    auto snapshot = test::pressed(kLayout, {{1, 0.0, 0.0, 1.0}, {2, 0.01, 0.0, 0.5}});
    snapshot.contacts.front().x_m = std::numeric_limits<double>::quiet_NaN();
    snapshot.load_N[5] = std::numeric_limits<float>::infinity();
    snapshot.load_N[6] = std::numeric_limits<float>::quiet_NaN();
    scene.take(snapshot);
    scene.draw();
    ASSERT_EQ(scene.marks().size(), 1U);
    EXPECT_TRUE(std::isfinite(scene.loadRange_N()));
}

TEST(TouchScene, linksAndPointsThatAreNotFiniteAreLeftOut) {
    TouchScene scene = test::emptyScene();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<Eigen::Vector3d> points = {{0, 0, 0}, {nan, 0, 0}, {1, 2, 0}};
    scene.setContour(points, points, {});
    EXPECT_EQ(scene.contourBox_m().max(), Eigen::Vector3d(1, 2, 0));
    std::vector<view3d::ArmLink> links(3);
    links[0].length_m = 0.2;
    links[0].radius_m = 0.01;
    links[1].length_m = nan;
    links[2].length_m = 0.2; // no radius
    scene.setArmLinks(links);
    // A tube along x from the origin, with room for the joint's ball of 1.25 radii.
    EXPECT_LT((scene.armBox_m().min() - Eigen::Vector3d(-0.0125, -0.0125, -0.0125)).norm(), 1e-12);
    EXPECT_LT((scene.armBox_m().max() - Eigen::Vector3d(0.2125, 0.0125, 0.0125)).norm(), 1e-12);
    scene.setArmLinks({});
    scene.setContour({}, {}, {});
    EXPECT_TRUE(scene.isEmpty());
    EXPECT_FALSE(scene.corners().empty());
}

TEST(TouchScene, objectsThatWereFoundBeforeAreDrawnAndCovered) {
    TouchScene scene = test::emptyScene();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<view3d::DrawnObject> objects{
        {1, QStringLiteral("1"), {{0, 0, 0}, {0.1, 0, 0}, {nan, 0, 0}}, {{0, 0, 0}, {0.1, 0, 0}}},
        {2, QStringLiteral("2"), {{nan, 0, 0}}, {}}};
    EXPECT_TRUE(scene.isEmpty());
    scene.setObjects(objects);
    EXPECT_FALSE(scene.isEmpty());
    ASSERT_EQ(scene.objects().objects().size(), 1U);
    EXPECT_EQ(scene.objects().objects()[0].points_m.size(), 2U);
    EXPECT_EQ(scene.objects().box_m().max(), Eigen::Vector3d(0.1, 0, 0));
    EXPECT_EQ(scene.worldMeshes().size(), 2U);
    scene.setObjects({});
    EXPECT_TRUE(scene.isEmpty());
    EXPECT_TRUE(scene.worldMeshes().empty());
}

TEST(TouchScene, aRobotTakesThePlaceOfTheTubes) {
    TouchScene scene = test::emptyScene();
    view3d::ArmLink link;
    link.length_m = 0.3;
    link.radius_m = 0.03;
    scene.setArmLinks(std::vector{link});
    const auto tubes = scene.worldMeshes().size();
    auto shape = std::make_shared<view3d::RobotShape>();
    shape->links = {view3d::boxMesh({0.2, 0.2, 0.2}), {}, view3d::boxMesh({0.1, 0.1, 0.1})};
    scene.setRobot(shape);
    // Nobody said where its links are.
    EXPECT_FALSE(scene.robot().isShown());
    EXPECT_EQ(scene.worldMeshes().size(), tubes);

    std::vector<Eigen::Isometry3d> poses(3, Eigen::Isometry3d::Identity());
    poses[2].translation() = Eigen::Vector3d(1.0, 0.0, 0.0);
    scene.setRobotPoses(poses, {});
    ASSERT_TRUE(scene.robot().isShown());
    EXPECT_FALSE(scene.robot().ghostShown());
    EXPECT_LT((scene.armBox_m().max() - Eigen::Vector3d(1.05, 0.1, 0.1)).norm(), 1e-6);
    EXPECT_LT((scene.armBox_m().min() - Eigen::Vector3d(-0.1, -0.1, -0.1)).norm(), 1e-6);
    // The two links that have a shape, where they are; the tubes are gone.
    const auto meshes = scene.worldMeshes();
    ASSERT_EQ(meshes.size(), 2U);
    EXPECT_NEAR(meshes[1]->GetBounds()[0], 0.95, 1e-6);

    std::vector<Eigen::Isometry3d> commanded = poses;
    commanded[2].translation() = Eigen::Vector3d(0.0, 2.0, 0.0);
    scene.setRobotPoses(poses, commanded);
    EXPECT_TRUE(scene.robot().ghostShown());
    EXPECT_LT(scene.armBox_m().max().y(), 0.2) << "the view is not fitted to a ghost";
    EXPECT_EQ(scene.worldMeshes().size(), 2U) << "a ghost is not data";

    // Poses that cannot be drawn.
    commanded.pop_back();
    scene.setRobotPoses(poses, commanded);
    EXPECT_TRUE(scene.robot().isShown());
    EXPECT_FALSE(scene.robot().ghostShown());
    poses[0].translation().x() = std::numeric_limits<double>::quiet_NaN();
    scene.setRobotPoses(poses, {});
    EXPECT_FALSE(scene.robot().isShown());
    EXPECT_EQ(scene.worldMeshes().size(), tubes);
    scene.setRobot(nullptr);
    EXPECT_EQ(scene.worldMeshes().size(), tubes);
}

TEST(TouchScene, theArmStandsOnABaseWhereThereIsGroundBelowIt) {
    TouchScene scene = test::emptyScene();
    view3d::ArmLink link;
    link.X_World_Link = Eigen::Isometry3d(Eigen::Translation3d(0.0, 0.0, 0.5));
    link.length_m = 0.3;
    link.radius_m = 0.03;
    scene.setArmLinks(std::vector{link});
    scene.setContour(std::vector<Eigen::Vector3d>{{0.2, 0.0, 0.0}}, {}, {}); // the ground is at or below 0
    double low_m = 1.0;
    for (const auto& mesh : scene.worldMeshes())
        low_m = std::min(low_m, mesh->GetBounds()[4]);
    EXPECT_LE(low_m, 0.0);
    // The camera is fitted to what was measured, not to the base.
    EXPECT_NEAR(scene.armBox_m().min().z(), 0.5 - 1.25 * 0.03, 1e-12);
}

TEST(TouchScene, theShadowOnTheGroundFallsToNothingInSmallSteps) {
    TouchScene scene = test::emptyScene();
    std::vector<view3d::ArmLink> links(1);
    links[0].X_World_Link = Eigen::Translation3d(0.0, 0.0, 0.3);
    links[0].length_m = 0.25;
    links[0].radius_m = 0.02;
    scene.setArmLinks(links);
    scene.draw();
    vtkPolyData* shadow = nullptr;
    vtkActorCollection* actors = scene.renderer()->GetActors();
    actors->InitTraversal();
    while (vtkActor* actor = actors->GetNextActor()) {
        auto* mesh = vtkPolyData::SafeDownCast(actor->GetMapper()->GetInputDataObject(0, 0));
        vtkDataArray* colours = mesh->GetPointData()->GetScalars();
        if (mesh->GetNumberOfPolys() > 0 && colours != nullptr && colours->GetNumberOfComponents() == 4 &&
            colours->GetRange(0)[1] == 0.0)
            shadow = mesh; // black
    }
    ASSERT_NE(shadow, nullptr);
    vtkDataArray* colours = shadow->GetPointData()->GetScalars();
    const auto alpha = [&](vtkIdType point) { return colours->GetComponent(point, 3); };
    double least = 255.0;
    double most = 0.0;
    double largestStep = 0.0;
    for (vtkIdType cell = 0; cell < shadow->GetNumberOfCells(); ++cell) {
        vtkIdType count = 0;
        const vtkIdType* points = nullptr;
        shadow->GetCellPoints(cell, count, points);
        for (vtkIdType i = 0; i < count; ++i) {
            least = std::min(least, alpha(points[i]));
            most = std::max(most, alpha(points[i]));
            largestStep = std::max(largestStep, std::abs(alpha(points[i]) - alpha(points[(i + 1) % count])));
        }
    }
    EXPECT_EQ(least, 0.0);
    EXPECT_GT(most, 40.0);
    EXPECT_LT(largestStep, 0.2 * most) << "within one quad, over which it is blended";
}

// Mesa's software driver reads such a texture in a loop as long as the cell's side is steep: frames of 380 ms
// in scene3d_frame_benchmark, 20 ms without.
TEST(TouchScene, theGridOfTheSkinIsNotFilteredByDirection) {
    TouchScene scene = test::emptyScene();
    int textures = 0;
    vtkActorCollection* actors = scene.renderer()->GetActors();
    actors->InitTraversal();
    while (vtkActor* actor = actors->GetNextActor()) {
        if (vtkTexture* texture = actor->GetTexture()) {
            ++textures;
            EXPECT_TRUE(texture->GetMipmap());
            EXPECT_EQ(texture->GetMaximumAnisotropicFiltering(), 1.0F);
        }
    }
    EXPECT_EQ(textures, 1);
}

TEST(GeometryExport, aStlFileHoldsTheTrianglesOfThePlateInMillimetres) {
    TouchScene scene = test::emptyScene();
    auto snapshot = test::pressed(kLayout, {});
    scene.take(snapshot);
    scene.draw();
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("plate.stl"));
    ASSERT_TRUE(view3d::exportGeometry(scene.worldMeshes(), path));
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    const QByteArray bytes = file.readAll();
    // Binary STL: 80 bytes of header, a count, 50 bytes each. Boxes without a floor: 5 quads; a slab: 6
    // quads.
    const auto triangles = qFromLittleEndian<quint32>(bytes.constData() + 80);
    EXPECT_EQ(triangles, 84U * 10U + 12U);
    ASSERT_EQ(bytes.size(), 84 + 50 * static_cast<qsizetype>(triangles));
    float largest = 0.0F;
    for (quint32 i = 0; i < triangles; ++i) {
        for (int corner = 0; corner < 3; ++corner) {
            const char* at = bytes.constData() + 84 + 50 * static_cast<qsizetype>(i) + 12 + 12 * corner;
            largest = std::max(largest, qFromLittleEndian<float>(at));
        }
    }
    EXPECT_NEAR(static_cast<double>(largest), 0.5 * 14 * 3.4, 1e-4);
}

TEST(GeometryExport, aVtpFileReadsBackWithColoursInThePlaceOfThePose) {
    TouchScene scene = test::emptyScene();
    scene.take(test::pressed(kLayout, {{1, 0.01, 0.0, 1.0}}));
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.translation() = Eigen::Vector3d(1.0, 2.0, 3.0);
    scene.setSensorPose(pose);
    scene.draw();
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("touch.vtp"));
    ASSERT_TRUE(view3d::exportGeometry(scene.worldMeshes(), path));
    const vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(QFile::encodeName(path).constData());
    reader->Update();
    vtkPolyData* read = reader->GetOutput();
    double bounds[6];
    read->GetBounds(bounds);
    EXPECT_GT(bounds[0], 1000.0 - 25.0);
    EXPECT_LT(bounds[1], 1000.0 + 25.0);
    EXPECT_GT(bounds[4], 3000.0 - 5.0);
    ASSERT_NE(read->GetPointData()->GetArray("colour"), nullptr);
    EXPECT_GT(read->GetNumberOfLines(), 0);
    EXPECT_NE(read->GetFieldData()->GetAbstractArray("length_unit"), nullptr);
    EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files), QStringList(QStringLiteral("touch.vtp")));
}

TEST(GeometryExport, aPlyFileNamesItsColours) {
    TouchScene scene = test::emptyScene();
    scene.take(test::pressed(kLayout, {{1, 0.01, 0.0, 1.0}}));
    scene.draw();
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("touch.ply"));
    const auto written = view3d::exportGeometry(scene.worldMeshes(), path);
    ASSERT_TRUE(written) << core::describe(written.error());
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    const QByteArray header = file.read(2000);
    EXPECT_TRUE(header.startsWith("ply\n"));
    EXPECT_TRUE(header.contains("property uchar red")) << header.toStdString();
}

TEST(GeometryExport, errorsSayWhatIsWrongAndLeaveNoFile) {
    TouchScene scene = test::emptyScene();
    scene.take(test::pressed(kLayout, {}));
    scene.draw();
    const QTemporaryDir folder;
    const auto unknown =
        view3d::exportGeometry(scene.worldMeshes(), folder.filePath(QStringLiteral("a.obj")));
    ASSERT_FALSE(unknown);
    EXPECT_EQ(unknown.error().kind, core::ErrorKind::badInput);
    const auto empty = view3d::exportGeometry({}, folder.filePath(QStringLiteral("a.stl")));
    ASSERT_FALSE(empty);
    EXPECT_EQ(empty.error().kind, core::ErrorKind::badInput);
    for (const char* name : {"no/such/folder/a.vtp", "no/such/folder/a.ply", "no/such/folder/a.stl"}) {
        const QString path = folder.filePath(QLatin1String(name));
        const auto lost = view3d::exportGeometry(scene.worldMeshes(), path);
        ASSERT_FALSE(lost) << name;
        EXPECT_EQ(lost.error().kind, core::ErrorKind::ioFailed);
        EXPECT_EQ(lost.error().where.file, path.toStdString());
    }
    EXPECT_TRUE(QDir(folder.path()).isEmpty());
}

TEST(TouchScene, theGridOfALargeSceneIsNotKeptUnderASmallOne) {
    view3d::GridPart grid;
    const auto box = [](double side_m) {
        return Eigen::AlignedBox3d(Eigen::Vector3d::Constant(-0.5 * side_m),
                                   Eigen::Vector3d::Constant(0.5 * side_m));
    };
    EXPECT_TRUE(grid.cover(box(1.0), false));
    EXPECT_DOUBLE_EQ(grid.spacing_m(), 0.2);
    EXPECT_FALSE(grid.cover(box(0.9), false)) << "an arm moves";
    EXPECT_TRUE(grid.cover(box(0.048), false)) << "an array";
    EXPECT_DOUBLE_EQ(grid.spacing_m(), 0.01);
}
