// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

namespace teleta::view3d {

/// An actor for a mesh whose points carry their colours.
struct MeshActor {
    enum class Shading {
        flat,   ///< a face is as bright as it is turned to the light
        smooth, ///< by the normals of the points
        none,   ///< the colours as they are
    };

    MeshActor(vtkPolyData* mesh, Shading shading) {
        mapper->SetInputData(mesh);
        mapper->SetScalarModeToUsePointData();
        actor->SetMapper(mapper);
        vtkProperty* property = actor->GetProperty();
        property->SetAmbient(0.15);
        property->SetDiffuse(0.85);
        switch (shading) {
        case Shading::flat:
            property->SetInterpolationToFlat();
            break;
        case Shading::smooth:
            property->SetInterpolationToPhong();
            property->SetAmbient(0.35);
            property->SetDiffuse(0.65);
            property->SetSpecular(0.15);
            property->SetSpecularPower(30.0);
            break;
        case Shading::none:
            property->LightingOff();
            break;
        }
    }

    void setLineWidth(double logical_px, double pixelScale) {
        actor->GetProperty()->SetLineWidth(static_cast<float>(logical_px * pixelScale));
    }

    /// Shows the mesh through whatever is before it: its depth is moved towards the camera by 0.6 of the
    /// range between the clipping planes, which keeps the order of its own parts.
    void showThrough() {
        constexpr double kUnits = -40'000.0; // of 1/65536 each
        mapper->SetResolveCoincidentTopologyToPolygonOffset();
        mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(0.0, kUnits);
        mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0.0, kUnits);
    }

    vtkNew<vtkPolyDataMapper> mapper;
    vtkNew<vtkActor> actor;
};

} // namespace teleta::view3d
