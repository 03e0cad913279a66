// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/mesh/geometry_writers.h"

#include <vtkNew.h>
#include <vtkPLYWriter.h>
#include <vtkPolyData.h>
#include <vtkSTLWriter.h>
#include <vtkXMLPolyDataWriter.h>

#include <string_view>

namespace {

template <typename Writer>
unsigned long writeWith(Writer* writer, vtkPolyData* mesh, const char* path) {
    writer->SetFileName(path);
    writer->SetInputData(mesh);
    writer->Write();
    return writer->GetErrorCode();
}

unsigned long write(const char* format, vtkPolyData* mesh, const char* path) {
    if (std::string_view(format) == "vtp") {
        const vtkNew<vtkXMLPolyDataWriter> writer;
        writer->SetDataModeToAppended();
        return writeWith(writer.Get(), mesh, path);
    }
    if (std::string_view(format) == "ply") {
        const vtkNew<vtkPLYWriter> writer;
        writer->SetArrayName("colour");
        return writeWith(writer.Get(), mesh, path);
    }
    const vtkNew<vtkSTLWriter> writer;
    writer->SetFileTypeToBinary();
    return writeWith(writer.Get(), mesh, path);
}

} // namespace

const teleta::view3d::GeometryWriters teleta_geometry_writers{&write};
