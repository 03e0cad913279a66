// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/mesh/geometry_export.h"

#include "backend/core/part.h"
#include "widgets/view3d/mesh/geometry_writers.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>

#include <vtkAppendPolyData.h>
#include <vtkErrorCode.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkStringArray.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>
#include <vtkTriangleFilter.h>

#include <filesystem>
#include <system_error>

namespace teleta::view3d {

namespace {

constexpr double kMillimetresPerMetre = 1000.0;

core::Unexpected failure(core::ErrorKind kind, const QString& path, const QString& message,
                         const QString& expected = {}) {
    return core::Unexpected(
        core::Error{kind, message.toStdString(), expected.toStdString(), {path.toStdString(), 0, 0}});
}

vtkSmartPointer<vtkPolyData> joinedInMillimetres(std::span<const vtkSmartPointer<vtkPolyData>> meshes_m) {
    const vtkNew<vtkAppendPolyData> joined;
    for (const auto& mesh : meshes_m)
        joined->AddInputData(mesh);
    const vtkNew<vtkTransform> scale;
    scale->Scale(kMillimetresPerMetre, kMillimetresPerMetre, kMillimetresPerMetre);
    const vtkNew<vtkTransformPolyDataFilter> scaled;
    scaled->SetInputConnection(joined->GetOutputPort());
    scaled->SetTransform(scale);
    scaled->Update();
    vtkSmartPointer<vtkPolyData> result = scaled->GetOutput();
    const vtkNew<vtkStringArray> unit;
    unit->SetName("length_unit");
    unit->InsertNextValue("mm");
    result->GetFieldData()->AddArray(unit);
    return result;
}

vtkSmartPointer<vtkPolyData> trianglesOf(vtkPolyData* mesh) {
    const vtkNew<vtkTriangleFilter> triangles;
    triangles->SetInputData(mesh);
    triangles->PassLinesOff();
    triangles->PassVertsOff();
    triangles->Update();
    return triangles->GetOutput();
}

} // namespace

core::Expected<void> exportGeometry(std::span<const vtkSmartPointer<vtkPolyData>> meshes_m,
                                    const QString& path) {
    const QString format = QFileInfo(path).suffix().toLower();
    if (format != QLatin1String("vtp") && format != QLatin1String("ply") && format != QLatin1String("stl")) {
        return failure(core::ErrorKind::badInput, path,
                       QCoreApplication::translate("view3d", "Geometry cannot be written in this format."),
                       QCoreApplication::translate("view3d", "a file name that ends in .vtp, .ply or .stl"));
    }
    if (meshes_m.empty()) {
        return failure(
            core::ErrorKind::badInput, path,
            QCoreApplication::translate("view3d", "The scene is empty: there is nothing to write."));
    }
    static const core::Expected<const GeometryWriters*> writers =
        core::part<GeometryWriters>("teleta_geometry_writers");
    if (!writers)
        return core::Unexpected(writers.error());
    vtkSmartPointer<vtkPolyData> mesh = joinedInMillimetres(meshes_m);
    if (format != QLatin1String("vtp"))
        mesh = trianglesOf(mesh);
    // The PLY writer insists on its extension.
    const QString part = QStringLiteral("%1.part.%2").arg(path, format);
    const QByteArray partName = QFile::encodeName(part);
    const unsigned long code = (*writers)->write(format.toLatin1().constData(), mesh, partName.constData());
    QString reason;
    if (code != vtkErrorCode::NoError) {
        reason = QString::fromLocal8Bit(vtkErrorCode::GetStringFromErrorCode(code));
    } else if (QFileInfo(part).size() == 0) {
        reason = QCoreApplication::translate("view3d", "nothing was written");
    } else {
        std::error_code renamed;
        std::filesystem::rename(partName.toStdString(), QFile::encodeName(path).toStdString(), renamed);
        if (!renamed)
            return {};
        reason = QString::fromStdString(renamed.message());
    }
    QFile::remove(part);
    return failure(
        core::ErrorKind::ioFailed, path,
        QCoreApplication::translate("view3d", "The geometry could not be written: %1").arg(reason));
}

} // namespace teleta::view3d
