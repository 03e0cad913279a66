// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes that others wrote: STL by VTK, Collada and OBJ by hand after their specifications.
#include "tests/backend/core/temporary_folder.h"
#include "tests/widgets/view3d/robot/mesh_measures.h"
#include "widgets/view3d/robot/mesh_file.h"

#include <gtest/gtest.h>
#include <vtkCubeSource.h>
#include <vtkNew.h>
#include <vtkSTLWriter.h>
#include <vtkTriangleFilter.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace teleta::view3d {
namespace {

std::string writeStl(const test::TemporaryFolder& folder, bool binary) {
    const vtkNew<vtkCubeSource> cube;
    cube->SetBounds(0.0, 0.1, 0.0, 0.2, 0.0, 0.3);
    const vtkNew<vtkTriangleFilter> triangles;
    triangles->SetInputConnection(cube->GetOutputPort());
    const vtkNew<vtkSTLWriter> writer;
    const std::string path = folder.path("cube.stl");
    writer->SetFileName(path.c_str());
    writer->SetInputConnection(triangles->GetOutputPort());
    binary ? writer->SetFileTypeToBinary() : writer->SetFileTypeToASCII();
    EXPECT_EQ(writer->Write(), 1);
    return path;
}

/// A tetrahedron with corners at 0 and at 1 unit along each axis, in red, moved by 2 units along x by its
/// node.
std::string collada(const std::string& asset) {
    return R"(<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
 <asset>)" +
           asset + R"(</asset>
 <library_effects><effect id="fx"><profile_COMMON><technique sid="t"><lambert>
   <diffuse><color>1 0 0 1</color></diffuse></lambert></technique></profile_COMMON></effect></library_effects>
 <library_materials><material id="red"><instance_effect url="#fx"/></material></library_materials>
 <library_geometries><geometry id="g"><mesh>
  <source id="p"><float_array id="pa" count="12">0 0 0 1 0 0 0 1 0 0 0 1</float_array>
   <technique_common><accessor source="#pa" count="4" stride="3">
    <param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/>
   </accessor></technique_common></source>
  <vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
  <triangles count="4" material="m"><input semantic="VERTEX" source="#v" offset="0"/>
   <p>0 2 1 0 1 3 0 3 2 1 2 3</p></triangles>
 </mesh></geometry></library_geometries>
 <library_visual_scenes><visual_scene id="s"><node id="n"><translate>2 0 0</translate>
  <instance_geometry url="#g"><bind_material><technique_common>
   <instance_material symbol="m" target="#red"/></technique_common></bind_material></instance_geometry>
 </node></visual_scene></library_visual_scenes>
 <scene><instance_visual_scene url="#s"/></scene>
</COLLADA>
)";
}

std::string errorOf(const core::Expected<TriangleMesh>& mesh) {
    return mesh ? std::string() : core::describe(mesh.error());
}

} // namespace

TEST(MeshFile, stlOfAnotherProgram) {
    for (const bool binary : {true, false}) {
        const test::TemporaryFolder folder;
        const auto mesh = readMesh(writeStl(folder, binary));
        ASSERT_TRUE(mesh) << core::describe(mesh.error());
        EXPECT_EQ(mesh->triangles(), 12U);
        EXPECT_NEAR(volume_m3(*mesh), 0.1 * 0.2 * 0.3, 1e-9);
        EXPECT_TRUE(normalsLookOut(*mesh));
        EXPECT_TRUE(boxOf(*mesh).isApprox(
            Eigen::AlignedBox3d(Eigen::Vector3d::Zero().eval(), Eigen::Vector3d(0.1, 0.2, 0.3)), 1e-6));
        // STL has no colours.
        for (const QRgb colour : mesh->colours)
            EXPECT_EQ(qAlpha(colour), 0);
    }
}

TEST(MeshFile, collada) {
    const test::TemporaryFolder folder;
    // Whatever is up: robots' descriptions have z up, and so do the programs that show them.
    for (const char* up : {"Z_UP", "Y_UP"}) {
        const std::string path = folder.write(
            "link.dae",
            collada(std::string("<unit name=\"millimeter\" meter=\"0.001\"/><up_axis>") + up + "</up_axis>"));
        const auto mesh = readMesh(path);
        ASSERT_TRUE(mesh) << core::describe(mesh.error());
        EXPECT_EQ(mesh->triangles(), 4U);
        EXPECT_NEAR(volume_m3(*mesh), 1e-9 / 6.0, 1e-15) << up;
        EXPECT_TRUE(boxOf(*mesh).isApprox(
            Eigen::AlignedBox3d(Eigen::Vector3d(2e-3, 0.0, 0.0), Eigen::Vector3d(3e-3, 1e-3, 1e-3)), 1e-6))
            << up;
        for (const QRgb colour : mesh->colours)
            EXPECT_EQ(colour, qRgb(255, 0, 0));
    }
}

TEST(MeshFile, objWithFaces) {
    const test::TemporaryFolder folder;
    const auto mesh = readMesh(folder.write("LINK.OBJ", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                                                        "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"));
    ASSERT_TRUE(mesh) << core::describe(mesh.error());
    EXPECT_NEAR(volume_m3(*mesh), 1.0 / 6.0, 1e-7);
}

TEST(MeshFile, badFilesAreNamed) {
    const test::TemporaryFolder folder;
    EXPECT_NE(errorOf(readMesh(folder.path("none.stl"))).find("none.stl: the mesh is missing"),
              std::string::npos);
    EXPECT_NE(errorOf(readMesh(folder.write("link.step", "ISO-10303-21;"))).find("STL, DAE and OBJ"),
              std::string::npos);
    for (const char* name : {"link.stl", "link.dae", "link.obj"})
        for (const std::string& text :
             {std::string(), std::string("not a mesh"), std::string("\0\0\xff\xff", 4)}) {
            const std::string error = errorOf(readMesh(folder.write(name, text)));
            EXPECT_NE(error.find("the mesh cannot be read"), std::string::npos) << name << error;
            EXPECT_NE(error.find(name), std::string::npos) << error;
        }
    // Cut off in the middle.
    const std::string whole = writeStl(folder, true);
    std::filesystem::resize_file(whole, std::filesystem::file_size(whole) / 2);
    EXPECT_FALSE(readMesh(whole));
    EXPECT_FALSE(readMesh(folder.write("cut.dae", collada("").substr(0, 700))));
    EXPECT_FALSE(readMesh(folder.write("nan.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")));
}

TEST(MeshFile, onlyTheFolderIsRead) {
    const auto path = meshPath("package://robot_description/meshes/link.stl", "/meshes");
    ASSERT_TRUE(path);
    EXPECT_EQ(*path, "/meshes/robot_description/meshes/link.stl");
    ASSERT_TRUE(meshPath("link.stl", "/meshes"));
    EXPECT_EQ(*meshPath("link.stl", "/meshes"), "/meshes/link.stl");
    for (const char* name : {"", "package://", "/etc/passwd", "file:///etc/passwd", "http://host/link.stl",
                             "package://robot/../../link.stl", "../link.stl", "package:///etc/passwd"})
        EXPECT_EQ(meshPath(name, "/meshes").error().kind, core::ErrorKind::refused) << name;
    EXPECT_EQ(meshPath("package://robot/link.stl", "").error().kind, core::ErrorKind::notFound);
}

} // namespace teleta::view3d
