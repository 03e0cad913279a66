// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <hdf5.h>
#include <matio.h>

namespace teleta::frames {

/// The functions of libhdf5 that are used. Its macros call functions of the library themselves, so they are
/// not.
struct Hdf5Functions {
    decltype(&H5open) open;
    decltype(&H5Eset_auto2) setErrorHandler;
    decltype(&H5Ewalk2) walkErrors;
    decltype(&H5Fopen) openFile;
    decltype(&H5Fclose) closeFile;
    decltype(&H5Ovisit2) visit;
    decltype(&H5Dopen2) openDataset;
    decltype(&H5Dclose) closeDataset;
    decltype(&H5Dget_space) spaceOf;
    decltype(&H5Dget_type) typeOf;
    decltype(&H5Dget_create_plist) creationOf;
    decltype(&H5Dget_storage_size) storageOf;
    decltype(&H5Dread) read;
    decltype(&H5Sget_simple_extent_type) extentOf;
    decltype(&H5Sget_simple_extent_ndims) dimensionsOf;
    decltype(&H5Sget_simple_extent_dims) sidesOf;
    decltype(&H5Screate_simple) createSpace;
    decltype(&H5Sselect_hyperslab) select;
    decltype(&H5Sclose) closeSpace;
    decltype(&H5Tget_class) classOf;
    decltype(&H5Tis_variable_str) isVariableText;
    decltype(&H5Tget_size) sizeOf;
    decltype(&H5Tclose) closeType;
    decltype(&H5Pget_nfilters) filtersOf;
    decltype(&H5Pget_filter2) filterOf;
    decltype(&H5Pget_layout) layoutOf;
    decltype(&H5Pget_external_count) externalOf;
    decltype(&H5Pcreate) createProperties;
    decltype(&H5Pset_chunk_cache) setChunkCache;
    decltype(&H5Pclose) closeProperties;
    decltype(&H5Aexists) hasAttribute;
    decltype(&H5Aopen) openAttribute;
    decltype(&H5Aget_type) attributeType;
    decltype(&H5Aget_space) attributeSpace;
    decltype(&H5Aread) readAttribute;
    decltype(&H5Aclose) closeAttribute;
    decltype(&H5free_memory) freeMemory;
    const hid_t* doubles;       ///< the type of a double
    const hid_t* datasetAccess; ///< the class of properties for opening a dataset
};

/// The functions of libmatio that are used.
struct MatioFunctions {
    decltype(&Mat_Open) open;
    decltype(&Mat_Close) close;
    decltype(&Mat_GetVersion) versionOf;
    decltype(&Mat_VarReadNextInfo) nextVariable;
    decltype(&Mat_VarRead) readVariable;
    decltype(&Mat_VarFree) freeVariable;
    decltype(&Mat_SizeOf) sizeOf;
};

/// What the module teleta_array_libraries exports.
struct ArrayLibraries {
    Hdf5Functions hdf5;
    MatioFunctions matio;
};

/// Loads the module when it is first called. Error: unavailable. Thread: any.
[[nodiscard]] core::Expected<const ArrayLibraries*> arrayLibraries();

} // namespace teleta::frames

extern "C" {
[[gnu::visibility("default")]] extern const teleta::frames::ArrayLibraries teleta_array_libraries;
}
