// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/vtk_version.h"

#include <vtkVersion.h>

namespace teleta::view3d {

QString vtkLibraryVersion() {
    return QString::fromLatin1(vtkVersion::GetVTKVersion());
}

} // namespace teleta::view3d
