// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view3d/mesh/mesh_builder.h"

#include <Eigen/Geometry>
#include <vtkActor.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkOpenGLVertexBufferObject.h>
#include <vtkProperty.h>

namespace teleta::view3d {

/// Copies a transform to VTK's own type.
[[nodiscard]] inline Eigen::Isometry3d isometryOf(const vtkMatrix4x4& matrix) {
    Eigen::Isometry3d transform = Eigen::Isometry3d::Identity();
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 4; ++column)
            transform(row, column) = matrix.GetElement(row, column);
    return transform;
}

inline void setMatrix(vtkMatrix4x4& matrix, const Eigen::Isometry3d& transform) {
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            matrix.SetElement(row, column, transform.matrix()(row, column));
}

/// An actor for a mesh whose points carry their colours.
struct MeshActor {
    enum class Shading {
        flat,   ///< brightness of each face by its angle to the light
        smooth, ///< by point normals
        none,   ///< plain colours
    };

    MeshActor(vtkPolyData* mesh, Shading shading) {
        mapper->SetInputData(mesh);
        mapper->SetScalarModeToUsePointData();
        // Scenes are about a metre large and lie around the origin: single precision is enough.
        mapper->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::DISABLE_SHIFT_SCALE);
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

    /// Draws only the sides of faces that are turned out, as a closed mesh needs. They run counter-clockwise.
    void hideInside() { actor->GetProperty()->BackfaceCullingOn(); }

    void setLineWidth(double logical_px, double pixelScale) {
        actor->GetProperty()->SetLineWidth(static_cast<float>(logical_px * pixelScale));
    }

    /// Draws the mesh in front of everything: moves its depth towards the camera by 0.6 of the range between
    /// the clipping planes, which keeps the order of its own parts.
    void showThrough() {
        constexpr double kUnits = -40'000.0; // of 1/65536 each
        mapper->SetResolveCoincidentTopologyToPolygonOffset();
        mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(0.0, kUnits);
        mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0.0, kUnits);
    }

    vtkNew<vtkOpenGLPolyDataMapper> mapper;
    vtkNew<vtkActor> actor;
};

/// A mesh builder with its actor.
struct Mesh : MeshBuilder, MeshActor {
    explicit Mesh(Shading shading, Alpha alpha = Alpha::ignored)
        : MeshBuilder(shading != Shading::none, alpha)
        , MeshActor(data(), shading) {
        // Otherwise VTK looks through all colours before each frame.
        if (alpha == Alpha::used)
            actor->ForceTranslucentOn();
    }
};

} // namespace teleta::view3d
