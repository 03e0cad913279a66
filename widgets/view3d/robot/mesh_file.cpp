// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/robot/mesh_file.h"

#include "backend/core/failure.h"
#include "backend/core/part.h"
#include "widgets/view3d/robot/mesh_reader.h"

#include <QCoreApplication>
#include <QString>

#include <algorithm>
#include <array>
#include <filesystem>

namespace teleta::view3d {

namespace {

namespace fs = std::filesystem;

struct MeshFileText {
    Q_DECLARE_TR_FUNCTIONS(MeshFile)
};

constexpr std::string_view kPackage = "package://";
constexpr std::uintmax_t kMostBytes = 200'000'000;

QString asText(std::string_view text) {
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

} // namespace

core::Expected<std::string> meshPath(std::string_view name, const std::string& folder) {
    if (folder.empty())
        return core::failed(core::ErrorKind::notFound,
                            MeshFileText::tr("the arm's file does not set mesh_path"),
                            MeshFileText::tr("mesh_path = \"FOLDER\""));
    const std::string_view rest = name.starts_with(kPackage) ? name.substr(kPackage.size()) : name;
    const fs::path path{rest};
    const bool leaves = std::ranges::any_of(path, [](const fs::path& part) { return part == ".."; });
    if (rest.empty() || rest.find("://") != std::string_view::npos || path.is_absolute() || leaves)
        return core::refused(
            MeshFileText::tr("the mesh %1 is not in the folder of the arm's meshes").arg(asText(name)));
    return (fs::path(folder) / path).string();
}

core::Expected<TriangleMesh> readMesh(const std::string& path) {
    const auto bad = [&](const QString& why) {
        return core::Unexpected(core::Error{core::ErrorKind::badInput, why.toStdString(), {}, {path, 0, 0}});
    };
    std::error_code error;
    if (!fs::is_regular_file(path, error))
        return core::Unexpected(core::Error{core::ErrorKind::notFound,
                                            MeshFileText::tr("the mesh is missing").toStdString(),
                                            {},
                                            {path, 0, 0}});
    const QString ending = asText(fs::path(path).extension().string()).toLower();
    constexpr std::array kEndings{".stl", ".dae", ".obj"};
    if (std::ranges::none_of(kEndings, [&](const char* known) { return ending == QLatin1String(known); }))
        return bad(MeshFileText::tr("meshes are read from STL, DAE and OBJ files"));
    if (const std::uintmax_t bytes = fs::file_size(path, error); error || bytes > kMostBytes)
        return bad(MeshFileText::tr("the mesh is larger than %1 MB").arg(kMostBytes / 1'000'000));
    static const auto reader = core::part<MeshReader>("teleta_mesh_reader");
    if (!reader)
        return core::Unexpected(reader.error());
    TriangleMesh mesh;
    std::string why;
    if (!(*reader)->read(path.c_str(), kMostTriangles, mesh, why))
        return bad(MeshFileText::tr("the mesh cannot be read: %1").arg(asText(why)));
    return mesh;
}

} // namespace teleta::view3d
