// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/vtk/vtk_version.h"

#include <Eigen/Core>
#include <vtkVersion.h>

namespace teleta::view3d {

QString vtkLibraryVersion() {
    return QString::fromLatin1(vtkVersion::GetVTKVersion());
}

QString eigenLibraryVersion() {
    return QStringLiteral("%1.%2.%3")
        .arg(EIGEN_WORLD_VERSION)
        .arg(EIGEN_MAJOR_VERSION)
        .arg(EIGEN_MINOR_VERSION);
}

} // namespace teleta::view3d
