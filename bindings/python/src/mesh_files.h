// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SPECTRAL_SEGMENTATION_PYTHON_MESH_FILES_H
#define SPECTRAL_SEGMENTATION_PYTHON_MESH_FILES_H

#include <pybind11/pybind11.h>

namespace python {

// Adds the functions that read and write the contents of mesh files, by the readers and writers of
// the tool.
void define_mesh_files(pybind11::module_& m);

// Adds the functions that make meshes of the parts of a mesh.
void define_parts(pybind11::module_& m);

} // namespace python

#endif // SPECTRAL_SEGMENTATION_PYTHON_MESH_FILES_H
