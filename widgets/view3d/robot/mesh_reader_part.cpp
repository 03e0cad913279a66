// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/robot/mesh_reader.h"

#include <algorithm>
#include <assimp/config.h>
#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <cmath>
#include <exception>
#include <span>

namespace {

using teleta::view3d::TriangleMesh;

/// Edges that are sharper stay edges.
constexpr float kSmooth_deg = 40.0F;

QRgb colourOf(const aiScene& scene, const aiMesh& part) {
    aiColor4D colour;
    // An STL file has a material that the library makes up.
    if (part.mMaterialIndex >= scene.mNumMaterials)
        return qRgba(0, 0, 0, 0);
    const aiMaterial& material = *scene.mMaterials[part.mMaterialIndex];
    aiString name;
    if (material.Get(AI_MATKEY_NAME, name) == AI_SUCCESS && name == aiString(AI_DEFAULT_MATERIAL_NAME))
        return qRgba(0, 0, 0, 0);
    if (aiGetMaterialColor(&material, AI_MATKEY_COLOR_DIFFUSE, &colour) != AI_SUCCESS)
        return qRgba(0, 0, 0, 0);
    const auto level = [](float value) {
        return static_cast<int>(
            std::lround(255.0F * std::clamp(std::isfinite(value) ? value : 0.0F, 0.0F, 1.0F)));
    };
    return qRgba(level(colour.r), level(colour.g), level(colour.b), 255);
}

bool append(const aiScene& scene, const aiMesh& part, TriangleMesh& mesh, std::string& why) {
    const auto first = static_cast<std::uint32_t>(mesh.points_m.size());
    const QRgb colour = colourOf(scene, part);
    for (unsigned i = 0; i < part.mNumVertices; ++i) {
        const aiVector3D& point = part.mVertices[i];
        const aiVector3D normal = part.HasNormals() ? part.mNormals[i] : aiVector3D(0.0F, 0.0F, 1.0F);
        if (!std::isfinite(point.x) || !std::isfinite(point.y) || !std::isfinite(point.z)) {
            why = "a corner is not finite";
            return false;
        }
        const bool isDirection = std::isfinite(normal.SquareLength()) && normal.SquareLength() > 0.0F;
        mesh.points_m.emplace_back(point.x, point.y, point.z);
        mesh.normals.emplace_back(isDirection ? Eigen::Vector3f(normal.x, normal.y, normal.z).normalized()
                                              : Eigen::Vector3f::UnitZ());
        mesh.colours.push_back(colour);
    }
    for (const aiFace& face : std::span(part.mFaces, part.mNumFaces))
        if (face.mNumIndices == 3)
            for (const unsigned corner : std::span(face.mIndices, 3))
                mesh.corners.push_back(first + corner);
    return true;
}

bool readWith(Assimp::Importer& importer, const char* path, std::size_t mostTriangles, TriangleMesh& mesh,
              std::string& why) {
    // Robots' files are in the frame of their link whatever they say is up (REP-103; as rviz takes them).
    importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
    importer.SetPropertyFloat(AI_CONFIG_PP_GSN_MAX_SMOOTHING_ANGLE, kSmooth_deg);
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    const aiScene* scene =
        importer.ReadFile(path, aiProcess_Triangulate | aiProcess_DropNormals | aiProcess_GenSmoothNormals |
                                    aiProcess_JoinIdenticalVertices | aiProcess_SortByPType |
                                    aiProcess_PreTransformVertices | aiProcess_ValidateDataStructure);
    if (scene == nullptr) {
        why = importer.GetErrorString();
        return false;
    }
    const std::span<aiMesh* const> parts(scene->mMeshes, scene->mNumMeshes);
    std::size_t triangles = 0;
    for (const aiMesh* part : parts)
        triangles += part->mNumFaces;
    if (triangles > mostTriangles) {
        why =
            std::to_string(triangles) + " triangles, at most " + std::to_string(mostTriangles) + " are drawn";
        return false;
    }
    mesh = {};
    for (const aiMesh* part : parts)
        if (!append(*scene, *part, mesh, why))
            return false;
    if (mesh.corners.empty())
        why = "no triangles";
    return !mesh.corners.empty();
}

bool read(const char* path, std::size_t mostTriangles, TriangleMesh& mesh, std::string& why) {
    try {
        Assimp::Importer importer;
        return readWith(importer, path, mostTriangles, mesh, why);
    } catch (const std::exception& error) {
        why = error.what();
        return false;
    }
}

} // namespace

const teleta::view3d::MeshReader teleta_mesh_reader{&read};
